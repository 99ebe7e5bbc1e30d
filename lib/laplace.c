/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Refinement. Where u = 0 for all free vertices, the residual r_i = sum_j w_ij (u_j - u_i) is that
 * of the fixed vertices alone. A step solves A d = r in plain doubles, adds d to u and takes
 *
 *     r_i += sum_j w_ij (d_j - d_i)
 *
 * What makes that exact and cheap is that d is first rounded to multiples of a quantum, 2^-26 of
 * the largest |d|: so differences of d are exact, their products with a weight are double-doubles,
 * and u, a sum of such d, is exact as a double-double. The sums r lose 2^-155 of the largest term
 * of the first step, which is all that limits the accuracy in the end. A step leaves an error of
 * half its quantum and whatever the solver is wrong about, so the next must be smaller; that it is
 * not is the only way to fail.
 *
 * Rounding. Symmetric problems have answers that are exactly 0, or halfway between two doubles,
 * where the last dust would decide about bits. So u is first rounded to a multiple of DUST, which
 * keeps such answers, and then to a double. */
#include "laplace.h"

#include "dd.h"
#include "mem.h"

#include <math.h>
#include <string.h>
#include <suitesparse/cholmod.h>

#define QUANTUM  0x1p-26 /* of the largest element of a step */
#define STEP_MAX 0x1p-79 /* of the last step, so that at most 2^-105 is left */
#define GAIN     0x1p-4  /* a step that is larger, relative to the one before, is no contraction */
#define DUST     0x1p-96

/* From so many free vertices on nested dissection pays. */
enum { DISSECT_FROM = 30000 };

struct work {
    size_t fixed, n;          /* vertices that are fixed, and free */
    struct laplace_edge *rim; /* edges with one fixed end, which is end[0] */
    size_t rim_count;
    struct td *r; /* residuals of one coordinate, x or y */
    struct dd *u; /* the solution, of free vertices */
    double *x;    /* a step, at all vertices */
    cholmod_common common;
    cholmod_sparse *a; /* the lower triangle; only weights of edges, off the diagonal, are exact */
    cholmod_factor *factor;
    cholmod_dense *rhs, *d;
    cholmod_dense *y, *e; /* cholmod_solve2's own */
};

/* After a call into the library: any status below CHOLMOD_OK is memory or a size beyond its
 * integers. */
static bool done(const struct work *w, struct err *err) {
    return w->common.status >= CHOLMOD_OK || err_memory(err);
}

static void work_init(struct work *w, const struct laplace_problem *p) {
    memset(w, 0, sizeof *w);
    w->fixed = p->fixed_count;
    w->n = p->vertex_count - p->fixed_count;
    cholmod_start(&w->common);
    w->common.print = 0;
    w->common.supernodal = CHOLMOD_SIMPLICIAL;
    w->common.grow0 = w->common.grow1 = 0; /* no room for updates of the factor */
    w->common.grow2 = 0;
    w->common.nmethods = w->n < DISSECT_FROM ? 1 : 2; /* the better of the two is taken */
    w->common.method[0].ordering = CHOLMOD_AMD;
    w->common.method[1].ordering = CHOLMOD_METIS;
}

static void work_free(struct work *w) {
    cholmod_common *c = &w->common;
    void *const own[] = {w->rim, w->r, w->u, w->x};
    for (size_t i = 0; i < sizeof own / sizeof *own; i++) free(own[i]);
    cholmod_free_sparse(&w->a, c);
    cholmod_free_factor(&w->factor, c);
    cholmod_free_dense(&w->rhs, c);
    cholmod_free_dense(&w->d, c);
    cholmod_free_dense(&w->y, c);
    cholmod_free_dense(&w->e, c);
    cholmod_finish(c);
}

/* ---- the matrix ---- */

static bool list_rim(struct work *w, const struct laplace_problem *p, struct err *err) {
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1 && !mem_new(w->rim, w->rim_count, err)) return false;
        w->rim_count = 0;
        for (size_t e = 0; e < p->edge_count; e++) {
            uint32_t i = p->edge[e].end[0], j = p->edge[e].end[1];
            if ((i < w->fixed) == (j < w->fixed)) continue;
            if (pass == 1)
                w->rim[w->rim_count] =
                    (struct laplace_edge){{i < j ? i : j, i < j ? j : i}, p->edge[e].weight};
            w->rim_count++;
        }
    }
    return true;
}

/* The lower triangle as a list of entries: the diagonal, then the edges between free vertices. */
static cholmod_triplet *entries(struct work *w, const struct laplace_problem *p) {
    cholmod_triplet *t =
        cholmod_allocate_triplet(w->n, w->n, w->n + p->edge_count, -1, CHOLMOD_REAL, &w->common);
    if (!t) return NULL;
    int *row = t->i, *column = t->j;
    double *value = t->x;
    size_t at = w->n;
    for (size_t i = 0; i < w->n; i++) row[i] = column[i] = (int)i, value[i] = 0;
    for (size_t e = 0; e < p->edge_count; e++) {
        size_t i = p->edge[e].end[0], j = p->edge[e].end[1];
        if (i >= w->fixed) value[i - w->fixed] += p->edge[e].weight;
        if (j >= w->fixed) value[j - w->fixed] += p->edge[e].weight;
        if (i < w->fixed || j < w->fixed) continue;
        row[at] = (int)((i > j ? i : j) - w->fixed);
        column[at] = (int)((i > j ? j : i) - w->fixed);
        value[at++] = -p->edge[e].weight;
    }
    t->nnz = at;
    return t;
}

/* Makes the matrix; the edges are not needed after that. */
static bool assemble(struct work *w, struct laplace_problem *p, struct err *err) {
    bool ok = list_rim(w, p, err);
    cholmod_triplet *list = ok ? entries(w, p) : NULL;
    free(p->edge);
    p->edge = NULL;
    if (list) w->a = cholmod_triplet_to_sparse(list, 0, &w->common);
    cholmod_free_triplet(&list, &w->common);
    return ok && done(w, err);
}

/* Gives back what was freed: each step of a large problem needs that room in another shape. */
static void trim(const struct work *w) {
    if (w->n >= DISSECT_FROM) mem_trim();
}

static bool factor(struct work *w, struct err *err) {
    cholmod_common *c = &w->common;
    w->factor = cholmod_analyze(w->a, c);
    trim(w);
    if (w->factor) cholmod_factorize(w->a, w->factor, c);
    if (!done(w, err)) return false;
    cholmod_free_work(c);
    trim(w);
    return w->factor->minor == w->n || err_set(err, ERR_REFUSAL, "precision: a pivot vanished");
}

/* ---- refinement ---- */

/* What a change x adds to the residuals. */
static void add_flows(struct work *w) {
    const int *start = w->a->p, *row = w->a->i;
    const double *value = w->a->x, *x = w->x + w->fixed;
    for (size_t j = 0; j < w->n; j++)
        for (int at = start[j]; at < start[j + 1]; at++) {
            if ((size_t)row[at] == j) continue;
            struct dd flow = dd_two_prod(-value[at], x[row[at]] - x[j]);
            td_add(&w->r[j], flow);
            td_add(&w->r[row[at]], dd_negate(flow));
        }
    for (size_t e = 0; e < w->rim_count; e++) {
        const uint32_t *end = w->rim[e].end;
        td_add(&w->r[end[1] - w->fixed],
               dd_two_prod(w->rim[e].weight, w->x[end[0]] - w->x[end[1]]));
    }
    for (size_t i = 0; i < w->n; i++) td_renormalise(&w->r[i]);
}

/* The integer nearest to y, |y| < 2^51. */
static double nearest_integer(double y) {
    return (y + 0x1.8p52) - 0x1.8p52;
}

/* Takes the step d, rounded to 26 bits. */
static void take_step(struct work *w, const double *d, double largest) {
    int e;
    frexp(largest, &e);
    double quantum = ldexp(QUANTUM, e);
    for (size_t i = 0; i < w->n; i++) {
        double step = nearest_integer(d[i] / quantum) * quantum;
        w->x[w->fixed + i] = step;
        w->u[i] = dd_add_double(w->u[i], step);
    }
    add_flows(w);
}

static double largest_of(const double *d, size_t n) {
    double largest = 0;
    for (size_t i = 0; i < n; i++)
        if (!(fabs(d[i]) <= largest)) largest = fabs(d[i]); /* also if d[i] is no number */
    return largest;
}

/* One step; *size is its largest element. */
static bool refine_once(struct work *w, double *size, struct err *err) {
    double before = *size, *rhs = w->rhs->x;
    for (size_t i = 0; i < w->n; i++) rhs[i] = w->r[i].s[0];
    cholmod_solve2(CHOLMOD_A, w->factor, w->rhs, NULL, &w->d, NULL, &w->y, &w->e, &w->common);
    if (!done(w, err)) return false;
    *size = largest_of(w->d->x, w->n);
    if (!(*size <= before * GAIN))
        return err_set(err, ERR_REFUSAL, "precision: the equations are too near to singular");
    if (*size > 0) take_step(w, w->d->x, *size);
    return true;
}

/* The multiple of DUST nearest to v, then the double nearest to that. */
static double round_once(struct dd v) {
    double hi = fabs(v.hi) < 0x1p51 * DUST ? nearest_integer(v.hi / DUST) * DUST : v.hi;
    return dd_two_sum(hi, nearest_integer((v.lo + (v.hi - hi)) / DUST) * DUST).hi;
}

/* Solves for coordinate k. */
static bool solve(struct work *w, double (*u)[2], int k, struct err *err) {
    double size = 2 / GAIN; /* the first step is the solution itself, in [-1,1] */
    memset(w->r, 0, w->n * sizeof *w->r);
    memset(w->u, 0, w->n * sizeof *w->u);
    for (size_t i = 0; i < w->fixed + w->n; i++) w->x[i] = i < w->fixed ? u[i][k] : 0;
    add_flows(w);
    memset(w->x, 0, w->fixed * sizeof *w->x);
    do {
        if (!refine_once(w, &size, err)) return false;
    } while (size > STEP_MAX);
    for (size_t i = 0; i < w->n; i++) u[w->fixed + i][k] = round_once(w->u[i]);
    return true;
}

static bool make_room(struct work *w, struct err *err) {
    if (!mem_new(w->r, w->n, err) || !mem_new(w->u, w->n, err) ||
        !mem_new(w->x, w->fixed + w->n, err))
        return false;
    w->rhs = cholmod_allocate_dense(w->n, 1, w->n, CHOLMOD_REAL, &w->common);
    return done(w, err);
}

bool laplace_solve(struct laplace_problem *problem, double (*u)[2], struct err *err) {
    struct work w;
    work_init(&w, problem);
    bool ok = assemble(&w, problem, err);
    if (ok && w.n > 0)
        ok = factor(&w, err) && make_room(&w, err) && solve(&w, u, 0, err) && solve(&w, u, 1, err);
    work_free(&w);
    trim(&w);
    return ok;
}
