/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: the defining sum with factorials, in long double. */
#include "bernstein.h"

#include "testing.h"

#include <math.h>

enum { DEGREE_MAX = 15, PATCH_MAX = 136 };

static long double factorial(int n) {
    long double f = 1;
    for (int i = 2; i <= n; i++) f *= i;
    return f;
}

static long double power(long double b, int n) {
    long double p = 1;
    for (int i = 0; i < n; i++) p *= b;
    return p;
}

/* sum c_ijk d!/(i!j!k!) b^ijk, or, l >= 0, its partial derivative by b_l; *scale is the sum of the
 * absolute terms. */
static long double direct(int d, int n, const double *c, int m, const double b[3], int l,
                          long double *scale) {
    long double sum = 0;
    int at = 0;
    *scale = 0;
    for (int i = d; i >= 0; i--)
        for (int j = d - i; j >= 0; j--, at++) {
            int e[3] = {i, j, d - i - j};
            long double term = factorial(d) / (factorial(e[0]) * factorial(e[1]) * factorial(e[2]));
            if (l >= 0) term *= e[l];
            for (int x = 0; x < 3; x++) term *= power(b[x], x == l && e[x] > 0 ? e[x] - 1 : e[x]);
            sum += term * c[n * at + m];
            *scale += fabsl(term * c[n * at + m]);
        }
    return sum;
}

static void random_case(uint64_t *s, int n, double *c, double b[3]) {
    double x = random_unit(s), y = random_unit(s);
    for (int i = 0; i < PATCH_MAX * n; i++)
        c[i] = ldexp(random_unit(s) - 0.5, (int)random_in(s, -3, 10));
    b[0] = random_in(s, 0, 4) ? fmin(x, y) : 0;
    b[1] = random_in(s, 0, 4) ? fabs(x - y) : 0;
    b[2] = 1 - (b[0] + b[1]);
}

static void against_the_formula(void **unused) {
    for (int i = 0; i < test_count(3000); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        int d = (int)random_in(&s, 0, DEGREE_MAX), n = (int)random_in(&s, 1, 4);
        double c[4 * PATCH_MAX], b[3], value[4], second[4], gradient[12];
        random_case(&s, n, c, b);
        bernstein_value(d, n, c, b, value);
        if (d > 0) bernstein_gradient(d, n, c, b, second, gradient);
        for (int m = 0; m < n; m++) {
            long double scale, exact = direct(d, n, c, m, b, -1, &scale);
            check_seed(seed, fabsl(value[m] - exact) <= 4 * (d + 1) * 0x1p-53L * scale);
            if (d == 0) continue;
            check_seed(seed, fabsl(second[m] - exact) <= 4 * (d + 1) * 0x1p-53L * scale);
            for (int l = 0; l < 3; l++) {
                exact = direct(d, n, c, m, b, l, &scale);
                check_seed(seed,
                           fabsl(gradient[n * l + m] - exact) <= 4 * (d + 1) * 0x1p-53L * scale);
            }
        }
    }
    (void)unused;
}

/* Coefficients all 1: the basis sums to (b0+b1+b2)^d, its derivatives to d. */
static void partition_of_unity(void **unused) {
    double c[PATCH_MAX], b[3], value, gradient[3];
    for (int d = 1; d <= DEGREE_MAX; d++) {
        uint64_t s = (uint64_t)d;
        for (int i = 0; i < test_count(100); i++) {
            random_case(&s, 1, c, b);
            for (int at = 0; at < PATCH_MAX; at++) c[at] = 1;
            bernstein_gradient(d, 1, c, b, &value, gradient);
            assert_true(fabs(value - 1) < 1e-14);
            for (int l = 0; l < 3; l++) assert_true(fabs(gradient[l] - d) < d * 1e-14);
        }
    }
    (void)unused;
}

static void corners_are_interpolated(void **unused) {
    double c[PATCH_MAX], value;
    for (int at = 0; at < PATCH_MAX; at++) c[at] = at + 0.1;
    for (int d = 0; d <= DEGREE_MAX; d++) {
        int corner[3] = {0, d * (d + 1) / 2, d * (d + 3) / 2};
        for (int l = 0; l < 3; l++) {
            double b[3] = {l == 0, l == 1, l == 2};
            bernstein_value(d, 1, c, b, &value);
            assert_true(value == c[corner[l]]);
        }
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(against_the_formula),
        cmocka_unit_test(partition_of_unity),
        cmocka_unit_test(corners_are_interpolated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
