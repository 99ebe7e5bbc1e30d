/* SPDX-License-Identifier: GPL-3.0-or-later */
/* polylines_io - polylines as text: `x y [LABEL]` a line, a blank line ends a polyline. The label
 * of a polyline is that of its first point, a number or a word. */
#ifndef POLYLINES_IO_H
#define POLYLINES_IO_H

#include "polylines.h"

enum { POLYLINES_NAMES_MAX = 256 };

/* Reads path (NULL or "-": stdin); there must be a point. Further columns are ignored. Errors:
 * file:LINE:COL; more than POLYLINES_NAMES_MAX different words. O(text). */
bool polylines_read(struct polylines *p, const char *path, struct err *err) WARN_UNUSED;
void polylines_free(struct polylines *p); /* harmless on a zeroed struct */

#endif
