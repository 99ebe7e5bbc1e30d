/* SPDX-License-Identifier: GPL-3.0-or-later */
/* psi there and back, in all planes, with depth and without: points, faces, derivatives (whose
 * product is the identity), normals (which come back); sheets that lie above each other. */
#include "deform.h"

#include "polynomials.h"
#include "testing.h"
#include "triangulations.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double depth[2] = {-3, 4.5};

/* phi and sigma near the identity on [-2,2]^2: one-to-one, and thick. */
static void random_map(struct polynomial f[4], int degree, uint64_t *s) {
    for (int c = 0; c < 4; c++) {
        random_polynomial(&f[c], degree, s);
        if (c < 2)
            f[c].c[c == 0][c == 1] += 1;
        else
            f[c].c[0][0] += depth[c - 2];
    }
}

static void make_spline(struct spline *s, const struct polynomial *f, int degree, bool has_depth,
                        const int axes[3], uint64_t seed) {
    struct grid g;
    random_grid(&g, 3, degree, seed);
    g.lattice = (struct lattice){0x1p-10, -1, -2};
    g.has_depth = has_depth;
    memcpy(g.depth, depth, sizeof g.depth);
    memcpy(g.axes, axes, sizeof g.axes);
    polynomial_spline(s, &g, f);
}

/* A point of the model in the prisms, often on an edge or a face. */
static void random_point(const struct grid *g, uint64_t *s, double p[3]) {
    const uint32_t *v = g->triangle[random_in(s, 0, g->triangle_count - 1)];
    double b[3] = {random_unit(s), random_unit(s), random_unit(s)};
    if (random_in(s, 0, 3) == 0) b[random_in(s, 0, 2)] = 0;
    for (int c = 0; c < 2; c++) {
        p[g->axes[c]] = 0;
        for (int l = 0; l < 3; l++) {
            double xy[2];
            grid_vertex(g, v[l], xy);
            p[g->axes[c]] += b[l] / (b[0] + b[1] + b[2]) * xy[c];
        }
    }
    b[0] = random_in(s, 0, 4) > 0 ? random_unit(s) : (double)random_in(s, 0, 1);
    p[g->axes[2]] = b[0] == 1 ? depth[1] : depth[0] + b[0] * (depth[1] - depth[0]);
}

static double distance(const double a[3], const double b[3]) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

struct pair {
    struct spline s;
    struct deform there, back;
};

static void open_pair(struct pair *p, bool one_to_one, const struct place *places, uint64_t seed) {
    struct projection projection = projection_of_model(&p->s.grid);
    struct err err = {0};
    check_seed(seed, deform_init(&p->there, &p->s, &projection, NULL, &err));
    check_seed(seed, deform_init_inverse(&p->back, &p->s, &projection, places, one_to_one, &err));
    if (one_to_one) check_seed(seed, deform_prove(&p->s, &projection, &err));
}

static void close_pair(struct pair *p) {
    deform_free(&p->there);
    deform_free(&p->back);
    spline_free(&p->s);
}

static void check_derivatives(double a[3][3], double b[3][3], uint64_t seed) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) sum += a[r][k] * b[k][c];
            check_seed(seed, fabs(sum - (r == c)) < 1e-10); /* needles */
        }
}

static void check_normal(struct pair *pair, const double p[3], const double q[3], uint64_t *s,
                         uint64_t seed) {
    double n[3], turned[3], again[3];
    for (int c = 0; c < 3; c++) n[c] = random_unit(s) - 0.5;
    check_seed(seed, deform_turn(&pair->there, 0, p, n, turned));
    check_seed(seed, deform_turn(&pair->back, 0, q, turned, again));
    check_seed(seed, distance(n, again) < 1e-10);
}

static void there_and_back(void **unused) {
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    int checked = 0;
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct polynomial f[4];
        struct pair pair;
        random_map(f, 4, &s);
        make_spline(&pair.s, f, 4 + i % 3, i % 4, order[i % 6], seed);
        open_pair(&pair, true, NULL, seed);
        for (int n = 0; n < 200; n++) {
            double p[3], q[3], again[3], to[3][3], from[3][3];
            random_point(&pair.s.grid, &s, p);
            if (!deform_point(&pair.there, 0, p, q, NULL)) continue;
            check_seed(seed, deform_point(&pair.back, 0, q, again, NULL));
            check_seed(seed, distance(p, again) < 64 * DBL_EPSILON);
            if (!deform_point(&pair.there, 0, again, q, to)) continue; /* an ulp outside */
            checked++;
            check_seed(seed, deform_point(&pair.back, 0, q, again, from));
            check_derivatives(to, from, seed);
            check_normal(&pair, p, q, &s, seed);
        }
        close_pair(&pair);
    }
    assert_true(checked > 100 * test_count(60));
    (void)unused;
}

/* At the faces: what is off by rounding is on them, what is off by more is outside. */
static void faces(void **unused) {
    static const int axes[3] = {0, 1, 2};
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct polynomial f[4];
        struct pair pair;
        random_map(f, 3, &s);
        make_spline(&pair.s, f, 3 + i % 3, true, axes, seed);
        open_pair(&pair, true, NULL, seed);
        for (int n = 0; n < 100; n++) {
            double p[3], q[3], again[3], off = 8 * DBL_EPSILON * (double)random_in(&s, 0, 30);
            int face = n % 2;
            random_point(&pair.s.grid, &s, p);
            p[2] = depth[face];
            if (!deform_point(&pair.there, 0, p, q, NULL)) continue;
            check_seed(seed, deform_point(&pair.back, 0, q, again, NULL));
            check_seed(seed, fabs(again[2] - p[2]) <= 64 * DBL_EPSILON);
            q[2] += face ? off : -off; /* an ulp of depths is 4 DBL_EPSILON */
            if (off <= 48 * DBL_EPSILON) {
                check_seed(seed, deform_point(&pair.back, 0, q, again, NULL));
                check_seed(seed, again[2] >= depth[0] && again[2] <= depth[1]);
            }
            if (off >= 80 * DBL_EPSILON)
                check_seed(seed, !deform_point(&pair.back, 0, q, again, NULL));
        }
        close_pair(&pair);
    }
    (void)unused;
}

/* z comes back bit for bit where sigma is at rest, and all where everything is. */
static void at_rest(void **unused) {
    static const int axes[3] = {2, 1, 0};
    for (int i = 0; i < test_count(20); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct pair pair;
        make_spline(&pair.s, NULL, 1 + i % 6, i % 3, axes, seed);
        if (i % 2) pair.s.phi[0][0] -= 0x1p-10;
        open_pair(&pair, true, NULL, seed);
        for (int n = 0; n < 100; n++) {
            double p[3], q[3], again[3];
            random_point(&pair.s.grid, &s, p);
            if (n == 0) p[0] = -0.0;
            if (!deform_point(&pair.there, 0, p, q, NULL)) continue;
            check_seed(seed, deform_point(&pair.back, 0, q, again, NULL));
            check_seed(seed, memcmp(&p[0], &again[0], sizeof *p) == 0);
            if (i % 2 == 0) check_seed(seed, memcmp(p, again, sizeof p) == 0);
        }
        close_pair(&pair);
    }
    (void)unused;
}

/* Two squares of two triangles each, apart in the plane, the second laid upon the first: (x,y) has
 * two preimages, and the depths of the sheets tell which one (x,y,z) has. */
static void sheets(void **unused) {
    struct grid g = {.degree = 2,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .has_depth = true,
                     .depth = {0, 1},
                     .vertex_count = 8,
                     .triangle_count = 4};
    static const uint32_t triangle[4][3] = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    struct place places[1] = {{.triangle = 2}};
    struct pair pair, known;
    struct err err;
    uint64_t s = 3;
    g.vertex = calloc(8, sizeof *g.vertex);
    g.triangle = calloc(4, sizeof *g.triangle);
    memcpy(g.triangle, triangle, sizeof triangle);
    for (int v = 0; v < 8; v++) {
        g.vertex[v][0] = (v % 4 == 1 || v % 4 == 2) + 3 * (v / 4);
        g.vertex[v][1] = v % 4 / 2;
    }
    assert_true(grid_build(&g, &err) && spline_identity(&pair.s, &g, &err));
    for (uint32_t p = 0; p < pair.s.grid.point_count; p++) {
        bool second = pair.s.phi[p][0] > 2;
        if (second) pair.s.phi[p][0] -= 3;
        for (int c = 0; c < 2; c++) pair.s.sigma[p][c] += second ? 5 : 0;
    }
    open_pair(&pair, false, NULL, 3);
    known = pair;
    open_pair(&known, false, places, 3);
    for (int n = 0; n < 200; n++) {
        double q[3] = {random_unit(&s), random_unit(&s), random_unit(&s)}, p[3];
        assert_true(deform_point(&pair.back, 0, q, p, NULL) && fabs(p[0] - q[0]) < 1e-15);
        assert_true(deform_point(&known.back, 0, q, p, NULL) && fabs(p[0] - q[0]) < 1e-15);
        q[2] += 5;
        assert_true(deform_point(&pair.back, 0, q, p, NULL) && fabs(p[0] - q[0] - 3) < 1e-15);
        q[2] += 5;
        assert_false(deform_point(&pair.back, 0, q, p, NULL));
    }
    deform_free(&known.there);
    deform_free(&known.back);
    /* the same without depth: known places decide */
    for (uint32_t p = 0; p < pair.s.grid.point_count; p++) pair.s.grid.has_depth = false;
    deform_free(&pair.there);
    deform_free(&pair.back);
    free(pair.s.sigma);
    pair.s.sigma = NULL;
    open_pair(&pair, false, places, 3);
    {
        double q[3] = {0.75, 0.25, 7}, p[3];
        assert_true(deform_point(&pair.back, 0, q, p, NULL) && p[0] == 3.75 && p[2] == 7);
        q[1] = 0.875; /* not in triangle 2 */
        assert_true(deform_point(&pair.back, 0, q, p, NULL) && p[0] == 0.75);
    }
    close_pair(&pair);
    (void)unused;
}

/* Known places change nothing for a map that is one-to-one, whatever they are. */
static void places_are_hints(void **unused) {
    static const int axes[3] = {0, 1, 2};
    for (int i = 0; i < test_count(20); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct polynomial f[4];
        struct place places[100];
        struct pair pair, known;
        random_map(f, 3, &s);
        make_spline(&pair.s, f, 3, i % 2, axes, seed);
        for (int n = 0; n < 100; n++)
            places[n].triangle =
                n % 7 ? (uint32_t)random_in(&s, 0, pair.s.grid.triangle_count - 1) : GRID_NONE;
        known = pair;
        open_pair(&pair, true, NULL, seed);
        open_pair(&known, true, places, seed);
        for (size_t n = 0; n < 100; n++) {
            double p[3], q[3], one[3] = {0}, two[3] = {0}, j[2][3][3] = {{{0}}};
            random_point(&pair.s.grid, &s, p);
            if (!deform_point(&pair.there, 0, p, q, NULL)) continue;
            check_seed(seed, deform_point(&pair.back, n, q, one, j[0]));
            check_seed(seed, deform_point(&known.back, n, q, two, j[1]));
            check_seed(seed, memcmp(one, two, sizeof one) == 0);
            check_seed(seed, memcmp(j[0], j[1], sizeof j[0]) == 0);
        }
        deform_free(&known.there);
        deform_free(&known.back);
        close_pair(&pair);
    }
    (void)unused;
}

/* Derivatives of the plane map in a batch, and those outside. */
static void batches(void **unused) {
    static const int axes[3] = {0, 1, 2};
    struct polynomial f[2] = {{2, {{0, 0.5}, {2, 0, 0}}}, {1, {{0, 4}}}}; /* (2x + y/2, 4y) */
    double points[2][3] = {{0, 0, 9}, {1e6, 0, 1}}, images[2][3], gradient[2][5];
    struct deform_batch batch = {
        .count = 2, .points = points, .images = images, .gradient = gradient};
    struct pair pair;
    double xy[2];
    make_spline(&pair.s, f, 3, false, axes, 1);
    grid_vertex(&pair.s.grid, 0, xy);
    points[0][0] = 2 * xy[0] + xy[1] / 2;
    points[0][1] = 4 * xy[1];
    open_pair(&pair, true, NULL, 1);
    assert_true(deform_points(&pair.back, &batch));
    assert_true(batch.outside == 1 && batch.first == 1);
    assert_true(fabs(images[0][0] - xy[0]) < 1e-14 && fabs(images[0][1] - xy[1]) < 1e-14);
    assert_true(images[0][2] == 9 && memcmp(images[1], points[1], sizeof points[1]) == 0);
    {
        const double expected[2][5] = {{0.5, -0.0625, 0, 0.25, 0.125}, {1, 0, 0, 1, 1}};
        for (int i = 0; i < 10; i++)
            assert_true(fabs(gradient[i / 5][i % 5] - expected[i / 5][i % 5]) < 1e-14);
    }
    close_pair(&pair);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_and_back),   cmocka_unit_test(faces),
        cmocka_unit_test(at_rest),          cmocka_unit_test(sheets),
        cmocka_unit_test(places_are_hints), cmocka_unit_test(batches),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
