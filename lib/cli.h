/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cli - what the programs share: options, usage, messages, exit status.
 *
 * A tool is
 *
 *     int main(int argc, char **argv) {
 *         struct err err = {0};
 *         struct cli cli;
 *         struct settings set = {...};
 *         cli_init(&cli, &program, argc, argv);
 *         if (parse(&cli, &set, &err)) run(&set, &err);
 *         return cli_finish(&cli, &err);
 *     }
 *
 * where parse and run stop by returning false with err filled, or, after --help and --version, with
 * err.kind still ERR_NONE. This is the one module that prints messages. */
#ifndef CLI_H
#define CLI_H

#include "err.h"
#include "progress.h"

#include <stdint.h>

struct cli_option {
    int key;          /* its letter, or a number from 256 for an option without one */
    const char *name; /* long name, no dashes; NULL ends the table */
    const char *arg;  /* name of its argument, NULL: none; "[=X]": optional; "FILE...": a file */
    const char *help; /* one line; NULL: it stands in the line of the next option */
};

struct cli_program {
    const char *name, *synopsis;      /* synopsis without the program's name */
    const struct cli_option *options; /* --help and --version are added */
    const char *epilogue;             /* last lines of --help: two pipelines that work */
    bool numbers_are_operands;        /* so "-0.5" is one; all options come before the operands */
};

struct cli {
    const struct cli_program *program;
    int argc;
    char **argv;
    const struct cli_option *option; /* the option that cli_next returned */
    const char *value;               /* its argument, NULL: none */
    char **operands;                 /* after CLI_END */
    int operand_count;
};

enum { CLI_END = -1, CLI_STOP = -2 };

void cli_init(struct cli *cli, const struct cli_program *program, int argc, char **argv);

/* The next option's key, CLI_END after the last, CLI_STOP on an error or after --help, --version.
 */
int cli_next(struct cli *cli, struct err *err);

/* The current option's value as a number, an integer, n numbers separated by commas, or two
 * integers as in 16x12; all within lo..hi, else a usage error that names option, value and range.
 */
bool cli_double(const struct cli *cli, double lo, double hi, double *x,
                struct err *err) WARN_UNUSED;
bool cli_int(const struct cli *cli, int64_t lo, int64_t hi, int64_t *n,
             struct err *err) WARN_UNUSED;
bool cli_doubles(const struct cli *cli, int n, double *x, struct err *err) WARN_UNUSED;
bool cli_cells(const struct cli *cli, int64_t hi, int64_t n[2], struct err *err) WARN_UNUSED;

/* The current option's value as an index into a table of names that NULL ends; the error lists
 * them. */
bool cli_choice(const struct cli *cli, const char *const *names, int *index,
                struct err *err) WARN_UNUSED;

/* The current option's value as a set of such names, with commas between them: bit 1 << index each.
 * At most 32 names. */
bool cli_names(const struct cli *cli, const char *const *names, unsigned *set,
               struct err *err) WARN_UNUSED;

/* A usage error about the current option: "--NAME: MESSAGE, got 'VALUE'". Always false. */
bool cli_bad_value(const struct cli *cli, struct err *err, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* There must be min..max operands, of which at most one is stdin. A missing optional last operand
 * counts as stdin. */
bool cli_check_operands(const struct cli *cli, int min, int max, struct err *err) WARN_UNUSED;

/* Of the files that are read, operands and values of options, at most one is "-". NULL: no file. */
bool cli_check_stdin(const struct cli *cli, int n, const char *const path[],
                     struct err *err) WARN_UNUSED;

/* Operand i, or "-" when it was left out. */
const char *cli_operand(const struct cli *cli, int i);

/* The history line of this command (formats.md): "NAME OPTIONS OPERANDS", files by their base
 * names, -o left out, control characters as blanks. The caller frees it. NULL: no memory. */
char *cli_history(const struct cli *cli, struct err *err) WARN_UNUSED;

/* "NAME: MESSAGE" on stderr: a remark that is not an error. */
void cli_note(const struct cli *cli, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Shows the progress of long work on stderr: after a second, and then every second, how much of it
 * is done. On a terminal that is one line, which disappears in the end. */
struct cli_progress {
    struct progress progress;
    const struct cli *cli;
    bool terminal;
    double next;   /* when to show it again, seconds of the monotonic clock */
    size_t length; /* of the line on the terminal */
};

/* What the library is to be given: NULL unless stderr is a terminal or `always` is true. */
struct progress *cli_progress_begin(struct cli_progress *p, const struct cli *cli, bool always);
void cli_progress_end(struct cli_progress *p); /* harmless if it was not begun */

/* Prints err, if any, checks stdout and stderr, and returns the exit status. */
int cli_finish(const struct cli *cli, const struct err *err);

#endif
