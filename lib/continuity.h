/* SPDX-License-Identifier: GPL-3.0-or-later */
/* continuity - how smooth a spline is, and how much freedom its conditions leave.
 *
 * Across the inner edge {a,b} of triangles u and v, with opposite vertices u0 and v0, a spline is
 * C^r exactly if for all n <= r and j+k = d-n
 *
 *     q^v_njk = sum over s+t+w=n of n!/(s!t!w!) B0^s B1^t B2^w q^u_s,j+t,k+w      [11] Theorem 3.1
 *
 * B being the barycentric coordinates of v0 in (u0,a,b); n = 1 are the quadrilateral conditions of
 * c1.h. If all hold up to n = d, both triangles have the same polynomial. */
#ifndef CONTINUITY_H
#define CONTINUITY_H

#include "spline.h"

/* The order of continuity of phi and, with depth, of sigma0 and sigma1 across the inner edge e, 0
 * to d. Conditions of order 1 hold if c1_holds says so; those of order n within 64 n u of their
 * terms, summed likewise. */
int continuity_order(const struct spline *s, uint32_t e, double extent);

struct continuity {
    uint32_t edges[GRID_DEGREE_MAX + 1]; /* inner edges of each order */
    double absolute, relative;           /* largest residuals of c1_residual, of all components */
    uint32_t worst;                      /* where, or GRID_NONE */
    size_t conditions, rank;             /* of order 1, on one component; the rank is exact */
};

/* 1 us an inner edge, and the exact rank (exact.h). */
bool continuity_survey(struct continuity *c, const struct spline *s, struct err *err) WARN_UNUSED;

#endif
