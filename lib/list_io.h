/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list_io - lists of points as text, one a line: `x y ...` or `x y z ...`.
 *
 * Further columns may be anything. Comments, blank lines and, in lists of two columns, lines HOLE
 * are no points; they pass, so that a polygon can be mapped as a list. */
#ifndef LIST_IO_H
#define LIST_IO_H

#include "filemap.h"
#include "obj_points.h"
#include "out.h"
#include "src.h"

/* Reads all points; the third coordinate of `columns` = 2 is 0. There must be a point. Errors:
 * file:LINE:COL. Freed by obj_points_free. */
bool list_read(struct obj_points *p, const struct filemap *f, int columns,
               struct err *err) WARN_UNUSED;

/* The line of point i, counted from 0, for messages. O(text). */
size_t list_line(const struct filemap *f, int columns, size_t i);

struct list_change {
    int columns;          /* 2 or 3 */
    double (*point)[3];   /* the new points */
    double (*further)[5]; /* NULL, or columns to be added behind all others */
    int digits;           /* as in num_print */
};

/* Writes a copy with other points. The text has been read before, so the only errors are those of
 * `out`, which stick there, and that the file changed meanwhile. */
bool list_copy(struct out *out, const struct filemap *f, size_t count,
               const struct list_change *change, struct err *err) WARN_UNUSED;

/* Copies a list while words of its lines are replaced: list_copier_next goes to the next line that
 * is a point, whose words src_word then takes from `src`; list_copier_cut leaves out what stands in
 * [begin, end), so that what is written to `out` after it comes in its place. `columns` is 3 where
 * lines HOLE are none of the list's. */
struct list_copier {
    struct src src;
    struct out *out;
    /* private */
    int columns;
    const char *done, *end;
};

void list_copier_begin(struct list_copier *k, struct out *out, const struct filemap *f,
                       int columns);
bool list_copier_next(struct list_copier *k);
void list_copier_cut(struct list_copier *k, const char *begin, const char *end);

/* Copies the rest. There must be no more points, and no error before: else the file has changed. */
bool list_copier_end(struct list_copier *k, struct err *err) WARN_UNUSED;

/* The same line by line for a reader: goes to the next line that is a point. */
bool list_next(struct src *src, int columns);

#endif
