/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: every triangle is tested in rationals; the lowest that holds the point wins. */
#include "locate.h"

#include "mem.h"

#include "testing.h"
#include "triangulations.h"

#include <gmp.h>
#include <math.h>

/* q[k] = world coordinate k of lattice point v, exactly. */
static void exact_vertex(const struct grid *g, const int32_t *v, mpq_t q[2]) {
    const double origin[2] = {g->lattice.x0, g->lattice.y0};
    mpq_t term;
    mpq_init(term);
    for (int k = 0; k < 2; k++) {
        mpq_set_d(q[k], g->lattice.step);
        mpq_set_si(term, v[k], 1);
        mpq_mul(q[k], q[k], term);
        mpq_set_d(term, origin[k]);
        mpq_add(q[k], q[k], term);
    }
    mpq_clear(term);
}

/* area = twice the signed area of a, b, p */
static void exact_area(mpq_t area, mpq_t a[2], mpq_t b[2], mpq_t p[2]) {
    mpq_t d[4], product;
    for (int i = 0; i < 4; i++) mpq_init(d[i]);
    mpq_init(product);
    for (int k = 0; k < 2; k++) {
        mpq_sub(d[k], b[k], a[k]);
        mpq_sub(d[2 + k], p[k], a[k]);
    }
    mpq_mul(area, d[0], d[3]);
    mpq_mul(product, d[1], d[2]);
    mpq_sub(area, area, product);
    mpq_clear(product);
    for (int i = 0; i < 4; i++) mpq_clear(d[i]);
}

/* The exact barycentric coordinates of p in t; true if none is negative. */
static bool exact_look(const struct grid *g, uint32_t t, const double p[2], mpq_t b[3]) {
    mpq_t corner[3][2], point[2], area;
    bool inside = true;
    mpq_inits(point[0], point[1], area, NULL);
    for (int l = 0; l < 3; l++) {
        mpq_inits(corner[l][0], corner[l][1], NULL);
        exact_vertex(g, g->vertex[g->triangle[t][l]], corner[l]);
    }
    for (int k = 0; k < 2; k++) mpq_set_d(point[k], p[k]);
    exact_area(area, corner[0], corner[1], corner[2]);
    for (int l = 0; l < 3; l++) {
        exact_area(b[l], corner[(l + 1) % 3], corner[(l + 2) % 3], point);
        mpq_div(b[l], b[l], area);
        inside = inside && mpq_sgn(b[l]) >= 0;
    }
    for (int l = 0; l < 3; l++) mpq_clears(corner[l][0], corner[l][1], NULL);
    mpq_clears(point[0], point[1], area, NULL);
    return inside;
}

static void check_point(const struct locator *l, const double p[2], uint32_t *hint, uint64_t seed) {
    const struct grid *g = l->grid;
    uint32_t expected = 0, t = GRID_NONE;
    double b[3] = {0};
    mpq_t exact[3];
    mpq_inits(exact[0], exact[1], exact[2], NULL);
    while (expected < g->triangle_count && !exact_look(g, expected, p, exact)) expected++;
    bool found = locate(l, p, hint, &t, b);
    check_seed(seed, found == (expected < g->triangle_count));
    if (found) {
        check_seed(seed, t == expected && *hint == t);
        check_seed(seed, b[0] + b[1] + b[2] == 1);
        for (int k = 0; k < 3; k++) {
            check_seed(seed, b[k] >= 0 && b[k] <= 1);
            check_seed(seed, mpq_sgn(exact[k]) != 0 || b[k] == 0);
            check_seed(seed, fabs(b[k] - mpq_get_d(exact[k])) < 1e-9);
        }
    }
    mpq_clears(exact[0], exact[1], exact[2], NULL);
}

/* A point in the box, at a lattice point, on an edge, or in a triangle; often an ulp off. */
static void choose_point(const struct grid *g, uint64_t *s, double p[2]) {
    const uint32_t *v = g->triangle[random_in(s, 0, g->triangle_count - 1)];
    const int32_t *a = g->vertex[v[0]], *b = g->vertex[v[1]], *c = g->vertex[v[2]];
    double x = random_unit(s), y = random_unit(s) * (1 - x);
    switch (random_in(s, 0, 4)) {
    case 0:
        x = y = 0;
        break;
    case 1:
        y = 0;
        break;
    case 2:
        x = (double)random_in(s, 0, 4) / 4;
        y = 1 - x;
        break;
    case 3: /* also outside */
        x = 3 * x - 1;
        y = 3 * y - 1;
        break;
    }
    for (int k = 0; k < 2; k++) {
        double at = a[k] + x * (b[k] - a[k]) + y * (c[k] - a[k]);
        p[k] = (k ? g->lattice.y0 : g->lattice.x0) + g->lattice.step * at;
        if (random_in(s, 0, 3) == 0) p[k] = nextafter(p[k], HUGE_VAL * (double)random_in(s, -1, 1));
        if (isnan(p[k])) p[k] = 0;
    }
}

enum { LATTICES = 10 };
static const struct lattice lattices[LATTICES] = {{1, 0, 0},
                                                  {0.1, 0, 0},
                                                  {0.1, 12.3, -1e3},
                                                  {0x1p-20, 1, 2},
                                                  {7e-5, -0.1, 1e-3},
                                                  {0x1p1005, 0, 0x1p1015},
                                                  {0x1.8p900, -1e273, 3},
                                                  {0x1p-1060, 0, 0x1p-1070},
                                                  {1e-170, 0, 0},
                                                  {1e200, 1e205, 0}};

static void against_brute_force(void **unused) {
    for (int i = 0; i < test_count(120); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct locator l;
        struct grid g;
        struct err err = {0};
        uint32_t hint = 0;
        double p[2];
        random_grid(&g, 4, 1, seed);
        g.lattice = lattices[i % LATTICES];
        assert_true(locator_init(&l, &g, &err));
        for (int n = 0; n < 150; n++) {
            if (random_in(&s, 0, 1)) hint = (uint32_t)random_in(&s, 0, g.triangle_count - 1);
            choose_point(&g, &s, p);
            check_point(&l, p, &hint, seed);
        }
        for (uint32_t v = 0; v < g.vertex_count; v++) {
            grid_vertex(&g, v, p);
            check_point(&l, p, &hint, seed);
        }
        locator_free(&l);
        grid_free(&g);
    }
    (void)unused;
}

/* A comb of needles from one corner: a walk is long, and every needle crosses many buckets. */
static void needles(void **unused) {
    enum { N = 600 };
    struct grid g = {.degree = 1, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
    struct locator l;
    struct err err = {0};
    uint32_t hint = 0;
    uint64_t s = 1;
    double p[2];
    assert_true(mem_new(g.vertex, N + 2, &err) && mem_new(g.triangle, N, &err));
    g.vertex_count = N + 2;
    g.triangle_count = N;
    for (int i = 0; i <= N; i++) {
        g.vertex[i + 1][0] = (1 << 20) - 700 * i;
        g.vertex[i + 1][1] = 300 + 900 * i;
    }
    for (uint32_t i = 0; i < N; i++) {
        g.triangle[i][1] = i + 1;
        g.triangle[i][2] = i + 2;
    }
    assert_true(grid_build(&g, &err));
    assert_true(locator_init(&l, &g, &err));
    assert_true(l.cell[l.raster.size[0] * l.raster.size[1]].start <= 16 * N);
    for (int i = 0; i < test_count(300); i++) {
        choose_point(&g, &s, p);
        check_point(&l, p, &hint, s);
    }
    locator_free(&l);
    grid_free(&g);
    (void)unused;
}

static void far_away(void **unused) {
    const double x[] = {1e308, -1e308, 1e17, -1e17, 5e-324, -5e-324};
    struct grid g;
    struct locator l;
    struct err err = {0};
    uint32_t hint = 0;
    random_grid(&g, 3, 1, 5);
    assert_true(locator_init(&l, &g, &err));
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++) {
            double p[2] = {x[i], x[j]};
            check_point(&l, p, &hint, 5);
        }
    locator_free(&l);
    grid_free(&g);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(against_brute_force),
        cmocka_unit_test(needles),
        cmocka_unit_test(far_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
