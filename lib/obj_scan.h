/* SPDX-License-Identifier: GPL-3.0-or-later */
/* obj_scan - the statements of a Wavefront OBJ text in memory, and the words of those we
 * understand.
 *
 * A statement is one line, or several: a final backslash continues it, except in a comment. '#'
 * starts a comment, CRLF ends a line as LF does, blanks are spaces, tabs and continuations. Nothing
 * is copied and nothing is counted on the way: line and column are found when an error needs them.
 */
#ifndef OBJ_SCAN_H
#define OBJ_SCAN_H

#include "err.h"

#include <stdint.h>

enum obj_kind {
    OBJ_END,     /* no more statements */
    OBJ_VERTEX,  /* v x y z ... */
    OBJ_NORMAL,  /* vn x y z */
    OBJ_TEXTURE, /* vt u [v [w]] */
    OBJ_FACE,    /* f and the old fo: corners v/vt/vn */
    OBJ_LINE,    /* l: v/vt */
    OBJ_POINT,   /* p: v */
    OBJ_SURFACE, /* surf: four numbers, then corners as those of a face */
    OBJ_OTHER,   /* blank lines, comments, everything else */
};

struct obj_scan {
    const char *name;       /* as in messages; borrowed */
    const char *text, *end; /* all of it; borrowed */
    const char *line;       /* the current statement [line, stop), its end of line [stop, next) */
    const char *stop, *next;
    const char *at; /* what is left of it: [at, stop) */
    struct err err; /* sticky */
};

/* A corner as it is written: v, v/vt, v//vn, v/vt/vn; 0: absent. Negative numbers count back. */
struct obj_corner {
    const char *begin, *end; /* its text */
    const char *cut;       /* with a normal: from here to `end` stand the slashes and the normal */
    const char *normal_at; /* the normal's number [normal_at, end) */
    int64_t vertex, texture, normal;
};

void obj_scan_init(struct obj_scan *s, const char *name, const char *text, size_t length);

/* Goes to the next statement; s->at is past its keyword. OBJ_END after an error, too. */
enum obj_kind obj_next(struct obj_scan *s);

/* The next n words must be numbers. `what` completes "expected ...". */
bool obj_numbers(struct obj_scan *s, const char *what, int n, double *x);

/* All further words must be numbers. */
bool obj_more_numbers(struct obj_scan *s, const char *what);

/* Nothing may follow. */
bool obj_end_line(struct obj_scan *s);

/* The next corner; false at the end of the statement or on an error. Numbers are not checked
 * against any count, but none is 0. */
bool obj_corner(struct obj_scan *s, struct obj_corner *corner);

/* Goes to the corners of a statement of this kind that may have normals; false if it has none. */
bool obj_to_corners(struct obj_scan *s, enum obj_kind kind);

/* The next word of the statement without its comment, [*begin, *end); false if there is none. */
bool obj_word(struct obj_scan *s, const char **begin, const char **end);

/* The index from 0 that `number` means where `count` are defined before it; negative ones are
 * checked, positive ones may lie ahead. `what` is "vertex", "normal" or "texture coordinate". */
bool obj_resolve(struct obj_scan *s, const struct obj_corner *corner, const char *what,
                 int64_t number, size_t count, size_t *index);

/* The line, from 1, of a place in the text. O(text). */
size_t obj_line_number(const struct obj_scan *s, const char *at);

/* Record an error at a place in the text. Always false. */
bool obj_expected(struct obj_scan *s, const char *at, const char *what);
bool obj_fail(struct obj_scan *s, const char *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
