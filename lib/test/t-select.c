/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Selections against brute force: looks at all points, and breadth-first searches in a net that is
 * built from integer positions without grid's numbering within triangles. */
#include "select.h"

#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct fixture {
    uint64_t seed, state;
    struct grid g;
    double (*phi)[2], (*nominal)[2];
    struct select_space space;
    int64_t (*key)[2]; /* nominal position times degree, an integer */
    int *distance;
};

static void set_up(struct fixture *f, uint64_t seed) {
    *f = (struct fixture){.seed = seed, .state = seed};
    int degree = (int)random_in(&f->state, 1, 6);
    random_grid(&f->g, (int)random_in(&f->state, 1, 4), degree, seed);
    f->phi = calloc(f->g.point_count, sizeof *f->phi);
    f->nominal = calloc(f->g.point_count, sizeof *f->nominal);
    f->key = calloc(f->g.point_count, sizeof *f->key);
    f->distance = calloc(f->g.point_count, sizeof *f->distance);
    for (uint32_t p = 0; p < f->g.point_count; p++) {
        grid_nominal(&f->g, p, f->nominal[p]);
        for (int c = 0; c < 2; c++) {
            f->key[p][c] = llround(f->nominal[p][c] * degree);
            f->phi[p][c] = floor(f->nominal[p][c]) + (double)random_in(&f->state, -2, 2);
        }
    }
    select_init(&f->space, &f->g, (const double(*)[2])f->phi);
}

static void tear_down(struct fixture *f) {
    select_free(&f->space);
    grid_free(&f->g);
    free(f->phi);
    free(f->nominal);
    free(f->key);
    free(f->distance);
}

/* A coordinate in and around the grid, often that of a control point. */
static double any_coordinate(struct fixture *f, int c) {
    uint32_t p = (uint32_t)random_in(&f->state, 0, f->g.point_count - 1);
    double x = f->nominal[p][c];
    return random_in(&f->state, 0, 1) ? x : x + 3 * (random_unit(&f->state) - 0.5);
}

static struct point_set run(struct fixture *f, const struct selector *s) {
    struct point_set set = {0};
    struct err err;
    check_seed(f->seed, select_points(&f->space, s, &set, &err));
    point_set_sort(&set);
    return set;
}

/* The set must be the points for which want[] is set. */
static void check_set(struct fixture *f, struct point_set *set, const bool *want) {
    size_t at = 0;
    for (uint32_t p = 0; p < f->g.point_count; p++)
        if (want[p]) {
            check_seed(f->seed, at < set->count && set->point[at] == p);
            at++;
        }
    check_seed(f->seed, at == set->count);
    free(set->point);
}

static void test_sets(void **unused) {
    uint32_t numbers[] = {5, 3, 9, 3, 5, 5, 0};
    struct point_set set = {0}, empty = {0};
    struct err err;
    (void)unused;
    for (size_t i = 0; i < 7; i++) assert_true(point_set_add(&set, numbers[i], &err));
    point_set_sort(&set);
    point_set_sort(&empty);
    assert_int_equal(set.count, 4);
    assert_memory_equal(set.point, ((uint32_t[]){0, 3, 5, 9}), 16);
    assert_true(point_set_has(&set, 9));
    assert_false(point_set_has(&set, 4));
    assert_false(point_set_has(&empty, 4));
    free(set.point);
}

/* ---- words ---- */

static void check_numbers(struct fixture *f) {
    uint32_t n = f->g.point_count, t = (uint32_t)random_in(&f->state, 0, f->g.triangle_count - 1);
    struct selector range = {.kind = SELECT_RANGE}, all = {.kind = SELECT_ALL};
    struct selector vertex = {.kind = SELECT_VERTEX, .vertex = f->g.vertex_count - 1};
    struct selector place = {.kind = SELECT_PLACE};
    bool *want = calloc(n, 1);
    struct point_set set;
    int i = (int)random_in(&f->state, 0, f->g.degree);
    int j = (int)random_in(&f->state, 0, f->g.degree - i);
    range.range.first = (uint32_t)random_in(&f->state, 0, n - 1);
    range.range.last = (uint32_t)random_in(&f->state, range.range.first, n - 1);
    for (uint32_t p = range.range.first; p <= range.range.last; p++) want[p] = true;
    set = run(f, &range);
    check_set(f, &set, want);
    memset(want, 1, n);
    set = run(f, &all);
    check_set(f, &set, want);
    memset(want, 0, n);
    want[f->g.vertex_count - 1] = true;
    set = run(f, &vertex);
    check_set(f, &set, want);
    place.place.triangle = t;
    place.place.weight[0] = i;
    place.place.weight[1] = j;
    place.place.weight[2] = f->g.degree - i - j;
    set = run(f, &place);
    check_seed(f->seed, set.count == 1);
    for (int c = 0; c < 2; c++) {
        int64_t sum = 0;
        for (int l = 0; l < 3; l++)
            sum += place.place.weight[l] * f->g.vertex[f->g.triangle[t][l]][c];
        check_seed(f->seed, f->key[set.point[0]][c] == sum);
    }
    free(set.point);
    free(want);
}

static void check_nearest(struct fixture *f, bool nominal, bool corner) {
    const double(*at)[2] = (const double(*)[2])(nominal ? f->nominal : f->phi);
    uint32_t n = corner ? f->g.vertex_count : f->g.point_count, best = 0;
    struct selector s = {.kind = SELECT_NEAREST};
    struct point_set set;
    double least = INFINITY;
    s.nearest.nominal = nominal;
    s.nearest.corner = corner;
    for (int c = 0; c < 2; c++) s.nearest.xy[c] = floor(any_coordinate(f, c) * 4) / 4;
    for (uint32_t p = 0; p < n; p++) {
        double dx = at[p][0] - s.nearest.xy[0], dy = at[p][1] - s.nearest.xy[1];
        double d2 = dx * dx + dy * dy;
        if (d2 < least) {
            least = d2;
            best = p;
        }
    }
    set = run(f, &s);
    check_seed(f->seed, set.count == 1 && set.point[0] == best);
    free(set.point);
}

static void check_box(struct fixture *f) {
    struct selector s = {.kind = SELECT_BOX};
    bool *want = calloc(f->g.point_count, 1);
    struct point_set set;
    size_t count = 0;
    for (int c = 0; c < 2; c++) {
        double a = any_coordinate(f, c), b = any_coordinate(f, c);
        s.box.lo[c] = fmin(a, b);
        s.box.hi[c] = fmax(a, b);
    }
    for (uint32_t p = 0; p < f->g.point_count; p++) {
        const double *x = f->nominal[p];
        want[p] = x[0] >= s.box.lo[0] && x[0] <= s.box.hi[0] && x[1] >= s.box.lo[1] &&
                  x[1] <= s.box.hi[1];
        count += want[p];
    }
    if (count > 0) {
        set = run(f, &s);
        check_set(f, &set, want);
    }
    free(want);
}

/* A right triangle with a corner at control point p. */
static void check_inside(struct fixture *f) {
    struct polygon g = {.point_count = 3, .loop_count = 1};
    struct selector s = {.kind = SELECT_INSIDE};
    bool *want = calloc(f->g.point_count, 1);
    uint32_t corner = (uint32_t)random_in(&f->state, 0, f->g.point_count - 1);
    const double *o = f->nominal[corner];
    double size = (double)random_in(&f->state, 1, 40) / 4;
    struct point_set set;
    struct err err;
    g.point = calloc(3, sizeof *g.point);
    g.loop_start = calloc(2, sizeof *g.loop_start);
    g.loop_start[1] = 3;
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 2; c++) g.point[i][c] = o[c] + (i == c + 1 ? size : 0);
    assert_true(polygon_build(&g, &err));
    for (uint32_t p = 0; p < f->g.point_count; p++) want[p] = polygon_side(&g, f->nominal[p]) >= 0;
    s.inside.polygon = &g;
    s.inside.file = "triangle.xy";
    check_seed(f->seed, want[corner]);
    set = run(f, &s);
    check_set(f, &set, want);
    polygon_free(&g);
    free(want);
}

static void move_some(struct fixture *f) {
    for (int i = 0; i < 5; i++) {
        uint32_t p = (uint32_t)random_in(&f->state, 0, f->g.point_count - 1);
        for (int c = 0; c < 2; c++) f->phi[p][c] += (double)random_in(&f->state, -8, 8);
        select_moved(&f->space, p);
    }
}

static void test_words(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(200); n++) {
        struct fixture f;
        set_up(&f, (uint64_t)n);
        for (int i = 0; i < 10; i++) {
            check_numbers(&f);
            for (int kind = 0; kind < 4; kind++) check_nearest(&f, kind & 1, kind & 2);
            check_box(&f);
            check_inside(&f);
            move_some(&f);
        }
        tear_down(&f);
    }
}

static void check_refusal(struct fixture *f, const struct selector *s, const char *message) {
    struct point_set set = {0};
    struct err err = {0};
    assert_false(select_points(&f->space, s, &set, &err));
    assert_string_equal(err.message, message);
    assert_int_equal(err.kind, ERR_INPUT);
    free(set.point);
}

static void test_refusals(void **unused) {
    struct fixture f = {0};
    struct recipe r = {.nx = 2, .ny = 1, .spacing = 2};
    struct err err;
    struct selector s = {.kind = SELECT_RANGE};
    (void)unused;
    triangulate(&f.g, &r, 5, 0);
    assert_true(grid_build(&f.g, &err));
    f.phi = calloc(f.g.point_count, sizeof *f.phi);
    select_init(&f.space, &f.g, (const double(*)[2])f.phi);
    s.range.first = 3;
    s.range.last = 66;
    check_refusal(&f, &s, "expected a point in 0..65, got 66");
    s = (struct selector){.kind = SELECT_VERTEX, .vertex = 6};
    check_refusal(&f, &s, "expected a vertex in 0..5, got 6");
    s = (struct selector){.kind = SELECT_PLACE, .place = {4, {5, 0, 0}}};
    check_refusal(&f, &s, "expected a triangle in 0..3, got 4");
    s = (struct selector){.kind = SELECT_PLACE, .place = {3, {1, 2, 3}}};
    check_refusal(&f, &s, "expected Bezier indices whose sum is the degree, 5, got 1,2,3");
    s = (struct selector){.kind = SELECT_BOX, .box = {{1.5, -4}, {1.6, -3}}};
    check_refusal(&f, &s, "expected a box with control points, got none in it");
    tear_down(&f);
}

/* ---- neighbourhoods ---- */

/* Are two control points neighbours in the net of some triangle? Their difference times degree is
 * then a side of the triangle, and both lie in it. */
static bool in_triangle(const struct fixture *f, uint32_t t, const int64_t key[2]) {
    const uint32_t *v = f->g.triangle[t];
    int64_t d = f->g.degree;
    for (int l = 0; l < 3; l++) {
        const int32_t *a = f->g.vertex[v[l]], *b = f->g.vertex[v[(l + 1) % 3]];
        if ((b[0] - a[0]) * (key[1] - d * a[1]) - (b[1] - a[1]) * (key[0] - d * a[0]) < 0)
            return false;
    }
    return true;
}

static bool joined(const struct fixture *f, uint32_t p, uint32_t q) {
    int64_t dx = f->key[q][0] - f->key[p][0], dy = f->key[q][1] - f->key[p][1];
    for (uint32_t t = 0; t < f->g.triangle_count; t++) {
        const uint32_t *v = f->g.triangle[t];
        for (int l = 0; l < 6; l++) {
            const int32_t *a = f->g.vertex[v[l % 3]];
            const int32_t *b = f->g.vertex[v[(l % 3 + 1 + l / 3) % 3]];
            if (b[0] - a[0] == dx && b[1] - a[1] == dy && in_triangle(f, t, f->key[p]) &&
                in_triangle(f, t, f->key[q]))
                return true;
        }
    }
    return false;
}

/* Relaxes distances until nothing changes. */
static void brute_distances(struct fixture *f, const bool *joins, const struct point_set *anchors) {
    uint32_t n = f->g.point_count;
    bool changed = true;
    for (uint32_t p = 0; p < n; p++) f->distance[p] = point_set_has(anchors, p) ? 0 : 1 << 20;
    while (changed) {
        changed = false;
        for (uint32_t p = 0; p < n; p++)
            for (uint32_t q = 0; q < n; q++)
                if (joins[p * n + q] && f->distance[p] + 1 < f->distance[q]) {
                    f->distance[q] = f->distance[p] + 1;
                    changed = true;
                }
    }
}

static void random_anchors(struct fixture *f, struct point_set *anchors) {
    struct err err;
    int64_t n = random_in(&f->state, 1, random_in(&f->state, 0, 3) ? 3 : 30);
    anchors->count = 0;
    while (n-- > 0)
        assert_true(
            point_set_add(anchors, (uint32_t)random_in(&f->state, 0, f->g.point_count - 1), &err));
    point_set_sort(anchors);
}

static void check_reach(struct fixture *f, const bool *joins, const struct point_set *anchors) {
    int steps = (int)random_in(&f->state, 0, 7), level = 1;
    struct point_set set = {0};
    struct err err;
    bool *want = calloc(f->g.point_count, 1);
    brute_distances(f, joins, anchors);
    for (uint32_t p = 0; p < f->g.point_count; p++)
        want[p] = f->distance[p] >= 1 && f->distance[p] <= steps;
    check_seed(f->seed, select_reach(&f->space, anchors, (uint32_t)steps, &set, &err));
    for (size_t i = 0; i < set.count; i++) { /* nearest first */
        check_seed(f->seed, f->distance[set.point[i]] >= level);
        level = f->distance[set.point[i]];
    }
    point_set_sort(&set);
    check_set(f, &set, want);
    free(want);
}

static void check_within(struct fixture *f, const struct point_set *anchors) {
    double distance = (double)random_in(&f->state, 0, 12) / 2;
    struct point_set set = {0};
    struct err err;
    bool *want = calloc(f->g.point_count, 1);
    for (uint32_t p = 0; p < f->g.point_count; p++)
        for (size_t i = 0; i < anchors->count; i++) {
            const double *a = f->nominal[anchors->point[i]], *b = f->nominal[p];
            double dx = b[0] - a[0], dy = b[1] - a[1];
            want[p] |= dx * dx + dy * dy <= distance * distance;
        }
    check_seed(f->seed, select_within(&f->space, anchors, distance, &set, &err));
    point_set_sort(&set);
    check_set(f, &set, want);
    free(want);
}

static void test_neighbourhoods(void **unused) {
    int tried = 0;
    (void)unused;
    for (int n = 0; n < test_count(300); n++) {
        struct fixture f;
        struct point_set anchors = {0};
        bool *joins;
        set_up(&f, (uint64_t)n);
        if (f.g.point_count > 400) {
            tear_down(&f);
            continue;
        }
        tried++;
        joins = calloc((size_t)f.g.point_count * f.g.point_count, 1);
        for (uint32_t p = 0; p < f.g.point_count; p++)
            for (uint32_t q = 0; q < f.g.point_count; q++)
                joins[p * f.g.point_count + q] = joined(&f, p, q);
        for (int i = 0; i < 10; i++) {
            random_anchors(&f, &anchors);
            check_reach(&f, joins, &anchors);
            check_within(&f, &anchors);
        }
        free(joins);
        free(anchors.point);
        tear_down(&f);
    }
    assert_true(4 * tried >= test_count(300));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sets),
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_neighbourhoods),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
