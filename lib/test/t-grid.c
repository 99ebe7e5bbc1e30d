/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle of the numbering: all positions i u0 + j u1 + k u2 of all triangles, sorted; edges and
 * fans by looking at all pairs of triangles. */
#include "grid.h"

#include "testing.h"
#include "triangulations.h"

#include <stdlib.h>
#include <string.h>

struct position {
    int64_t x, y;
    uint32_t point;
};

static int compare_positions(const void *a, const void *b) {
    const struct position *p = a, *q = b;
    if (p->x != q->x) return p->x < q->x ? -1 : 1;
    if (p->y != q->y) return p->y < q->y ? -1 : 1;
    return p->point < q->point ? -1 : p->point > q->point;
}

static struct position position_of(const struct grid *g, uint32_t t, int i, int j, int k) {
    const uint32_t *c = g->triangle[t];
    const int32_t *a = g->vertex[c[0]], *b = g->vertex[c[1]], *d = g->vertex[c[2]];
    return (struct position){(int64_t)i * a[0] + (int64_t)j * b[0] + (int64_t)k * d[0],
                             (int64_t)i * a[1] + (int64_t)j * b[1] + (int64_t)k * d[1],
                             grid_point(g, t, i, j, k)};
}

static struct position *all_positions(const struct grid *g, size_t *count) {
    size_t size = (size_t)grid_patch_size(g->degree), n = 0;
    struct position *all = calloc(size * g->triangle_count, sizeof *all);
    assert_non_null(all);
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        uint32_t patch[GRID_PATCH_MAX];
        size_t first = n;
        grid_patch(g, t, patch);
        for (int i = g->degree; i >= 0; i--)
            for (int j = g->degree - i; j >= 0; j--) {
                all[n] = position_of(g, t, i, j, g->degree - i - j);
                assert_int_equal(all[n].point, patch[n - first]);
                n++;
            }
        assert_int_equal(n - first, size);
    }
    *count = n;
    return all;
}

/* Equal positions have one number, different ones have different numbers, none is left out. */
static void check_bijection(const struct grid *g, uint64_t seed) {
    size_t n;
    uint32_t distinct = 0;
    struct position *all = all_positions(g, &n);
    bool *seen = calloc(g->point_count, 1);
    assert_non_null(seen);
    qsort(all, n, sizeof *all, compare_positions);
    for (size_t i = 0; i < n; i++) {
        bool same = i > 0 && all[i].x == all[i - 1].x && all[i].y == all[i - 1].y;
        check_seed(seed, all[i].point < g->point_count);
        check_seed(seed, !same || all[i].point == all[i - 1].point);
        if (same) continue;
        check_seed(seed, !seen[all[i].point]);
        seen[all[i].point] = true;
        distinct++;
    }
    check_seed(seed, distinct == g->point_count);
    free(seen);
    free(all);
}

/* With integer coordinates a nominal position is one rounded quotient. */
static void check_nominals(const struct grid *g, uint64_t seed) {
    size_t n;
    struct position *all = all_positions(g, &n);
    double(*nominal)[2] = calloc(g->point_count, sizeof *nominal);
    assert_non_null(nominal);
    grid_nominals(g, nominal);
    for (size_t i = 0; i < n; i++) {
        double one[2], *xy = nominal[all[i].point];
        grid_nominal(g, all[i].point, one);
        check_seed(seed, xy[0] == (double)all[i].x / g->degree);
        check_seed(seed, xy[1] == (double)all[i].y / g->degree);
        check_seed(seed, one[0] == xy[0] && one[1] == xy[1]);
    }
    free(nominal);
    free(all);
}

static int compare_pairs(const void *a, const void *b) {
    const uint32_t *p = a, *q = b;
    if (p[0] != q[0]) return p[0] < q[0] ? -1 : 1;
    return p[1] < q[1] ? -1 : p[1] > q[1];
}

/* The order of numbers: corners, edges sorted by (a,b) and run from a, triangles by rows. */
static void check_order(const struct grid *g, uint64_t seed) {
    uint32_t(*pair)[2] = calloc(3 * g->triangle_count, sizeof *pair), n = 0, p = 0;
    int d = g->degree;
    assert_non_null(pair);
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++, n++) {
            uint32_t a = g->triangle[t][l], b = g->triangle[t][(l + 1) % 3];
            pair[n][0] = a < b ? a : b;
            pair[n][1] = a < b ? b : a;
        }
    qsort(pair, n, sizeof *pair, compare_pairs);
    p = g->vertex_count;
    for (uint32_t h = 0, e = 0; h < n; h++) {
        if (h > 0 && compare_pairs(pair[h], pair[h - 1]) == 0) continue;
        check_seed(seed, compare_pairs(pair[h], g->edge[e++]) == 0);
        for (int k = 1; k < d; k++, p++) {
            struct grid_place at = grid_place(g, p);
            const uint32_t *c = g->triangle[at.triangle];
            for (int l = 0; l < 3; l++)
                check_seed(seed, at.weight[l] == (c[l] == pair[h][0]   ? d - k
                                                  : c[l] == pair[h][1] ? k
                                                                       : 0));
        }
    }
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int i = d - 2; i >= 1; i--)
            for (int j = d - 1 - i; j >= 1; j--)
                check_seed(seed, grid_point(g, t, i, j, d - i - j) == p++);
    check_seed(seed, p == g->point_count);
    free(pair);
}

/* Is p one of the points of t? Looks at all of them. */
static bool has_point(const struct grid *g, uint32_t t, uint32_t p) {
    uint32_t patch[GRID_PATCH_MAX];
    grid_patch(g, t, patch);
    for (int i = 0; i < grid_patch_size(g->degree); i++)
        if (patch[i] == p) return true;
    return false;
}

static void check_places(const struct grid *g, uint64_t seed) {
    for (uint32_t p = 0; p < g->point_count; p++) {
        uint32_t single, n, found = 0, lowest = GRID_NONE;
        const uint32_t *list = grid_triangles_of(g, p, &single, &n);
        for (uint32_t t = 0; t < g->triangle_count; t++) {
            bool listed = false;
            for (uint32_t i = 0; i < n; i++) listed = listed || list[i] == t;
            check_seed(seed, listed == has_point(g, t, p));
            if (!listed) continue;
            int w[3];
            grid_weights(g, p, t, w);
            check_seed(seed, grid_point(g, t, w[0], w[1], w[2]) == p);
            if (found++ == 0) lowest = t;
        }
        check_seed(seed, found == n && grid_place(g, p).triangle == lowest);
    }
}

static void check_edges(const struct grid *g, uint64_t seed) {
    for (uint32_t e = 0; e < g->edge_count; e++) {
        uint32_t expect[3] = {GRID_NONE, GRID_NONE, GRID_NONE}, n = 0;
        for (uint32_t t = 0; t < g->triangle_count; t++) {
            int common = 0;
            for (int l = 0; l < 3; l++)
                common += g->triangle[t][l] == g->edge[e][0] || g->triangle[t][l] == g->edge[e][1];
            if (common < 2) continue;
            check_seed(seed, n < 2);
            expect[n++] = t;
            int l = grid_opposite(g, t, e);
            check_seed(seed, g->triangle_edge[t][l] == e);
            check_seed(seed, g->triangle[t][l] != g->edge[e][0]);
            check_seed(seed, g->triangle[t][l] != g->edge[e][1]);
        }
        check_seed(seed, memcmp(expect, g->edge_triangle[e], 8) == 0);
        check_seed(seed, grid_edge_is_inner(g, e) == (n == 2));
    }
}

/* Corner l of t with triangle[t][l] = v. */
static int corner(const struct grid *g, uint32_t t, uint32_t v) {
    int l = 0;
    while (g->triangle[t][l] != v) l++;
    return l;
}

static void check_fans(const struct grid *g, uint64_t seed) {
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        const uint32_t *fan = g->fan + g->fan_start[v];
        uint32_t n = g->fan_start[v + 1] - g->fan_start[v], incident = 0, lowest = GRID_NONE;
        for (uint32_t t = g->triangle_count; t-- > 0;)
            for (int l = 0; l < 3; l++)
                if (g->triangle[t][l] == v) incident++, lowest = t;
        check_seed(seed, incident == n && n > 0);
        for (uint32_t i = 0; i + 1 < n; i++) {
            const uint32_t *a = g->triangle[fan[i]], *b = g->triangle[fan[i + 1]];
            check_seed(seed,
                       a[(corner(g, fan[i], v) + 2) % 3] == b[(corner(g, fan[i + 1], v) + 1) % 3]);
        }
        const uint32_t *first = g->triangle[fan[0]], *last = g->triangle[fan[n - 1]];
        bool closed =
            first[(corner(g, fan[0], v) + 1) % 3] == last[(corner(g, fan[n - 1], v) + 2) % 3];
        check_seed(seed, !closed || fan[0] == lowest);
    }
}

static void test_random_grids(void **state) {
    int n = test_count(150);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)n; seed++) {
        struct grid g;
        random_grid(&g, 4, 1 + (int)(seed % GRID_DEGREE_MAX), seed);
        check_bijection(&g, seed);
        check_nominals(&g, seed);
        check_order(&g, seed);
        check_places(&g, seed);
        check_edges(&g, seed);
        check_fans(&g, seed);
        grid_free(&g);
    }
}

/* A hub with many triangles: parabola points seen from below. */
static void test_hub(void **state) {
    enum { N = 4000 };
    struct grid g = {.degree = 3, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
    struct err err = {0};
    (void)state;
    g.vertex_count = N + 1;
    g.triangle_count = N - 1;
    g.vertex = calloc(N + 1, sizeof *g.vertex);
    g.triangle = calloc(N - 1, sizeof *g.triangle);
    assert_true(g.vertex && g.triangle);
    g.vertex[N][1] = -GRID_COORDINATE_MAX;
    for (int i = 0; i < N; i++) {
        g.vertex[i][0] = i - N / 2;
        g.vertex[i][1] = -(i - N / 2) * (i - N / 2);
    }
    for (uint32_t i = 0; i + 1 < N; i++) {
        g.triangle[i][0] = i;
        g.triangle[i][1] = N;
        g.triangle[i][2] = i + 1;
    }
    assert_true(grid_build(&g, &err));
    assert_int_equal(g.edge_count, 2 * N - 1);
    assert_int_equal(g.fan_start[N + 1] - g.fan_start[N], N - 1);
    check_bijection(&g, 0);
    grid_free(&g);
}

/* Bad grids: vertices, triangles, what the message says and whom it blames. */
struct bad {
    uint32_t vertices, triangles;
    int32_t vertex[8][2];
    uint32_t triangle[6][3];
    const char *message;
    struct grid_culprit culprit;
};

static const struct bad bad_grids[] = {
    {3,
     1,
     {{0, 0}, {1, 0}, {0, 1}},
     {{0, 2, 1}},
     "triangle 0 (0 2 1) is clockwise",
     {GRID_BAD_TRIANGLE, 0}},
    {3,
     1,
     {{0, 0}, {1, 1}, {2, 2}},
     {{0, 1, 2}},
     "triangle 0 (0 1 2) has no area",
     {GRID_BAD_TRIANGLE, 0}},
    {3,
     1,
     {{0, 0}, {1, 0}, {0, 1}},
     {{0, 1, 1}},
     "triangle 0 (0 1 1) has no area",
     {GRID_BAD_TRIANGLE, 0}},
    {3,
     1,
     {{0, 0}, {1, 0}, {0, 1}},
     {{0, 1, 3}},
     "triangle 0 has vertex 3, but there are 3",
     {GRID_BAD_TRIANGLE, 0}},
    {4,
     1,
     {{0, 0}, {1, 0}, {0, 1}, {5, 5}},
     {{0, 1, 2}},
     "no triangle has vertex 3",
     {GRID_BAD_VERTEX, 3}},
    {6,
     2,
     {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {5, 5}, {1, 0}},
     {{0, 1, 2}, {5, 4, 3}},
     "vertices 1 and 5 are both at (1 0)",
     {GRID_BAD_VERTEX, 5}},
    {3,
     1,
     {{0, 0}, {16777217, 0}, {0, 1}},
     {{0, 1, 2}},
     "vertex 1 (16777217 0) is not in -2^24..2^24",
     {GRID_BAD_VERTEX, 1}},
    {3,
     1,
     {{0, 0}, {1, 0}, {0, INT32_MIN}},
     {{0, 1, 2}},
     "vertex 2 (0 -2147483648) is not in -2^24..2^24",
     {GRID_BAD_VERTEX, 2}},
    {5,
     3,
     {{0, 0}, {9, 0}, {0, 9}, {9, 9}, {9, 8}},
     {{0, 1, 2}, {1, 3, 2}, {1, 4, 2}},
     "edge {1,2} has more than two triangles: 0, 1, 2",
     {GRID_BAD_TRIANGLE, 2}},
    {4,
     2,
     {{0, 0}, {9, 0}, {0, 9}, {1, 5}},
     {{0, 1, 2}, {1, 3, 0}},
     "triangles 0 and 1 lie on the same side of their edge {0,1}",
     {GRID_BAD_TRIANGLE, 1}},
    {3,
     2,
     {{0, 0}, {1, 0}, {0, 1}},
     {{0, 1, 2}, {1, 2, 0}},
     "triangles 0 and 1 lie on the same side of their edge {0,1}",
     {GRID_BAD_TRIANGLE, 1}},
    {5,
     2,
     {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}},
     {{0, 1, 2}, {0, 3, 4}},
     "the triangles around vertex 0 form two fans: of triangle 0 and of 1",
     {GRID_BAD_TRIANGLE, 1}},
    {6,
     4,
     {{0, 0}, {9, -1}, {0, 9}, {-9, -1}, {20, 0}, {20, 9}},
     {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}},
     "the triangles around vertex 0 form two fans: of triangle 3 and of 0",
     {GRID_BAD_TRIANGLE, 0}},
};

static struct grid copy_bad(const struct bad *b) {
    struct grid g = {.degree = 5, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
    g.vertex_count = b->vertices;
    g.triangle_count = b->triangles;
    g.vertex = malloc(sizeof b->vertex);
    g.triangle = malloc(sizeof b->triangle);
    assert_true(g.vertex && g.triangle);
    memcpy(g.vertex, b->vertex, sizeof b->vertex);
    memcpy(g.triangle, b->triangle, sizeof b->triangle);
    return g;
}

static void test_bad_grids(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof bad_grids / sizeof *bad_grids; i++) {
        const struct bad *b = &bad_grids[i];
        struct grid g = copy_bad(b);
        struct grid_culprit culprit;
        struct err err = {0};
        assert_false(grid_build_blaming(&g, &culprit, &err));
        assert_int_equal(err.kind, ERR_INPUT);
        assert_string_equal(err.message, b->message);
        assert_int_equal(culprit.kind, b->culprit.kind);
        assert_int_equal(culprit.number, b->culprit.number);
        assert_null(g.vertex);
    }
}

/* Fields that no file can set wrong, but a caller can. */
static void test_bad_frames(void **state) {
    static const struct bad good = {3, 1, {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, "", {0, 0}};
    static const struct {
        int degree;
        struct lattice lattice;
        double depth[2];
        const char *message;
    } cases[] = {
        {0, {1, 0, 0}, {0, 1}, "degree 0 is not in 1..15"},
        {16, {1, 0, 0}, {0, 1}, "degree 16 is not in 1..15"},
        {5, {0, 0, 0}, {0, 1}, "the lattice (step 0, origin 0 0) is not finite with step > 0"},
        {5,
         {1, 0, 1e308 * 10},
         {0, 1},
         "the lattice (step 1, origin 0 inf) is not finite with step > 0"},
        {5,
         {1e305, 0, 0},
         {0, 1},
         "the lattice (step 9.9999999999999994e+304, origin 0 0) is not finite with step > 0"},
        {5, {1, 0, 0}, {1, 1}, "depth 1 1 is not an interval a < b"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct grid g = copy_bad(&good);
        struct err err = {0};
        g.degree = cases[i].degree;
        g.lattice = cases[i].lattice;
        g.has_depth = true;
        memcpy(g.depth, cases[i].depth, sizeof g.depth);
        assert_false(grid_build(&g, &err));
        assert_string_equal(err.message, cases[i].message);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_grids),
        cmocka_unit_test(test_hub),
        cmocka_unit_test(test_bad_grids),
        cmocka_unit_test(test_bad_frames),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
