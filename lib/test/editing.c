/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "editing.h"

#include "dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *allocate(size_t n, size_t size) {
    void *p = calloc(n ? n : 1, size);
    INVARIANT(p);
    return p;
}

void editing_begin(struct editing *s, struct grid *g, int continuity, double max_gain,
                   uint64_t seed) {
    struct decles_options options = {continuity, max_gain};
    *s = (struct editing){.g = *g, .seed = seed};
    s->q = allocate(g->point_count, 2 * sizeof *s->q);
    s->old = allocate(g->point_count, 2 * sizeof *s->old);
    for (uint32_t p = 0; p < g->point_count; p++) grid_nominal(&s->g, p, s->q + 2 * p);
    for (size_t i = 0; i < 2 * (size_t)g->point_count; i++)
        s->magnitude = fmax(s->magnitude, fabs(s->q[i]));
    memcpy(s->old, s->q, g->point_count * 2 * sizeof *s->q);
    s->editor = decles_new(&s->g, &options, &s->err);
    check_seed(seed, s->editor != NULL);
}

void editing_end(struct editing *s) {
    decles_free(s->editor);
    grid_free(&s->g);
    free(s->q);
    free(s->old);
}

/* E by brute force: every condition with a point of A or D. */
static void check_sets(const struct editing *s, const struct decles_edit *edit) {
    const struct grid *g = &s->g;
    char *inside = allocate(g->point_count, 1);
    size_t n = 0;
    for (size_t i = 0; i < edit->anchor_count; i++) inside[edit->anchor[i].point] = 1;
    for (size_t i = 0; i < s->report.derived; i++) {
        check_seed(s->seed, inside[s->report.derived_point[i]] == 0);
        check_seed(s->seed, !decles_is_pinned(s->editor, s->report.derived_point[i]));
        inside[s->report.derived_point[i]] = 2;
    }
    for (uint32_t p = 0; p < g->point_count; p++)
        check_seed(s->seed, inside[p] || memcmp(s->q + 2 * p, s->old + 2 * p, 16) == 0);
    for (uint32_t e = 0; e < g->edge_count; e++)
        for (int m = 0; grid_edge_is_inner(g, e) && m < g->degree; m++) {
            struct c1_condition c = c1_condition(g, e, m);
            bool touched = false;
            for (int i = 0; i < 4; i++)
                touched = touched || (c.coefficient[i] != 0 && inside[c.point[i]]);
            if (!touched || s->report.conditions == 0) continue;
            check_seed(s->seed,
                       n < s->report.conditions &&
                           s->report.condition[n] == e * (uint64_t)g->degree + (uint64_t)m);
            n++;
        }
    check_seed(s->seed, n == s->report.conditions);
    free(inside);
}

bool editing_apply(struct editing *s, const struct decles_edit *edit, int k) {
    memcpy(s->old, s->q, s->g.point_count * 2 * sizeof *s->q);
    if (!decles_apply(s->editor, s->q, 2, k, edit, &s->report, &s->err)) {
        check_seed(s->seed, memcmp(s->old, s->q, s->g.point_count * 2 * sizeof *s->q) == 0);
        check_seed(s->seed, s->err.kind == ERR_REFUSAL && s->err.message[0] != '\0');
        return false;
    }
    check_sets(s, edit);
    for (size_t i = 0; i < edit->anchor_count; i++)
        for (int c = 0; c < k; c++)
            check_seed(s->seed,
                       s->q[2 * edit->anchor[i].point + (uint32_t)c] == edit->anchor[i].to[c]);
    return true;
}

bool editing_move(struct editing *s, uint32_t p, double dx, double dy) {
    struct decles_motion motion = {.kind = DECLES_TRANSLATE, .by = {dx, dy}};
    struct decles_anchor anchor = {p, 0, {s->q[2 * p] + dx, s->q[2 * p + 1] + dy}};
    struct decles_edit edit = {
        .anchor_count = 1, .anchor = &anchor, .motion_count = 1, .motion = &motion};
    return editing_apply(s, &edit, 2);
}

void editing_undo(struct editing *s) {
    memcpy(s->q, s->old, s->g.point_count * 2 * sizeof *s->q);
}

void editing_check_c1(const struct editing *s) {
    struct c1_field field = {s->q, 2, 2, c1_extent(&s->g)};
    double absolute, relative;
    uint32_t edge;
    c1_residual(&s->g, &field, &absolute, &relative, &edge);
    check_seed(s->seed, absolute <= 1e-13 * s->magnitude);
    check_seed(s->seed, relative <= 64 * 0x1p-53);
}

/* The rows of E as dense equations for D, component c. */
static void fill_rows(const struct editing *s, const size_t *column, int c, long double *a,
                      long double *b) {
    size_t n = s->report.derived;
    for (size_t r = 0; r < s->report.conditions; r++) {
        uint64_t number = s->report.condition[r], d = (uint64_t)s->g.degree;
        struct c1_condition row = c1_condition(&s->g, (uint32_t)(number / d), (int)(number % d));
        long double scale = 1 / (long double)row.coefficient[0];
        for (int i = 0; i < 4; i++) {
            uint32_t p = row.point[i];
            long double value = (long double)row.coefficient[i] * scale;
            if (column[p] > 0)
                a[r * n + column[p] - 1] = value;
            else
                b[r] -= value * (long double)s->q[2 * p + (uint32_t)c];
        }
    }
}

void editing_check_solution(const struct editing *s, const double *weight, int k) {
    size_t n = s->report.derived, m = s->report.conditions, *column, bytes = sizeof(long double);
    double *w = allocate(n, sizeof *w), *target = allocate(n, sizeof *target);
    column = allocate(s->g.point_count, sizeof *column);
    for (size_t i = 0; i < n; i++) {
        column[s->report.derived_point[i]] = i + 1;
        w[i] = weight ? weight[s->report.derived_point[i]] : 1;
    }
    for (int c = 0; c < k; c++) {
        long double *a = allocate(m * n, bytes), *b = allocate(m, bytes), *x = allocate(n, bytes);
        fill_rows(s, column, c, a, b);
        for (size_t i = 0; i < n; i++) target[i] = s->report.suggested[i * (size_t)k + (size_t)c];
        check_seed(s->seed, dense_least_squares(a, b, m, n, w, target, x) < 1e-13 * s->magnitude);
        for (size_t i = 0; i < n; i++) {
            double found = s->q[2 * s->report.derived_point[i] + (uint32_t)c];
            check_seed(s->seed, fabsl((long double)found - x[i]) <= 1e-12 * s->magnitude);
        }
        free(a);
        free(b);
        free(x);
    }
    free(w);
    free(target);
    free(column);
}

void random_points(const struct grid *g, uint64_t *seed, uint32_t *points, size_t n) {
    for (size_t i = 0; i < n; i++) {
        bool fresh;
        INVARIANT(n <= g->point_count);
        do {
            points[i] = (uint32_t)random_in(seed, 0, g->point_count - 1);
            fresh = true;
            for (size_t j = 0; j < i; j++) fresh = fresh && points[j] != points[i];
        } while (!fresh);
    }
}
