/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unknown i is the value at vertex list[i]. Residuals b - L x are sums of five numbers in
 * double-double; a step solves for the correction in plain doubles. */
#include "icc_green.h"

#include "dd.h"
#include "mem.h"

#include <math.h>
#include <string.h>
#include <suitesparse/cholmod.h>

#define STEP_MAX  0x1p-60  /* relative to each value, for the last step: its error is far smaller */
#define VALUE_MIN 0x1p-900 /* of the value at the maximum */
enum { STEPS_MAX = 12 };

struct green {
    const struct icc_domain *d;
    const uint32_t *list;
    uint32_t count;
    uint32_t *number; /* nx ny: of a vertex in the list, from 1 */
    struct dd *b, *x; /* count each */
    cholmod_common common;
    cholmod_sparse *l;
    cholmod_factor *factor;
    cholmod_dense *r, *step, *y, *e;
};

static bool done(const struct green *g, struct err *err) {
    return g->common.status >= CHOLMOD_OK || err_memory(err);
}

static bool green_init(struct green *g, struct err *err) {
    cholmod_common *c = &g->common;
    cholmod_l_start(c);
    c->print = 0;
    c->supernodal = CHOLMOD_SIMPLICIAL;
    c->nmethods = 1;
    c->method[0].ordering = CHOLMOD_AMD;
    g->l = cholmod_l_allocate_sparse(g->count, g->count, (size_t)g->count * 3, true, true, -1,
                                     CHOLMOD_REAL, c);
    g->r = cholmod_l_zeros(g->count, 1, CHOLMOD_REAL, c);
    return done(g, err) && mem_new(g->number, icc_domain_size(g->d), err) &&
           mem_new(g->b, g->count, err) && mem_new(g->x, g->count, err);
}

static void green_free(struct green *g) {
    cholmod_common *c = &g->common;
    cholmod_l_free_sparse(&g->l, c);
    cholmod_l_free_factor(&g->factor, c);
    cholmod_l_free_dense(&g->r, c);
    cholmod_l_free_dense(&g->step, c);
    cholmod_l_free_dense(&g->y, c);
    cholmod_l_free_dense(&g->e, c);
    cholmod_l_finish(c);
    free(g->number);
    free(g->b);
    free(g->x);
}

static void neighbours(const struct green *g, uint32_t i, uint32_t next[4]) {
    uint32_t v = g->list[i], nx = g->d->nx;
    next[0] = g->number[v - nx];
    next[1] = g->number[v - 1];
    next[2] = g->number[v + 1];
    next[3] = g->number[v + nx];
}

/* The lower triangle by columns, rows in rising order. */
static void assemble(struct green *g) {
    SuiteSparse_long *start = g->l->p, *row = g->l->i, n = 0;
    double *value = g->l->x;
    for (uint32_t i = 0; i < g->count; i++) {
        uint32_t next[4];
        SuiteSparse_long first = n + 1;
        start[i] = n;
        row[n] = i;
        value[n++] = 4;
        neighbours(g, i, next);
        for (int k = 0; k < 4; k++) {
            SuiteSparse_long at = n;
            if (next[k] == 0 || next[k] - 1 < i) continue;
            for (; at > first && row[at - 1] > next[k] - 1; at--) row[at] = row[at - 1];
            row[at] = next[k] - 1;
            value[n++] = -1;
        }
    }
    start[g->count] = n;
}

static bool factor(struct green *g, struct err *err) {
    assemble(g);
    g->factor = cholmod_l_analyze(g->l, &g->common);
    if (g->factor) cholmod_l_factorize(g->l, g->factor, &g->common);
    return done(g, err);
}

static void residual(struct green *g) {
    double *r = g->r->x;
    for (uint32_t i = 0; i < g->count; i++) {
        uint32_t next[4];
        struct dd sum = {-4 * g->x[i].hi, -4 * g->x[i].lo};
        neighbours(g, i, next);
        for (int k = 0; k < 4; k++)
            if (next[k]) sum = dd_add(sum, g->x[next[k] - 1]);
        r[i] = dd_add(sum, g->b[i]).hi;
    }
}

/* Adds the step; returns how large it was, relative to the values. */
static double add_step(struct green *g) {
    const double *step = g->step->x;
    double largest = 0, least = 0;
    for (uint32_t i = 0; i < g->count; i++) {
        g->x[i] = dd_add_double(g->x[i], step[i]);
        least = fmax(least, VALUE_MIN * g->x[i].hi);
    }
    for (uint32_t i = 0; i < g->count; i++)
        if (!(fabs(step[i]) <= largest * g->x[i].hi) && g->x[i].hi > least)
            largest = fabs(step[i]) / g->x[i].hi;
    return largest;
}

/* x = L^-1 b. */
static bool solve(struct green *g, struct err *err) {
    memset(g->x, 0, g->count * sizeof *g->x);
    for (int steps = 0; steps < STEPS_MAX; steps++) {
        residual(g);
        cholmod_l_solve2(CHOLMOD_A, g->factor, g->r, NULL, &g->step, NULL, &g->y, &g->e,
                         &g->common);
        if (!done(g, err)) return false;
        if (add_step(g) <= STEP_MAX) return true;
    }
    return err_set(err, ERR_REFUSAL, "precision: the harmonic equation does not converge");
}

static void take(const struct green *g, double *u) {
    double least = 0;
    for (uint32_t i = 0; i < g->count; i++) least = fmax(least, VALUE_MIN * g->x[i].hi);
    for (uint32_t i = 0; i < g->count; i++) u[g->list[i]] = g->x[i].hi > least ? g->x[i].hi : 0;
}

bool icc_green(const struct icc_domain *d, uint32_t maximum, const uint32_t *list, uint32_t count,
               int times, double *u, struct err *err) {
    struct green g = {.d = d, .list = list, .count = count};
    bool ok = green_init(&g, err);
    for (uint32_t i = 0; ok && i < count; i++) g.number[list[i]] = i + 1;
    ok = ok && factor(&g, err);
    if (ok) g.b[g.number[maximum] - 1].hi = 1;
    for (int k = 0; ok && k < times; k++) {
        if (k > 0) memcpy(g.b, g.x, count * sizeof *g.b);
        ok = solve(&g, err);
    }
    if (ok) take(&g, u);
    green_free(&g);
    return ok;
}
