/* SPDX-License-Identifier: GPL-3.0-or-later */
/* polylines_io - polylines as text: `x y [LABEL]` a line, a blank line ends a polyline. The label
 * of a polyline is that of its first point, a number or a word. */
#ifndef POLYLINES_IO_H
#define POLYLINES_IO_H

#include "out.h"
#include "polylines.h"

/* Reads path (NULL or "-": stdin); there must be a point. Further columns are ignored. Errors:
 * file:LINE:COL; more than POLYLINES_NAMES_MAX different words. O(text). */
bool polylines_read(struct polylines *p, const char *path, struct err *err) WARN_UNUSED;

/* Writes them, every point with the label of its line; digits as in num_print. */
void polylines_write(struct out *out, const struct polylines *p, int digits);

#endif
