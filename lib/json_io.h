/* SPDX-License-Identifier: GPL-3.0-or-later */
/* json_io - a grid as JSON: all that is in the file, and what else a reader would have to derive,
 * the numbers of each triangle's control points and their nominal positions. The members stand in
 * convert-grid(1). */
#ifndef JSON_IO_H
#define JSON_IO_H

#include "out.h"
#include "spline.h"

/* history: comment lines (history.h); digits: of the control points, as in num_print. The result is
 * well-formed UTF-8; other bytes of the history become U+FFFD. */
void json_write(struct out *out, const struct spline *s, const char *history, int digits);

#endif
