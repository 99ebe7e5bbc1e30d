/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_green - Green's functions of the grid over a cage.
 *
 * L u (v) = 4 u(v) - the sum of u over the four neighbours of v, u = 0 where the list of vertices
 * does not reach. u = L^-1 e, e = 1 at the maximum and 0 elsewhere, is harmonic but there; L^-2 e
 * has the least sum of (L u)^2 of all functions with its value at the maximum. Both are positive.
 *
 * L is factored by CHOLMOD's simplicial LDL^T, which calls no BLAS; the solution is refined in
 * double-double and rounded once, so that its bits depend on no compiler. L being an M-matrix,
 * that is as good, relatively, for values that are tiny because they are far from the maximum: to
 * 2^-900 of the value there; below, the result is 0. */
#ifndef ICC_GREEN_H
#define ICC_GREEN_H

#include "icc_domain.h"

/* u = L^-times e, times 1 or 2, on the vertices of the list, among which is the maximum; u has
 * room for the whole grid, and the rest of it is 0 and stays 0. */
bool icc_green(const struct icc_domain *d, uint32_t maximum, const uint32_t *list, uint32_t count,
               int times, double *u, struct err *err) WARN_UNUSED;

#endif
