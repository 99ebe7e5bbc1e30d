/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli.h"

#include "mem.h"
#include "num.h"

#include <errno.h>
#include <fcntl.h>
#include <getopt.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { KEY_HELP = 'h', KEY_VERSION = 'V', OPTIONS_MAX = 40 };

static const struct cli_option common[] = {
    {KEY_HELP, "help", NULL, "print this and exit"},
    {KEY_VERSION, "version", NULL, "print the version and exit"},
};

/* A program started with stdin, stdout or stderr closed would get that number for the next file it
 * opens. So each closed one becomes a descriptor on which reading or writing fails. */
static void occupy_standard_streams(void) {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0) (void)!open("/dev/null", fd ? O_RDONLY : O_WRONLY);
}

void cli_init(struct cli *cli, const struct cli_program *program, int argc, char **argv) {
    occupy_standard_streams();
    optind = 0; /* getopt starts anew, also for a second command line in one process */
    *cli = (struct cli){.program = program, .argc = argc, .argv = argv};
}

static int option_count(const struct cli_program *program) {
    int n = 0;
    while (program->options[n].name) n++;
    return n;
}

static const struct cli_option *option_at(const struct cli_program *program, int i) {
    int n = option_count(program);
    return i < n ? &program->options[i] : &common[i - n];
}

static bool is_optional(const struct cli_option *o) {
    return o->arg && o->arg[0] == '[';
}

/* Returns how many options the line is about: one, or those without help as well that precede it.
 */
static int print_option(const struct cli_option *o) {
    char left[120];
    int n = 0, length = 0;
    do {
        const char *space = o->arg && !is_optional(o) ? " " : "", *arg = o->arg ? o->arg : "";
        const char letter[] = {'-', (char)o->key, ',', ' ', '\0'};
        length +=
            snprintf(left + length, sizeof left - (size_t)length, "%s%s--%s%s%s", n ? "; " : "",
                     o->key < 256 ? letter
                     : n          ? ""
                                  : "    ",
                     o->name, space, arg);
        INVARIANT(length < (int)sizeof left);
        n++;
    } while (!o++->help);
    printf("  %-27s %s\n", left, o[-1].help);
    return n;
}

static void print_help(const struct cli_program *program) {
    int n = option_count(program);
    printf("usage: %s %s\n", program->name, program->synopsis);
    for (int i = 0; i < n;) i += print_option(&program->options[i]);
    printf("  %-27s %s\n", "-h, --help; -V, --version", "print this; print the version");
    fputs(program->epilogue, stdout);
}

/* Fills getopt's two descriptions of the options from our one table. */
static void describe(const struct cli_program *program, struct option *longs, char *shorts) {
    int n = option_count(program) + (int)(sizeof common / sizeof *common);
    INVARIANT(n < OPTIONS_MAX);
    if (program->numbers_are_operands) *shorts++ = '+'; /* stop at the first operand */
    *shorts++ = ':';                                    /* report a missing argument apart */
    for (int i = 0; i < n; i++) {
        const struct cli_option *o = option_at(program, i);
        int has = is_optional(o) ? optional_argument : o->arg ? required_argument : no_argument;
        longs[i] = (struct option){o->name, has, NULL, 256 + i};
        if (o->key >= 256) continue;
        *shorts++ = (char)o->key;
        if (has == required_argument) *shorts++ = ':';
    }
    longs[n] = (struct option){0};
    *shorts = '\0';
}

static const struct cli_option *find_option(const struct cli_program *program, int got) {
    int n = option_count(program) + (int)(sizeof common / sizeof *common);
    if (got >= 256) return option_at(program, got - 256);
    for (int i = 0; i < n; i++)
        if (option_at(program, i)->key == got) return option_at(program, i);
    return NULL;
}

static bool usage_error(const struct cli *cli, struct err *err, const char *what,
                        const char *word) {
    return err_set(err, ERR_USAGE, "%s '%s'; try %s --help", what, word, cli->program->name);
}

/* What getopt did not like: optopt is a letter, the number of a long option whose argument is
 * missing or not wanted, or 0 for an unknown long option. */
static bool bad_option(const struct cli *cli, int got, struct err *err) {
    const char letter[] = {'-', (char)optopt, '\0'};
    const char *what = got == ':'      ? "missing argument of"
                       : optopt >= 256 ? "surplus argument of"
                                       : "unknown option";
    bool is_letter = optopt > 0 && optopt < 256;
    return usage_error(cli, err, what, is_letter ? letter : cli->argv[optind - 1]);
}

/* Is the next word a negative number, where that is an operand? */
static bool at_number(const struct cli *cli) {
    int at = optind ? optind : 1; /* 0: getopt has not begun */
    const char *word = at < cli->argc ? cli->argv[at] : "", *next;
    double x;
    if (!cli->program->numbers_are_operands || word[0] != '-') return false;
    if (num_read(word, word + strlen(word), &x, &next) != NUM_OK) return false;
    optind = at;
    return true;
}

static int end_of_options(struct cli *cli) {
    cli->operands = cli->argv + optind;
    cli->operand_count = cli->argc - optind;
    return CLI_END;
}

int cli_next(struct cli *cli, struct err *err) {
    struct option longs[OPTIONS_MAX];
    char shorts[2 * OPTIONS_MAX + 3];
    int got;
    opterr = 0;
    describe(cli->program, longs, shorts);
    if (at_number(cli)) return end_of_options(cli);
    got = getopt_long(cli->argc, cli->argv, shorts, longs, NULL);
    if (got == -1) return end_of_options(cli);
    if (got == '?' || got == ':') {
        bad_option(cli, got, err);
        return CLI_STOP;
    }
    cli->option = find_option(cli->program, got);
    cli->value = optarg;
    INVARIANT(cli->option);
    if (cli->option->key == KEY_HELP) print_help(cli->program);
    if (cli->option->key == KEY_VERSION)
        printf("%s (supple) %s\n", cli->program->name, SUPPLE_VERSION);
    return cli->option->key == KEY_HELP || cli->option->key == KEY_VERSION ? CLI_STOP
                                                                           : cli->option->key;
}

bool cli_bad_value(const struct cli *cli, struct err *err, const char *format, ...) {
    char text[512];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return err_set(err, ERR_USAGE, "--%s: expected %s, got '%s'; try %s --help", cli->option->name,
                   text, cli->value, cli->program->name);
}

/* Reads n numbers separated by commas, with nothing behind them. */
static bool read_list(const char *s, int n, double *x) {
    const char *end = s + strlen(s);
    for (int i = 0; i < n; i++) {
        if (i > 0 && *s++ != ',') return false;
        if (num_read(s, end, &x[i], &s) != NUM_OK) return false;
    }
    return s == end;
}

bool cli_double(const struct cli *cli, double lo, double hi, double *x, struct err *err) {
    if (read_list(cli->value, 1, x) && *x >= lo && *x <= hi) return true;
    return cli_bad_value(cli, err, "a number in %g..%g", lo, hi);
}

bool cli_int(const struct cli *cli, int64_t lo, int64_t hi, int64_t *n, struct err *err) {
    const char *end = cli->value + strlen(cli->value), *next = NULL;
    if (num_read_int(cli->value, end, n, &next) == NUM_OK && next == end && *n >= lo && *n <= hi)
        return true;
    return cli_bad_value(cli, err, "an integer in %lld..%lld", (long long)lo, (long long)hi);
}

bool cli_doubles(const struct cli *cli, int n, double *x, struct err *err) {
    if (read_list(cli->value, n, x)) return true;
    if (n == 1) return cli_bad_value(cli, err, "a number");
    return cli_bad_value(cli, err, "%d numbers separated by commas (%s)", n, cli->option->arg);
}

bool cli_cells(const struct cli *cli, int64_t hi, int64_t n[2], struct err *err) {
    const char *s = cli->value, *end = s + strlen(s), *next = NULL;
    bool ok = num_read_int(s, end, &n[0], &next) == NUM_OK && *next == 'x' &&
              num_read_int(next + 1, end, &n[1], &next) == NUM_OK && next == end;
    if (ok && n[0] >= 1 && n[0] <= hi && n[1] >= 1 && n[1] <= hi) return true;
    return cli_bad_value(cli, err, "two integers in 1..%lld as in 16x12", (long long)hi);
}

/* The index of the name [word, word + length), or -1. */
static int find_name(const char *const *names, const char *word, size_t length) {
    for (int i = 0; names[i]; i++)
        if (strlen(names[i]) == length && memcmp(names[i], word, length) == 0) return i;
    return -1;
}

static bool bad_name(const struct cli *cli, const char *what, const char *const *names,
                     struct err *err) {
    char list[256] = "";
    size_t used = 0;
    for (int i = 0; names[i] && used < sizeof list; i++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", i ? ", " : "", names[i]);
    return cli_bad_value(cli, err, "%s %s", what, list);
}

bool cli_choice(const struct cli *cli, const char *const *names, int *index, struct err *err) {
    int found = find_name(names, cli->value, strlen(cli->value));
    if (found < 0) return bad_name(cli, "one of", names, err);
    *index = found;
    return true;
}

bool cli_names(const struct cli *cli, const char *const *names, unsigned *set, struct err *err) {
    unsigned found = 0;
    for (const char *at = cli->value;; at++) {
        size_t n = strcspn(at, ",");
        int i = find_name(names, at, n);
        if (i < 0) return bad_name(cli, "a list, with commas, of", names, err);
        found |= 1u << i;
        at += n;
        if (!*at) break;
    }
    *set = found;
    return true;
}

const char *cli_operand(const struct cli *cli, int i) {
    return i < cli->operand_count ? cli->operands[i] : "-";
}

bool cli_check_operands(const struct cli *cli, int min, int max, struct err *err) {
    int standard = 0;
    if (cli->operand_count < min)
        return err_set(err, ERR_USAGE, "missing operand; usage: %s %s", cli->program->name,
                       cli->program->synopsis);
    if (cli->operand_count > max)
        return usage_error(cli, err, "surplus operand", cli->operands[max]);
    for (int i = 0; i < max; i++) standard += strcmp(cli_operand(cli, i), "-") == 0;
    if (standard > 1)
        return err_set(err, ERR_USAGE, "two inputs from stdin; usage: %s %s", cli->program->name,
                       cli->program->synopsis);
    return true;
}

bool cli_check_stdin(const struct cli *cli, int n, const char *const path[], struct err *err) {
    int standard = 0;
    for (int i = 0; i < n; i++) standard += path[i] && strcmp(path[i], "-") == 0;
    return standard <= 1 ||
           err_set(err, ERR_USAGE, "two inputs from stdin; try %s --help", cli->program->name);
}

static const char *base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash && slash[1] ? slash + 1 : path;
}

static char printable(char c) {
    return (unsigned char)c < ' ' || c == 127 ? ' ' : c;
}

/* Appends one word of the command line, in quotes where a shell would need them. */
static void append_word(FILE *to, const char *word) {
    bool plain = *word && !strpbrk(word, " \t\n\r\"'\\!#$&*();<>?[]`{|}~");
    if (!plain) fputc('\'', to);
    for (; *word; word++)
        if (*word == '\'')
            fputs("'\\''", to);
        else
            fputc(printable(*word), to);
    if (!plain) fputc('\'', to);
}

/* " --name", " --name value" or, where the value may be left out, " --name=value". */
static void append_option(FILE *to, const struct cli *cli) {
    const struct cli_option *o = cli->option;
    bool file = o->arg && strstr(o->arg, "FILE");
    fprintf(to, " --%s", o->name);
    if (!cli->value) return;
    fputc(is_optional(o) ? '=' : ' ', to);
    append_word(to, file ? base_name(cli->value) : cli->value);
}

char *cli_history(const struct cli *cli, struct err *err) {
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    struct cli scan = *cli;
    struct err ignored = {0};
    int key;
    if (!to) {
        err_memory(err);
        return NULL;
    }
    fputs(cli->program->name, to);
    optind = 0; /* read the options once more; this also forgets getopt's place in a word */
    while ((key = cli_next(&scan, &ignored)) >= 0)
        if (key != 'o') append_option(to, &scan);
    for (int i = 0; i < scan.operand_count; i++)
        if (strcmp(scan.operands[i], "-") != 0) {
            fputc(' ', to);
            append_word(to, base_name(scan.operands[i]));
        }
    if (fclose(to) == 0) return text;
    free(text);
    err_memory(err);
    return NULL;
}

void cli_note(const struct cli *cli, const char *format, ...) {
    va_list args;
    fprintf(stderr, "%s: ", cli->program->name);
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    fputc('\n', stderr);
}

/* One line, whatever the names of files and the values of options hold. */
static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void show_progress(struct progress *progress, double fraction) {
    struct cli_progress *p = (struct cli_progress *)(void *)progress; /* its first member */
    double time = now();
    if (time < p->next) return;
    p->next = time + 1;
    p->length = (size_t)fprintf(stderr, "%s%s: %.0f %% done%s", p->terminal ? "\r" : "",
                                p->cli->program->name, 100 * fraction, p->terminal ? "" : "\n");
}

struct progress *cli_progress_begin(struct cli_progress *p, const struct cli *cli, bool always) {
    bool terminal = isatty(STDERR_FILENO);
    *p = (struct cli_progress){{show_progress}, cli, terminal, now() + 1, 0};
    return terminal || always ? &p->progress : NULL;
}

void cli_progress_end(struct cli_progress *p) {
    if (p->terminal && p->length > 0) fprintf(stderr, "\r%*s\r", (int)p->length, "");
    p->length = 0;
}

static void print_error(const struct cli *cli, const struct err *err) {
    char text[sizeof err->file + sizeof err->message + 64];
    int n = snprintf(text, sizeof text, "%s", err->file);
    if (err->line) n += snprintf(text + n, sizeof text - (size_t)n, ":%zu", err->line);
    if (err->col) n += snprintf(text + n, sizeof text - (size_t)n, ":%zu", err->col);
    snprintf(text + n, sizeof text - (size_t)n, "%s%s", n ? ": " : "", err->message);
    for (char *c = text; *c; c++) *c = printable(*c);
    fprintf(stderr, "%s: %s\n", cli->program->name, text);
}

int cli_finish(const struct cli *cli, const struct err *err) {
    int status = (int)err->kind;
    if (err->kind) print_error(cli, err);
    if (fflush(stdout) != 0 ||
        ferror(stdout)) { /* only --help and --version use stdio; results go through out.h */
        fprintf(stderr, "%s: cannot write <stdout>: %s\n", cli->program->name, strerror(errno));
        if (status == 0) status = ERR_INPUT;
    }
    if (fflush(stderr) != 0 && status == 0) status = ERR_INPUT;
    return status;
}
