/* SPDX-License-Identifier: GPL-3.0-or-later */
/* predicate - exact signs. A floating-point filter first, GMP rationals where it does not decide.
 */
#ifndef PREDICATE_H
#define PREDICATE_H

#include <math.h>
#include <stdint.h>

/* World position of the integer lattice point (X, Y): the real numbers x0 + step*X, y0 + step*Y
 * themselves are meant, not their roundings (formats.md, grid). step > 0. */
struct lattice {
    double step, x0, y0;
};

/* Twice the signed area of a lattice triangle in lattice units, > 0 counter-clockwise. Exact for
 * |X|, |Y| <= 2^24: below 2^53. */
int64_t predicate_area2(const int32_t a[2], const int32_t b[2], const int32_t c[2]);

/* Sign of the signed area of a, b, p for lattice points a, b and a world point p: +1 where p lies
 * left of a->b, 0 on the line, -1 right. Exact for any finite p. */
int predicate_side(const struct lattice *lattice, const int32_t a[2], const int32_t b[2],
                   const double p[2]);

/* The same for three world points. */
int predicate_orient(const double a[2], const double b[2], const double c[2]);

/* The same where the third point is the exact sum of c and rest. */
int predicate_orient_sum(const double a[2], const double b[2], const double c[2],
                         const double rest[2]);

/* The filter of predicate_side, for inner loops: an approximation of
 *     (Xb - Xa) (py - y0 - step Ya) - (Yb - Ya) (px - x0 - step Xa),
 * twice the area of a, b, p over step. Its sign is right where its magnitude exceeds *bound; *bound
 * is never negative (infinite or NaN where the computation overflows, so compare with ">").
 *
 * With u = 2^-53 and my = |py| + |y0| + |step Ya|, the bracket e = py - y0 - step Ya takes three
 * roundings, each of a number of magnitude <= my (1+u)^2: error <= 3u my to first order. The
 * product with the exact integer adds u |dx e| <= u |dx| my, the final difference u (|dx| my +
 * |dy| mx): 5u in all, to first order; 8u covers the terms of second order and the roundings of
 * the bound itself. Products of an integer and a double are exact where they are subnormal. */
static inline double predicate_side_filter(const struct lattice *lattice, const int32_t a[2],
                                           const int32_t b[2], const double p[2], double *bound) {
    double sx = lattice->step * a[0], sy = lattice->step * a[1];
    double ex = p[0] - (lattice->x0 + sx), ey = p[1] - (lattice->y0 + sy);
    double dx = b[0] - a[0], dy = b[1] - a[1];
    *bound = 0x1p-50 * (fabs(dx) * (fabs(p[1]) + fabs(lattice->y0) + fabs(sy)) +
                        fabs(dy) * (fabs(p[0]) + fabs(lattice->x0) + fabs(sx)));
    return dx * ey - dy * ex;
}

/* The same for predicate_orient_sum: an approximation of (bx-ax)(cy+ry-ay) - (by-ay)(cx+rx-ax),
 * twice the area of a, b, c + r, where r is at most half an ulp of c. Differences carry a relative
 * error u, sums with r another: c - a is exact unless it is far larger than r. The products and the
 * last difference add u each: |error| <= 5u (|l| + |r|) to first order, plus half of the least
 * subnormal for a product that underflows. */
static inline double predicate_orient_filter(const double a[2], const double b[2],
                                             const double c[2], const double rest[2],
                                             double *bound) {
    double l = (b[0] - a[0]) * (c[1] - a[1] + rest[1]);
    double r = (b[1] - a[1]) * (c[0] - a[0] + rest[0]);
    *bound = 0x1p-50 * (fabs(l) + fabs(r)) + 0x1p-1072;
    return l - r;
}

#endif
