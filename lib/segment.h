/* SPDX-License-Identifier: GPL-3.0-or-later */
/* segment - the straight way from a to b, a and b not the same: points on it and near it. Rounded.
 */
#ifndef SEGMENT_H
#define SEGMENT_H

#include <math.h>

static inline double segment_length(const double a[2], const double b[2]) {
    double x = b[0] - a[0], y = b[1] - a[1];
    return sqrt(x * x + y * y);
}

/* a + lambda (b - a), from the nearer end: so both ends are exact, and the sense of the segment
 * does not matter. */
static inline void segment_point(const double a[2], const double b[2], double lambda, double p[2]) {
    for (int k = 0; k < 2; k++)
        p[k] = lambda <= 0.5 ? a[k] + lambda * (b[k] - a[k]) : b[k] - (1 - lambda) * (b[k] - a[k]);
}

/* The square of the distance of p; *lambda in [0,1]: where the nearest point is. */
static inline double segment_distance2(const double a[2], const double b[2], const double p[2],
                                       double *lambda) {
    double x = b[0] - a[0], y = b[1] - a[1], dx = p[0] - a[0], dy = p[1] - a[1];
    *lambda = fmin(fmax((dx * x + dy * y) / (x * x + y * y), 0), 1);
    dx -= *lambda * x;
    dy -= *lambda * y;
    return dx * dx + dy * dy;
}

#endif
