/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: the determinants as written, in GMP rationals. */
#include "predicate.h"

#include "testing.h"

#include <gmp.h>
#include <stdlib.h>

/* Sign of (bx-ax)(cy-ay) - (by-ay)(cx-ax); b and c are replaced by their differences to a. */
static int sign_of(mpq_t a[2], mpq_t b[2], mpq_t c[2]) {
    mpq_t l, r;
    int sign;
    mpq_inits(l, r, NULL);
    for (int k = 0; k < 2; k++) {
        mpq_sub(b[k], b[k], a[k]);
        mpq_sub(c[k], c[k], a[k]);
    }
    mpq_mul(l, b[0], c[1]);
    mpq_mul(r, b[1], c[0]);
    sign = mpq_cmp(l, r);
    mpq_clears(l, r, NULL);
    return (sign > 0) - (sign < 0);
}

/* Of a, b and the sum of c and rest. */
static int exact_orient_sum(const double a[2], const double b[2], const double c[2],
                            const double rest[2]) {
    mpq_t q[3][2], r;
    int sign;
    mpq_init(r);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++) mpq_init(q[i][k]);
        mpq_set_d(q[0][k], a[k]);
        mpq_set_d(q[1][k], b[k]);
        mpq_set_d(q[2][k], c[k]);
        mpq_set_d(r, rest[k]);
        mpq_add(q[2][k], q[2][k], r);
    }
    sign = sign_of(q[0], q[1], q[2]);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) mpq_clear(q[i][k]);
    mpq_clear(r);
    return sign;
}

static int exact_orient(const double a[2], const double b[2], const double c[2]) {
    return exact_orient_sum(a, b, c, (const double[]){0, 0});
}

static int exact_side(const struct lattice *lattice, const int32_t a[2], const int32_t b[2],
                      const double p[2]) {
    const double origin[2] = {lattice->x0, lattice->y0};
    mpq_t q[3][2], o, step;
    int sign;
    mpq_inits(o, step, NULL);
    mpq_set_d(step, lattice->step);
    for (int k = 0; k < 2; k++) {
        const int32_t n[2] = {a[k], b[k]};
        mpq_set_d(o, origin[k]);
        for (int i = 0; i < 2; i++) {
            mpq_init(q[i][k]);
            mpq_set_si(q[i][k], n[i], 1);
            mpq_mul(q[i][k], q[i][k], step);
            mpq_add(q[i][k], q[i][k], o);
        }
        mpq_init(q[2][k]);
        mpq_set_d(q[2][k], p[k]);
    }
    sign = sign_of(q[0], q[1], q[2]);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) mpq_clear(q[i][k]);
    mpq_clears(o, step, NULL);
    return sign;
}

static double ulps_away(double x, int64_t n) {
    for (; n > 0; n--) x = nextafter(x, HUGE_VAL);
    for (; n < 0; n++) x = nextafter(x, -HUGE_VAL);
    return x;
}

static const struct lattice lattices[] = {
    {1, 0, 0},         {0.25, -100, -80},      {0.1, 0, 0},           {0.1, 1e6, -1.0 / 3},
    {1e-9, 1e9, 7e-7}, {0x1p-1060, 0, 1e-300}, {0x1p900, 0x1p950, 0}, {3, 1e-30, 1e30},
};

/* Points at fractions of an edge, a few last places off: the filter cannot decide these. */
static void side_near_edges(void **unused) {
    int n = test_count(40000);
    int zeros = 0;
    for (int i = 0; i < n; i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        const struct lattice *l = &lattices[random_in(&s, 0, 7)];
        int64_t range = (int64_t)1 << random_in(&s, 1, 24), parts = random_in(&s, 1, 8);
        int64_t part = random_in(&s, -parts, 2 * parts);
        int32_t a[2], b[2];
        double p[2];
        for (int k = 0; k < 2; k++) {
            a[k] = (int32_t)random_in(&s, -range, range);
            b[k] = (int32_t)random_in(&s, -range, range);
        }
        for (int k = 0; k < 2; k++) {
            double origin = k ? l->y0 : l->x0;
            double at = a[k] + (double)part * ((double)b[k] - a[k]) / (double)parts;
            p[k] = ulps_away(origin + l->step * at, random_in(&s, -2, 2) * random_in(&s, 0, 1));
        }
        int sign = exact_side(l, a, b, p);
        zeros += sign == 0;
        check_seed(seed, predicate_side(l, a, b, p) == sign);
        check_seed(seed, predicate_side(l, b, a, p) == -sign);
    }
    assert_true(zeros > n / 20); /* the test does test the edge itself */
    (void)unused;
}

/* Any finite point, up to the largest double and down to subnormals. */
static void side_of_extremes(void **unused) {
    for (int i = 0; i < test_count(20000); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        const struct lattice *l = &lattices[random_in(&s, 0, 7)];
        int32_t a[2], b[2];
        double p[2];
        for (int k = 0; k < 2; k++) {
            a[k] = (int32_t)random_in(&s, -(1 << 24), 1 << 24);
            b[k] = (int32_t)random_in(&s, -(1 << 24), 1 << 24);
            p[k] = ldexp(random_unit(&s) - 0.5, (int)random_in(&s, -1074, 1024));
        }
        check_seed(seed, predicate_side(l, a, b, p) == exact_side(l, a, b, p));
    }
    (void)unused;
}

static void orient(void **unused) {
    for (int i = 0; i < test_count(40000); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        int exponent = (int)random_in(&s, 0, 5) ? 0 : (int)random_in(&s, -1070, 1020);
        double t = random_in(&s, 0, 1) ? (double)random_in(&s, -8, 16) / 8 : random_unit(&s);
        double a[2], b[2], c[2];
        for (int k = 0; k < 2; k++) {
            a[k] = ldexp(random_unit(&s) - 0.5, exponent);
            b[k] = ldexp(random_unit(&s) - 0.5, exponent);
            if (random_in(&s, 0, 9) == 0) b[k] = a[k];
            if (i % 3 == 0) { /* on a lattice, as differences are exact */
                a[k] = floor(ldexp(a[k], 20 - exponent));
                b[k] = floor(ldexp(b[k], 20 - exponent));
            }
            c[k] =
                ulps_away(a[k] + t * (b[k] - a[k]), random_in(&s, -2, 2) * random_in(&s, 0, i % 3));
        }
        int sign = exact_orient(a, b, c);
        check_seed(seed, predicate_orient(a, b, c) == sign);
        check_seed(seed, predicate_orient(b, c, a) == sign);
        check_seed(seed, predicate_orient(b, a, c) == -sign);
    }
    (void)unused;
}

/* The nearest double to a point of the line, and what is missing, or not quite that. */
static void orient_sum(void **unused) {
    int n = test_count(40000), zeros = 0;
    for (int i = 0; i < n; i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        double a[2], b[2], c[2], rest[2], d, t = (double)random_in(&s, 1, 15) / 16;
        for (int k = 0; k < 2; k++) {
            a[k] = ldexp(random_unit(&s) - 0.5, (int)random_in(&s, 0, 8));
            b[k] = a[k] + ldexp((double)random_in(&s, -1024, 1024), (int)random_in(&s, -60, 0));
            d = t * (b[k] - a[k]); /* exact, as b - a has few bits or is one double */
            c[k] = a[k] + d;
            rest[k] = d - (c[k] - a[k]);
            if (random_in(&s, 0, 3) == 0) rest[k] = ulps_away(rest[k], random_in(&s, -1, 1));
            rest[k] = fmax(fmin(rest[k], fabs(c[k]) * 0x1p-54), -fabs(c[k]) * 0x1p-54);
        }
        int sign = exact_orient_sum(a, b, c, rest);
        zeros += sign == 0;
        check_seed(seed, predicate_orient_sum(a, b, c, rest) == sign);
        check_seed(seed, predicate_orient_sum(b, a, c, rest) == -sign);
    }
    assert_true(zeros > n / 20);
    (void)unused;
}

static void area2(void **unused) {
    const int32_t m = 1 << 24, a[2] = {-m, -m}, b[2] = {m, -m}, c[2] = {m, m}, d[2] = {0, 1};
    assert_int_equal(predicate_area2(a, b, c), (int64_t)1 << 50);
    assert_int_equal(predicate_area2(a, c, b), -((int64_t)1 << 50));
    assert_int_equal(predicate_area2(a, c, d), (int64_t)1 << 25);
    assert_int_equal(predicate_area2(a, a, b), 0);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(side_near_edges), cmocka_unit_test(side_of_extremes),
        cmocka_unit_test(orient),          cmocka_unit_test(orient_sum),
        cmocka_unit_test(area2),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
