/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: the defining sum over control points, and polynomial maps, which are the same on every
 * triangle, so they also show that triangles fit together to any order. */
#include "spline.h"

#include "deform.h"
#include "mem.h"
#include "polynomials.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <string.h>

/* A spline whose four components (phi, sigma) are the polynomials f, or the identity (f NULL). */
static void make_spline(struct spline *s, const struct polynomial *f, const struct lattice *lattice,
                        int degree, bool depth, uint64_t seed) {
    struct grid g;
    random_grid(&g, 3, degree, seed);
    g.lattice = *lattice;
    g.has_depth = depth;
    g.depth[0] = -3;
    g.depth[1] = 4.5;
    polynomial_spline(s, &g, f);
}

static const struct lattice fine = {0x1p-10, -1, -2};
static const struct lattice lattices[] = {
    {1, 0, 0}, {0.1, 0, 0}, {0x1p-4, -1, -2}, {0.3, 1e3, -1.0 / 3}, {1e-7, 1, 1}};

/* A point of the triangulation near a random place, with its triangle. */
static bool random_point(const struct spline *s, uint64_t *state, double p[3], uint32_t *t,
                         double b[3]) {
    const struct grid *g = &s->grid;
    const uint32_t *v = g->triangle[random_in(state, 0, g->triangle_count - 1)];
    double w[3] = {random_unit(state), random_unit(state), random_unit(state)};
    struct locator l;
    struct err err = {0};
    uint32_t hint = 0;
    bool found;
    if (random_in(state, 0, 3) == 0) w[random_in(state, 0, 2)] = 0;
    for (int k = 0; k < 2; k++) {
        long double sum = 0, xy[2];
        for (int i = 0; i < 3; i++) {
            world_of(g, v[i], xy);
            sum += xy[k] * w[i];
        }
        p[k] = (double)(sum / ((long double)w[0] + w[1] + w[2]));
    }
    p[2] = -3 + 7.5 * random_unit(state);
    assert_true(locator_init(&l, g, &err));
    found = locate(&l, p, &hint, t, b);
    locator_free(&l);
    return found;
}

static void identity_is_exact(void **unused) {
    int found = 0;
    for (int i = 0; i < test_count(100); i++) {
        uint64_t seed = (uint64_t)i, state = seed;
        struct spline s;
        make_spline(&s, NULL, &lattices[i % 5], 1 + i % GRID_DEGREE_MAX, i % 2, seed);
        for (int n = 0; n < 30; n++) {
            double p[3], value[3], jacobian[3][3], b[3];
            uint32_t t;
            if (!random_point(&s, &state, p, &t, b)) continue;
            if (n == 0) p[2] = -0.0;
            found++;
            spline_evaluate(&s, t, b, p, value, jacobian);
            check_seed(seed, memcmp(p, value, sizeof p) == 0);
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) check_seed(seed, jacobian[r][c] == (r == c));
            spline_evaluate(&s, t, b, p, value, NULL);
            check_seed(seed, memcmp(p, value, sizeof p) == 0);
        }
        spline_free(&s);
    }
    assert_true(found > 20 * test_count(100));
    (void)unused;
}

/* sum q_ijk d!/(i!j!k!) b0^i b1^j b2^k of one component of the control points (stride 2). */
static long double direct(const struct grid *g, uint32_t t, const double (*q)[2], int m,
                          const double b[3]) {
    long double sum = 0;
    int d = g->degree;
    for (int i = 0; i <= d; i++)
        for (int j = 0; i + j <= d; j++) {
            int e[3] = {i, j, d - i - j}, n = 0;
            long double term = q[grid_point(g, t, e[0], e[1], e[2])][m];
            for (int l = 0; l < 3; l++)
                for (int x = 1; x <= e[l]; x++) term *= b[l] * (long double)++n / x;
            sum += term;
        }
    return sum;
}

static void against_the_sum(void **unused) {
    for (int i = 0; i < test_count(200); i++) {
        uint64_t seed = (uint64_t)i, state = seed + 1000;
        struct spline s;
        double p[3], value[3], b[3];
        uint32_t t;
        make_spline(&s, NULL, &fine, 1 + i % 9, i % 2, seed);
        for (uint32_t q = 0; q < s.grid.point_count; q++)
            for (int m = 0; m < 2; m++) {
                s.phi[q][m] += random_unit(&state);
                if (s.sigma) s.sigma[q][m] += random_unit(&state);
            }
        for (int n = 0; n < 10; n++) {
            if (!random_point(&s, &state, p, &t, b)) continue;
            spline_evaluate(&s, t, b, p, value, NULL);
            for (int m = 0; m < 2; m++) {
                long double exact = direct(&s.grid, t, (const double(*)[2])s.phi, m, b);
                check_seed(seed, fabsl(value[m] - exact) < 1e-13L);
            }
            if (!s.sigma) continue;
            long double a0 = (4.5L - p[2]) / 7.5L, a1 = (p[2] + 3.0L) / 7.5L;
            long double exact = a0 * direct(&s.grid, t, (const double(*)[2])s.sigma, 0, b) +
                                a1 * direct(&s.grid, t, (const double(*)[2])s.sigma, 1, b);
            check_seed(seed, fabsl(value[2] - exact) < 1e-13L);
        }
        spline_free(&s);
    }
    (void)unused;
}

static void check_polynomial_point(const struct polynomial f[4], const double p[3], bool depth,
                                   const double value[3], double jacobian[3][3], uint64_t seed) {
    long double a[2] = {(4.5L - p[2]) / 7.5L, (p[2] + 3.0L) / 7.5L};
    for (int r = 0; r < 3; r++) {
        long double exact[4] = {p[2], 0, 0, 1}; /* value, then derivatives */
        for (int c = 0; c < 3; c++) {
            int dx = c == 1, dy = c == 2;
            if (r < 2)
                exact[c] = polynomial_value(&f[r], dx, dy, p[0], p[1]);
            else if (depth)
                exact[c] = a[0] * polynomial_value(&f[2], dx, dy, p[0], p[1]) +
                           a[1] * polynomial_value(&f[3], dx, dy, p[0], p[1]);
        }
        if (r < 2) exact[3] = 0;
        if (r == 2 && depth)
            exact[3] = (polynomial_value(&f[3], 0, 0, p[0], p[1]) -
                        polynomial_value(&f[2], 0, 0, p[0], p[1])) /
                       7.5L;
        check_seed(seed, fabsl(value[r] - exact[0]) < 1e-12L);
        for (int c = 0; c < 3; c++) check_seed(seed, fabsl(jacobian[r][c] - exact[c + 1]) < 1e-11L);
    }
}

/* degree f <= degree of the spline: also affine maps, and the blossom raised in degree. */
static void polynomial_maps(void **unused) {
    for (int i = 0; i < test_count(200); i++) {
        uint64_t seed = (uint64_t)i, state = seed;
        int degree = 1 + i % 7;
        struct polynomial f[4];
        struct spline s;
        double p[3], value[3], jacobian[3][3], b[3];
        uint32_t t;
        for (int m = 0; m < 4; m++)
            random_polynomial(&f[m], (int)random_in(&state, 1, degree), &state);
        make_spline(&s, f, &fine, degree, i % 2, seed);
        for (int n = 0; n < 10; n++) {
            if (!random_point(&s, &state, p, &t, b)) continue;
            spline_evaluate(&s, t, b, p, value, jacobian);
            check_polynomial_point(f, p, i % 2, value, jacobian, seed);
        }
        spline_free(&s);
    }
    (void)unused;
}

static void cursor_is_the_same(void **unused) {
    for (int i = 0; i < test_count(50); i++) {
        uint64_t seed = (uint64_t)i, state = seed;
        struct spline s;
        struct spline_cursor c;
        struct err err = {0};
        make_spline(&s, NULL, &lattices[i % 5], 1 + i % 6, i % 2, seed);
        for (uint32_t q = 0; q < s.grid.point_count; q++) s.phi[q][q % 2] *= random_unit(&state);
        assert_true(spline_cursor_init(&c, &s, &err));
        for (int n = 0; n < 20; n++) {
            double p[3], b[3], one[3], two[3], j[2][3][3];
            uint32_t t;
            if (!random_point(&s, &state, p, &t, b)) continue;
            spline_evaluate(&s, t, b, p, one, j[0]);
            spline_cursor_evaluate(&c, t, b, p, two, j[1]);
            check_seed(seed, memcmp(one, two, sizeof one) == 0);
            check_seed(seed, memcmp(j[0], j[1], sizeof j[0]) == 0);
            spline_cursor_evaluate(&c, t, b, p, one, NULL);
            for (int k = 0; k < 3; k++)
                check_seed(seed, fabs(one[k] - two[k]) < 1e-12 * (1 + fabs(two[k])));
        }
        spline_cursor_free(&c);
        spline_free(&s);
    }
    (void)unused;
}

/* All six planes: the point moves as in the frame xy, its coordinates permuted. */
/* For points of a model, nothing known about their places. */
static bool init(struct deform *d, const struct spline *s) {
    struct projection projection = projection_of_model(&s->grid);
    struct err err = {0};
    return deform_init(d, s, &projection, NULL, &err);
}

static void planes(void **unused) {
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = (uint64_t)i, state = seed;
        const int *axes = order[i % 6];
        struct polynomial f[4];
        struct spline s;
        struct deform d;
        for (int m = 0; m < 4; m++) random_polynomial(&f[m], 3, &state);
        make_spline(&s, f, &fine, 3, i % 2, seed);
        memcpy(s.grid.axes, axes, sizeof s.grid.axes);
        assert_true(init(&d, &s));
        for (int n = 0; n < 20; n++) {
            double p[3], b[3], model[3], image[3], turned[3][3], value[3], jacobian[3][3];
            uint32_t t;
            if (!random_point(&s, &state, p, &t, b)) continue;
            for (int k = 0; k < 3; k++) model[axes[k]] = p[k];
            check_seed(seed, deform_point(&d, 0, model, image, turned));
            for (int r = 0; r < 3; r++) {
                value[r] = image[axes[r]];
                for (int c = 0; c < 3; c++) jacobian[r][c] = turned[axes[r]][axes[c]];
            }
            check_polynomial_point(f, p, i % 2, value, jacobian, seed);
            model[axes[2]] = 4.6;
            check_seed(seed, deform_point(&d, 0, model, image, NULL) == !s.grid.has_depth);
        }
        deform_free(&d);
        spline_free(&s);
    }
    (void)unused;
}

static void deform_overflow_and_outside(void **unused) {
    struct spline s;
    struct deform d;
    struct err err = {0};
    double points[3][3] = {{0, 0, 0}, {1e9, 0, 0}, {0, 0, 0}}, images[3][3], b[3];
    struct deform_batch batch = {.count = 3, .points = points, .images = images};
    uint32_t t;
    uint64_t state = 7;
    make_spline(&s, NULL, &fine, 2, false, 7);
    while (!random_point(&s, &state, points[0], &t, b)) continue;
    memcpy(points[2], points[0], sizeof *points);
    assert_true(init(&d, &s));
    assert_true(deform_points(&d, &batch));
    assert_true(batch.outside == 1 && batch.first == 1 &&
                memcmp(points, images, sizeof points) == 0);
    deform_free(&d);
    s.grid.has_depth = true;
    s.grid.depth[0] = 1;
    s.grid.depth[1] = 2;
    assert_true(mem_new(s.sigma, s.grid.point_count, &err));
    for (uint32_t p = 0; p < s.grid.point_count; p++) s.sigma[p][0] = s.sigma[p][1] = 1e300;
    points[0][2] = 1.5;
    points[2][2] = 5;
    assert_true(init(&d, &s));
    assert_true(deform_points(&d, &batch));
    assert_true(batch.outside == 2 && batch.first == 1 && images[0][2] > 9e299);
    deform_free(&d);
    assert_true(init(&d, &s));
    for (uint32_t p = 0; p < s.grid.point_count; p++) d.cursor.shift[4 * p + 3] = HUGE_VAL;
    assert_false(deform_points(&d, &batch));
    assert_int_equal(batch.first, 0);
    deform_free(&d);
    spline_free(&s);
    (void)unused;
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Tangents stay tangent, the side stays the side, the length stays. */
static void normals(void **unused) {
    for (int i = 0; i < test_count(2000); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        double j[3][3], n[3], m[3], tangent[2][3], image[3];
        double scale = ldexp(1, (int)random_in(&s, -600, 600));
        for (int r = 0; r < 3; r++) {
            n[r] = random_unit(&s) - 0.5;
            for (int c = 0; c < 3; c++)
                j[r][c] = random_unit(&s) - 0.5 + 2 * (r == c) * (i % 3 - 1);
        }
        for (int r = 0; r < 3; r++) { /* n x (random) */
            tangent[0][r] = random_unit(&s) - 0.5;
            tangent[1][r] = 0;
        }
        for (int r = 0; r < 3; r++)
            tangent[1][r] =
                n[(r + 1) % 3] * tangent[0][(r + 2) % 3] - n[(r + 2) % 3] * tangent[0][(r + 1) % 3];
        for (int r = 0; r < 3; r++) n[r] *= scale;
        check_seed(seed, deform_normal(j, n, m));
        for (int r = 0; r < 3; r++) {
            n[r] /= scale;
            m[r] /= scale;
        }
        check_seed(seed, fabs(dot(m, m) - dot(n, n)) < 1e-13);
        for (int r = 0; r < 3; r++) image[r] = dot(j[r], tangent[1]);
        check_seed(seed, fabs(dot(m, image)) < 1e-13);
        for (int r = 0; r < 3; r++) image[r] = dot(j[r], n);
        check_seed(seed, dot(m, image) > 0);
    }
    (void)unused;
}

static void singular_normals(void **unused) {
    double flat[3][3] = {{1, 0, 0}, {0, 0, 0}, {0, 0, 1}}, n[3] = {0.1, 0.2, 0.3}, m[3];
    double broken[3][3] = {{NAN, 0, 0}, {0, 1, 0}, {0, 0, 1}},
           huge[3][3] = {{1e308, 0, 0}, {0, 1e308, 0}, {0, 0, 1e308}};
    double identity[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, zero[3] = {0, 0, 0};
    assert_false(deform_normal(flat, n, m));
    assert_memory_equal(n, m, sizeof n);
    assert_false(deform_normal(broken, n, m));
    assert_memory_equal(n, m, sizeof n);
    assert_false(deform_normal(huge, n, m));
    assert_memory_equal(n, m, sizeof n);
    assert_true(deform_normal(identity, n, m));
    assert_memory_equal(n, m, sizeof n);
    assert_true(deform_normal(identity, zero, m));
    assert_memory_equal(zero, m, sizeof n);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identity_is_exact),
        cmocka_unit_test(against_the_sum),
        cmocka_unit_test(polynomial_maps),
        cmocka_unit_test(cursor_is_the_same),
        cmocka_unit_test(planes),
        cmocka_unit_test(deform_overflow_and_outside),
        cmocka_unit_test(normals),
        cmocka_unit_test(singular_normals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
