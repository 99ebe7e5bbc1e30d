/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: the distance of a segment from a convex cell by ternary search along the segment; insides
 * of polygons by the sum of the angles at which their sides are seen. */
#include "paint.h"

#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef long double real;

static real to_side(real x, real y, const int32_t *a, const int32_t *b) {
    real dx = b[0] - a[0], dy = b[1] - a[1];
    real t = ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return sqrtl((x - a[0] - t * dx) * (x - a[0] - t * dx) +
                 (y - a[1] - t * dy) * (y - a[1] - t * dy));
}

/* Distance of a point from a convex counter-clockwise cell, 0 inside. */
static real to_cell(real x, real y, int n, const int32_t (*c)[2]) {
    real best = HUGE_VALL;
    bool inside = true;
    for (int k = 0; k < n; k++) {
        const int32_t *a = c[k], *b = c[(k + 1) % n];
        inside = inside && (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0;
        best = fminl(best, to_side(x, y, a, b));
    }
    return inside ? 0 : best;
}

static real along(const double *p, const double *q, real t, int n, const int32_t (*c)[2]) {
    return to_cell(p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), n, c);
}

static real segment_to_cell(const double *p, const double *q, int n, const int32_t (*c)[2]) {
    real low = 0, high = 1;
    for (int k = 0; k < 120; k++) {
        real a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (along(p, q, a, n, c) <= along(p, q, b, n, c))
            high = b;
        else
            low = a;
    }
    return fminl(along(p, q, (low + high) / 2, n, c),
                 fminl(along(p, q, 0, n, c), along(p, q, 1, n, c)));
}

/* Times that the polygon goes around (x, y). */
static int winding(real x, real y, size_t n, const double (*xy)[2]) {
    real sum = 0;
    for (size_t i = 0; i < n; i++) {
        const double *p = xy[i], *q = xy[(i + 1) % n];
        real ax = p[0] - x, ay = p[1] - y, bx = q[0] - x, by = q[1] - y;
        sum += atan2l(ax * by - ay * bx, ax * bx + ay * by);
    }
    return (int)lroundl(sum / (2 * acosl(-1)));
}

enum { CORNERS = 12, SHAPES = 8 };

struct shape {
    double xy[CORNERS][2];
    size_t n;
    bool is_polygon;
};

struct scene {
    struct pattern pattern;
    double radius;
    struct shape shape[SHAPES];
};

static void random_shape(struct shape *shape, const double low[2], const double high[2],
                         uint64_t *s) {
    double spread = random_in(s, 0, 2) ? 1 : 0.05, middle[2]; /* some are small */
    for (int c = 0; c < 2; c++) middle[c] = low[c] + (high[c] - low[c]) * random_unit(s);
    shape->n = (size_t)random_in(s, 1, CORNERS);
    shape->is_polygon = random_in(s, 0, 1);
    for (size_t i = 0; i < shape->n; i++)
        for (int c = 0; c < 2; c++) {
            double x = middle[c] + spread * (high[c] - low[c]) * (random_unit(s) - 0.5);
            if (random_in(s, 0, 3) == 0) x = rint(x);
            shape->xy[i][c] = fmin(fmax(x, low[c]), high[c]);
        }
}

/* A copy nearby: much of what is near it is painted already. */
static void move_shape(struct shape *to, const struct shape *from, const double low[2],
                       const double high[2], double side, uint64_t *s) {
    *to = *from;
    for (int c = 0; c < 2; c++) {
        double by = side * (random_unit(s) - 0.5);
        for (size_t i = 0; i < to->n; i++)
            to->xy[i][c] = fmin(fmax(from->xy[i][c] + by, low[c]), high[c]);
    }
}

/* Shapes that keep clear of the outermost cells. */
static void random_scene(struct scene *scene, uint64_t seed) {
    uint64_t s = seed;
    int32_t side = 2 * (int32_t)random_in(&s, 5, 500), low[2], high[2], height = side;
    uint32_t cells[2] = {(uint32_t)random_in(&s, 5, 14), (uint32_t)random_in(&s, 5, 14)};
    struct err err = {0};
    enum pattern_kind kind = (enum pattern_kind)(seed % 3);
    double inner_low[2], inner_high[2];
    if (kind == PATTERN_HEX) height = (13 * side + 7) / 15;
    for (int c = 0; c < 2; c++) {
        low[c] = (int32_t)random_in(&s, -9999, 9999);
        high[c] = low[c] + (int32_t)cells[c] * (c ? height : side);
    }
    assert_true(pattern_init(&scene->pattern, kind, cells, low, high, &err));
    scene->radius = random_in(&s, 0, 4) ? random_unit(&s) * 2 * side : 0;
    for (int c = 0; c < 2; c++) {
        inner_low[c] = low[c] + (c ? height : side);
        inner_high[c] = high[c] - (c ? height : side);
    }
    random_shape(&scene->shape[0], inner_low, inner_high, &s);
    for (int k = 1; k < SHAPES; k++)
        if (seed % 2)
            random_shape(&scene->shape[k], inner_low, inner_high, &s);
        else
            move_shape(&scene->shape[k], &scene->shape[0], inner_low, inner_high, side, &s);
}

static bool paint_shape(struct paint *paint, const struct shape *shape, struct err *err) {
    if (shape->is_polygon)
        return paint_polygon(paint, shape->n, (const double(*)[2])shape->xy, err);
    for (size_t i = 0; i + 1 < shape->n || i == 0; i++)
        paint_segment(paint, shape->xy[i], shape->xy[i + 1 < shape->n ? i + 1 : i]);
    return true;
}

/* What a shape makes of a cell: 1 painted, 0 not, -1 too near to call. */
static int expected(const struct scene *scene, const struct shape *shape, uint32_t column,
                    uint32_t row) {
    real near = HUGE_VALL, x = 0, y = 0,
         slack = (scene->pattern.x[1] - scene->pattern.x[0]) * 1e-8L;
    size_t sides = shape->is_polygon ? shape->n : shape->n > 1 ? shape->n - 1 : 1;
    int32_t c[4][2];
    int n = pattern_cell(&scene->pattern, column, row, c);
    for (size_t i = 0; i < sides; i++)
        near = fminl(near, segment_to_cell(shape->xy[i], shape->xy[(i + 1) % shape->n], n,
                                           (const int32_t(*)[2])c));
    if (fabsl(near - scene->radius) < slack) return -1;
    if (near < scene->radius) return 1;
    for (int k = 0; k < n; k++) {
        x += (real)c[k][0] / n;
        y += (real)c[k][1] / n;
    }
    return shape->is_polygon && winding(x, y, shape->n, (const double(*)[2])shape->xy) != 0;
}

/* Paints shape after shape, and checks all cells after each. */
static int check_scene(const struct scene *scene, uint64_t seed) {
    const struct pattern *p = &scene->pattern;
    struct paint paint;
    struct err err = {0};
    int called = 0, *want = calloc((size_t)p->columns * p->ny, sizeof *want);
    check_seed(seed, want && paint_init(&paint, p, scene->radius, &err));
    for (int k = 0; k < SHAPES; k++) {
        check_seed(seed, paint_shape(&paint, &scene->shape[k], &err));
        for (uint32_t cell = 0; cell < p->columns * p->ny; cell++) {
            int now = expected(scene, &scene->shape[k], cell % p->columns, cell / p->columns);
            if (want[cell] != 1 && now != 0) want[cell] = now;
            called += want[cell] >= 0;
            check_seed(seed, want[cell] < 0 || want[cell] == paint.keep[cell]);
        }
    }
    paint_free(&paint);
    free(want);
    return called;
}

static void test_shapes(void **state) {
    int count = test_count(40), called = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        struct scene scene;
        random_scene(&scene, seed);
        called += check_scene(&scene, seed);
        pattern_free(&scene.pattern);
    }
    assert_true(called > 100 * count);
}

/* A point without a radius is painted wherever it lies, on lines and corners too. */
static void test_points_on_lines(void **state) {
    const uint32_t cells[2] = {6, 6};
    const int32_t low[2] = {-2, -2}, high[2] = {10, 10};
    (void)state;
    for (int kind = 0; kind < 3; kind++)
        for (int x = 0; x <= 16; x++)
            for (int y = 0; y <= 16; y++) {
                const double p[2] = {x / 2., y / 2.};
                struct pattern pattern;
                struct paint paint;
                struct err err = {0};
                size_t painted = 0, holding = 0;
                assert_true(
                    pattern_init(&pattern, (enum pattern_kind)kind, cells, low, high, &err));
                assert_true(paint_init(&paint, &pattern, 0, &err));
                paint_segment(&paint, p, p);
                for (uint32_t c = 0; c < pattern.columns * pattern.ny; c++) {
                    int32_t corner[4][2];
                    int n =
                        pattern_cell(&pattern, c % pattern.columns, c / pattern.columns, corner);
                    bool holds = to_cell(p[0], p[1], n, (const int32_t(*)[2])corner) == 0;
                    holding += holds;
                    painted += paint.keep[c];
                    assert_true(!holds || paint.keep[c]);
                }
                assert_int_equal(painted, holding);
                paint_free(&paint);
                pattern_free(&pattern);
            }
}

/* Random cells, kept off the outermost ones: afterwards grid_build finds one fan everywhere,
 * nothing is lost, and nothing is added where all was well. */
static void test_fans(void **state) {
    int count = test_count(1000), with_gaps = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        uint64_t s = seed;
        const uint32_t cells[2] = {(uint32_t)random_in(&s, 3, 12), (uint32_t)random_in(&s, 3, 12)};
        const int32_t low[2] = {0, 0}, high[2] = {(int32_t)cells[0] * 4, (int32_t)cells[1] * 4};
        struct grid g = {.degree = 1, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
        struct pattern p;
        struct paint b;
        struct err err = {0};
        size_t before = 0, after = 0, added;
        assert_true(pattern_init(&p, (enum pattern_kind)(seed % 3), cells, low, high, &err));
        assert_true(paint_init(&b, &p, 0, &err));
        for (uint32_t row = 1; row + 1 < p.ny; row++)
            for (uint32_t c = 2; c + 2 < p.columns; c++)
                b.keep[row * p.columns + c] = random_in(&s, 0, 2) == 0;
        b.keep[p.columns + 1] = 1;
        uint8_t *old = malloc(p.columns * p.ny);
        assert_non_null(old);
        memcpy(old, b.keep, p.columns * p.ny);
        added = paint_join_fans(&b);
        for (uint32_t c = 0; c < p.columns * p.ny; c++) {
            before += old[c];
            after += b.keep[c];
            check_seed(seed, b.keep[c] >= old[c]);
        }
        check_seed(seed, after == before + added);
        with_gaps += added > 0;
        check_seed(seed, pattern_triangulate(&p, b.keep, &g, &err) && grid_build(&g, &err));
        grid_free(&g);
        assert_true(pattern_triangulate(&p, old, &g, &err));
        g.degree = 1;
        g.axes[1] = 1;
        g.axes[2] = 2;
        g.lattice.step = 1;
        bool sound = grid_build(&g, &err);
        check_seed(seed, sound == (added == 0));
        grid_free(&g);
        free(old);
        paint_free(&b);
        pattern_free(&p);
    }
    assert_true(with_gaps > count / 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shapes),
        cmocka_unit_test(test_points_on_lines),
        cmocka_unit_test(test_fans),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
