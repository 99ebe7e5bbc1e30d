// SPDX-License-Identifier: GPL-3.0-or-later
/* Cholesky (CHOLMOD, simplicial L D L^T of the normal matrix G^T G, which calls no BLAS):
 *
 *     G^T G l = h - G^T g,    v = G l + g
 *
 * QR (SuiteSparseQR), G E = Q R with a column permutation E. Let Q^T g = (g1, g2) split after m
 * entries; then Q^T v = (y, g2) with
 *
 *     R^T y = E^T h,    R E^T l = y - g1,    v = Q (y, g2)
 *
 * (Bjoerck, "Iterative refinement of linear least squares solutions I", BIT 7, 1967). */
#include "kkt.h"

#include <string.h>

/* After a call into the library: any status below CHOLMOD_OK is memory or a size beyond its
 * integers. */
static bool done(const struct kkt *kkt, struct err *err) {
    return kkt->common.status >= CHOLMOD_OK || err_memory(err);
}

bool kkt_init(struct kkt *kkt, size_t n, size_t m, size_t k, SuiteSparse_long *start,
              SuiteSparse_long *row, double *value, struct err *err) {
    memset(kkt, 0, sizeof *kkt);
    cholmod_common *c = &kkt->common;
    cholmod_l_start(c);
    c->print = 0;
    c->supernodal = CHOLMOD_SIMPLICIAL;
    c->nmethods = 1;
    c->method[0].ordering = CHOLMOD_AMD;
    kkt->g = (cholmod_sparse){.nrow = n,
                              .ncol = m,
                              .nzmax = (size_t)start[m],
                              .p = start,
                              .i = row,
                              .x = value,
                              .itype = CHOLMOD_LONG,
                              .xtype = CHOLMOD_REAL,
                              .dtype = CHOLMOD_DOUBLE,
                              .packed = true};
    kkt->v = cholmod_l_zeros(n, k, CHOLMOD_REAL, c);
    kkt->l = cholmod_l_zeros(m, k, CHOLMOD_REAL, c);
    return done(kkt, err);
}

void kkt_free(struct kkt *kkt) {
    cholmod_common *c = &kkt->common;
    if (!kkt->g.p) return;
    cholmod_l_free_factor(&kkt->cholesky, c);
    SuiteSparseQR_C_free(&kkt->qr, c);
    cholmod_l_free_dense(&kkt->v, c);
    cholmod_l_free_dense(&kkt->l, c);
    cholmod_l_free_dense(&kkt->y, c);
    cholmod_l_free_dense(&kkt->e, c);
    cholmod_l_finish(c);
}

static bool factor_cholesky(struct kkt *kkt, bool *regular, struct err *err) {
    cholmod_common *c = &kkt->common;
    cholmod_sparse *gt = cholmod_l_transpose(&kkt->g, 1, c);
    if (gt) kkt->cholesky = cholmod_l_analyze(gt, c); /* of gt * gt^T: gt is not symmetric */
    if (kkt->cholesky) cholmod_l_factorize(gt, kkt->cholesky, c);
    cholmod_l_free_sparse(&gt, c);
    *regular = kkt->cholesky && kkt->cholesky->minor == kkt->g.ncol;
    return done(kkt, err);
}

static bool factor_qr(struct kkt *kkt, bool *regular, struct err *err) {
    cholmod_common *c = &kkt->common;
    cholmod_l_free_factor(&kkt->cholesky, c);
    kkt->qr = SuiteSparseQR_C_factorize(SPQR_ORDERING_DEFAULT, SPQR_NO_TOL, &kkt->g, c);
    *regular = kkt->qr && (size_t)c->SPQR_istat[4] == kkt->g.ncol; /* [4]: rank */
    return done(kkt, err);
}

bool kkt_factor(struct kkt *kkt, enum kkt_method method, bool *regular, struct err *err) {
    return method == KKT_QR ? factor_qr(kkt, regular, err) : factor_cholesky(kkt, regular, err);
}

static bool solve_cholesky(struct kkt *kkt, struct err *err) {
    cholmod_common *c = &kkt->common;
    double plus[2] = {1, 0}, minus[2] = {-1, 0};
    cholmod_dense *l = NULL;
    cholmod_l_sdmult(&kkt->g, true, minus, plus, kkt->v, kkt->l, c);
    cholmod_l_solve2(CHOLMOD_A, kkt->cholesky, kkt->l, NULL, &l, NULL, &kkt->y, &kkt->e, c);
    if (!done(kkt, err)) return false;
    cholmod_l_free_dense(&kkt->l, c);
    kkt->l = l;
    cholmod_l_sdmult(&kkt->g, false, plus, plus, kkt->l, kkt->v, c);
    return done(kkt, err);
}

/* Of y and q = Q^T g, n x k: y becomes (y, g2), q becomes y - g1. */
static void exchange(cholmod_dense *y, cholmod_dense *q, size_t m) {
    double *top = y->x, *turned = q->x;
    for (size_t c = 0; c < y->ncol; c++) {
        for (size_t i = 0; i < y->nrow; i++) {
            size_t at = i + c * y->nrow;
            double g = turned[at];
            turned[at] = i < m ? top[at] - g : 0;
            if (i >= m) top[at] = g;
        }
    }
}

static bool solve_qr(struct kkt *kkt, struct err *err) {
    cholmod_common *c = &kkt->common;
    cholmod_dense *v = NULL, *l = NULL;
    cholmod_dense *y = SuiteSparseQR_C_solve(SPQR_RTX_EQUALS_ETB, kkt->qr, kkt->l, c);
    cholmod_dense *q = SuiteSparseQR_C_qmult(SPQR_QTX, kkt->qr, kkt->v, c);
    if (y && q) {
        exchange(y, q, kkt->g.ncol);
        l = SuiteSparseQR_C_solve(SPQR_RETX_EQUALS_B, kkt->qr, q, c);
        v = SuiteSparseQR_C_qmult(SPQR_QX, kkt->qr, y, c);
    }
    cholmod_l_free_dense(&y, c);
    cholmod_l_free_dense(&q, c);
    cholmod_l_free_dense(&kkt->l, c);
    cholmod_l_free_dense(&kkt->v, c);
    kkt->l = l;
    kkt->v = v;
    return (l && v) || err_memory(err);
}

bool kkt_solve(struct kkt *kkt, struct err *err) {
    return kkt->qr ? solve_qr(kkt, err) : solve_cholesky(kkt, err);
}
