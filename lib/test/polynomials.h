/* SPDX-License-Identifier: GPL-3.0-or-later */
/* polynomials - oracles for splines, in long double: polynomial maps, whose control points are
 * their blossoms, and the defining sum over control points. */
#ifndef POLYNOMIALS_H
#define POLYNOMIALS_H

#include "spline.h"

#include "testing.h"

enum { TERMS = GRID_DEGREE_MAX + 1 };

/* sum c[p][q] x^p y^q, p + q <= degree */
struct polynomial {
    int degree;
    long double c[TERMS][TERMS];
};

/* f itself, or its derivative by x (dx = 1) or y (dy = 1). */
long double polynomial_value(const struct polynomial *f, int dx, int dy, long double x,
                             long double y);

/* Coefficients that shrink as in a map of the unit square. */
void random_polynomial(struct polynomial *f, int degree, uint64_t *s);

/* World position of a vertex. */
void world_of(const struct grid *g, uint32_t v, long double xy[2]);

/* The spline on the built grid *g, which moves into it, whose components (phi, and with depth
 * sigma) are these polynomials, of degrees no higher than the grid's; f NULL: the identity. The
 * same on every triangle, so triangles fit together to any order. */
void polynomial_spline(struct spline *s, struct grid *g, const struct polynomial *f);

/* phi by its defining sum, sum q_ijk d!/(i!j!k!) b0^i b1^j b2^k, and its derivative by x and y
 * (unless NULL). */
void sum_at(const struct spline *s, uint32_t t, const long double b[3], long double value[2],
            long double jacobian[2][2]);

/* The least and the largest singular value. */
void singular_values(long double j[2][2], long double *least, long double *largest);

#endif
