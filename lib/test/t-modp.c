/* SPDX-License-Identifier: GPL-3.0-or-later */
/* modp: against GMP, at random and at the borders. */
#include "modp.h"
#include "testing.h"

#include <gmp.h>

static void set_u64(mpz_t z, uint64_t x) {
    mpz_import(z, 1, 1, sizeof x, 0, 0, &x);
}

static uint64_t residue(const mpz_t z, uint64_t q) {
    uint64_t r = 0;
    mpz_t t;
    mpz_init(t);
    set_u64(t, q);
    mpz_mod(t, z, t);
    mpz_export(&r, NULL, 1, sizeof r, 0, 0, t);
    mpz_clear(t);
    return r;
}

/* The list is complete: mpz_nextprime from each to the one before it. */
static void primes_in_order(void **state) {
    struct modp_primes primes = {0};
    struct err err;
    uint64_t last = UINT64_C(1) << 61;
    mpz_t z, next;
    (void)state;
    mpz_inits(z, next, NULL);
    for (size_t k = 0; k < 200; k++) {
        struct modp m;
        assert_true(modp_prime(&primes, k, &m, &err));
        assert_true(m.q < last && m.q + m.c == UINT64_C(1) << 61 && m.q >> MODP_BITS == 1);
        set_u64(z, m.q);
        assert_int_not_equal(mpz_probab_prime_p(z, 40), 0);
        mpz_nextprime(next, z);
        assert_true(k == 0 ? mpz_sizeinbase(next, 2) == 62 : residue(next, UINT64_MAX) == last);
        last = m.q;
    }
    modp_primes_free(&primes);
    modp_primes_free(&primes);
    mpz_clears(z, next, NULL);
}

/* Mostly random, else near 0, q/2 or q. */
static uint64_t operand(uint64_t *seed, uint64_t q) {
    uint64_t a = random_bits(seed) % q, near = random_bits(seed) % 3;
    switch (random_bits(seed) % 8) {
    case 0:
        return near;
    case 1:
        return q - 1 - near;
    case 2:
        return q / 2 + near - 1;
    default:
        return a;
    }
}

static void check_products(struct modp m, uint64_t a, uint64_t b, uint64_t seed) {
    mpz_t x, y, t;
    mpz_inits(x, y, t, NULL);
    set_u64(x, a);
    set_u64(y, b);
    mpz_mul(t, x, y);
    check_seed(seed, modp_mul(m, a, b) == residue(t, m.q));
    mpz_add(t, x, y);
    check_seed(seed, modp_add(m, a, b) == residue(t, m.q));
    mpz_sub(t, x, y);
    check_seed(seed, modp_sub(m, a, b) == residue(t, m.q));
    mpz_clears(x, y, t, NULL);
    if (a > 0) check_seed(seed, modp_mul(m, a, modp_inverse(m, a)) == 1);
}

static void check_int(struct modp m, int64_t a, uint64_t seed) {
    mpz_t x;
    mpz_init_set_si(x, a);
    check_seed(seed, modp_of_int(m, a) == residue(x, m.q));
    mpz_clear(x);
}

static void arithmetic(void **state) {
    static const uint64_t c[] = {1, 31, 45, 1525, 2605};
    static const int64_t borders[] = {0, 1, -1, INT64_MAX, INT64_MIN, INT64_MIN + 1};
    (void)state;
    for (int i = 0; i < test_count(100000); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct modp m = {(UINT64_C(1) << 61) - c[i % 5], c[i % 5]};
        uint64_t a = operand(&s, m.q), b = operand(&s, m.q);
        check_products(m, a % m.q, b % m.q, seed);
        check_int(m, (int64_t)random_bits(&s) >> random_bits(&s) % 63, seed);
        check_int(m, borders[i % 6], seed);
        check_int(m, (int64_t)m.q * (i % 7 - 3), seed);
    }
}

/* Every fraction within the limit is found; what is found is one. */
static void fractions(void **state) {
    const struct modp m = {(UINT64_C(1) << 61) - 1, 1};
    const uint64_t limit = UINT64_C(1) << 29;
    (void)state;
    for (int i = 0; i < test_count(50000); i++) {
        uint64_t seed = (uint64_t)i, s = seed, d = 1 + random_bits(&s) % limit, g;
        int64_t n = random_in(&s, -(int64_t)limit, (int64_t)limit);
        uint64_t a = modp_mul(m, modp_of_int(m, n), modp_inverse(m, d));
        uint64_t found = modp_denominator(m, a, limit), back;
        mpz_t z;
        mpz_init(z);
        set_u64(z, d);
        g = n == 0 ? d : mpz_gcd_ui(NULL, z, (unsigned long)(n < 0 ? -n : n));
        mpz_clear(z);
        check_seed(seed, found == d / g);
        a = random_bits(&s) % m.q;
        found = modp_denominator(m, a, limit);
        back = modp_mul(m, a, found);
        check_seed(seed, found <= limit);
        check_seed(seed, found == 0 || back <= limit || m.q - back <= limit);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(primes_in_order),
        cmocka_unit_test(arithmetic),
        cmocka_unit_test(fractions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
