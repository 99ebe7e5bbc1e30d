/* SPDX-License-Identifier: GPL-3.0-or-later */
/* curve - Bezier curves of any degree as cubic ones, for drawing. */
#ifndef CURVE_H
#define CURVE_H

#include "drawing.h"

enum { CURVE_DEGREE_MAX = 15 };

/* Continues the path, which stands at q[0], to q[degree] along the Bezier curve with these control
 * points, by cubic curves that leave it nowhere by more than the tolerance, at the same parameter.
 * Degrees up to 3 are exact. */
void curve_draw(struct drawing *d, int degree, const double (*q)[2], double tolerance);

#endif
