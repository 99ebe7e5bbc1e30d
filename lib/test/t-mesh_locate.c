/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points in triangles, against all triangles in integers. Coordinates are small integers, so that
 * points fall on edges and corners all the time; rests then move them off by less than any double
 * can tell. */
#include "mesh_locate.h"

#include "mem.h"
#include "shim_cgal.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 60, SIZE = 12 };

struct sample {
    struct mesh mesh;
    double scale;
};

static void take(struct sample *s, struct shim_cgal_mesh *from) {
    struct err err = {0};
    s->mesh = (struct mesh){.vertex_count = from->vertex_count,
                            .triangle_count = from->triangle_count,
                            .vertex = from->vertex,
                            .triangle = from->triangle};
    assert_true(mesh_link(&s->mesh, &err));
}

/* Some different points of the lattice, joined by a Delaunay triangulation, without some of its
 * triangles. False: all lie on a line. */
static bool make(struct sample *s, uint64_t *state) {
    double point[POINTS][2];
    size_t n = 0, want = (size_t)random_in(state, 3, POINTS);
    bool used[SIZE + 1][SIZE + 1] = {{false}};
    struct shim_cgal_mesh mesh;
    struct shim_cgal_report report;
    s->scale = (const double[]){1, 0x1p-300, 0x1p200}[random_in(state, 0, 2)];
    while (n < want) {
        int64_t x = random_in(state, 0, SIZE), y = random_in(state, 0, SIZE);
        if (used[x][y]) {
            want--;
            continue;
        }
        used[x][y] = true;
        point[n][0] = (double)x * s->scale;
        point[n++][1] = (double)y * s->scale;
    }
    if (!shim_cgal_delaunay((const double(*)[2])point, n, &mesh, &report)) return false;
    for (size_t t = 0; mesh.triangle_count > 1 && t < mesh.triangle_count; t++)
        if (random_in(state, 0, 7) == 0)
            memmove(mesh.triangle[t], mesh.triangle[t + 1],
                    (--mesh.triangle_count - t) * sizeof *mesh.triangle);
    take(s, &mesh);
    return true;
}

/* A point in quarters of the lattice, and a direction in which it is moved by next to nothing. */
struct query {
    int64_t at[2], move[2];
};

/* Sign of the orientation of a, b and the point. */
static int orient(const struct sample *s, const double a[2], const double b[2],
                  const struct query *q) {
    int64_t dx = (int64_t)((b[0] - a[0]) / s->scale), dy = (int64_t)((b[1] - a[1]) / s->scale);
    int64_t px = q->at[0] - 4 * (int64_t)(a[0] / s->scale);
    int64_t py = q->at[1] - 4 * (int64_t)(a[1] / s->scale);
    int64_t det = dx * py - dy * px;
    if (det == 0) det = dx * q->move[1] - dy * q->move[0];
    return (det > 0) - (det < 0);
}

static bool has(const struct sample *s, uint32_t t, const struct query *q) {
    const uint32_t *v = s->mesh.triangle[t];
    for (int e = 0; e < 3; e++)
        if (orient(s, s->mesh.vertex[v[e]], s->mesh.vertex[v[(e + 1) % 3]], q) < 0) return false;
    return true;
}

/* The lowest triangle that has the point. */
static uint32_t brute(const struct sample *s, const struct query *q) {
    uint32_t t = 0;
    while (t < s->mesh.triangle_count && !has(s, t, q)) t++;
    return t < s->mesh.triangle_count ? t : MESH_NONE;
}

static void check_query(const struct sample *s, const struct mesh_locator *l, uint64_t *state,
                        uint64_t seed) {
    struct query q;
    struct mesh_point p, mean;
    struct mesh_place place = {MESH_NONE, {0, 0, 0}};
    uint32_t hint = (uint32_t)random_in(state, 0, (int64_t)s->mesh.triangle_count - 1), expected;
    bool moved = random_in(state, 0, 1);
    for (int k = 0; k < 2; k++) {
        q.at[k] = random_in(state, 0, 1) ? 4 * random_in(state, -1, SIZE + 1)
                                         : random_in(state, -2, 4 * SIZE + 2);
        q.move[k] = moved ? random_in(state, -2, 2) : 0;
        p.at[k] = (double)q.at[k] * 0.25 * s->scale;
        p.rest[k] = (double)q.move[k] * 0x1p-60 * s->scale;
    }
    if (p.at[0] == 0 || p.at[1] == 0) q.move[0] = q.move[1] = 0, p.rest[0] = p.rest[1] = 0;
    expected = brute(s, &q);
    check_seed(seed, mesh_locate(l, &p, &hint, &place) == (expected != MESH_NONE));
    if (expected == MESH_NONE) return;
    /* where triangles were taken away, a corner may have several fans: one of them is searched */
    if (!q.move[0] && !q.move[1] && q.at[0] % 4 == 0 && q.at[1] % 4 == 0)
        check_seed(seed, has(s, expected = place.triangle, &q));
    check_seed(seed, place.triangle == expected);
    mean = mesh_mean(&s->mesh, (const double(*)[2])s->mesh.vertex, &place);
    for (int k = 0; k < 2; k++) {
        check_seed(seed, fabs(mean.at[k] - p.at[k]) <= 1e-14 * s->scale);
        check_seed(seed, place.weight[k] >= 0);
    }
    for (int e = 0; e < 3; e++) {
        const uint32_t *v = s->mesh.triangle[expected];
        int sign = orient(s, s->mesh.vertex[v[(e + 1) % 3]], s->mesh.vertex[v[(e + 2) % 3]], &q);
        check_seed(seed, (place.weight[e] > 0) == (sign > 0));
    }
}

/* The nearest of many points on all boundary edges is no nearer than the one found. */
static void check_rim(const struct sample *s, const struct mesh_locator *l, uint64_t *state,
                      uint64_t seed) {
    struct mesh_point p = {{0}, {0}}, q;
    struct mesh_place place;
    double best = INFINITY, found;
    for (int k = 0; k < 2; k++) p.at[k] = s->scale * (random_unit(state) * 16 - 2);
    mesh_locate_rim(l, &p, &place);
    q = mesh_mean(&s->mesh, (const double(*)[2])s->mesh.vertex, &place);
    found = sqrt(pow((p.at[0] - q.at[0]) / s->scale, 2) + pow((p.at[1] - q.at[1]) / s->scale, 2));
    for (uint32_t t = 0; t < s->mesh.triangle_count; t++)
        for (int e = 0; e < 3; e++) {
            const double *a = s->mesh.vertex[s->mesh.triangle[t][(e + 1) % 3]];
            const double *b = s->mesh.vertex[s->mesh.triangle[t][(e + 2) % 3]];
            if (s->mesh.across[t][e] != MESH_NONE) continue;
            for (int i = 0; i <= 16; i++) {
                double x = (a[0] + (b[0] - a[0]) * i / 16 - p.at[0]) / s->scale;
                double y = (a[1] + (b[1] - a[1]) * i / 16 - p.at[1]) / s->scale;
                best = fmin(best, sqrt(x * x + y * y));
            }
        }
    check_seed(seed, found <= best + 1e-12);
    check_seed(seed, place.weight[0] * place.weight[1] * place.weight[2] == 0);
}

static void test_brute(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(1500); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct sample s;
        struct mesh_locator l;
        struct err err = {0};
        if (!make(&s, &state)) continue;
        assert_true(mesh_locator_init(&l, &s.mesh, (const double(*)[2])s.mesh.vertex, &err));
        for (int i = 0; i < 200; i++) check_query(&s, &l, &state, seed);
        for (int i = 0; i < 5; i++) check_rim(&s, &l, &state, seed);
        mesh_locator_free(&l);
        mesh_free(&s.mesh);
    }
}

/* Edges have their two triangles, and each knows the other. */
static void test_links(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(200); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct sample s;
        if (!make(&s, &state)) continue;
        for (uint32_t t = 0; t < s.mesh.triangle_count; t++)
            for (int e = 0; e < 3; e++) {
                uint32_t a = s.mesh.triangle[t][(e + 1) % 3], b = s.mesh.triangle[t][(e + 2) % 3];
                uint32_t expected = MESH_NONE;
                for (uint32_t u = 0; u < s.mesh.triangle_count; u++)
                    for (int f = 0; f < 3; f++)
                        if (s.mesh.triangle[u][f] == b && s.mesh.triangle[u][(f + 1) % 3] == a)
                            expected = u;
                check_seed(seed, s.mesh.across[t][e] == expected);
            }
        mesh_free(&s.mesh);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_brute),
        cmocka_unit_test(test_links),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
