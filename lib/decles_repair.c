/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The projection onto the C1 splines is the edit without anchors in which all points are slaves,
 * each with its own position as the suggested one, and E is all conditions. */
#include "decles.h"

#include "decles_rank.h"
#include "decles_sets.h"
#include "decles_solve.h"
#include "mem.h"

#include <string.h>

static bool is_smooth(const struct grid *g, const struct c1_field *v) {
    for (uint32_t e = 0; e < g->edge_count; e++) {
        if (!grid_edge_is_inner(g, e)) continue;
        for (int m = 0; m < g->degree; m++) {
            struct c1_condition condition = c1_condition(g, e, m);
            for (int c = 0; c < v->k; c++)
                if (!c1_holds(c1_evaluate(&condition, v, c))) return false;
        }
    }
    return true;
}

/* D = all points, E = all conditions. */
static bool take_all(struct decles_sets *sets, const struct grid *g, struct err *err) {
    struct decles_edit edit = {.slave_count = g->point_count};
    uint32_t *all;
    bool ok;
    if (!mem_new(all, g->point_count, err)) return false;
    for (uint32_t p = 0; p < g->point_count; p++) all[p] = p;
    edit.slave = all;
    ok = decles_sets_begin(sets, &edit, err);
    free(all);
    return ok;
}

static bool project(const struct decles_sets *sets, const struct exact_rows *rows,
                    const struct c1_field *v, struct err *err) {
    size_t n = sets->derived_count, k = (size_t)v->k;
    struct decles_targets targets = {.k = v->k};
    struct clsq_report report;
    double *from = NULL, *to = NULL, *weight = NULL;
    bool ok = mem_new(from, n * k, err) && mem_new(to, n * k, err) && mem_new(weight, n, err);
    for (size_t p = 0; ok && p < n; p++) {
        memcpy(from + p * k, v->q + p * v->stride, k * sizeof *from);
        weight[p] = 1;
    }
    targets.suggested = from;
    targets.weight = weight;
    ok = ok && decles_solve(sets, rows, &targets, to, &report, err);
    for (size_t p = 0; ok && p < n; p++) memcpy(v->q + p * v->stride, to + p * k, k * sizeof *to);
    free(from);
    free(to);
    free(weight);
    return ok;
}

bool decles_repair(const struct grid *g, double *q, size_t stride, int k, struct err *err) {
    struct c1_field values = {q, stride, k, c1_extent(g)};
    struct decles_sets sets;
    struct exact_rows rows = {0};
    bool ok;
    INVARIANT(k == 1 || k == 2);
    if (is_smooth(g, &values)) return true;
    ok = decles_sets_init(&sets, g, true, err) && take_all(&sets, g, err) &&
         decles_rows_init(&rows, &sets, err);
    if (ok && g->degree >= 5) INVARIANT(rows.rank == c1_rank_formula(g));
    ok = ok && project(&sets, &rows, &values, err);
    exact_rows_free(&rows);
    decles_sets_free(&sets);
    return ok;
}
