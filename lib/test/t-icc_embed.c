/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The invariants of a triangulated cage and of its image in the disk, in rationals, areas and sums;
 * and what no disk can be. */
#include "icc_embed.h"

#include "cages.h"
#include "testing.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Twice the area of a, b, c, exactly. */
static void exact_area(mpq_t area, const double a[2], const double b[2], const double c[2]) {
    mpq_t d[4], term;
    const double from[4] = {b[0], c[1], b[1], c[0]};
    mpq_init(term);
    for (int i = 0; i < 4; i++) {
        mpq_init(d[i]);
        mpq_set_d(d[i], from[i]);
        mpq_set_d(term, a[i == 1 || i == 2]);
        mpq_sub(d[i], d[i], term);
    }
    mpq_mul(area, d[0], d[1]);
    mpq_mul(term, d[2], d[3]);
    mpq_sub(area, area, term);
    for (int i = 0; i < 4; i++) mpq_clear(d[i]);
    mpq_clear(term);
}

/* All triangles are counter-clockwise, and together twice the area of the rim's polygon, exactly.
 */
static void check_triangles(const struct icc_mesh *m, const double (*at)[2], const char *name) {
    mpq_t sum, area;
    mpq_inits(sum, area, NULL);
    for (size_t t = 0; t < m->mesh.triangle_count; t++) {
        const uint32_t *v = m->mesh.triangle[t];
        exact_area(area, at[v[0]], at[v[1]], at[v[2]]);
        if (mpq_sgn(area) <= 0) fail_msg("%s: triangle %zu is turned over", name, t);
        mpq_add(sum, sum, area);
    }
    for (uint32_t i = 1; i + 1 < m->rim_count; i++) {
        exact_area(area, at[0], at[i], at[i + 1]);
        mpq_sub(sum, sum, area);
    }
    assert_int_equal(mpq_sgn(sum), 0);
    mpq_clears(sum, area, NULL);
}

/* Is p the exact point at numerator / parts of the way from a to b? */
static bool is_at(const double a[2], const double b[2], uint32_t numerator, uint32_t parts,
                  const double p[2]) {
    bool same = true;
    for (int k = 0; k < 2; k++) {
        mpq_t x, y, lambda;
        mpq_inits(x, y, lambda, NULL);
        mpq_set_ui(lambda, numerator, parts);
        mpq_canonicalize(lambda);
        mpq_set_d(x, a[k]);
        mpq_set_d(y, b[k]);
        mpq_sub(y, y, x);
        mpq_mul(y, y, lambda);
        mpq_add(x, x, y);
        mpq_set_d(y, p[k]);
        same = same && mpq_equal(x, y);
        mpq_clears(x, y, lambda, NULL);
    }
    return same;
}

static void check_rim(const struct icc_mesh *m, const struct cage *c, const struct icc_disk *d,
                      const double (*image)[2]) {
    uint32_t v = 0;
    for (uint32_t k = 0; k < c->count; k++) {
        uint32_t parts = m->start[k + 1] - m->start[k], next = cage_next(c, k);
        assert_int_equal(m->start[k], v);
        assert_true(parts > 0 && (parts & (parts - 1)) == 0);
        assert_memory_equal(m->mesh.vertex[v], c->vertex[k], sizeof *c->vertex);
        for (uint32_t i = 0; i < parts; i++, v++) {
            double p[2], *q = m->mesh.vertex[v];
            assert_int_equal(m->side[v], k);
            cage_point(c, k, (double)i / parts, p);
            assert_memory_equal(q, p, sizeof p);
            if (c->count < 500) /* few enough for corners of 34 bits */
                assert_true(is_at(d->corner[k], d->corner[next], i, parts, image[v]));
        }
    }
    assert_int_equal(v, m->rim_count);
}

/* Every inside vertex is the mean of its neighbours, with weights found here in another way. */
static void check_means(const struct icc_mesh *m, const double (*image)[2], bool uniform) {
    size_t n = m->mesh.vertex_count;
    long double(*pull)[2] = calloc(n, sizeof *pull), *size = calloc(n, sizeof *size);
    assert_true(pull && size);
    for (size_t t = 0; t < m->mesh.triangle_count; t++)
        for (int e = 0; e < 3; e++) {
            long double both = 0, w;
            uint32_t i = m->mesh.triangle[t][(e + 1) % 3], j = m->mesh.triangle[t][(e + 2) % 3];
            uint32_t o[2] = {m->mesh.triangle[t][e], 0}, u = m->mesh.across[t][e];
            if (u == MESH_NONE) continue;
            for (int f = 0; f < 3; f++)
                if (m->mesh.triangle[u][f] != i && m->mesh.triangle[u][f] != j)
                    o[1] = m->mesh.triangle[u][f];
            for (int s = 0; s < 2; s++) {
                const double *a = m->mesh.vertex[i], *b = m->mesh.vertex[j],
                             *c = m->mesh.vertex[o[s]];
                long double ax = (long double)a[0] - c[0], ay = (long double)a[1] - c[1];
                long double bx = (long double)b[0] - c[0], by = (long double)b[1] - c[1];
                both += (ax * bx + ay * by) / fabsl(ax * by - ay * bx);
            }
            w = uniform ? 1 : fminl(fmaxl(both / 2, 0.05L), 20);
            for (int k = 0; k < 2; k++) pull[i][k] += w * (image[j][k] - image[i][k]) / 2;
            for (int k = 0; k < 2; k++) pull[j][k] += w * (image[i][k] - image[j][k]) / 2;
            size[i] += w, size[j] += w;
        }
    for (size_t v = m->rim_count; v < n; v++)
        for (int k = 0; k < 2; k++) assert_true(fabsl(pull[v][k]) < 1e-13L * size[v]);
    free(pull);
    free(size);
}

static void check_pair(const struct cage_pair *pair, size_t points) {
    struct cage cages[2];
    struct icc_disk disk;
    struct err err = {0};
    assert_true(cage_init(&cages[0], (const double(*)[2])pair->source, pair->count, &err));
    assert_true(
        cage_init_like(&cages[1], (const double(*)[2])pair->target, pair->count, cages, &err));
    assert_true(icc_disk_init(&disk, cages, &err));
    for (int i = 0; i < 2; i++) {
        struct icc_mesh m;
        double(*image)[2];
        bool uniform;
        assert_true(icc_mesh_init(&m, &cages[i], disk.length, points, &err));
        assert_true(icc_embed(&m, &disk, &image, &uniform, &err));
        check_triangles(&m, (const double(*)[2])m.mesh.vertex, pair->name);
        check_triangles(&m, (const double(*)[2])image, pair->name);
        check_rim(&m, &cages[i], &disk, (const double(*)[2])image);
        if (pair->stretch < 1e9) check_means(&m, (const double(*)[2])image, uniform);
        free(image);
        icc_mesh_free(&m);
    }
    icc_disk_free(&disk);
    cage_free(&cages[0]);
    cage_free(&cages[1]);
}

static void test_hard(void **unused) {
    (void)unused;
    for (int i = 0; i < CAGE_PAIRS_QUICK; i++) {
        struct cage_pair pair;
        cage_pair_make(&pair, i);
        check_pair(&pair, icc_mesh_points(pair.count));
        cage_pair_free(&pair);
    }
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(30); n++) {
        struct cage_pair pair;
        uint64_t state = (uint64_t)n;
        cage_pair_random(&pair, 3, 60, (uint64_t)n);
        check_pair(&pair, (size_t)random_in(&state, 0, 500));
        cage_pair_free(&pair);
    }
}

/* About as many inside points as wanted where there is room for them. */
static void test_points(void **unused) {
    static const size_t counts[] = {1, 10, 100, 1000, 10000};
    const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    struct cage c;
    struct err err = {0};
    (void)unused;
    assert_int_equal(icc_mesh_points(3), 600);
    assert_int_equal(icc_mesh_points(30), 600);
    assert_int_equal(icc_mesh_points(31), 620);
    assert_int_equal(icc_mesh_points(1000), 20000);
    assert_int_equal(icc_mesh_points(100000), 20000);
    assert_true(cage_init(&c, square, 4, &err));
    for (int i = 0; i < 5; i++) {
        struct icc_mesh m;
        assert_true(icc_mesh_init(&m, &c, NULL, counts[i], &err));
        double inside = (double)(m.mesh.vertex_count - m.rim_count), want = (double)counts[i];
        assert_true(fabs(inside - want) <= 3 * sqrt(want));
        icc_mesh_free(&m);
    }
    struct icc_mesh m;
    assert_false(icc_mesh_init(&m, &c, NULL, (size_t)ICC_POINTS_MAX + 1, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    cage_free(&c);
}

/* Far from the origin, sides are a few hundred doubles long: their parts would touch. */
static void test_far(void **unused) {
    const double comb[8][2] = {{0, 0},  {64, 0}, {64, 64}, {34, 64},
                               {34, 2}, {32, 2}, {32, 64}, {0, 64}};
    (void)unused;
    for (int e = 40; e <= 52; e++) {
        struct cage_pair pair = {
            "far from the origin",          8,    calloc(8, sizeof *pair.source),
            calloc(8, sizeof *pair.target), 1e16, 1};
        for (int i = 0; i < 8; i++)
            for (int k = 0; k < 2; k++) {
                pair.target[i][k] = comb[i][k];
                pair.source[i][k] = comb[i][k] + ldexp(1, e);
            }
        check_pair(&pair, 1000);
        cage_pair_free(&pair);
    }
}

/* A disk that is not convex, as rounding could make it: refused, not mapped to. */
static void test_refusal(void **unused) {
    struct cage_pair pair;
    struct cage c;
    struct icc_disk disk;
    struct icc_mesh m;
    struct err err = {0};
    double(*image)[2];
    bool uniform;
    (void)unused;
    cage_pair_random(&pair, 12, 12, 3);
    assert_true(cage_init(&c, (const double(*)[2])pair.source, pair.count, &err));
    assert_true(icc_disk_init(&disk, &c, &err) && icc_mesh_init(&m, &c, NULL, 600, &err));
    memcpy(disk.corner[3], (const double[]){0, 0}, sizeof *disk.corner);
    assert_false(icc_embed(&m, &disk, &image, &uniform, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "precision"));
    assert_null(image);
    icc_mesh_free(&m);
    icc_disk_free(&disk);
    cage_free(&c);
    cage_pair_free(&pair);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hard), cmocka_unit_test(test_random),  cmocka_unit_test(test_points),
        cmocka_unit_test(test_far),  cmocka_unit_test(test_refusal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
