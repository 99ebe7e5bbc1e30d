/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "c1.h"

#include "dense.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const uint64_t prime = 2147483647;

static uint64_t reduce(int64_t n) {
    int64_t rest = n % (int64_t)prime;
    return (uint64_t)(rest < 0 ? rest + (int64_t)prime : rest);
}

/* A power L^d of a linear form is in every C1 space; its control points are L(u0)^i L(u1)^j
 * L(u2)^k. Such powers span all polynomials. Modulo a prime nothing is rounded. */
static void fill_power(const struct grid *g, uint64_t *seed, uint64_t *q) {
    int64_t a = random_in(seed, 1, 1 << 28), b = random_in(seed, 1, 1 << 28),
            c = random_in(seed, 1, 1 << 28);
    for (uint32_t p = 0; p < g->point_count; p++) {
        struct grid_place place = grid_place(g, p);
        q[p] = 1;
        for (int l = 0; l < 3; l++) {
            const int32_t *u = g->vertex[g->triangle[place.triangle][l]];
            uint64_t value = reduce(a * u[0] + b * u[1] + c);
            for (int i = 0; i < place.weight[l]; i++) q[p] = q[p] * value % prime;
        }
    }
}

static bool vanishes(const struct c1_condition *c, const uint64_t *q) {
    uint64_t sum = 0;
    for (int i = 0; i < 4; i++) sum += reduce(c->coefficient[i]) * q[c->point[i]] % prime;
    return sum % prime == 0;
}

static void polynomials_are_c1(void **state) {
    (void)state;
    for (int run = 0, n = test_count(60); run < n; run++) {
        uint64_t seed = 100 + (uint64_t)run, s = seed;
        struct grid g;
        random_grid(&g, 4, 1 + run % 15, seed);
        uint64_t *q = calloc(g.point_count, sizeof *q);
        fill_power(&g, &s, q);
        for (uint32_t e = 0; e < g.edge_count; e++)
            for (int m = 0; grid_edge_is_inner(&g, e) && m < g.degree; m++) {
                struct c1_condition c = c1_condition(&g, e, m);
                check_seed(seed, vanishes(&c, q));
                check_seed(seed, c.coefficient[0] != 0 && c.coefficient[1] != 0);
                q[c.point[0]]++; /* and not by chance */
                check_seed(seed, !vanishes(&c, q));
                q[c.point[0]]--;
            }
        free(q);
        grid_free(&g);
    }
}

/* The extremes have weight 1 against the edge, the order along it is from a to b. */
static void condition_lies_as_drawn(void **state) {
    (void)state;
    for (int run = 0, n = test_count(40); run < n; run++) {
        uint64_t seed = 200 + (uint64_t)run;
        struct grid g;
        random_grid(&g, 4, 2 + run % 8, seed);
        int d = g.degree;
        for (uint32_t e = 0; e < g.edge_count; e++)
            for (int m = 0; grid_edge_is_inner(&g, e) && m < d; m++) {
                struct c1_condition c = c1_condition(&g, e, m);
                for (int i = 0; i < 2; i++) {
                    uint32_t t = g.edge_triangle[e][1 - i];
                    int w[3], l = grid_opposite(&g, t, e), b = (l + 1) % 3;
                    if (g.triangle[t][b] != g.edge[e][1]) b = (l + 2) % 3;
                    grid_weights(&g, c.point[i], t, w);
                    check_seed(seed, w[l] == 1 && w[b] == m);
                    grid_weights(&g, c.point[2 + i], t, w);
                    check_seed(seed, w[l] == 0 && w[b] == m + i);
                }
            }
        grid_free(&g);
    }
}

struct visits {
    const struct grid *g;
    unsigned char *count; /* of each condition */
    uint32_t point;
    bool good;
};

static void note(void *context, uint32_t e, int m) {
    struct visits *v = context;
    v->good = v->good && v->count[e * (uint32_t)v->g->degree + (uint32_t)m] == 0;
    v->count[e * (uint32_t)v->g->degree + (uint32_t)m] = 1;
}

static void conditions_of_points(void **state) {
    (void)state;
    for (int run = 0, n = test_count(30); run < n; run++) {
        uint64_t seed = 300 + (uint64_t)run;
        struct grid g;
        random_grid(&g, 3, 1 + run % 8, seed);
        struct visits v = {&g, calloc(g.edge_count, (size_t)g.degree), 0, true};
        for (uint32_t p = 0; p < g.point_count; p++) {
            memset(v.count, 0, g.edge_count * (size_t)g.degree);
            c1_conditions_of(&g, p, note, &v);
            for (uint32_t e = 0; e < g.edge_count; e++)
                for (int m = 0; m < g.degree; m++) {
                    bool has = false;
                    if (grid_edge_is_inner(&g, e)) {
                        struct c1_condition c = c1_condition(&g, e, m);
                        for (int i = 0; i < 4; i++)
                            has = has || (c.point[i] == p && c.coefficient[i] != 0);
                    }
                    check_seed(seed, has == v.count[e * (uint32_t)g.degree + (uint32_t)m]);
                }
        }
        check_seed(seed, v.good);
        free(v.count);
        grid_free(&g);
    }
}

/* The paper's table 1 as counts. */
static void types_are_as_many_as_expected(void **state) {
    (void)state;
    for (int d = 3; d <= 8; d++) {
        struct grid g;
        uint32_t n[6] = {0}, inner = (uint32_t)((d - 1) * (d - 2) / 2);
        random_grid(&g, 4, d, (uint64_t)d);
        for (uint32_t p = 0; p < g.point_count; p++) n[c1_type(&g, p)]++;
        assert_int_equal(n[TYPE_CORNER], g.vertex_count);
        assert_int_equal(n[TYPE_EDGE_CORNER], 2 * g.edge_count);
        assert_int_equal(n[TYPE_EDGE], (uint32_t)(d - 3) * g.edge_count);
        assert_int_equal(n[TYPE_INNER_CORNER], (d == 3 ? 1 : 3) * g.triangle_count);
        assert_int_equal(n[TYPE_INNER_EDGE],
                         (d < 4 ? 0 : 3 * (uint32_t)(d - 4)) * g.triangle_count);
        inner -= (d == 3 ? 1 : 3) + (d < 4 ? 0 : 3 * (uint32_t)(d - 4));
        assert_int_equal(n[TYPE_INTERIOR], inner * g.triangle_count);
        grid_free(&g);
    }
    assert_string_equal(c1_type_names[TYPE_EDGE_CORNER], "edge-corner");
    assert_null(c1_type_names[TYPE_INTERIOR + 1]);
}

/* The rank formula against elimination of all conditions of random triangulations. */
static size_t rank_of_all(const struct grid *g) {
    size_t rows = 0, rank;
    int64_t *a;
    for (uint32_t e = 0; e < g->edge_count; e++)
        rows += grid_edge_is_inner(g, e) ? (size_t)g->degree : 0;
    a = calloc(rows * g->point_count + 1, sizeof *a);
    rows = 0;
    for (uint32_t e = 0; e < g->edge_count; e++)
        for (int m = 0; grid_edge_is_inner(g, e) && m < g->degree; m++, rows++) {
            struct c1_condition c = c1_condition(g, e, m);
            for (int i = 0; i < 4; i++) a[rows * g->point_count + c.point[i]] += c.coefficient[i];
        }
    rank = dense_rank(a, rows, g->point_count);
    free(a);
    return rank;
}

static void rank_formula(void **state) {
    (void)state;
    for (int run = 0, n = test_count(40); run < n; run++) {
        uint64_t seed = 400 + (uint64_t)run;
        struct grid g;
        random_grid(&g, 3, 5 + run % 4, seed);
        check_seed(seed, rank_of_all(&g) == c1_rank_formula(&g));
        grid_free(&g);
    }
}

static void singular_vertices(void **state) {
    (void)state;
    struct recipe crossed = {.nx = 3, .ny = 2, .spacing = 4, .crossed = true, .components = 1};
    struct err err = {0};
    struct grid g;
    uint32_t inner, singular;
    triangulate(&g, &crossed, 5, 1);
    assert_true(grid_build(&g, &err));
    c1_vertices(&g, &inner, &singular);
    assert_int_equal(inner, 6 + 2); /* squares' centres, lattice points */
    assert_int_equal(singular, 6);
    assert_int_equal(rank_of_all(&g), c1_rank_formula(&g));
    g.vertex[12][0]++; /* the first centre: now only near to singular */
    c1_vertices(&g, &inner, &singular);
    assert_int_equal(singular, 5);
    assert_int_equal(rank_of_all(&g), c1_rank_formula(&g));
    grid_free(&g);
}

static void residual(void **state) {
    (void)state;
    struct recipe recipe = {.nx = 3, .ny = 3, .spacing = 10, .components = 1};
    struct err err = {0};
    struct grid g;
    double absolute, relative, *q;
    uint32_t edge;
    triangulate(&g, &recipe, 5, 1);
    assert_true(grid_build(&g, &err));
    q = calloc(g.point_count, 2 * sizeof *q);
    for (uint32_t p = 0; p < g.point_count; p++) grid_nominal(&g, p, q + 2 * p);
    for (size_t c = 0; c < 2; c++) {
        c1_residual(&g, &(struct c1_field){q + c, 2, 1, c1_extent(&g)}, &absolute, &relative,
                    &edge);
        assert_true(relative <= 0x1p-53 && absolute <= 30 * 4 * 0x1p-53);
    }
    for (uint32_t e = 0; e < g.edge_count; e++) { /* break one condition: it is found */
        struct c1_condition c;
        if (!grid_edge_is_inner(&g, e)) continue;
        c = c1_condition(&g, e, 2);
        q[2 * c.point[0]] += 0.5;
        c1_residual(&g, &(struct c1_field){q, 2, 1, c1_extent(&g)}, &absolute, &relative, &edge);
        assert_int_equal(edge, e);
        assert_true(absolute > 0.1 && absolute <= 0.5 && relative > 1e-3);
        assert_false(c1_holds(c1_evaluate(&c, &(struct c1_field){q, 2, 1, c1_extent(&g)}, 0)));
        q[2 * c.point[0]] = (double)NAN;
        c1_residual(&g, &(struct c1_field){q, 2, 1, c1_extent(&g)}, &absolute, &relative, &edge);
        assert_true(edge == e && isnan(absolute) && isnan(relative));
        assert_false(c1_holds(c1_evaluate(&c, &(struct c1_field){q, 2, 1, c1_extent(&g)}, 0)));
        grid_nominal(&g, c.point[0], q + 2 * c.point[0]);
    }
    free(q);
    grid_free(&g);
}

static void tolerance(void **state) {
    (void)state;
    assert_true(c1_holds((struct c1_value){0, 0}));
    assert_true(c1_holds((struct c1_value){64 * 0x1p-53, 1}));
    assert_false(c1_holds((struct c1_value){65 * 0x1p-53, 1}));
    assert_true(c1_relative((struct c1_value){0, 0}) == 0);
    assert_true(c1_relative((struct c1_value){-1, 4}) == 0.25);
    struct c1_condition c = {{0, 1, 2, 3}, {-1, -1, 1, 1}};
    double q[] = {1, 2, 4, 8};
    struct c1_value v = c1_evaluate(&c, &(struct c1_field){q, 1, 1, 0.5}, 0);
    assert_true(v.sum == 9 && v.terms == 4 * 8.5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_c1),
        cmocka_unit_test(condition_lies_as_drawn),
        cmocka_unit_test(conditions_of_points),
        cmocka_unit_test(types_are_as_many_as_expected),
        cmocka_unit_test(rank_formula),
        cmocka_unit_test(singular_vertices),
        cmocka_unit_test(residual),
        cmocka_unit_test(tolerance),
    };
    return cmocka_run_group_tests_name("c1", tests, NULL, NULL);
}
