/* SPDX-License-Identifier: GPL-3.0-or-later */
/* kkt - approximate solutions of the equations of a least norm problem,
 *
 *      [ I   -G ] [ v ]   [ g ]
 *      [ G^T  0 ] [ l ] = [ h ]        G sparse, n x m, of rank m,
 *
 * in plain doubles, for k right-hand sides. Two methods: Cholesky is quick and loses twice as many
 * digits as QR where G is near to dependent (the error of a solution grows with cond(G)^2 and
 * cond(G)). Whoever wants the last bit refines: clsq.h. */
#ifndef KKT_H
#define KKT_H

#include "err.h"

#include <suitesparse/SuiteSparseQR_C.h>

enum kkt_method { KKT_CHOLESKY, KKT_QR };

struct kkt {
    cholmod_dense *v, *l; /* n x k and m x k, column-major: right-hand side, then solution */
    /* private */
    cholmod_common common;
    cholmod_sparse g;
    cholmod_factor *cholesky;
    SuiteSparseQR_C_factorization *qr;
    cholmod_dense *y, *e; /* cholmod_solve2's own */
};

/* G in compressed columns: start has m + 1 entries; borrowed until kkt_free, which is due also
 * after a failure, and harmless on a zeroed struct. */
bool kkt_init(struct kkt *kkt, size_t n, size_t m, size_t k, SuiteSparse_long *start,
              SuiteSparse_long *row, double *value, struct err *err) WARN_UNUSED;
void kkt_free(struct kkt *kkt);

/* Factors G. *regular tells whether kkt_solve may be called: false where a pivot is 0. */
bool kkt_factor(struct kkt *kkt, enum kkt_method method, bool *regular,
                struct err *err) WARN_UNUSED;

/* Overwrites v, l = g, h by the solution, with the factors made last. */
bool kkt_solve(struct kkt *kkt, struct err *err) WARN_UNUSED;

#endif
