/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bernstein - polynomials in Bernstein form on a triangle.
 *
 *   f(b) = sum over i+j+k=d of c_ijk * d!/(i!j!k!) * b0^i b1^j b2^k                     [14] (1)(2)
 *
 * Coefficients stand in the order of grid_patch, i descending, then j descending, each with n
 * components side by side, 1 <= n <= 4: c[n * (r(r+1)/2 + k) + m], r = d - i. 0 <= d <= 15. Both
 * calls cost O(n d^2) by nested multiplication; for b >= 0 they add only terms of the sum's own
 * signs, so the error is some d units in the last place of sum |c_ijk B_ijk|. */
#ifndef BERNSTEIN_H
#define BERNSTEIN_H

void bernstein_value(int degree, int n, const double *c, const double b[3], double *value);

/* Value and partial derivatives of the form above, b0, b1, b2 taken as independent:
 * gradient[n * l + m] = df_m / db_l. The derivative along a direction whose barycentric coordinates
 * are e (sum 0) is e0 g0 + e1 g1 + e2 g2. degree >= 1. */
void bernstein_gradient(int degree, int n, const double *c, const double b[3], double *value,
                        double *gradient);

#endif
