/* SPDX-License-Identifier: GPL-3.0-or-later */
/* xy_io - polygons and points as .xy files: `x y` a line. In a polygon, a line of blanks only, or
 * HOLE, ends a loop (several count as one); comment lines belong to no loop and end none. */
#ifndef XY_IO_H
#define XY_IO_H

#include "polygon.h"

/* Reads and builds a polygon; NULL or "-" is stdin. Refused: no loop, a loop of fewer than three
 * points, more than two columns, Triangle's .poly. Call polygon_free only after success. */
bool xy_read_polygon(struct polygon *g, const char *path, struct err *err) WARN_UNUSED;

/* Reads a list of points, `x y` a line, of any number; further columns are skipped. The caller
 * frees *point, on success. */
bool xy_read_points(double (**point)[2], size_t *count, const char *path,
                    struct err *err) WARN_UNUSED;

#endif
