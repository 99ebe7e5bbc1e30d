/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grid_io - the grid format, supple-grid(5). */
#ifndef GRID_IO_H
#define GRID_IO_H

#include "out.h"
#include "spline.h"

/* A spline as a file: what is to be kept beside the map itself. */
struct grid_file {
    struct spline spline;
    char *history; /* the comment lines after the first record, each "# ...\n"; may be "" */
};

/* Reads path (NULL or "-": stdin). 100 MB/s or more. Errors name line and column, also of a vertex
 * or triangle that makes the grid unsound. */
bool grid_read(struct grid_file *file, const char *path, struct err *err) WARN_UNUSED;
void grid_file_free(struct grid_file *file);

/* The same from memory; and whether the first word is that of a grid. Name and text are borrowed.
 */
bool grid_read_text(struct grid_file *file, const char *name, const char *text, size_t length,
                    struct err *err) WARN_UNUSED;
bool grid_is_text(const char *text, size_t length);

/* Writes the canonical form: plane and lattice only where they are not the default. `added` is a
 * line for the history without "# " and newline, or NULL. `digits` is for the control points;
 * lattice and depth, which give the points their meaning, are always written exactly.
 * Reading and writing a canonical file gives the same bytes. */
void grid_write(struct out *out, const struct grid_file *file, const char *added, int digits);

/* The checksum of the domain: the CRC-32 (zlib) of the lines from `plane` to the last triangle as
 * grid_write writes them, newlines included. So a default plane or lattice, which has no line,
 * adds nothing, and neither do degree, history and control points. O(n) time, O(1) memory. */
bool grid_checksum(const struct grid *g, uint32_t *checksum, struct err *err) WARN_UNUSED;

#endif
