/* SPDX-License-Identifier: GPL-3.0-or-later */
/* xy_io - polygons as .xy files: `x y` a line; a line of blanks only, or HOLE, ends a loop (several
 * count as one). Comment lines belong to no loop and end none. */
#ifndef XY_IO_H
#define XY_IO_H

#include "polygon.h"

/* Reads and builds a polygon; NULL or "-" is stdin. Refused: no loop, a loop of fewer than three
 * points, more than two columns, Triangle's .poly. Call polygon_free only after success. */
bool xy_read_polygon(struct polygon *g, const char *path, struct err *err) WARN_UNUSED;

#endif
