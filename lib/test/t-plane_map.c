/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps on triangles: proofs against planted folds, halving against its definition in rationals, and
 * mending of maps with vertices thrown about. */
#include "joint.h"

#include "halfedge.h"
#include "num.h"
#include "planar.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The identity on a random triangulation of a square of this side, the target shaken. */
static void make(struct plane_map *map, const struct planar *recipe, int rounds, uint64_t *state) {
    struct shim_cgal_mesh m;
    size_t n;
    planar_make(&m, recipe, state);
    n = m.vertex_count;
    *map = (struct plane_map){.vertex_count = n, .triangle_count = m.triangle_count};
    map->triangle = m.triangle;
    map->at[0] = calloc(n, sizeof *map->at[0]);
    memcpy(map->at[0], m.vertex, n * sizeof *map->at[0]);
    planar_shake(&m, recipe, rounds, state);
    map->at[1] = m.vertex;
}

static bool total(mpq_t area, const struct plane_map *map, int plane) {
    return planar_total(area, (const double(*)[2])map->at[plane],
                        (const uint32_t(*)[3])map->triangle, map->triangle_count);
}

/* Each edge in two triangles, or in one: on the boundary of the square. */
static bool is_conforming(const struct plane_map *map, double side) {
    const uint32_t(*triangle)[3] = (const uint32_t(*)[3])map->triangle;
    uint32_t *twin;
    struct err err;
    bool ok = halfedge_twins(&twin, triangle, map->triangle_count, &err);
    for (uint32_t h = 0; ok && h < 3 * map->triangle_count; h++) {
        const double *a = map->at[0][halfedge_from(triangle, h)],
                     *b = map->at[0][halfedge_to(triangle, h)];
        bool rim = false;
        for (int c = 0; c < 2; c++) rim = rim || (a[c] == b[c] && (a[c] == 0 || a[c] == side));
        ok = twin[h] == HALFEDGE_NONE ? rim : !rim && twin[twin[h]] == h;
    }
    free(twin);
    return ok;
}

static double largest(const struct plane_map *map) {
    double most = 0;
    for (size_t t = 0; t < map->triangle_count; t++) {
        const double *a = map->at[0][map->triangle[t][0]], *b = map->at[0][map->triangle[t][1]],
                     *c = map->at[0][map->triangle[t][2]];
        most = fmax(most, (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    return most / 2;
}

/* Coordinates are multiples of 1/64, so that halving them is exact for a while. */
static void test_split(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(100); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct planar recipe = {4, 1, (int)random_in(&state, 0, 40),
                                (int)random_in(&state, 0, 1000)};
        double limit = 16 / pow(2, random_unit(&state) * 12);
        struct plane_map map;
        struct err err;
        mpq_t area[2], whole;
        mpq_inits(area[0], area[1], whole, NULL);
        mpq_set_ui(whole, 32, 1);
        make(&map, &recipe, 20, &state);
        size_t before = map.triangle_count;
        bool small = largest(&map) <= limit;
        check_seed(seed, plane_map_split(&map, limit, 1000000, 0, &err));
        check_seed(seed, small == (map.triangle_count == before));
        check_seed(seed, largest(&map) <= limit && is_conforming(&map, 4));
        for (int m = 0; m < 2; m++)
            check_seed(seed, total(area[m], &map, m) && mpq_equal(area[m], whole));
        check_seed(seed, (double)map.triangle_count <= (double)before + 8 * 32 / limit);
        check_seed(seed, plane_map_prove(&map, &err));
        plane_map_free(&map);
        mpq_clears(area[0], area[1], whole, NULL);
    }
}

/* With few digits there are triangles that cannot be halved; the rest is sound. */
static void test_split_digits(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(50); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct planar recipe = {4, 1, 0, 1000};
        struct plane_map map;
        struct err err;
        mpq_t area;
        mpq_init(area);
        make(&map, &recipe, 0, &state);
        check_seed(seed, plane_map_split(&map, 0.01, 1000000, 2, &err));
        check_seed(seed, map.triangle_count > 500 && largest(&map) > 0.01);
        for (int m = 0; m < 2; m++) check_seed(seed, total(area, &map, m));
        for (size_t v = 0; v < map.vertex_count; v++)
            for (int c = 0; c < 2; c++)
                check_seed(seed, map.at[1][v][c] == num_rounded(map.at[1][v][c], 2));
        plane_map_free(&map);
        mpq_clear(area);
    }
}

static void test_split_limit(void **unused) {
    uint64_t state = 1;
    struct plane_map map;
    struct err err = {0};
    (void)unused;
    make(&map, &(struct planar){4, 1, 10, 0}, 0, &state);
    assert_false(plane_map_split(&map, 1e-3, 1000, 0, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message, "more than 1000 triangles are needed");
    plane_map_free(&map);
}

static void test_prove(void **unused) {
    uint64_t state = 2;
    struct plane_map map;
    struct err err = {0};
    (void)unused;
    make(&map, &(struct planar){2, 1, 30, 0}, 10, &state);
    assert_true(plane_map_prove(&map, &err));
    for (int m = 0; m < 2; m++) {
        double *p = map.at[m][8], old = p[0]; /* the first one inside */
        p[0] += 100;
        assert_false(plane_map_prove(&map, &err));
        assert_int_equal(err.kind, ERR_REFUSAL);
        assert_non_null(strstr(err.message, m == 0 ? "of the source is turned over"
                                                   : "of the target is turned over"));
        p[0] = old;
    }
    plane_map_free(&map);
}

/* A strip of counter-clockwise triangles that runs round in a circle and over its own beginning. */
static void test_prove_overlap(void **unused) {
    enum { STEPS = 20 };
    struct plane_map map = {2 * (STEPS + 1), 2 * STEPS, {NULL, NULL}, NULL};
    struct err err = {0};
    (void)unused;
    map.triangle = calloc(map.triangle_count, sizeof *map.triangle);
    for (int m = 0; m < 2; m++) map.at[m] = calloc(map.vertex_count, sizeof *map.at[m]);
    for (int i = 0; i <= STEPS; i++)
        for (int k = 0; k < 2; k++) {
            double *p = map.at[0][2 * i + k], *q = map.at[1][2 * i + k], angle = i * 0.35;
            p[0] = i;
            p[1] = k == 0 ? 1 : 0;
            q[0] = (k == 0 ? 1 : 2) * cos(angle);
            q[1] = (k == 0 ? 1 : 2) * sin(angle);
        }
    for (uint32_t i = 0; i < STEPS; i++) {
        const uint32_t t[2][3] = {{2 * i, 2 * i + 1, 2 * i + 2}, {2 * i + 1, 2 * i + 3, 2 * i + 2}};
        memcpy(map.triangle[2 * i], t, sizeof t);
    }
    assert_true(plane_map_flipped(&map, 0, 0) == map.triangle_count);
    assert_true(plane_map_flipped(&map, 1, 0) == map.triangle_count);
    assert_false(plane_map_prove(&map, &err));
    assert_non_null(strstr(err.message, "the boundary of the target, as rounded, meets itself"));
    plane_map_free(&map);
}

/* Some vertices are thrown about; mending takes them away, or says how many triangles it left. */
static void test_mend(void **unused) {
    int mended = 0, n = 0;
    (void)unused;
    for (; n < test_count(200); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct planar recipe = {4, 1, 60, 200};
        struct plane_map map;
        struct joint j;
        struct err err;
        size_t left, flipped = 0;
        mpq_t area, whole;
        mpq_inits(area, whole, NULL);
        mpq_set_ui(whole, 32, 1);
        make(&map, &recipe, 5, &state);
        for (int64_t i = random_in(&state, 0, 4); i > 0; i--) {
            size_t v = (size_t)random_in(&state, 16, (int64_t)map.vertex_count - 1);
            for (int c = 0; c < 2; c++) map.at[1][v][c] = 0.5 + 3 * random_unit(&state);
        }
        check_seed(seed, joint_init(&j, &map, NULL, &err));
        memset(j.fixed, true, 16);
        check_seed(seed, joint_mend(&j, &left, &err));
        check_seed(seed, joint_finish(&j, &map, &err));
        for (size_t t = 0; t < map.triangle_count; t++)
            flipped += plane_map_flipped(&map, 1, t) == t;
        check_seed(seed, flipped == left && total(area, &map, 0) && mpq_equal(area, whole));
        if (left == 0) check_seed(seed, total(area, &map, 1) && mpq_equal(area, whole));
        mended += left == 0;
        plane_map_free(&map);
        joint_free(&j);
        mpq_clears(area, whole, NULL);
    }
    assert_true(mended > n / 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_split),         cmocka_unit_test(test_split_digits),
        cmocka_unit_test(test_split_limit),   cmocka_unit_test(test_prove),
        cmocka_unit_test(test_prove_overlap), cmocka_unit_test(test_mend),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
