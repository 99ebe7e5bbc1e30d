/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Held against all pairs of triangles, clipped by one another. */
#include "mem.h"
#include "overlap.h"

#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <string.h>

/* Twice the area that two triangles have in common (Sutherland and Hodgman): coordinates are small,
 * so that an area which is not 0 is far from it. */
static double common_area(const struct grid *g, uint32_t s, uint32_t t) {
    double p[16][2], q[16][2], area = 0;
    int n = 3;
    for (int i = 0; i < 6; i++) p[i / 2][i % 2] = g->vertex[g->triangle[s][i / 2]][i % 2];
    for (int l = 0; l < 3; l++) {
        const int32_t *a = g->vertex[g->triangle[t][l]],
                      *b = g->vertex[g->triangle[t][(l + 1) % 3]];
        double side[16];
        int m = 0;
        for (int i = 0; i < n; i++)
            side[i] = (b[0] - a[0]) * (p[i][1] - a[1]) - (b[1] - a[1]) * (p[i][0] - a[0]);
        for (int i = 0; i < n; i++) {
            int j = (i + 1) % n;
            if (side[i] >= 0) memcpy(q[m++], p[i], sizeof p[i]);
            if (side[i] * side[j] >= 0) continue;
            for (int c = 0; c < 2; c++)
                q[m][c] = p[i][c] + (p[j][c] - p[i][c]) * side[i] / (side[i] - side[j]);
            m++;
        }
        n = m;
        memcpy(p, q, sizeof p);
        if (n == 0) return 0;
    }
    for (int i = 0; i < n; i++) {
        int j = (i + 1) % n;
        area += p[i][0] * p[j][1] - p[i][1] * p[j][0];
    }
    return area;
}

/* Does a corner of one that the other has not lie on the other? */
static bool touch(const struct grid *g, uint32_t s, uint32_t t) {
    for (int k = 0; k < 6; k++) {
        const uint32_t *mine = g->triangle[k < 3 ? s : t], *other = g->triangle[k < 3 ? t : s];
        uint32_t v = mine[k % 3];
        int inside = 0;
        if (v == other[0] || v == other[1] || v == other[2]) continue;
        for (int l = 0; l < 3; l++)
            inside += predicate_area2(g->vertex[other[l]], g->vertex[other[(l + 1) % 3]],
                                      g->vertex[v]) >= 0;
        if (inside == 3) return true;
    }
    return false;
}

static enum overlap_kind brute(const struct grid *g, const struct overlap *o, uint64_t seed) {
    enum overlap_kind worst = OVERLAP_NONE;
    for (uint32_t s = 0; s < g->triangle_count; s++)
        for (uint32_t t = s + 1; t < g->triangle_count; t++) {
            enum overlap_kind kind = common_area(g, s, t) > 1e-6 ? OVERLAP_AREA
                                     : touch(g, s, t)            ? OVERLAP_TOUCH
                                                                 : OVERLAP_NONE;
            check_seed(seed, overlap_of_triangles(g, s, t) == kind);
            check_seed(seed, overlap_of_triangles(g, t, s) == kind);
            worst = kind > worst ? kind : worst;
            if (o->kind != OVERLAP_NONE && o->triangle[0] == s && o->triangle[1] == t)
                check_seed(seed, o->kind == kind);
        }
    return worst;
}

/* Two triangulations, the second one moved so that they lie apart, touch, or overlap. */
static void test_components(void **state) {
    uint64_t seed = 9;
    int seen[3] = {0};
    (void)state;
    for (int n = test_count(400); n > 0; n--) {
        uint64_t start = seed;
        struct recipe r = {.nx = (int)random_in(&seed, 1, 4),
                           .ny = (int)random_in(&seed, 1, 3),
                           .spacing = 10,
                           .jitter = random_bits(&seed) & 1,
                           .flips = 1,
                           .removals = (int)random_in(&seed, 0, 4),
                           .components = 2,
                           .shuffled = random_bits(&seed) & 1};
        struct grid g;
        struct overlap o;
        struct err err;
        int32_t dx, dy, middle = 10 * r.nx + 4;
        triangulate(&g, &r, 1, random_bits(&seed));
        dx = (int32_t)random_in(&seed, -20 * r.nx, 10);
        if (random_bits(&seed) & 1) dx = -30; /* squares touch squares */
        dy = random_bits(&seed) & 1 ? 0 : (int32_t)random_in(&seed, -20, 20);
        for (uint32_t v = 0; v < g.vertex_count; v++)
            if (g.vertex[v][0] > middle) {
                g.vertex[v][0] += dx;
                g.vertex[v][1] += dy;
            }
        if (!grid_build(&g, &err)) continue; /* two vertices in one place */
        assert_true(overlap_find(&o, &g, &err));
        check_seed(start, (o.kind == OVERLAP_NONE) == (o.text[0] == '\0'));
        check_seed(start, brute(&g, &o, start) == o.kind);
        check_seed(start, o.kind == OVERLAP_NONE || o.triangle[0] < o.triangle[1]);
        seen[o.kind]++;
        grid_free(&g);
    }
    for (int k = 0; k < 3; k++) assert_true(seen[k] > 0);
}

/* Five triangles that wind twice round a vertex, in the domain. */
static void test_double_fan(void **state) {
    static const int32_t rim[5][2] = {{9, 0}, {-8, 6}, {2, -9}, {3, 9}, {-8, -6}};
    struct grid g = {.degree = 1,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .vertex_count = 6,
                     .triangle_count = 5};
    struct overlap o;
    struct err err;
    (void)state;
    assert_true(mem_new(g.vertex, 6, &err) && mem_new(g.triangle, 5, &err));
    for (uint32_t i = 0; i < 5; i++) {
        memcpy(g.vertex[i + 1], rim[i], sizeof rim[i]);
        g.triangle[i][1] = i + 1;
        g.triangle[i][2] = i == 4 ? 1 : i + 2;
    }
    assert_true(grid_build(&g, &err) && overlap_find(&o, &g, &err));
    assert_int_equal(o.kind, OVERLAP_AREA);
    assert_int_equal(brute(&g, &o, 0), OVERLAP_AREA);
    grid_free(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_components),
                                       cmocka_unit_test(test_double_fan)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
