/* SPDX-License-Identifier: GPL-3.0-or-later */
/* predicate - exact signs. A floating-point filter first, GMP rationals where it does not decide.
 */
#ifndef PREDICATE_H
#define PREDICATE_H

#include <stdint.h>

/* World position of the integer lattice point (X, Y): the real numbers x0 + step*X, y0 + step*Y
 * themselves are meant, not their roundings (formats.md, grid). */
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

#endif
