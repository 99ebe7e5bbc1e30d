/* SPDX-License-Identifier: GPL-3.0-or-later */
/* err - what went wrong, by value.
 *
 * Every call that can fail returns bool and takes a `struct err *` as its last argument. On failure
 * it returns false and fills the struct; on success it leaves the struct alone. The numeric value
 * of a kind is the exit status of a program that stops because of it (supple(7), EXIT STATUS). */
#ifndef ERR_H
#define ERR_H

#include <stdbool.h>
#include <stddef.h>

#define WARN_UNUSED __attribute__((warn_unused_result))

enum err_kind {
    ERR_NONE = 0,    /* nothing wrong */
    ERR_INPUT = 1,   /* syntax, wrong counts, cut files, input and output, memory */
    ERR_USAGE = 2,   /* unknown option, value out of range, missing operand */
    ERR_REFUSAL = 3, /* the input is sound and the answer does not exist */
};

struct err {
    enum err_kind kind;
    char file[256];    /* "" when the message has no place */
    size_t line, col;  /* from 1; 0 = unknown */
    char message[768]; /* one line, no final newline, no tool name */
};

/* Fills *err, place unknown. Always returns false, so that a function may end with it. */
bool err_set(struct err *err, enum err_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The same with a place: file (any length, cut at its front), line and column from 1 or 0. */
bool err_set_at(struct err *err, enum err_kind kind, const char *file, size_t line, size_t col,
                const char *format, ...) __attribute__((format(printf, 6, 7)));

/* Adds a place to an error that has none. Always returns false. */
bool err_place(struct err *err, const char *file, size_t line, size_t col);

/* "cannot WHAT FILE: reason of errno". Always returns false. */
bool err_system(struct err *err, const char *what, const char *file);

/* "out of memory". Always returns false. */
bool err_memory(struct err *err);

/* A bug, not an input, makes this false: the program stops with a message. Always compiled in. */
#define INVARIANT(condition) ((condition) ? (void)0 : err_bug(__FILE__, __LINE__, #condition))
_Noreturn void err_bug(const char *file, int line, const char *condition);

#endif
