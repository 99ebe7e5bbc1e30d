/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps made of overlays of random meshes, settled at doubles or at few digits: by exact areas, no
 * triangle is turned over in either plane, nothing is lost, and fixed vertices are where they
 * belong. */
#include "overlay_map.h"

#include "num.h"
#include "planar.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Two meshes of the square, and where their vertices lie in the two domains. */
struct pair {
    struct shim_cgal_mesh cgal[2], domain[2];
    struct overlay_mesh mesh[2];
    struct overlay o;
    struct overlay_map m;
};

static void copy_mesh(struct shim_cgal_mesh *to, const struct shim_cgal_mesh *from) {
    *to = *from;
    to->vertex = calloc(from->vertex_count, sizeof *to->vertex);
    to->triangle = calloc(from->triangle_count, sizeof *to->triangle);
    memcpy(to->vertex, from->vertex, from->vertex_count * sizeof *to->vertex);
    memcpy(to->triangle, from->triangle, from->triangle_count * sizeof *to->triangle);
}

static void nudge(struct shim_cgal_mesh *m, size_t first, uint64_t *state) {
    for (size_t v = first; v < m->vertex_count; v++)
        m->vertex[v][random_in(state, 0, 1)] *= 1 + 0x1p-52 * (double)random_in(state, -2, 2);
}

static void pair_make(struct pair *p, const struct planar *recipe, bool near, uint64_t *state) {
    *p = (struct pair){.m = {.overlay = &p->o, .mesh = p->mesh}};
    for (int m = 0; m < 2; m++) {
        if (m == 1 && near) {
            copy_mesh(&p->cgal[1], &p->cgal[0]);
            nudge(&p->cgal[1], 4 * (size_t)recipe->size, state);
        } else
            planar_make(&p->cgal[m], recipe, state);
        p->mesh[m] = (struct overlay_mesh){p->cgal[m].vertex_count, p->cgal[m].triangle_count,
                                           (const double(*)[2])p->cgal[m].vertex,
                                           (const uint32_t(*)[3])p->cgal[m].triangle};
        copy_mesh(&p->domain[m], &p->cgal[m]);
        planar_shake(&p->domain[m], recipe, 20, state);
        p->m.x[m] = (const double(*)[2])p->domain[m].vertex;
    }
}

static void pair_free(struct pair *p) {
    for (int m = 0; m < 2; m++) {
        free(p->cgal[m].vertex);
        free(p->cgal[m].triangle);
        free(p->domain[m].vertex);
        free(p->domain[m].triangle);
    }
    overlay_free(&p->o);
}

/* Fixes the corners of the square, all of the boundary if digits = 0, and settles. */
static bool settle(struct joint *j, const struct planar *recipe, int digits, double slack,
                   struct err *err) {
    double side = recipe->size * recipe->step;
    for (size_t v = 0; v < j->map.vertex_count; v++) {
        const double *p = j->map.at[0][v];
        bool x = p[0] == 0 || p[0] == side, y = p[1] == 0 || p[1] == side;
        j->fixed[v] = digits ? x && y : x || y;
    }
    return joint_settle(j, (int[2]){0, digits}, slack, err);
}

static void check_map(uint64_t seed, const struct plane_map *map, const struct planar *recipe,
                      int digits) {
    double side = recipe->size * recipe->step;
    mpq_t area, whole;
    mpq_inits(area, whole, NULL);
    for (int m = 0; m < 2; m++) {
        check_seed(seed, plane_map_flipped(map, m, 0) == map->triangle_count);
        check_seed(seed, planar_total(area, (const double(*)[2])map->at[m],
                                      (const uint32_t(*)[3])map->triangle, map->triangle_count));
        mpq_set_d(whole, 2 * side * side);
        if (recipe->step == 1 && (m == 0 || digits == 0)) check_seed(seed, mpq_equal(area, whole));
        check_seed(seed, fabs(mpq_get_d(area) - mpq_get_d(whole)) <
                             (digits ? 8 * side * side * pow(10, 1 - digits) : 1e-12));
        for (size_t v = 0; v < map->vertex_count; v++)
            for (int c = 0; m == 1 && c < 2; c++)
                check_seed(seed, map->at[m][v][c] == num_rounded(map->at[m][v][c], digits));
    }
    mpq_clears(area, whole, NULL);
}

/* Returns the number of vertices that were taken away. */
static size_t check_pair(uint64_t seed, struct pair *p, const struct planar *recipe, int digits) {
    struct plane_map map = {0};
    struct joint j = {0};
    struct err err = {0};
    size_t lost;
    bool ok = false;
    check_seed(seed, overlay_build(&p->o, p->mesh, &err));
    for (double slack = JOINT_SLACK; !ok && slack < 1e6; slack *= 30) {
        joint_free(&j);
        check_seed(seed, overlay_map(&p->m, &map, &err));
        check_seed(seed, joint_init(&j, &map, &p->m.meaning, &err));
        ok = settle(&j, recipe, digits, slack, &err);
    }
    if (!ok) fprintf(stderr, "%s\n", err.message);
    check_seed(seed, ok);
    check_seed(seed, joint_finish(&j, &map, &err));
    check_map(seed, &map, recipe, digits);
    lost = p->o.vertex_count - map.vertex_count;
    plane_map_free(&map);
    joint_free(&j);
    return lost;
}

static void test_doubles(void **unused) {
    size_t lost = 0;
    (void)unused;
    for (int n = 0; n < test_count(100); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct planar recipe = {(int)random_in(&state, 1, 8), 1, (int)random_in(&state, 0, 80),
                                (int)random_in(&state, 0, 2000)};
        struct pair p;
        pair_make(&p, &recipe, n % 4 == 0, &state);
        lost += check_pair(seed, &p, &recipe, 0);
        pair_free(&p);
    }
    assert_true(lost > 0);
}

static void test_digits(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(100); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct planar recipe = {(int)random_in(&state, 1, 8), n % 2 ? 1 : 0.1,
                                (int)random_in(&state, 0, 80), (int)random_in(&state, 0, 2000)};
        struct pair p;
        pair_make(&p, &recipe, false, &state);
        check_pair(seed, &p, &recipe, (int)random_in(&state, 1, 6));
        pair_free(&p);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_doubles),
        cmocka_unit_test(test_digits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
