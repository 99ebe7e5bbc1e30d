/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dense - dense linear algebra for tests, slow and plain, sharing nothing with lib/. */
#ifndef DENSE_H
#define DENSE_H

#include <stddef.h>
#include <stdint.h>

/* Rank of an m x n integer matrix (row-major) over Q: the larger of its ranks modulo two primes.
 * Never too large; too small only if both primes happen to divide the same minors. O(m^2 n). */
size_t dense_rank(const int64_t *a, size_t m, size_t n);

/* Minimises sum w_j (x_j - t_j)^2 subject to sum_j a_ij x_j = b_i, rows of a in any number and of
 * any rank, in long double: Gram-Schmidt, twice, with pivoting on the rows of A W^-1/2. Returns the
 * largest |A x - b| relative to the row's norm: large if the equations contradict each other. */
long double dense_least_squares(const long double *a, const long double *b, size_t m, size_t n,
                                const double *weight, const double *target, long double *x);

#endif
