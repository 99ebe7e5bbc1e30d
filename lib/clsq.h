/* SPDX-License-Identifier: GPL-3.0-or-later */
/* clsq - weighted least squares under linear equations:
 *
 *      minimise  sum_j w_j |x_j - t_j|^2   subject to   A x + F f = 0
 *
 * for k right-hand sides at once ([14] (13)-(23)). A and F have the same rows, which must be
 * independent in A (exact.h chooses such rows). x - t = W^-1 A^T (A W^-1 A^T)^-1 (-F f - A t).
 * Everything is scaled by powers of two; the normal matrix is factored by CHOLMOD's simplicial
 * LDL^T, which calls no BLAS; residuals are kept in triple-double, the solution in double-double,
 * and refined until the error is about 2^-110 of the solution. Then each x is rounded once, so that
 * the result has the same bits whatever the BLAS, the compiler or the number of threads. Where
 * refinement does not contract, a QR factorisation (SuiteSparseQR) with the same refinement takes
 * over.
 *
 * Accuracy: each x_j is the exact solution rounded correctly, but for an error of at most 2^-104
 * max |x - t|. Points in no row keep their bits. Weights may be any positive doubles; neither
 * ratios of 10^12 between them nor rows as near to dependent as a condition number of 10^12 hurt;
 * far beyond that the problem is refused. */
#ifndef CLSQ_H
#define CLSQ_H

#include "err.h"
#include "sparse.h"

struct clsq_problem {
    const struct int_matrix *a; /* m x n, rows independent over Q */
    const struct int_matrix *f; /* m x p */
    int k;                      /* right-hand sides, 1 or 2 */
    const double *weight;       /* n, > 0 */
    const double *target;       /* n x k, row-major */
    const double *fixed;        /* p x k, row-major: the f above */
    bool use_qr;                /* QR at once; the same bits, slower: for tests */
};

struct clsq_report {
    int refinements; /* steps until the correction was negligible */
    bool by_qr;      /* the fallback was needed */
};

/* Fills x (n x k, row-major; undefined after a failure). m = 0 copies the target. Refuses
 * (ERR_REFUSAL) where even QR does not contract: A is too near to dependent for doubles; and where
 * x overflows. Cost: near-linear for planar problems; 50 us for 50 x 121, 0.6 s for 96,361 x
 * 193,600. */
bool clsq_solve(const struct clsq_problem *problem, double *x, struct clsq_report *report,
                struct err *err) WARN_UNUSED;

#endif
