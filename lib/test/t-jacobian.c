/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Maps whose least determinant is known exactly: phi = (x, g(x,y)) has det = dg/dy. */
#include "jacobian.h"
#include "rational.h"
#include "volume.h"

#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POWERS = 9 };

/* sum c[a][b] s^a t^b, coefficients exact; s, t are coordinates from the triangle's first corner */
struct poly {
    double c[POWERS][POWERS];
};

static struct poly constant(double c) {
    return (struct poly){{{c}}};
}

static struct poly linear(double c, double s, double t) {
    return (struct poly){{{c, t}, {s}}};
}

static struct poly sum(struct poly p, struct poly q) {
    for (int i = 0; i < POWERS * POWERS; i++)
        p.c[i / POWERS][i % POWERS] += q.c[i / POWERS][i % POWERS];
    return p;
}

static struct poly product(struct poly p, struct poly q) {
    struct poly r = {0};
    for (int a = 0; a < POWERS; a++)
        for (int b = 0; b < POWERS; b++)
            for (int c = 0; a + c < POWERS; c++)
                for (int d = 0; b + d < POWERS; d++) r.c[a + c][b + d] += p.c[a][b] * q.c[c][d];
    return r;
}

/* The integral over t from 0; coefficients must divide. */
static struct poly integral(struct poly p) {
    struct poly r = {0};
    for (int a = 0; a < POWERS; a++)
        for (int b = 0; b + 1 < POWERS; b++) {
            r.c[a][b + 1] = p.c[a][b] / (b + 1);
            assert_true(r.c[a][b + 1] * (b + 1) == p.c[a][b]);
        }
    return r;
}

static double value_of(const struct poly *p, double s, double t) {
    double sum = 0;
    for (int a = POWERS; a-- > 0;) {
        double row = 0;
        for (int b = POWERS; b-- > 0;) row = row * t + p->c[a][b];
        sum = sum * s + row;
    }
    return sum;
}

/* Bernstein coefficient of p with weights (d-j-k, j, k) on the right triangle with legs `size`:
 * s^a t^b has size^(a+b) j..(j-a+1) k..(k-b+1) / (d..(d-a-b+1)). It must be a double. */
static double coefficient(const struct poly *p, int d, int j, int k, double size) {
    mpq_t total, term, factor;
    double result;
    mpq_inits(total, term, factor, NULL);
    for (int a = 0; a <= j && a < POWERS; a++)
        for (int b = 0; b <= k && b < POWERS; b++) {
            mpq_set_d(term, p->c[a][b]);
            for (int i = 0; i < a + b; i++) {
                mpq_set_d(factor, size * (i < a ? j - i : k - (i - a)));
                mpq_mul(term, term, factor);
                mpq_set_d(factor, d - i);
                mpq_div(term, term, factor);
            }
            mpq_add(total, total, term);
        }
    result = mpq_get_d(total);
    mpq_set_d(term, result);
    assert_true(mpq_equal(term, total));
    mpq_clears(total, term, factor, NULL);
    return result;
}

/* One triangle (0,0), (size,0), (0,size), size = step * legs, with the map (s, g). */
static void plant(struct spline *s, int degree, int legs, double step, const struct poly *g) {
    struct grid grid = {.degree = degree,
                        .axes = {0, 1, 2},
                        .lattice = {step, 0, 0},
                        .vertex_count = 3,
                        .triangle_count = 1};
    struct poly x = linear(0, 1, 0);
    struct err err;
    uint32_t q[GRID_PATCH_MAX];
    grid.vertex = calloc(3, sizeof *grid.vertex);
    grid.triangle = calloc(1, sizeof *grid.triangle);
    grid.vertex[1][0] = grid.vertex[2][1] = legs;
    for (uint32_t l = 0; l < 3; l++) grid.triangle[0][l] = l;
    assert_true(grid_build(&grid, &err));
    assert_true(spline_identity(s, &grid, &err));
    grid_patch(&s->grid, 0, q);
    for (int r = 0, i = 0; r <= degree; r++)
        for (int k = 0; k <= r; k++, i++) {
            s->phi[q[i]][0] = coefficient(&x, degree, r - k, k, step * legs);
            s->phi[q[i]][1] = coefficient(g, degree, r - k, k, step * legs);
        }
}

/* Certifies and frees; the bounds must bracket dense samples of det. */
static struct jacobian_bounds certify(struct spline *s, const struct poly *det, double tolerance,
                                      double *value) {
    struct least_rule rule = jacobian_default_rule;
    struct jacobian_report r;
    struct err err;
    double size = s->grid.lattice.step * s->grid.vertex[1][0], largest = 0;
    rule.tolerance = tolerance;
    assert_true(jacobian_report_init(&r, s, JACOBIAN_PLANE, &rule, false, &err));
    for (int j = 0; j <= 40; j++)
        for (int k = 0; j + k <= 40; k++)
            largest = fmax(largest, fabs(value_of(det, size * j / 40, size * k / 40)));
    for (int j = 0; j <= 40; j++)
        for (int k = 0; j + k <= 40; k++)
            assert_true(value_of(det, size * j / 40, size * k / 40) >=
                        r.least.low - 1e-13 * largest);
    assert_true(r.least.low <= r.least.high && r.value <= r.least.high);
    if (r.least.verdict == JACOBIAN_CERTIFIED || r.least.verdict == JACOBIAN_FOLDS)
        assert_true(r.least.high - r.least.low <= 1.000001 * tolerance * fabs(r.least.high));
    if (value) *value = r.value;
    jacobian_report_free(&r);
    spline_free(s);
    return r.least;
}

/* m + 3 (s-a)^2 + 3 (t-b)^2, on legs of 840: exact in degrees 3 to 8 */
static struct poly dip(double m, double a, double b) {
    struct poly x = linear(-a, 1, 0), y = linear(-b, 0, 1);
    struct poly det = sum(product(constant(3), product(x, x)), product(constant(3), product(y, y)));
    return sum(det, constant(m));
}

static enum jacobian_verdict expected(double m) {
    return m > 0 ? JACOBIAN_CERTIFIED : m < 0 ? JACOBIAN_FOLDS : JACOBIAN_DEGENERATE;
}

static void check_dip(int degree, double m, int a, int b, double tolerance, uint64_t seed) {
    struct poly det = dip(m, a, b), g = integral(det);
    struct jacobian_bounds got;
    struct spline s;
    double value;
    plant(&s, degree, 840, 1, &g);
    got = certify(&s, &det, tolerance, &value);
    check_seed(seed, got.verdict == expected(m));
    check_seed(seed, got.low <= m && m <= got.high && m <= value);
    if (m == 0) check_seed(seed, got.high == 0 && value == 0);
}

/* 2^-20 is 1e-12 of the mean. Where the dip's place is no dyadic fraction of 840, so is the zero.
 */
static void test_dips(void **state) {
    static const double depth[] = {1000, 1, 0x1p-20, 0, -0x1p-20, -1, -1000};
    uint64_t seed = 7;
    (void)state;
    for (int n = test_count(60); n > 0; n--) {
        uint64_t start = seed;
        int degree = (int)random_in(&seed, 3, 8), where = (int)random_in(&seed, 0, 3);
        double m = depth[random_in(&seed, 0, 6)];
        int a = (int)random_in(&seed, 1, 838), b = (int)random_in(&seed, 1, 839 - a);
        if (where == 1) b = random_bits(&seed) & 1 ? 0 : 840 - a;
        if (where == 2) a = 0;
        if (where == 3)
            a = random_bits(&seed) & 1 ? 0 : 840, b = a || random_bits(&seed) & 1 ? 0 : 840;
        check_dip(degree, m, a, b, random_bits(&seed) & 1 ? 0.01 : 1e-6, start);
    }
}

static void test_low_degrees(void **state) {
    struct spline s;
    struct jacobian_bounds got;
    (void)state;
    for (int m = -2; m <= 2; m++) {
        struct poly flat = constant(m), slope = linear(m, 0.5, 0.25), g = integral(flat);
        plant(&s, 1, 840, 1, &g);
        got = certify(&s, &flat, 0.01, NULL);
        assert_int_equal(got.verdict, expected(m));
        assert_true(got.low <= m && m <= got.high);
        g = integral(slope); /* least at corner 0 */
        plant(&s, 2, 840, 1, &g);
        got = certify(&s, &slope, 0.01, NULL);
        assert_int_equal(got.verdict, expected(m));
        assert_true(got.low <= m && m <= got.high);
    }
}

/* -dip turns everything over, and is least at a corner. */
static void test_flips(void **state) {
    static const double corner[3][2] = {{0, 0}, {840, 0}, {0, 840}};
    uint64_t seed = 17;
    (void)state;
    for (int n = test_count(40); n > 0; n--) {
        uint64_t start = seed;
        int degree = (int)random_in(&seed, 3, 8);
        int a = (int)random_in(&seed, 0, 840), b = (int)random_in(&seed, 0, 840 - a);
        struct poly det = product(constant(-1), dip((double)random_in(&seed, 1, 1000), a, b));
        struct poly g = integral(det);
        struct jacobian_bounds got;
        struct spline s;
        double least = 0, value;
        for (int l = 0; l < 3; l++) least = fmin(least, value_of(&det, corner[l][0], corner[l][1]));
        plant(&s, degree, 840, 1, &g);
        got = certify(&s, &det, 0.01, &value);
        check_seed(start, got.verdict == JACOBIAN_FOLDS);
        check_seed(start, got.low <= least && least <= got.high && least <= value);
    }
}

/* A least value above B, by little or much, is certified. Below, the verdict may be that it is
 * undecided, and is never a wrong one. */
static void test_threshold(void **state) {
    static const double depth[] = {1000, 1, 0x1p-20};
    struct least_room *room;
    struct err err;
    uint64_t seed = 23;
    int undecided = 0;
    (void)state;
    assert_non_null(room = least_room_new(&err));
    for (int n = test_count(60); n > 0; n--) {
        uint64_t start = seed;
        int degree = (int)random_in(&seed, 3, 8), sign = random_bits(&seed) & 1 ? 1 : -1;
        int a = (int)random_in(&seed, 1, 838), b = (int)random_in(&seed, 1, 839 - a);
        double m = depth[random_in(&seed, 0, 2)], c[LEAST_SIZE_MAX], error, factor, mean = 0;
        struct poly det = dip(sign * m, a, b), g = integral(det);
        struct least_rule rule = {0.01, 0, 4096};
        struct least_place place;
        struct jacobian_bounds got;
        struct spline s;
        plant(&s, degree, 840, 1, &g);
        assert_true(jacobian_coefficients(&s, JACOBIAN_PLANE, 0, c, &error, &factor));
        for (int i = 0; i < least_size(2 * degree - 2); i++) mean += fabs(c[i]);
        mean *= factor / least_size(2 * degree - 2);
        for (int k = 0; k < 6; k++) {
            static const double times[] = {0, 0x1p-40, 0.5, 0.999, 1.001, 1000};
            rule.undecided = fmin(0.5, times[k] * m / mean);
            least_place_init(&place);
            assert_true(jacobian_triangle(room, &s, JACOBIAN_PLANE, 0, &rule, &got, &place, &err));
            check_seed(start, got.low <= sign * m && sign * m <= got.high);
            check_seed(start, got.verdict == expected(sign) ||
                                  (times[k] > 1 && got.verdict == JACOBIAN_UNDECIDED));
            undecided += got.verdict == JACOBIAN_UNDECIDED;
            least_place_free(&place);
        }
        spline_free(&s);
    }
    assert_true(undecided > 0);
    least_room_free(room);
}

/* 3 (x^2 - 1/2)^2 + 3 y^2 + m on legs of 15/8, y = t - shift */
static struct poly irrational(double m, double shift) {
    struct poly x = linear(0, 1, 0), y = linear(-shift, 0, 1);
    struct poly square = sum(product(x, x), constant(-0.5));
    struct poly det = sum(product(square, square), product(y, y));
    return sum(product(constant(3), det), constant(m));
}

static void test_irrational_zero(void **state) {
    (void)state;
    for (int degree = 5; degree <= 6; degree++)
        for (int edge = 0; edge < 2; edge++)
            for (int sign = -1; sign <= 1; sign++) {
                struct poly det = irrational(15 * sign * 0x1p-30, edge ? 0 : 0.5), g = {0};
                struct jacobian_bounds got;
                struct spline s;
                for (int a = 0; a < POWERS; a++)
                    for (int b = 0; b + 1 < POWERS; b++) g.c[a][b + 1] = det.c[a][b] / (b + 1);
                plant(&s, degree, 15, 0.125, &g);
                got = certify(&s, &det, 0.01, NULL);
                if (sign == 0) {
                    assert_int_equal(got.verdict, JACOBIAN_UNDECIDED);
                    assert_true(got.low <= 0 && got.low >= -40 * 0x1p-100);
                    assert_true(got.high > 0 && got.high <= 40 * 0x1p-100);
                } else {
                    assert_int_equal(got.verdict, expected(sign));
                    assert_true(got.low <= 15 * sign * 0x1p-30 && got.high >= 15 * sign * 0x1p-30);
                }
            }
}

/* Zero all along a circle without rational points, s^2 + t^2 = 3: the work ends, the bounds hold.
 */
static void test_curve_of_zeros(void **state) {
    struct poly x = linear(0, 1, 0), y = linear(0, 0, 1), det, g = {0};
    struct poly circle = sum(sum(product(x, x), product(y, y)), constant(-3));
    struct jacobian_bounds got;
    struct spline s;
    (void)state;
    det = product(constant(15), product(circle, circle));
    g = integral(det);
    plant(&s, 5, 15, 0.125, &g);
    got = certify(&s, &det, 0.01, NULL);
    assert_int_equal(got.verdict, JACOBIAN_UNDECIDED);
    assert_true(got.low <= 0 && got.low > -0.01 && got.high > 0 && got.high < 0.01);
}

/* Four positive triangles of the net, and det = -4 in the middle of edge 020-002. */
static void test_positive_net(void **state) {
    static const double net[6][2] = {{0, 0}, {-1, 2}, {0, -2}, {-2, -2}, {-1, 0}, {-2, 0}};
    struct poly flat = linear(0, 0, 1);
    struct jacobian_report r;
    struct least_place middle;
    mpz_t c[LEAST_SIZE_MAX];
    mpq_t factor, value;
    struct spline s;
    struct err err;
    uint32_t q[GRID_PATCH_MAX];
    (void)state;
    plant(&s, 2, 1, 1, &flat);
    grid_patch(&s.grid, 0, q);
    for (int i = 0; i < 6; i++) memcpy(s.phi[q[i]], net[i], sizeof net[i]);
    assert_true(jacobian_report_init(&r, &s, JACOBIAN_PLANE, &jacobian_default_rule, true, &err));
    assert_int_equal(r.least.verdict, JACOBIAN_FOLDS);
    assert_true(r.value <= -4 * 0.98 && r.least.low <= -4);
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_init(c[i]);
    mpq_inits(factor, value, NULL);
    least_place_init(&middle);
    for (int l = 0; l < 3; l++) mpz_set_ui(middle.weight[l], l > 0);
    jacobian_coefficients_exact(&s, JACOBIAN_PLANE, 0, c, factor);
    least_value(2, (const mpz_t *)c, &middle, value);
    mpq_mul(value, value, factor);
    assert_true(mpq_cmp_si(value, -4, 1) == 0);
    least_place_free(&middle);
    mpq_clears(factor, value, NULL);
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_clear(c[i]);
    jacobian_report_free(&r);
    spline_free(&s);
}

/* integral of s^a t^b over the triangle with legs `size`: size^(a+b+2) a! b! / (a+b+2)! */
static void integrate(const struct poly *p, double size, mpq_t total) {
    mpq_t term, factor;
    mpq_inits(term, factor, NULL);
    mpq_set_ui(total, 0, 1);
    for (int a = 0; a < POWERS; a++)
        for (int b = 0; b < POWERS; b++) {
            mpq_set_d(term, p->c[a][b]);
            for (int i = 1; i <= a + b + 2; i++) {
                mpq_set_d(factor, i <= a ? size * i : i <= a + b ? size * (i - a) : size);
                mpq_mul(term, term, factor);
                mpq_set_ui(factor, (unsigned long)i, 1);
                mpq_div(term, term, factor);
            }
            mpq_add(total, total, term);
        }
    mpq_clears(term, factor, NULL);
}

static void give_depth(struct spline *s, const struct poly *thickness, double size) {
    int d = s->grid.degree;
    uint32_t q[GRID_PATCH_MAX];
    s->grid.has_depth = true;
    s->grid.depth[0] = -1;
    s->grid.depth[1] = 2;
    assert_non_null(s->sigma = calloc(s->grid.point_count, sizeof *s->sigma));
    grid_patch(&s->grid, 0, q);
    for (int r = 0, i = 0; r <= d; r++)
        for (int k = 0; k <= r; k++, i++) {
            s->sigma[q[i]][0] = r - 2 * k;
            s->sigma[q[i]][1] = s->sigma[q[i]][0] + coefficient(thickness, d, r - k, k, size);
        }
}

/* Thickness 3 m + 3 (s-a)^2 + 3 (t-b)^2 over 3: its least value, and the volume, as closed forms.
 */
static void test_depth(void **state) {
    uint64_t seed = 5;
    (void)state;
    for (int n = test_count(50); n > 0; n--) {
        uint64_t start = seed;
        int degree = (int)random_in(&seed, 3, 8), m = (int)random_in(&seed, -3, 3);
        int a = (int)random_in(&seed, 0, 400), b = (int)random_in(&seed, 0, 400);
        struct poly det = dip((double)random_in(&seed, -9, 9), b, a), g = integral(det);
        struct poly thickness = dip(3 * m, a, b), both = product(det, thickness);
        struct jacobian_report r;
        struct spline s;
        struct err err;
        double volume, ratio;
        mpq_t exact;
        plant(&s, degree, 840, 1, &g);
        give_depth(&s, &thickness, 840);
        assert_true(
            jacobian_report_init(&r, &s, JACOBIAN_THICKNESS, &jacobian_default_rule, true, &err));
        check_seed(start, r.least.verdict == expected(m));
        check_seed(start, r.least.low <= m && m <= r.least.high && m <= r.value);
        assert_true(volume_of_prisms(&s, &volume, &ratio, &err));
        mpq_init(exact);
        integrate(&both, 840, exact);
        check_seed(start, volume == rational_round(exact));
        mpz_mul_ui(mpq_denref(exact), mpq_denref(exact), 840 * 840 / 2 * 3);
        mpq_canonicalize(exact);
        check_seed(start, ratio == rational_round(exact));
        mpq_clear(exact);
        jacobian_report_free(&r);
        spline_free(&s);
    }
}

/* phi's component at b, weights in long double, by de Casteljau; derivative towards `to`. */
static long double derivative(const struct spline *s, const uint32_t *q, int c, const double *b,
                              int to) {
    int d = s->grid.degree;
    long double v[GRID_PATCH_MAX];
    for (int i = 0; i < grid_patch_size(d); i++) v[i] = (long double)s->phi[q[i]][c];
    for (int e = d; e > 1; e--)
        for (int r = 0; r < e; r++)
            for (int k = 0; k <= r; k++) {
                int i = r * (r + 1) / 2 + k;
                v[i] = (long double)b[0] * v[i] + (long double)b[1] * v[i + r + 1] +
                       (long double)b[2] * v[i + r + 2];
            }
    return d * (v[to] - v[0]);
}

static long double determinant(const struct spline *s, const double *b, double area2) {
    uint32_t q[GRID_PATCH_MAX];
    grid_patch(&s->grid, 0, q);
    return (derivative(s, q, 0, b, 1) * derivative(s, q, 1, b, 2) -
            derivative(s, q, 1, b, 1) * derivative(s, q, 0, b, 2)) /
           (long double)area2;
}

/* A random net, mild to wild, far from the origin, of an odd scale; twice the area of its triangle.
 */
static double random_net(struct spline *s, uint64_t *seed) {
    struct poly g = linear(0, 0, 1);
    int degree = (int)random_in(seed, 1, 15);
    double size = ldexp(0.1, (int)random_in(seed, -30, 30)), wild = 0.6 * random_unit(seed);
    double shift = size * (double)random_in(seed, -9, 9);
    plant(s, degree, 720720, 0x1p-20, &g);
    s->grid.lattice.step = size * 0x1p-20;
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int c = 0; c < 2; c++) {
            double noise = wild * (random_unit(seed) - 0.5) / degree;
            s->phi[p][c] = shift + size * (s->phi[p][c] + noise);
        }
    return 720720.0 * 720720.0 * s->grid.lattice.step * s->grid.lattice.step;
}

static void check_samples(const struct spline *s, double area2, struct jacobian_bounds bounds,
                          const struct least_place *place, uint64_t seed) {
    uint64_t state = seed;
    double at[3], total = 0, value;
    for (int i = 0; i < 1000; i++) {
        double b1 = random_unit(&state), b2 = (1 - b1) * random_unit(&state);
        double b[3] = {1 - b1 - b2, b1, b2};
        check_seed(seed, (double)determinant(s, b, area2) >= bounds.low - 1e-9);
    }
    for (int l = 0; l < 3; l++) total += mpz_get_d(place->weight[l]);
    for (int l = 0; l < 3; l++) at[l] = mpz_get_d(place->weight[l]) / total;
    value = (double)determinant(s, at, area2);
    check_seed(seed, fabs(value - bounds.high) <= 1e-9 * (1 + fabs(value)));
}

/* Bounds bracket samples and tighten, and the witness is what it is said to be. */
static void test_random(void **state) {
    struct least_room *room;
    struct err err;
    uint64_t seed = 11;
    (void)state;
    assert_non_null(room = least_room_new(&err));
    for (int n = test_count(200); n > 0; n--) {
        struct least_rule rule = {0.05, 0x1p-100, 4096};
        struct jacobian_bounds loose, tight;
        struct least_place at;
        struct spline s;
        uint64_t start = seed;
        double area2 = random_net(&s, &seed);
        least_place_init(&at);
        assert_true(jacobian_triangle(room, &s, JACOBIAN_PLANE, 0, &rule, &loose, &at, &err));
        rule.tolerance = 1e-5;
        assert_true(jacobian_triangle(room, &s, JACOBIAN_PLANE, 0, &rule, &tight, &at, &err));
        check_seed(start, tight.verdict == loose.verdict);
        check_seed(start, loose.high - loose.low <= 0.051 * fabs(loose.high));
        check_seed(start, tight.high - tight.low <= 1.1e-5 * fabs(tight.high));
        check_seed(start, tight.low <= loose.high && loose.low <= tight.high);
        check_samples(&s, area2, tight, &at, start);
        least_place_free(&at);
        spline_free(&s);
    }
    least_room_free(room);
}

/* Each coefficient in doubles is within its error of the exact one; 2^-45 is for the factor. */
static void check_error(const struct spline *s, const struct spline *r, mpz_t *c, mpq_t factor,
                        uint64_t seed) {
    double coarse[LEAST_SIZE_MAX], error, scale;
    mpq_t exact;
    mpq_init(exact);
    check_seed(seed, jacobian_polar(s, r, JACOBIAN_PLANE, 0, coarse, &error, &scale));
    for (int i = 0; i < least_size(jacobian_degree(s, JACOBIAN_PLANE)); i++) {
        mpq_set_z(exact, c[i]);
        mpq_mul(exact, exact, factor);
        check_seed(seed, fabs(mpq_get_d(exact) - scale * coarse[i]) <=
                             scale * (error + 0x1p-45 * fabs(coarse[i])));
    }
    mpq_clear(exact);
}

static double polar_value(const struct spline *s, const struct spline *r, const double b[3],
                          mpz_t *c, uint64_t seed) {
    struct least_place place;
    mpq_t factor, value;
    double result;
    mpq_inits(factor, value, NULL);
    least_place_init(&place);
    least_place_set(&place, b);
    jacobian_polar_exact(s, r, JACOBIAN_PLANE, 0, c, factor);
    check_error(s, r, c, factor, seed);
    least_value(jacobian_degree(s, JACOBIAN_PLANE), (const mpz_t *)c, &place, value);
    mpq_mul(value, value, factor);
    result = mpq_get_d(value);
    least_place_free(&place);
    mpq_clears(factor, value, NULL);
    return result;
}

/* The polar form of two nets makes up the determinants of all nets between them. */
static void check_polar(mpz_t *c, uint64_t seed) {
    static const double b[3] = {0.25, 0.125, 0.625};
    uint64_t state = seed;
    struct spline s, between, r;
    double area2 = random_net(&s, &state), share = random_unit(&state), sum, value;
    between = r = s;
    between.phi = calloc(s.grid.point_count, sizeof *between.phi);
    r.phi = calloc(s.grid.point_count, sizeof *r.phi);
    for (uint32_t p = 0; p < s.grid.point_count; p++)
        for (int k = 0; k < 2; k++) {
            r.phi[p][k] = s.phi[p][k] * (1.5 - random_unit(&state));
            between.phi[p][k] = s.phi[p][k] + share * (r.phi[p][k] - s.phi[p][k]);
        }
    sum = (1 - share) * (1 - share) * polar_value(&s, &s, b, c, seed) +
          2 * share * (1 - share) * polar_value(&s, &r, b, c, seed) +
          share * share * polar_value(&r, &r, b, c, seed);
    value = (double)determinant(&between, b, area2);
    check_seed(seed, fabs(sum - value) <= 1e-9 * (1 + fabs(value)));
    free(between.phi);
    free(r.phi);
    spline_free(&s);
}

static void test_polar(void **state) {
    mpz_t c[LEAST_SIZE_MAX];
    (void)state;
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_init(c[i]);
    for (int n = test_count(100); n > 0; n--) check_polar(c, 1300 + (uint64_t)n);
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_clear(c[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dips),
        cmocka_unit_test(test_low_degrees),
        cmocka_unit_test(test_flips),
        cmocka_unit_test(test_threshold),
        cmocka_unit_test(test_irrational_zero),
        cmocka_unit_test(test_curve_of_zeros),
        cmocka_unit_test(test_positive_net),
        cmocka_unit_test(test_depth),
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_polar),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
