/* SPDX-License-Identifier: GPL-3.0-or-later */
/* inverse_row - the preimages of many points that follow each other evenly along lines, as the
 * pixels of an image do, in a tenth of the time that inverse.h takes for each of them.
 *
 * Under a map that has been proved to be one-to-one, any preimage of a point is the preimage. So
 * the preimages of the three points before tell where to begin, and Newton's method goes on from
 * there, on the polynomial of the triangle that holds the point. With
 *
 *   J  the derivative of phi at the beginning, r = phi(p) - q, step = J^-1 r,
 *   K  a Lipschitz constant of the derivative,  h = |J^-1| K |step|
 *
 * a step with h <= 1/4 ends within 2 h |step| of a preimage (Newton and Kantorovich); steps are
 * taken until that is no more than the tolerance. What ends outside its triangle is tried in the
 * neighbour's. Where all this does not work in a few steps, for the first points, near the boundary
 * and of maps that are not one-to-one, inverse_find is asked. */
#ifndef INVERSE_ROW_H
#define INVERSE_ROW_H

#include "inverse.h"

/* A preimage. */
struct inverse_spot {
    uint32_t triangle;       /* GRID_NONE: outside */
    double p[2];             /* world units */
    double derivative[2][2]; /* of the inverse map: [r][c] = d p_r / d q_c; about as exact as a
                                pixel's footprint needs, infinite or NaN where phi is singular */
};

struct inverse_row {
    struct inverse_cursor cursor;
    double tolerance;
    /* private */
    struct spline_cursor spline;
    struct inverse_patch *patch; /* that of triangle t is in slot t mod slots; NULL: none is used */
    uint32_t slots;
    uint32_t alike; /* how many points until now were in triangle `last` */
    uint32_t last;
};

/* The index is borrowed. `tolerance` is that of preimages, in world units, beside the few ulp of
 * inverse.h. */
bool inverse_row_init(struct inverse_row *r, const struct inverse *v, double tolerance,
                      struct err *err) WARN_UNUSED;
void inverse_row_free(struct inverse_row *r); /* harmless on a zeroed struct */

/* The preimages of n points, fast if they follow each other evenly. */
void inverse_row_find(struct inverse_row *r, size_t n, const double (*q)[2],
                      struct inverse_spot *spot);

#endif
