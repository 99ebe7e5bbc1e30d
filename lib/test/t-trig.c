// SPDX-License-Identifier: GPL-3.0-or-later
/* trig against identities and against MPFR at 300 bits, with another reduction. */
#include "trig.h"

#include "testing.h"

#include <inttypes.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The double nearest to x as if its exponent had no bounds below, then a subnormal: by integers. */
static double nearest(mpfr_t x) {
    double scaled_up;
    mpfr_t y;
    if (mpfr_zero_p(x)) return 0;
    mpfr_exp_t e = mpfr_get_exp(x), last = e - 53 < -1074 ? -1074 : e - 53;
    mpfr_init2(y, 400);
    mpfr_mul_2si(y, x, -last, MPFR_RNDN);
    mpfr_rint(y, y, MPFR_RNDN);
    scaled_up = mpfr_get_d(y, MPFR_RNDN);
    mpfr_clear(y);
    return ldexp(scaled_up, (int)last);
}

/* Reduction by whole turns only, with as many bits as the number needs. */
static void oracle(double degrees, double *cosine, double *sine) {
    mpfr_t x, pi, c, s;
    mpfr_inits2(2500, x, pi, (mpfr_ptr)NULL);
    mpfr_inits2(300, c, s, (mpfr_ptr)NULL);
    mpfr_set_d(x, degrees, MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul(x, x, pi, MPFR_RNDN);
    mpfr_div_ui(x, x, 180, MPFR_RNDN);
    mpfr_sin_cos(s, c, x, MPFR_RNDN);
    *cosine = nearest(c), *sine = nearest(s);
    mpfr_clears(x, pi, c, s, (mpfr_ptr)NULL);
}

static void check(double degrees) {
    double c, s, exact_c, exact_s;
    trig_degrees(degrees, &c, &s);
    oracle(degrees, &exact_c, &exact_s);
    if (c != exact_c || s != exact_s) print_error("trig_degrees(%a) = %a %a\n", degrees, c, s);
    assert_true(c == exact_c && s == exact_s);
    assert_true(fabsl((long double)c * c + (long double)s * s - 1) < 0x1p-51L);
    trig_degrees(-degrees, &exact_c, &exact_s);
    assert_true(c == exact_c && s == -exact_s); /* symmetric */
}

static void test_random(void **state) {
    (void)state;
    uint64_t seed = 1;
    for (int i = 0; i < test_count(1000); i++) {
        double unit = (double)(int64_t)random_bits(&seed) * 0x1p-63;
        check(360 * unit);
        check(unit * pow(10, (double)(random_bits(&seed) % 40) - 20));
    }
    for (int i = 0; i < test_count(200); i++) { /* any finite double */
        uint64_t bits = random_bits(&seed);
        double any;
        memcpy(&any, &bits, sizeof any);
        if (isfinite(any)) check(any);
    }
}

static void test_extremes(void **state) {
    (void)state;
    static const double angles[] = {1e20,
                                    1e300,
                                    0x1.fffffffffffffp1023,
                                    0x1p-1074,
                                    0x3p-1074,
                                    0x1p-1022,
                                    0x1.123456789abcdp-1019,
                                    45,
                                    0x1p-1069,
                                    0x7bp-1074,
                                    1e-300};
    for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) check(angles[i]);
    for (int turn = -360; turn <= 720; turn += 15) {
        if (turn % 30) check(turn);
        for (int side = -1; side <= 1; side += 2) check(nextafter(turn, side * 1e9));
    }
}

/* Multiples of 30 degrees, where the value is rational: cosine 2c/2 from a table of twelve. */
static void test_exact(void **state) {
    (void)state;
    static const int twice[12] = {2, 9, 1, 0, -1, 9, -2, 9, -1, 0, 1, 9}; /* 9: irrational */
    for (int i = -36; i <= 36; i++) {
        double c, s;
        trig_degrees(30.0 * i, &c, &s);
        int at = (i + 36) % 12, before = (i + 45) % 12; /* sin x = cos(x - 90) */
        if (twice[at] != 9)
            assert_true(c == twice[at] / 2.0);
        else
            assert_true(fabs(c) == 0x1.bb67ae8584caap-1);
        if (twice[before] != 9)
            assert_true(s == twice[before] / 2.0);
        else
            assert_true(fabs(s) == 0x1.bb67ae8584caap-1);
        assert_true(!(c == 0 && signbit(c)) && !(s == 0 && signbit(s)));
    }
    double c, s;
    trig_degrees(45, &c, &s);
    assert_true(c == s && c == sqrt(0.5));
    trig_degrees(-0.0, &c, &s);
    assert_true(c == 1 && s == 0 && !signbit(s));
}

/* base^exponent by exp(exponent log base) with bits to spare. */
static double power_oracle(double base, double exponent) {
    mpfr_t x;
    mpfr_init2(x, 400);
    mpfr_set_d(x, base, MPFR_RNDN);
    mpfr_log(x, x, MPFR_RNDN);
    mpfr_mul_d(x, x, exponent, MPFR_RNDN);
    mpfr_exp(x, x, MPFR_RNDN);
    double y = nearest(x);
    mpfr_clear(x);
    return y;
}

static void test_pow(void **state) {
    (void)state;
    uint64_t seed = 2;
    for (int i = 0; i < test_count(2000); i++) {
        double base = pow(10, (double)(int64_t)random_bits(&seed) * 0x1p-62);
        double exponent = (double)(int64_t)random_bits(&seed) * 0x1p-63;
        if (i % 4 == 0) exponent *= 180; /* overflow and subnormals too */
        double got = trig_pow(base, exponent), exact = power_oracle(base, exponent);
        if (got != exact) print_error("trig_pow(%a, %a) = %a\n", base, exponent, got);
        assert_true(got == exact);
    }
    assert_true(trig_pow(7, 0) == 1 && trig_pow(1, 1e300) == 1 && trig_pow(3, 1) == 3);
    assert_true(trig_pow(1.5, 0.5) == sqrt(1.5) && trig_pow(2.25, 0.5) == 1.5);
    assert_true(trig_pow(2, -1074) == 0x1p-1074 && trig_pow(2, 1023) == 0x1p1023);
    assert_true(trig_pow(8, -358) == 0x1p-1074 && trig_pow(4, -537.5) == 0);
    assert_true(trig_pow(0x3p-538, 2) == 0x2p-1074); /* 2.25 * 2^-1074 */
    assert_true(trig_pow(0x1.8p-537, 2) == 0x2p-1074 && trig_pow(0x5p-538, 2) == 0x6p-1074);
    assert_true(trig_pow(1e-308, 1e-300) == 1 && trig_pow(nextafter(1, 2), 1e-300) == 1);
    assert_true(isinf(trig_pow(1e300, 2)) && trig_pow(1e-300, 2) == 0);
    assert_true(trig_pow(0.1, 2) == 0.1 * 0.1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_extremes),
        cmocka_unit_test(test_exact),
        cmocka_unit_test(test_pow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
