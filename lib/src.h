/* SPDX-License-Identifier: GPL-3.0-or-later */
/* src - a reader of line-oriented text with one sticky error.
 *
 * It hands out lines; within a line, words and numbers. '#' starts a comment, CRLF ends a line as
 * LF does, blanks are spaces and tabs. After the first error every call returns false and src->err
 * says "file:LINE:COL: expected X, got Y", so that a parser may check once, at its end. Lines may
 * have any length; memory is O(longest line + 256 KB). Only modules named *_io and edits use it. */
#ifndef SRC_H
#define SRC_H

#include "err.h"

#include <stdint.h>

struct src {
    const char *name;     /* as in messages; borrowed until src_close */
    size_t line;          /* number of the current line, from 1 */
    const char *begin;    /* the current line [begin, end), without its end-of-line */
    const char *at, *end; /* what is left of it; comments are cut off */
    const char *comment;  /* '#' of the comment cut off, or NULL; it ends at raw_end */
    const char *raw_end;
    struct err err; /* sticky */
    bool eof;       /* the input ended cleanly */
    /* private */
    int fd; /* -1: memory */
    bool ended;
    char *buf;
    size_t cap, lo, hi;
};

/* Opens a file; NULL or "-" is stdin, called "<stdin>". The path is borrowed. */
bool src_open(struct src *src, const char *path, struct err *err) WARN_UNUSED;

/* Reads text in memory; name and text are borrowed, and lines and words lie in the text itself. */
void src_open_text(struct src *src, const char *name, const char *text, size_t length);
void src_close(struct src *src);

/* Goes to the next line, comment or blank alike (at == end then). False at the end or on error. */
bool src_raw_line(struct src *src);

/* Goes to the next line that has a word. False at the end (src->eof) or on error. */
bool src_line(struct src *src);

/* The next word of the line, [*word, *word + *length), valid until the next line. False, without an
 * error, when the line has no more. */
bool src_word(struct src *src, const char **word, size_t *length);

/* Is the next word this one? Takes it if so; never an error. */
bool src_take(struct src *src, const char *word);

/* The next word must be this one; a number; an integer in lo..hi; the end of the line.
 * `what` completes "expected ..." in the message, e.g. "a vertex number". */
bool src_expect(struct src *src, const char *word);
bool src_double(struct src *src, const char *what, double *x);
bool src_int(struct src *src, const char *what, int64_t lo, int64_t hi, int64_t *n);
bool src_end_line(struct src *src);

/* Records "expected WHAT, got NEXT WORD" at the next word. Always false. */
bool src_expected(struct src *src, const char *what);

/* The column of a pointer into the current line, from 1. */
static inline uint32_t src_column(const struct src *src, const char *at) {
    size_t column = (size_t)(at - src->begin) + 1;
    return column < UINT32_MAX ? (uint32_t)column : UINT32_MAX;
}

/* Records any other error, at column `at` (a pointer into the line, or NULL: its beginning).
 * Always false. */
bool src_fail(struct src *src, const char *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
