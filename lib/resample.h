/* SPDX-License-Identifier: GPL-3.0-or-later */
/* resample - the same spline in another Bezier form: on a finer triangulation, or of a higher
 * degree.
 *
 * Both are linear maps with rational coefficients from the old control points of a triangle to the
 * new ones, which are computed exactly and rounded once: the maps differ by at most an ulp of the
 * net.
 *
 * A piece is a triangle inside a triangle of the old grid, its corners given by integer barycentric
 * coordinates with a common sum. Its control point of weights (i,j,k) is the blossom of the old
 * patch at corner 0 i times, corner 1 j times, corner 2 k times ([LS] 2.8). */
#ifndef RESAMPLE_H
#define RESAMPLE_H

#include "spline.h"

struct piece {
    uint32_t triangle;    /* of the old grid */
    int32_t corner[3][3]; /* barycentric coordinates of corner l: corner[l][0..2] / sum */
};

/* Fills *fine with the map of s on the built grid *g (which moves into it, also on failure):
 * triangle t of g is piece[t]. All coordinate sums are `sum`, a power of two; sum^degree <= 2^53.
 */
bool resample_pieces(const struct spline *s, struct grid *g, const struct piece *piece, int32_t sum,
                     struct spline *fine, struct err *err) WARN_UNUSED;

/* The map of s as a spline of higher degree <= GRID_DEGREE_MAX, on the same triangulation:
 * q'_m = sum over l of C(m0,l0) C(m1,l1) C(m2,l2) / C(D,d) q_l                           [LS] 2.15
 */
bool resample_degree(const struct spline *s, int degree, struct spline *raised,
                     struct err *err) WARN_UNUSED;

/* A deep copy of the grid's defining fields, to be completed by grid_build. */
bool resample_copy_grid(const struct grid *g, struct grid *copy, struct err *err) WARN_UNUSED;

#endif
