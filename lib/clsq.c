// SPDX-License-Identifier: GPL-3.0-or-later
/* With d = x - t and a multiplier lambda for each row, the minimum is where
 *
 *     W d - A^T lambda = 0,      A d = b,      b = -F f - A t.
 *
 * Scaling, all by powers of two and so without any rounding: column j by s_j with 1 <= w_j s_j^2 <
 * 4, row i by r_i so that its largest entry has order 1, each right-hand side so that its largest
 * target or fixed value has. With B = R A S, W' = S W S, d = S u the same equations read
 *
 *     r1 = B^T lambda - W' u = 0,      r2 = R b - B u = 0.
 *
 * Refinement: r1 and r2 are kept as triple-doubles (struct td). They start as 0 and R b. A step
 * solves for a correction (du, dlambda) in plain doubles (kkt.h), adds du to u, and
 *
 *     r1 += B^T dlambda - W' du,      r2 -= B du,
 *
 * where products of doubles are exact and sums lose 2^-155 of the first, largest step. So neither
 * the fast factorisation nor the condition number limits what u, a double-double, can reach, as
 * long as each step is smaller than the one before; lambda itself is never needed. The error left
 * after a step is about step * rate, rate = step / step before; we stop where that is 2^-110 of the
 * solution (and the step itself below 2^-70), both in the norms max |u| and max |d|.
 *
 * Rounding. Symmetric problems have answers that are exactly 0, or halfway between two doubles
 * (means of two doubles often are), where the last dust would decide about bits. So d_j is first
 * rounded to a multiple of 2^-104 max |d| or 2^-96 |d_j|, which keeps every such answer and removes
 * the dust; then t + d is rounded to double.
 *
 * Proof. Factors that are all rounding, of rows nearly parallel, can make steps small that should
 * be large. So at the end r1 and r2 are compared, entry by entry, with what errors of 2^-60 x_j, or
 * 2^-75 max |d|, would make of them. */
#include "clsq.h"

#include "dd.h"
#include "kkt.h"
#include "mem.h"

#include <math.h>
#include <string.h>

#define STEP_MAX  0x1p-70  /* of the solution, for the last step */
#define ERROR_MAX 0x1p-110 /* the same for the error expected after it */
#define DUST_ALL  0x1p-104 /* of the largest d, and */
#define DUST_ONE  0x1p-96  /* of one d_j: what rounding regards as dust is below half of it */
#define PROOF_ONE 0x1p-60  /* of x_j, and */
#define PROOF_ALL 0x1p-75  /* of the largest d: the errors that the residuals may speak of */

/* Bits that a step must gain, in the mean of all. Less is no contraction; a slow Cholesky gives up
 * early, since QR is the quicker way then. */
static const int step_bits[] = {[KKT_CHOLESKY] = 8, [KKT_QR] = 3};

/* All arrays of n or m elements for each right-hand side are column-major. */
struct work {
    const struct clsq_problem *p;
    size_t m, n, k;
    SuiteSparse_long *start, *col; /* A's pattern */
    double *b;                     /* B, entries as in A */
    double *g;                     /* G^T = B W'^-1/2 */
    double *s, *w, *root;          /* s_j, w'_j and its square root */
    double *r;                     /* r_i */
    double *unit;                  /* k powers of two: right-hand sides are divided by them */
    struct dd *u;
    struct td *r1, *r2;
    double *step; /* k: the last step relative to the solution */
    struct kkt kkt;
};

static double power_of_two(int e) {
    return ldexp(1, e);
}

/* The power of two at or below |x| > 0; 2^-900 below that, so that it has an inverse. */
static double magnitude(double x) {
    int e;
    frexp(x, &e);
    return power_of_two(e - 1 < -900 ? -900 : e - 1);
}

static bool work_init(struct work *w, const struct clsq_problem *p, struct err *err) {
    memset(w, 0, sizeof *w);
    w->p = p;
    w->m = p->a->rows, w->n = p->a->cols, w->k = (size_t)p->k;
    size_t nz = p->a->start[w->m];
    return mem_new(w->start, w->m + 1, err) && mem_new(w->col, nz, err) && mem_new(w->b, nz, err) &&
           mem_new(w->g, nz, err) && mem_new(w->s, w->n, err) && mem_new(w->w, w->n, err) &&
           mem_new(w->root, w->n, err) && mem_new(w->r, w->m, err) && mem_new(w->unit, w->k, err) &&
           mem_new(w->step, w->k, err) && mem_new(w->u, w->n * w->k, err) &&
           mem_new(w->r1, w->n * w->k, err) && mem_new(w->r2, w->m * w->k, err);
}

static void work_free(struct work *w) {
    kkt_free(&w->kkt);
    void *const all[] = {w->start, w->col,  w->b,    w->g, w->s,  w->w, w->root,
                         w->r,     w->unit, w->step, w->u, w->r1, w->r2};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) free(all[i]);
}

/* s_j = 2^-e for w_j = 2^(2e) w'_j, 1 <= w'_j < 4. */
static void scale_columns(struct work *w) {
    for (size_t j = 0; j < w->n; j++) {
        int e;
        INVARIANT(w->p->weight[j] > 0 && isfinite(w->p->weight[j]));
        frexp(w->p->weight[j], &e);
        e = (e - 1) & ~1; /* the even number at or below */
        w->w[j] = ldexp(w->p->weight[j], -e);
        w->s[j] = power_of_two(-e / 2);
        w->root[j] = sqrt(w->w[j]);
    }
}

static void scale_rows(struct work *w) {
    const struct int_matrix *a = w->p->a;
    for (size_t i = 0; i < w->m; i++) {
        double largest = 0;
        for (size_t e = a->start[i]; e < a->start[i + 1]; e++)
            largest = fmax(largest, fabs((double)a->value[e]) * w->s[a->col[e]]);
        INVARIANT(largest > 0);
        w->r[i] = 1 / magnitude(largest);
        for (size_t e = a->start[i]; e < a->start[i + 1]; e++) {
            uint32_t j = a->col[e];
            w->col[e] = (SuiteSparse_long)j;
            w->b[e] = (double)a->value[e] * w->s[j] * w->r[i];
            w->g[e] = w->b[e] / w->root[j];
        }
        w->start[i + 1] = (SuiteSparse_long)a->start[i + 1];
    }
}

static void scale_right_hand_sides(struct work *w) {
    const struct clsq_problem *p = w->p;
    for (size_t c = 0; c < w->k; c++) {
        double largest = 0;
        for (size_t j = 0; j < w->n; j++) largest = fmax(largest, fabs(p->target[j * w->k + c]));
        for (size_t j = 0; j < p->f->cols; j++)
            largest = fmax(largest, fabs(p->fixed[j * w->k + c]));
        INVARIANT(isfinite(largest));
        w->unit[c] = magnitude(largest);
    }
}

/* *sum -= row i of the matrix times column c of x, divided by its unit. */
static void subtract_row(struct td *sum, const struct int_matrix *a, size_t i, const double *x,
                         size_t k, size_t c, double per_unit) {
    for (size_t e = a->start[i]; e < a->start[i + 1]; e++)
        td_add_product(sum, -(double)a->value[e], x[a->col[e] * k + c] * per_unit);
}

/* r2 = R b, column by column. */
static void begin_residuals(struct work *w) {
    const struct clsq_problem *p = w->p;
    for (size_t c = 0; c < w->k; c++) {
        double per_unit = 1 / w->unit[c];
        for (size_t i = 0; i < w->m; i++) {
            struct td *sum = &w->r2[c * w->m + i];
            subtract_row(sum, p->a, i, p->target, w->k, c, per_unit);
            subtract_row(sum, p->f, i, p->fixed, w->k, c, per_unit);
            td_renormalise(sum);
            for (int q = 0; q < 3; q++) sum->s[q] *= w->r[i];
        }
    }
}

/* Takes the correction v, l out of the residuals of column c, and v becomes du = W'^-1/2 v. */
static void take_correction(struct work *w, size_t c) {
    double *du = (double *)w->kkt.v->x + c * w->n;
    const double *dlambda = (const double *)w->kkt.l->x + c * w->m;
    struct td *r1 = w->r1 + c * w->n, *r2 = w->r2 + c * w->m;
    for (size_t j = 0; j < w->n; j++) {
        du[j] /= w->root[j];
        td_add_product(&r1[j], -w->w[j], du[j]);
    }
    for (size_t i = 0; i < w->m; i++) {
        for (SuiteSparse_long e = w->start[i]; e < w->start[i + 1]; e++) {
            SuiteSparse_long j = w->col[e];
            td_add_product(&r1[j], w->b[e], dlambda[i]);
            td_add_product(&r2[i], -w->b[e], du[j]);
        }
        td_renormalise(&r2[i]);
    }
    for (size_t j = 0; j < w->n; j++) td_renormalise(&r1[j]);
}

/* Adds du to u; returns its size relative to the new u, in the worse of the two norms. */
static double add_correction(struct work *w, size_t c) {
    const double *du = (const double *)w->kkt.v->x + c * w->n;
    struct dd *u = w->u + c * w->n;
    double size_u = 0, size_d = 0, step_u = 0, step_d = 0;
    for (size_t j = 0; j < w->n; j++) {
        u[j] = dd_add_double(u[j], du[j]);
        size_u = fmax(size_u, fabs(u[j].hi));
        size_d = fmax(size_d, fabs(u[j].hi) * w->s[j]);
        step_u = fmax(step_u, fabs(du[j]));
        step_d = fmax(step_d, fabs(du[j]) * w->s[j]);
        if (!isfinite(u[j].hi)) return INFINITY;
    }
    return size_d == 0 ? 0 : fmax(step_u / size_u, step_d / size_d);
}

/* One step for all right-hand sides. *error: the largest that is expected to be left, INFINITY
 * where a column does not contract. */
static bool refine_once(struct work *w, int steps, int bits, double *error, struct err *err) {
    double *v = w->kkt.v->x, *l = w->kkt.l->x;
    for (size_t c = 0; c < w->k; c++)
        for (size_t j = 0; j < w->n; j++) v[c * w->n + j] = w->r1[c * w->n + j].s[0] / w->root[j];
    for (size_t i = 0; i < w->k * w->m; i++) l[i] = w->r2[i].s[0];
    if (!kkt_solve(&w->kkt, err)) return false;
    *error = 0;
    for (size_t c = 0; c < w->k; c++) {
        take_correction(w, c);
        double step = add_correction(w, c), before = w->step[c];
        double left = step == 0 ? 0 : step * fmin(1, step / before);
        if (step > STEP_MAX) left = step;
        if (step > power_of_two(-bits * steps)) left = INFINITY;
        *error = fmax(*error, left);
        w->step[c] = step;
    }
    return true;
}

/* Solves with one method from the beginning; *converged tells whether it did. */
static bool refine(struct work *w, enum kkt_method method, struct clsq_report *report,
                   bool *converged, struct err *err) {
    double error = INFINITY;
    if (!kkt_factor(&w->kkt, method, converged, err)) return false;
    if (!*converged) return true;
    memset(w->u, 0, w->n * w->k * sizeof *w->u);
    memset(w->r1, 0, w->n * w->k * sizeof *w->r1);
    memset(w->r2, 0, w->m * w->k * sizeof *w->r2);
    begin_residuals(w);
    for (size_t c = 0; c < w->k; c++) w->step[c] = 1;
    report->refinements = -1; /* the first step is the solution itself */
    do {
        if (!refine_once(w, ++report->refinements, step_bits[method], &error, err)) return false;
    } while (error > ERROR_MAX && error < INFINITY);
    *converged = error <= ERROR_MAX;
    return true;
}

/* The integer nearest to y; from 2^52 on there is nothing else. */
static double nearest_integer(double y) {
    if (fabs(y) >= 0x1p52) return y;
    double shift = copysign(0x1p52, y);
    return (y + shift) - shift;
}

/* The multiple of quantum, a power of two, nearest to d. */
static struct dd quantise(struct dd d, double quantum) {
    double hi = nearest_integer(d.hi / quantum) * quantum;
    return dd_two_sum(hi, nearest_integer((d.lo + (d.hi - hi)) / quantum) * quantum);
}

static double largest_of(const struct work *w, size_t c) {
    double largest = 0;
    for (size_t j = 0; j < w->n; j++)
        largest = fmax(largest, fabs(w->u[c * w->n + j].hi) * w->s[j]);
    return largest;
}

/* What such errors of the points and fixed points can add up to in row i of column c, scaled as r2.
 * absolute: PROOF_ALL times the largest d. */
static double row_tolerance(const struct work *w, const double *x, size_t i, size_t c,
                            double absolute) {
    const struct int_matrix *a = w->p->a, *f = w->p->f;
    double sum = 0, relative = PROOF_ONE / w->unit[c];
    for (size_t e = a->start[i]; e < a->start[i + 1]; e++)
        sum += fabs((double)a->value[e]) * (fabs(x[a->col[e] * w->k + c]) * relative + absolute);
    for (size_t e = f->start[i]; e < f->start[i + 1]; e++)
        sum += fabs((double)f->value[e] * w->p->fixed[f->col[e] * w->k + c] * relative);
    return sum * w->r[i];
}

/* Do the residuals prove x? */
static bool proved(const struct work *w, const double *x) {
    for (size_t c = 0; c < w->k; c++) {
        const struct td *r1 = w->r1 + c * w->n, *r2 = w->r2 + c * w->m;
        double absolute = largest_of(w, c) * PROOF_ALL, relative = PROOF_ONE / w->unit[c];
        for (size_t i = 0; i < w->m; i++)
            if (!(fabs(r2[i].s[0]) <= row_tolerance(w, x, i, c, absolute))) return false;
        for (size_t j = 0; j < w->n; j++) {
            double d = fabs(r1[j].s[0]) / w->w[j] * w->s[j];
            if (!(d <= fabs(x[j * w->k + c]) * relative + absolute)) return false;
        }
    }
    return true;
}

/* x = t + d, rounded. Points that do not move keep their bits. */
static void finish(const struct work *w, double *x) {
    for (size_t c = 0; c < w->k; c++) {
        const struct dd *u = w->u + c * w->n;
        double dust = largest_of(w, c) * DUST_ALL;
        for (size_t j = 0; j < w->n; j++) {
            double t = w->p->target[j * w->k + c];
            struct dd d = {u[j].hi * w->s[j], u[j].lo * w->s[j]};
            if (d.hi != 0) d = quantise(d, magnitude(fmax(dust, fabs(d.hi) * DUST_ONE)));
            d = (struct dd){d.hi * w->unit[c], d.lo * w->unit[c]};
            x[j * w->k + c] = d.hi == 0 ? t : dd_add_double(d, t).hi;
        }
    }
}

/* One method from factors to proof; *solved tells whether it did. */
static bool try(struct work *w, enum kkt_method method, double *x, struct clsq_report *report,
                bool *solved, struct err *err) {
    report->by_qr = method == KKT_QR;
    if (!refine(w, method, report, solved, err)) return false;
    if (!*solved) return true;
    finish(w, x);
    for (size_t j = 0; j < w->n * w->k; j++)
        if (!isfinite(x[j]))
            return err_set(err, ERR_REFUSAL, "the solution is too large for a double");
    *solved = proved(w, x);
    return true;
}

static bool solve(struct work *w, double *x, struct clsq_report *report, struct err *err) {
    bool solved = false;
    scale_columns(w);
    scale_rows(w);
    scale_right_hand_sides(w);
    if (!kkt_init(&w->kkt, w->n, w->m, w->k, w->start, w->col, w->g, err)) return false;
    if (!w->p->use_qr && !try(w, KKT_CHOLESKY, x, report, &solved, err)) return false;
    if (!solved && !try(w, KKT_QR, x, report, &solved, err)) return false;
    return solved ||
           err_set(err, ERR_REFUSAL, "conditions too near to dependent for double precision");
}

bool clsq_solve(const struct clsq_problem *problem, double *x, struct clsq_report *report,
                struct err *err) {
    struct work w;
    *report = (struct clsq_report){0};
    if (problem->a->rows == 0) {
        size_t n = problem->a->cols * (size_t)problem->k;
        for (size_t i = 0; i < n; i++) x[i] = problem->target[i];
        return true;
    }
    bool ok = work_init(&w, problem, err) && solve(&w, x, report, err);
    work_free(&w);
    return ok;
}
