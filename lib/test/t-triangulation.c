/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids of triangles, points and segments: random ones against brute force in integers, and planted
 * faults, each refused by its name. */
#include "triangulation.h"

#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct lattice_choice sixteen_bits = {0, 16};

static struct triangulation with_vertices(size_t n) {
    struct triangulation t = {.vertex_count = n};
    t.vertex = calloc(n, sizeof *t.vertex);
    return t;
}

static void scramble(struct triangulation *t, uint64_t *state) {
    for (size_t i = 0; i < t->triangle_count; i++) {
        uint32_t *c = t->triangle[i], c0 = c[0];
        if (random_in(state, 0, 1)) continue;
        c[0] = c[1];
        c[1] = c0;
    }
}

/* A sound random grid, each triangle turned at random, is what comes out again. */
static void test_round_trip(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(300); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct grid a, b = {.degree = 3, .axes = {0, 1, 2}};
        struct err err = {0};
        struct triangulation t;
        random_grid(&a, 6, 3, seed);
        t = with_vertices(a.vertex_count + 1);
        t.triangle_count = a.triangle_count;
        t.triangle = calloc(t.triangle_count, sizeof *t.triangle);
        for (uint32_t v = 0; v < a.vertex_count; v++)
            for (int c = 0; c < 2; c++) t.vertex[v][c] = a.vertex[v][c] * 0.25 - 7;
        t.vertex[a.vertex_count][0] = 1e9; /* unused */
        memcpy(t.triangle, a.triangle, t.triangle_count * sizeof *t.triangle);
        scramble(&t, &state);
        if (!triangulation_grid(&b, &t, &(struct lattice_choice){0.25, 20}, &err))
            fprintf(stderr, "%s\n", err.message);
        check_seed(seed, err.kind == ERR_NONE);
        check_seed(seed, a.vertex_count == b.vertex_count && a.triangle_count == b.triangle_count);
        for (uint32_t v = 0; v < a.vertex_count; v++)
            for (int c = 0; c < 2; c++)
                check_seed(seed, (c ? b.lattice.y0 : b.lattice.x0) + 0.25 * b.vertex[v][c] ==
                                     t.vertex[v][c]);
        check_seed(seed, a.edge_count == b.edge_count && a.point_count == b.point_count);
        grid_free(&a);
        grid_free(&b);
        triangulation_free(&t);
    }
}

static int64_t orient(const int32_t a[2], const int32_t b[2], const int32_t c[2]) {
    return ((int64_t)b[0] - a[0]) * ((int64_t)c[1] - a[1]) -
           ((int64_t)b[1] - a[1]) * ((int64_t)c[0] - a[0]);
}

/* > 0 if d lies in the circle through a, b, c (counter-clockwise); small coordinates. */
static int64_t in_circle(const int32_t a[2], const int32_t b[2], const int32_t c[2],
                         const int32_t d[2]) {
    const int32_t *p[3] = {a, b, c};
    int64_t x[3], y[3], z[3];
    for (int i = 0; i < 3; i++) {
        x[i] = p[i][0] - d[0];
        y[i] = p[i][1] - d[1];
        z[i] = x[i] * x[i] + y[i] * y[i];
    }
    return x[0] * (y[1] * z[2] - y[2] * z[1]) - y[0] * (x[1] * z[2] - x[2] * z[1]) +
           z[0] * (x[1] * y[2] - x[2] * y[1]);
}

static void check_delaunay(const struct grid *g, uint64_t seed) {
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const int32_t *a = g->vertex[g->triangle[t][0]], *b = g->vertex[g->triangle[t][1]],
                      *c = g->vertex[g->triangle[t][2]];
        check_seed(seed, orient(a, b, c) > 0);
        for (uint32_t v = 0; v < g->vertex_count; v++)
            check_seed(seed, in_circle(a, b, c, g->vertex[v]) <= 0);
    }
    for (uint32_t e = 0; e < g->edge_count; e++) /* boundary edges bound the hull */
        for (uint32_t v = 0; v < g->vertex_count; v++) {
            uint32_t t = g->edge_triangle[e][0];
            int l = grid_opposite(g, t, e);
            const uint32_t *c = g->triangle[t];
            if (g->edge_triangle[e][1] != GRID_NONE) break;
            check_seed(seed, orient(g->vertex[c[(l + 1) % 3]], g->vertex[c[(l + 2) % 3]],
                                    g->vertex[v]) >= 0);
        }
}

/* Distinct points of a small square: many on circles and lines. */
static void test_points(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(300); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        int size = (int)random_in(&state, 2, 30);
        bool used[31 * 31] = {false};
        struct triangulation t = with_vertices((size_t)(size * size));
        struct grid g = {.degree = 1, .axes = {0, 1, 2}};
        struct err err = {0};
        size_t count = 0;
        bool ok, flat = true;
        for (int i = 0; i < size * size / 2 + 3; i++) {
            int64_t x = random_in(&state, 0, size - 1), y = random_in(&state, 0, size - 1);
            if (used[y * 31 + x]) continue;
            used[y * 31 + x] = true;
            t.vertex[count][0] = (double)x;
            t.vertex[count++][1] = (double)y;
        }
        t.vertex_count = count;
        for (size_t i = 2; i < count; i++)
            flat =
                flat && (t.vertex[i][0] - t.vertex[0][0]) * (t.vertex[1][1] - t.vertex[0][1]) ==
                            (t.vertex[i][1] - t.vertex[0][1]) * (t.vertex[1][0] - t.vertex[0][0]);
        ok = triangulation_grid(&g, &t, &(struct lattice_choice){1, 16}, &err);
        check_seed(seed, ok == (count >= 3 && !flat));
        if (ok) {
            check_seed(seed, g.vertex_count == count);
            check_delaunay(&g, seed);
        }
        grid_free(&g);
        triangulation_free(&t);
    }
}

struct figure {
    double vertex[12][2];
    uint32_t triangle[8][3], segment[12][2];
    double seed[2][2];
    size_t vertices, triangles, segments, seeds;
    const char *message; /* NULL: sound */
    uint32_t result;     /* number of triangles then */
};

static bool make(struct grid *g, const struct figure *f, const struct lattice_choice *choice,
                 struct err *err) {
    struct triangulation t = with_vertices(f->vertices);
    bool ok;
    memcpy(t.vertex, f->vertex, f->vertices * sizeof *t.vertex);
    t.triangle_count = f->triangles;
    t.segment_count = f->segments;
    t.seed_count = f->seeds;
    t.triangle = calloc(f->triangles + 1, sizeof *t.triangle);
    t.segment = calloc(f->segments + 1, sizeof *t.segment);
    t.seed = calloc(f->seeds + 1, sizeof *t.seed);
    memcpy(t.triangle, f->triangle, f->triangles * sizeof *t.triangle);
    memcpy(t.segment, f->segment, f->segments * sizeof *t.segment);
    memcpy(t.seed, f->seed, f->seeds * sizeof *t.seed);
    *g = (struct grid){.degree = 1, .axes = {0, 1, 2}};
    ok = triangulation_grid(g, &t, choice, err);
    triangulation_free(&t);
    return ok;
}

/* Two squares, the inner one 2..6 and the outer 0..8. */
#define SQUARES                                                                                    \
    {0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {6, 2}, {6, 6}, {                                      \
        2, 6                                                                                       \
    }
#define ROUNDS                                                                                     \
    {0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {                                      \
        7, 4                                                                                       \
    }

static const struct figure figures[] = {
    {.vertices = 4,
     .vertex = {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
     .triangles = 2,
     .triangle = {{0, 1, 2}, {0, 3, 2}},
     .result = 2},
    {.vertices = 3,
     .vertex = {{0, 0}, {2, 2}, {4, 4}},
     .triangles = 1,
     .triangle = {{0, 1, 2}},
     .message = "triangle 0, with a corner at (0, 0), has no area"},
    {.vertices = 4,
     .vertex = {{0, 0}, {4, 0}, {4, 4}, {3, 3}}, /* both on one side */
     .triangles = 2,
     .triangle = {{0, 1, 2}, {0, 1, 3}},
     .message = "triangles 0 and 1 lie on the same side of their edge {0,1}"},
    {.vertices = 5,
     .vertex = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 3}},
     .triangles = 3,
     .triangle = {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}},
     .message = "has more than two triangles: 0, 1, 2"},
    {.vertices = 5,
     .vertex = {{0, 0}, {2, 0}, {2, 2}, {-2, 0}, {-2, -2}}, /* pinched */
     .triangles = 2,
     .triangle = {{0, 1, 2}, {0, 3, 4}},
     .message = "around vertex 0 form two fans"},
    {.vertices = 6,
     .vertex = {{0, 0}, {4, 0}, {2, 4}, {2, 0}, {0, -3}, {4, -3}},
     .triangles = 2,
     .triangle = {{0, 1, 2}, {3, 4, 5}},
     .message = "overlap or T-junction: the point (2, 0) lies on the side from (0, 0) to (4, 0)"},
    {.vertices = 6,
     .vertex = {{0, 0}, {4, 0}, {2, 4}, {0, 3}, {4, 3}, {2, -1}},
     .triangles = 2,
     .triangle = {{0, 1, 2}, {3, 4, 5}},
     .message = "overlap or T-junction: the side"},
    {.vertices = 6,
     .vertex = {{0, 0}, {8, 0}, {4, 8}, {3, 2}, {5, 2}, {4, 3}}, /* one in another */
     .triangles = 2,
     .triangle = {{0, 1, 2}, {3, 4, 5}},
     .message = "is covered 2 times"},
    {.vertices = 6,
     .vertex = {{0, 0}, {4, 0}, {2, 4}, {0, 0}, {-4, 0}, {-2, -4}},
     .triangles = 2,
     .triangle = {{0, 1, 2}, {3, 4, 5}},
     .message = "points 0 and 3 are both at (0, 0)"},
    /* five triangles round vertex 0 that wind more than once: all counter-clockwise */
    {.vertices = 6,
     .vertex = {{0, 0}, {4, 0}, {-2, 3}, {-2, -3}, {3, 1}, {-1, 3.5}},
     .triangles = 5,
     .triangle = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 3}},
     .message = "triangles"},
    {.vertices = 8, .vertex = {SQUARES}, .segments = 8, .segment = {ROUNDS}, .result = 10},
    {.vertices = 8,
     .vertex = {SQUARES},
     .segments = 8,
     .segment = {ROUNDS},
     .seeds = 1,
     .seed = {{4, 4}},
     .result = 8},
    {.vertices = 8, .vertex = {SQUARES}, .segments = 4, .segment = {ROUNDS}, .result = 10},
    {.vertices = 8,
     .vertex = {SQUARES},
     .segments = 3,
     .segment = {ROUNDS},
     .message = "the segments enclose nothing"},
    {.vertices = 8,
     .vertex = {SQUARES},
     .segments = 1,
     .segment = {{0, 6}},
     .message = "the point (2, 2) lies on the side from (0, 0) to (6, 6)"},
    {.vertices = 4,
     .vertex = {SQUARES},
     .segments = 2,
     .segment = {{0, 2}, {1, 3}},
     .message = "the side from (8, 0) to (0, 8) crosses the side from (0, 0) to (8, 8)"},
    {.vertices = 4,
     .vertex = {SQUARES},
     .segments = 1,
     .segment = {{2, 2}},
     .message = "segment 0 joins a vertex to itself"},
    {.vertices = 3, .vertex = {{0, 0}, {1, 1}, {3, 3}}, .message = "all points lie on a line"},
    {.vertices = 2, .vertex = {{0, 0}, {1, 1}}, .message = "fewer than three vertices"},
    {.vertices = 3,
     .vertex = {{0, 0}, {1, 1}, {0, 0}},
     .message = "points 0 and 2 are both at (0, 0)"},
};

static void test_figures(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) {
        const struct figure *f = &figures[i];
        struct err err = {0};
        struct grid g;
        bool ok = make(&g, f, &sixteen_bits, &err);
        if (ok != !f->message || (!ok && !strstr(err.message, f->message)))
            fail_msg("figure %zu: got '%s'", i, err.message);
        assert_int_equal(ok ? g.triangle_count : 0, f->result);
        if (!ok) assert_int_equal(err.kind, ERR_REFUSAL);
        grid_free(&g);
    }
}

static void test_coarse_lattice(void **unused) {
    static const struct figure flips = {.vertices = 4,
                                        .vertex = {{0, 0}, {100, 0}, {50, 0.01}, {50, 40}},
                                        .triangles = 3,
                                        .triangle = {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}}};
    static const struct figure meets = {
        .vertices = 6,
        .vertex = {{0, 0}, {100, 0}, {50, 40}, {50, -0.1}, {100, -30}, {0, -30}},
        .triangles = 2,
        .triangle = {{0, 1, 2}, {3, 4, 5}}};
    struct err err;
    struct grid g;
    (void)unused;
    assert_false(make(&g, &flips, &(struct lattice_choice){1, 16}, &err));
    assert_non_null(
        strstr(err.message, "lattice too coarse: the triangle with a corner at (0, 0)"));
    grid_free(&g);
    assert_true(make(&g, &flips, &(struct lattice_choice){0, 20}, &err));
    grid_free(&g);
    assert_false(make(&g, &meets, &(struct lattice_choice){1, 16}, &err));
    assert_non_null(strstr(err.message, "lattice too coarse: then the point (50, 0) lies on"));
    grid_free(&g);
    assert_true(make(&g, &meets, &sixteen_bits, &err));
    grid_free(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),
        cmocka_unit_test(test_points),
        cmocka_unit_test(test_figures),
        cmocka_unit_test(test_coarse_lattice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
