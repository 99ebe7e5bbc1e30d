/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Point in polygon against a winding sum in integers, and planted answers. Coordinates are small
 * integers, so that points fall on vertices and edges all the time. */
#include "polygon.h"

#include "testing.h"
#include "xy_io.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct loops {
    size_t loop_count, start[5];
    int64_t xy[400][2];
};

static void build(struct polygon *g, const struct loops *l, double scale) {
    struct err err;
    size_t n = l->start[l->loop_count];
    *g = (struct polygon){.point_count = n, .loop_count = l->loop_count};
    g->point = calloc(n, sizeof *g->point);
    g->loop_start = calloc(l->loop_count + 1, sizeof *g->loop_start);
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) g->point[i][c] = (double)l->xy[i][c] * scale;
    memcpy(g->loop_start, l->start, (l->loop_count + 1) * sizeof *g->loop_start);
    assert_true(polygon_build(g, &err));
}

/* On a loop: 0. Else the parity of edges that a ray to the left, slightly raised, meets. */
static int brute(const struct loops *l, int64_t px, int64_t py) {
    bool inside = false;
    for (size_t k = 0; k < l->loop_count; k++)
        for (size_t i = l->start[k]; i < l->start[k + 1]; i++) {
            const int64_t *a = l->xy[i], *b = l->xy[i + 1 < l->start[k + 1] ? i + 1 : l->start[k]];
            int64_t cross = (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]);
            int64_t dot = (px - a[0]) * (px - b[0]) + (py - a[1]) * (py - b[1]);
            if (cross == 0 && dot <= 0) return 0;
            if (a[1] <= py && b[1] > py && cross < 0) inside = !inside;
            if (b[1] <= py && a[1] > py && cross > 0) inside = !inside;
        }
    return inside ? 1 : -1;
}

static void random_loops(struct loops *l, uint64_t *state, int size) {
    l->loop_count = (size_t)random_in(state, 1, 4);
    l->start[0] = 0;
    for (size_t k = 0; k < l->loop_count; k++) {
        l->start[k + 1] = l->start[k] + (size_t)random_in(state, 1, 90);
        for (size_t i = l->start[k]; i < l->start[k + 1]; i++)
            for (int c = 0; c < 2; c++) l->xy[i][c] = random_in(state, 0, size);
    }
}

/* The square of the distance from edge a b, in units. */
static double distance2(const int64_t a[2], const int64_t b[2], int64_t px, int64_t py) {
    double x = (double)(b[0] - a[0]), y = (double)(b[1] - a[1]), size = x * x + y * y;
    double dx = (double)(px - a[0]), dy = (double)(py - a[1]);
    double s = size > 0 ? (dx * x + dy * y) / size : 0;
    s = s < 0 ? 0 : s > 1 ? 1 : s;
    return (dx - s * x) * (dx - s * x) + (dy - s * y) * (dy - s * y);
}

/* Edges of no length are no edges. */
static void check_near(const struct polygon *g, const struct loops *l, int64_t px, int64_t py,
                       double scale, uint64_t seed) {
    double p[2] = {(double)px * scale, (double)py * scale}, best = INFINITY;
    size_t edge = SIZE_MAX;
    bool found;
    if (scale > 1 || scale < 1) return; /* squares of distances overflow */
    for (size_t k = 0; k < l->loop_count; k++)
        for (size_t i = l->start[k]; i < l->start[k + 1]; i++) {
            const int64_t *a = l->xy[i], *b = l->xy[i + 1 < l->start[k + 1] ? i + 1 : l->start[k]];
            if (memcmp(a, b, sizeof *l->xy) == 0) return;
            best = fmin(best, distance2(a, b, px, py));
        }
    found = polygon_near(g, p, 1.05, &edge);
    check_seed(seed, found == (best < 1.05 * 1.05));
    if (!found) return;
    const double *a = g->point[edge], *b = g->point[g->next[edge]];
    const int64_t ia[2] = {(int64_t)a[0], (int64_t)a[1]}, ib[2] = {(int64_t)b[0], (int64_t)b[1]};
    check_seed(seed, fabs(distance2(ia, ib, px, py) - best) < 1e-12);
}

/* The sense of a loop is the sign of its area where it is simple; the lowest point is lowest. */
static void test_sense(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(300); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct loops l = {1, {0, 3}, {{0}}};
        struct polygon g;
        int64_t area;
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 2; c++) l.xy[i][c] = random_in(&state, 0, 4);
        area = (l.xy[1][0] - l.xy[0][0]) * (l.xy[2][1] - l.xy[0][1]) -
               (l.xy[1][1] - l.xy[0][1]) * (l.xy[2][0] - l.xy[0][0]);
        build(&g, &l, 1);
        check_seed(seed, polygon_sense(&g, 0) == (area > 0) - (area < 0));
        size_t low = polygon_lowest(&g, 0);
        for (int i = 0; i < 3; i++)
            check_seed(seed, l.xy[low][0] < l.xy[i][0] ||
                                 (l.xy[low][0] == l.xy[i][0] && l.xy[low][1] <= l.xy[i][1]));
        polygon_free(&g);
    }
}

static void test_random(void **unused) {
    static const double scales[] = {1, 0x1p-1000, 0x1p1000, 0.1};
    (void)unused;
    for (int n = 0; n < test_count(2000); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct loops l;
        struct polygon g;
        int size = (int)random_in(&state, 1, 12);
        double scale = scales[n % 3]; /* powers of two: no rounding */
        random_loops(&l, &state, size);
        build(&g, &l, scale);
        for (int64_t x = -1; x <= size + 1; x++)
            for (int64_t y = -1; y <= size + 1; y++) {
                double p[2] = {(double)x * scale, (double)y * scale};
                check_seed(seed, polygon_side(&g, p) == brute(&l, x, y));
                check_near(&g, &l, x, y, scale, seed);
            }
        polygon_free(&g);
    }
}

/* Points beside the edge from (0,0) to (3,1) that no rounded cross product could tell apart. */
static void test_exact(void **unused) {
    struct loops l = {1, {0, 3}, {{0, 0}, {3, 1}, {0, 1}}};
    struct polygon g;
    double third = 1.0 / 3; /* below 1/3, so (1, third) is outside */
    (void)unused;
    build(&g, &l, 1);
    assert_int_equal(polygon_side(&g, (double[2]){1, third}), -1);
    assert_int_equal(polygon_side(&g, (double[2]){1, 0x1.5555555555556p-2}), 1);
    assert_int_equal(polygon_side(&g, (double[2]){1.5, 0.5}), 0);
    assert_int_equal(polygon_side(&g, (double[2]){0, 0}), 0);
    polygon_free(&g);
}

/* A comb has edges that reach through every band; a long one must not cost n^2. */
static void test_comb(void **unused) {
    enum { TEETH = 100000 };
    struct polygon g = {.point_count = 2 * TEETH, .loop_count = 1};
    struct err err;
    (void)unused;
    g.point = calloc(g.point_count, sizeof *g.point);
    g.loop_start = calloc(2, sizeof *g.loop_start);
    g.loop_start[1] = g.point_count;
    for (size_t i = 0; i < g.point_count; i++) {
        g.point[i][0] = (double)i;
        g.point[i][1] = i % 2 ? 1000 : 0;
    }
    assert_true(polygon_build(&g, &err));
    assert_int_equal(polygon_side(&g, (double[2]){1, 500}), 1);
    assert_int_equal(polygon_side(&g, (double[2]){2, 500}), -1);
    assert_int_equal(polygon_side(&g, (double[2]){0.5, 500}), 0);
    polygon_free(&g);
}

/* ---- xy_io ---- */

static const char *write_file(const char *text) {
    static char path[64];
    FILE *f;
    snprintf(path, sizeof path, "/tmp/t-polygon.%ld", (long)getpid());
    f = fopen(path, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    return path;
}

static bool read_text(const char *text, struct polygon *g, struct err *err) {
    const char *path = write_file(text);
    bool ok = xy_read_polygon(g, path, err);
    unlink(path);
    return ok;
}

static void test_read(void **unused) {
    static const char *const texts[] = {
        "0 0\n4 0\n4 4\n0 4\n\n1 1\n2 1\n2 2\n",
        "# outer\n0 0\n4 0 # right\n# no end of the loop\n4 4\n0 4\n \t\n\nHOLE\n1 1\n2 1\n2 2\n\n",
        "\n\n0 0\r\n4 0\r\n4 4\r\n0 4\r\n\r\n1 1\r\n2 1\r\n2 2",
        "HOLE\n+0 -0\n4e0 0\n4. 4\n0 4\n  HOLE # hole\n1 1\n2 1\n2 2\nHOLE\n",
    };
    (void)unused;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct polygon g;
        struct err err;
        assert_true(read_text(texts[i], &g, &err));
        assert_int_equal(g.loop_count, 2);
        assert_int_equal(g.loop_start[1], 4);
        assert_int_equal(g.point_count, 7);
        assert_int_equal(polygon_side(&g, (double[2]){3, 2}), 1);
        assert_int_equal(polygon_side(&g, (double[2]){1.75, 1.5}), -1); /* in the hole */
        polygon_free(&g);
    }
}

static void test_refusals(void **unused) {
    static const struct {
        const char *text;
        size_t line, col;
        const char *message;
    } bad[] = {
        {"", 1, 1, "expected a polygon, got end of file"},
        {"# nothing\n\n", 3, 1, "expected a polygon, got end of file"},
        {"0 0\n1 0\n", 1, 1, "expected a loop of three points or more, got 2"},
        {"0 0\n1 0\n1 1\n\n5 5\n", 5, 1, "expected a loop of three points or more, got 1"},
        {"0 0\n1\n", 2, 2, "expected y, got end of line"},
        {"0 0\n1 nan\n", 2, 3, "expected y, got 'nan'"},
        {"0 0\n1 0 7\n", 2, 5, "expected the end of the line, got '7'"},
        {"0 0\n1 0\n1 1\nHOLE 2\n", 4, 6, "expected the end of the line, got '2'"},
        {"hole\n", 1, 1, "expected x, got 'hole'"},
        {"4 2 0 1\n1 0 0 1\n", 1, 1,
         "expected 'x y', got the header of a .poly file; mkgrid --triangulation reads those"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct polygon g;
        struct err err = {0};
        assert_false(read_text(bad[i].text, &g, &err));
        assert_string_equal(err.message, bad[i].message);
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
        assert_int_equal(err.kind, ERR_INPUT);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random), cmocka_unit_test(test_sense),
        cmocka_unit_test(test_exact),  cmocka_unit_test(test_comb),
        cmocka_unit_test(test_read),   cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
