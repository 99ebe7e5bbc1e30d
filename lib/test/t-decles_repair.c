/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Repair gives the nearest C1 spline, once and for all. */
#include "dense.h"
#include "editing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The projection by dense long double least squares, component c of k = 2. */
static void project(const struct grid *g, const double *q, int c, long double *x) {
    size_t rows = (size_t)g->edge_count * (size_t)g->degree, n = g->point_count, m = 0;
    long double *a = calloc(rows * n, sizeof *a), *b = calloc(rows, sizeof *b);
    double *weight = malloc(n * sizeof *weight), *target = malloc(n * sizeof *target);
    for (uint32_t e = 0; e < g->edge_count; e++)
        for (int i = 0; grid_edge_is_inner(g, e) && i < g->degree; i++, m++) {
            struct c1_condition row = c1_condition(g, e, i);
            for (int j = 0; j < 4; j++)
                a[m * n + row.point[j]] =
                    (long double)row.coefficient[j] / (long double)row.coefficient[0];
        }
    for (size_t p = 0; p < n; p++) {
        weight[p] = 1;
        target[p] = q[2 * p + (size_t)c];
    }
    dense_least_squares(a, b, m, n, weight, target, x);
    free(a);
    free(b);
    free(weight);
    free(target);
}

static void nearest_and_idempotent(void **state) {
    (void)state;
    for (int run = 0, runs = test_count(24); run < runs; run++) {
        uint64_t seed = 8000 + (uint64_t)run, random = seed;
        struct grid g;
        struct editing s;
        struct err err = {0};
        random_grid(&g, 2, 2 + run % 6, seed);
        editing_begin(&s, &g, 0, 100, seed);
        size_t bytes = 2 * s.g.point_count * sizeof *s.q;
        check_seed(seed, decles_repair(&s.g, s.q, 2, 2, &err));
        check_seed(seed, memcmp(s.q, s.old, bytes) == 0); /* the identity is C1 already */
        for (size_t i = 0; i < 2 * (size_t)s.g.point_count; i++)
            s.q[i] += (random_unit(&random) - 0.5) * 0.2 * s.magnitude;
        memcpy(s.old, s.q, bytes);
        check_seed(seed, decles_repair(&s.g, s.q, 2, 1, &err)); /* x alone, then both */
        for (size_t p = 0; p < s.g.point_count; p++)
            check_seed(seed, s.q[2 * p + 1] == s.old[2 * p + 1]);
        check_seed(seed, decles_repair(&s.g, s.q, 2, 2, &err));
        editing_check_c1(&s);
        long double *x = malloc(s.g.point_count * sizeof *x);
        for (int c = 0; c < 2; c++) {
            project(&s.g, s.old, c, x);
            for (size_t p = 0; p < s.g.point_count; p++)
                check_seed(seed, fabsl(x[p] - (long double)s.q[2 * p + (size_t)c]) <=
                                     1e-12 * s.magnitude);
        }
        memcpy(s.old, s.q, bytes);
        check_seed(seed, decles_repair(&s.g, s.q, 2, 2, &err));
        check_seed(seed, memcmp(s.q, s.old, bytes) == 0);
        free(x);
        editing_end(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(nearest_and_idempotent)};
    return cmocka_run_group_tests_name("decles_repair", tests, NULL, NULL);
}
