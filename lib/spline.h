/* SPDX-License-Identifier: GPL-3.0-or-later */
/* spline - a deformation: a grid and control points.
 *
 *   phi(p) = sum q_ijk B_ijk(b),  B_ijk = d!/(i!j!k!) b0^i b1^j b2^k             [14] (1)(2)
 *   psi(x,y,z) = (phi(x,y), a0 sigma0(x,y) + a1 sigma1(x,y)),                    [11] (9)
 *   a0 = (b-z)/(b-a), a1 = (z-a)/(b-a)
 *
 * Evaluation works on displacements, q - nominal position, and adds the point itself: the same
 * value up to rounding, and where all control points of a triangle are nominal, psi is the identity
 * bit for bit. */
#ifndef SPLINE_H
#define SPLINE_H

#include "grid.h"

struct spline {
    struct grid grid;
    double (*phi)[2]; /* point_count control points of phi, world units */
    double (
        *sigma)[2]; /* with depth: coefficients of sigma0 (bottom) and sigma1 (top); else NULL */
};

/* Room for the control points on the built grid *g, whose ownership moves into the spline (also on
 * failure); they are 0. */
bool spline_allocate(struct spline *s, struct grid *g, struct err *err) WARN_UNUSED;

/* The identity on the built grid *g, whose ownership moves into the spline (also on failure). */
bool spline_identity(struct spline *s, struct grid *g, struct err *err) WARN_UNUSED;
void spline_free(struct spline *s);

/* Value and, if jacobian is not NULL, the exact derivative of psi at p = (x, y, depth) in the
 * grid's axes, which lies in triangle t at barycentric coordinates b. Without depth z passes
 * through and jacobian[2] = (0,0,1). jacobian[r][c] = d psi_r / d p_c. Nested Bernstein scheme,
 * O(degree^2). */
void spline_evaluate(const struct spline *s, uint32_t t, const double b[3], const double p[3],
                     double value[3], double jacobian[3][3]);

/* The same for many points: nominal positions are computed once, and what a triangle needs is
 * gathered when the triangle changes. The results are the same bit for bit. */
struct spline_cursor {
    const struct spline *spline; /* borrowed, unchanged while the cursor lives */
    double *shift;               /* displacements of all control points */
    double *patch;               /* those of `triangle` */
    uint32_t triangle;
};
bool spline_cursor_init(struct spline_cursor *c, const struct spline *s,
                        struct err *err) WARN_UNUSED;
void spline_cursor_free(struct spline_cursor *c);
void spline_cursor_evaluate(struct spline_cursor *c, uint32_t t, const double b[3],
                            const double p[3], double value[3], double jacobian[3][3]);

/* The displacement of phi and, with depth, of sigma0 and sigma1 at b in triangle t: 2 or 4 numbers,
 * exactly 0 where all control points that count there are nominal. */
void spline_cursor_shift(struct spline_cursor *c, uint32_t t, const double b[3], double *shift);

#endif
