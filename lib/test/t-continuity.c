/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The order of continuity of planted splines: the truncated power (p . n)^r, n normal to an edge,
 * added on one side of it, is C^(r-1) there and not C^r; and what grids are made of. */
#include "continuity.h"
#include "mem.h"
#include "topology.h"

#include "testing.h"

#include <string.h>

/* Two triangles with the common edge (0,0)-(4,2), which is edge 0. */
static void two_triangles(struct spline *s, int degree, int32_t below, int32_t above) {
    const int32_t vertex[4][2] = {{0, 0}, {4, 2}, {below, -4}, {above, 6}};
    struct grid g = {.degree = degree,
                     .axes = {0, 1, 2},
                     .lattice = {0.5, 0, 0},
                     .vertex_count = 4,
                     .triangle_count = 2};
    struct err err;
    assert_true(mem_new(g.vertex, 4, &err) && mem_new(g.triangle, 2, &err));
    memcpy(g.vertex, vertex, sizeof vertex);
    memcpy(g.triangle, (uint32_t[2][3]){{0, 2, 1}, {0, 1, 3}}, 6 * sizeof(uint32_t));
    assert_true(grid_build(&g, &err) && spline_identity(s, &g, &err));
}

/* Adds amount * (b0)^r to component c on triangle 1, b0 its barycentric coordinate of vertex 3,
 * which vanishes on the edge: coefficients C(k,r) / C(d,r). */
static void add_power(struct spline *s, int r, int c, double amount) {
    int d = s->grid.degree;
    for (int k = r; k <= d; k++)
        for (int i = 0; i <= d - k; i++) {
            double ratio = 1;
            for (int m = 0; m < r; m++) ratio *= (double)(k - m) / (d - m);
            s->phi[grid_point(&s->grid, 1, i, d - k - i, k)][c] += amount * ratio;
        }
}

static void test_orders(void **state) {
    uint64_t seed = 3;
    (void)state;
    for (int n = test_count(200); n > 0; n--) {
        uint64_t start = seed;
        int d = (int)random_in(&seed, 1, 8), r = (int)random_in(&seed, 1, d);
        struct continuity c;
        struct spline s;
        struct err err;
        two_triangles(&s, d, (int32_t)random_in(&seed, -1, 7), (int32_t)random_in(&seed, -3, 5));
        check_seed(start, continuity_order(&s, 0, 4) == d);
        add_power(&s, r, (int)random_in(&seed, 0, 1), 0.25);
        check_seed(start, continuity_survey(&c, &s, &err));
        for (int order = 0; order <= d; order++)
            check_seed(start, c.edges[order] == (order == r - 1));
        check_seed(start, c.conditions == (size_t)d && c.rank == (size_t)d);
        check_seed(start, (c.absolute > 1e-6) == (r == 1) && c.worst != GRID_NONE);
        spline_free(&s);
    }
}

/* A ring of 8 triangles around a square hole, and a triangle apart. */
static void test_topology(void **state) {
    static const int32_t vertex[11][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3},  {1, 1}, {2, 1},
                                          {2, 2}, {1, 2}, {9, 9}, {10, 9}, {9, 10}};
    static const uint32_t triangle[9][3] = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6},
                                            {3, 7, 6}, {3, 0, 7}, {0, 4, 7}, {8, 9, 10}};
    struct grid g = {.degree = 1,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .vertex_count = 11,
                     .triangle_count = 9};
    struct topology t;
    struct err err;
    (void)state;
    assert_true(mem_new(g.vertex, 11, &err) && mem_new(g.triangle, 9, &err));
    memcpy(g.vertex, vertex, sizeof vertex);
    memcpy(g.triangle, triangle, sizeof triangle);
    assert_true(grid_build(&g, &err) && topology_survey(&t, &g, &err));
    assert_int_equal(t.components, 2);
    assert_int_equal(t.loops, 3);
    assert_int_equal(t.inner_edges, 8);
    assert_int_equal(t.boundary_edges, 11);
    grid_free(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_orders),
                                       cmocka_unit_test(test_topology)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
