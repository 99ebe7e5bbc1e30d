// SPDX-License-Identifier: GPL-3.0-or-later
/* dd against MPFR with enough bits to be exact. */
#include "dd.h"

#include "testing.h"

#include <math.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>

/* Any sign, an exponent in [-spread, spread], often few bits, so that ties and runs of 0 and 1 in
 * the halves occur. */
static double random_double(uint64_t *state, int spread) {
    uint64_t bits = random_bits(state), shape = random_bits(state);
    int64_t mantissa = (int64_t)(bits >> 11);
    if (shape % 4 == 0) mantissa &= ~((INT64_C(1) << (shape >> 8) % 53) - 1);
    if (shape % 4 == 1) mantissa |= (INT64_C(1) << (shape >> 8) % 53) - 1;
    double x = ldexp((double)mantissa, (int)(shape >> 16) % (spread + 1) - 53);
    return shape & 0x80 ? -x : x;
}

static struct dd random_dd(uint64_t *state, int spread) {
    double hi = random_double(state, spread);
    return dd_two_sum(hi, hi * 0x1p-53 * (double)(int64_t)random_bits(state) * 0x1p-63);
}

enum { BITS = 4000 }; /* exact for all sums and products here */

/* |hi + lo - exact| <= bound * |size|, and the normal form. */
static bool is_near(struct dd x, mpfr_t exact, mpfr_t size, double bound) {
    mpfr_t error, limit;
    mpfr_inits2(BITS, error, limit, (mpfr_ptr)NULL);
    mpfr_sub_d(error, exact, x.hi, MPFR_RNDN);
    mpfr_sub_d(error, error, x.lo, MPFR_RNDN);
    mpfr_mul_d(limit, size, bound, MPFR_RNDN);
    bool near = mpfr_cmpabs(error, limit) <= 0 && x.hi + x.lo == x.hi;
    mpfr_clears(error, limit, (mpfr_ptr)NULL);
    return near;
}

static void set_dd(mpfr_t x, struct dd value) {
    mpfr_set_d(x, value.hi, MPFR_RNDN);
    mpfr_add_d(x, x, value.lo, MPFR_RNDN);
}

static void test_transforms(void **state) {
    (void)state;
    uint64_t seed = 1;
    mpfr_t exact;
    mpfr_init2(exact, BITS);
    for (int i = 0; i < test_count(100000); i++) {
        double a = random_double(&seed, 460), b = random_double(&seed, i % 2 ? 60 : 460);
        struct dd sum = dd_two_sum(a, b), product = dd_two_prod(a, b), half = dd_split(a);
        mpfr_set_d(exact, a, MPFR_RNDN);
        mpfr_add_d(exact, exact, b, MPFR_RNDN);
        assert_true(sum.hi == a + b && is_near(sum, exact, exact, 0));
        struct dd fast = fabs(a) >= fabs(b) ? dd_fast_two_sum(a, b) : dd_fast_two_sum(b, a);
        assert_true(fast.hi == sum.hi && fast.lo == sum.lo);
        mpfr_set_d(exact, a, MPFR_RNDN);
        mpfr_mul_d(exact, exact, b, MPFR_RNDN);
        assert_true(product.hi == a * b && is_near(product, exact, exact, 0));
        assert_true(half.hi + half.lo == a);
    }
    mpfr_clear(exact);
}

/* The ends of the documented range of products. */
static void test_range(void **state) {
    (void)state;
    uint64_t seed = 2;
    mpfr_t exact;
    mpfr_init2(exact, BITS);
    for (int i = 0; i < test_count(10000); i++) {
        double a = ldexp(random_double(&seed, 0), 996), b = ldexp(random_double(&seed, 0), 27);
        double tiny = ldexp(1 + fabs(random_double(&seed, 0)), -500);
        double small = ldexp(1 + fabs(random_double(&seed, 0)), -469);
        mpfr_set_d(exact, a, MPFR_RNDN);
        mpfr_mul_d(exact, exact, b, MPFR_RNDN);
        assert_true(is_near(dd_two_prod(a, b), exact, exact, 0));
        mpfr_set_d(exact, tiny, MPFR_RNDN);
        mpfr_mul_d(exact, exact, small, MPFR_RNDN);
        assert_true(is_near(dd_two_prod(tiny, small), exact, exact, 0));
    }
    mpfr_clear(exact);
}

static void test_arithmetic(void **state) {
    (void)state;
    uint64_t seed = 3;
    mpfr_t x, y, exact, size;
    mpfr_inits2(BITS, x, y, exact, size, (mpfr_ptr)NULL);
    for (int i = 0; i < test_count(50000); i++) {
        struct dd a = random_dd(&seed, 200), b = random_dd(&seed, i % 2 ? 4 : 200);
        double d = random_double(&seed, i % 2 ? 4 : 200);
        if (i % 5 == 0) b = dd_add_double(dd_negate(a), a.lo / 3); /* cancels */
        set_dd(x, a), set_dd(y, b);
        mpfr_add(exact, x, y, MPFR_RNDN);
        assert_true(is_near(dd_add(a, b), exact, exact, 0x1p-103));
        mpfr_add_d(exact, x, d, MPFR_RNDN);
        mpfr_set_d(size, fmax(fabs(a.hi), fabs(d)), MPFR_RNDN);
        assert_true(is_near(dd_add_double(a, d), exact, size, 0x1p-104));
        mpfr_mul(exact, x, y, MPFR_RNDN);
        assert_true(is_near(dd_mul(a, b), exact, exact, 0x1p-102));
        mpfr_mul_d(exact, x, d, MPFR_RNDN);
        assert_true(is_near(dd_mul_double(a, d), exact, exact, 0x1p-102));
    }
    mpfr_clears(x, y, exact, size, (mpfr_ptr)NULL);
}

/* Sums of products that cancel: the partial sums of large terms, then their negatives. */
static void test_accumulator(void **state) {
    (void)state;
    enum { TERMS = 40 };
    uint64_t seed = 4;
    mpfr_t exact, term, size;
    mpfr_inits2(BITS, exact, term, size, (mpfr_ptr)NULL);
    for (int i = 0; i < test_count(5000); i++) {
        struct td sum = {{0, 0, 0}};
        double a[TERMS], b[TERMS];
        mpfr_set_zero(exact, 1);
        mpfr_set_zero(size, 1);
        for (int t = 0; t < TERMS; t++) {
            bool back = i % 2 && t >= TERMS / 2;
            a[t] = back ? -a[t - TERMS / 2] : random_double(&seed, 40);
            b[t] = back ? b[t - TERMS / 2] : random_double(&seed, 40);
            if (back && t % 3 == 0) b[t] = nextafter(b[t], 0);
            td_add_product(&sum, a[t], b[t]);
            mpfr_set_d(term, a[t], MPFR_RNDN);
            mpfr_mul_d(term, term, b[t], MPFR_RNDN);
            mpfr_add(exact, exact, term, MPFR_RNDN);
            if (mpfr_cmpabs(term, size) > 0) mpfr_set(size, term, MPFR_RNDN);
            if (t % 7 == 0) td_renormalise(&sum);
        }
        td_renormalise(&sum);
        assert_true(sum.s[0] + sum.s[1] == sum.s[0] && sum.s[1] + sum.s[2] == sum.s[1]);
        mpfr_sub_d(exact, exact, sum.s[2], MPFR_RNDN);
        assert_true(is_near((struct dd){sum.s[0], sum.s[1]}, exact, size, TERMS * 0x1p-156));
    }
    mpfr_clears(exact, term, size, (mpfr_ptr)NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_transforms),
        cmocka_unit_test(test_range),
        cmocka_unit_test(test_arithmetic),
        cmocka_unit_test(test_accumulator),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
