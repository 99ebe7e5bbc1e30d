/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ray - how often a Bezier arc crosses the ray that leaves a point to the left.
 *
 * A closed curve of arcs winds round the point as often as it crosses the ray downwards less
 * upwards. To that end let a point of the curve be high if its y is larger than that of the point
 * p, else low. What lies left of p crosses upwards as often as its end is high, less its beginning;
 * what has no point on the ray, not at all; and an arc falls into such pieces unless it runs
 * through p. All is decided exactly. */
#ifndef RAY_H
#define RAY_H

#include <stdbool.h>

/* Adds to *winding the crossings downwards less upwards of an arc of degree d; false if that is not
 * found within 128 halvings, as where the arc runs through p. 10 ns unless p lies in the box of the
 * control points. */
bool ray_winding(int d, const double (*q)[2], const double p[2], int *winding);

#endif
