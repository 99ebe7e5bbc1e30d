/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rational.h"

#include <limits.h>
#include <math.h>
#include <mpfr.h>

/* Rounds v to odd at 64 bits first: rounding again, to 53 bits or to a subnormal, is then the same
 * as rounding once. */
double rational_round(const mpq_t v) {
    mpfr_t x;
    double result;
    mpfr_init2(x, 64);
    if (mpfr_set_q(x, v, MPFR_RNDZ) != 0) {
        mpfr_t odd;
        mpfr_init2(odd, 65);
        mpfr_set(odd, x, MPFR_RNDN);
        if (mpfr_sgn(x) > 0) /* one bit more than x has: always odd */
            mpfr_nextabove(odd);
        else
            mpfr_nextbelow(odd);
        mpfr_swap(x, odd);
        mpfr_clear(odd);
    }
    result = mpfr_zero_p(x) ? 0.0 : mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return result;
}

/* x = m 2^e, m odd or 0; returns e, INT_MAX for 0. */
static int split(double x, mpz_t m) {
    int e;
    mp_bitcnt_t zeros;
    if (x == 0) {
        mpz_set_ui(m, 0);
        return INT_MAX;
    }
    mpz_set_d(m, ldexp(frexp(x, &e), 53));
    zeros = mpz_scan1(m, 0);
    mpz_fdiv_q_2exp(m, m, zeros);
    return e - 53 + (int)zeros;
}

int rational_integers(int n, const double *x, mpz_t *m) {
    int least = INT_MAX, e;
    mpz_t ignored;
    mpz_init(ignored);
    for (int i = 0; i < n; i++) {
        e = split(x[i], ignored);
        if (e < least) least = e;
    }
    for (int i = 0; i < n; i++)
        if ((e = split(x[i], m[i])) != INT_MAX) mpz_mul_2exp(m[i], m[i], (mp_bitcnt_t)(e - least));
    mpz_clear(ignored);
    return least == INT_MAX ? 0 : least;
}

/* By continued fractions: the integer parts in common, and then the least integer that fits. */
void rational_simplest(mpq_t lo, mpq_t hi, mpq_t result) {
    mpz_t whole;
    mpz_init(whole);
    mpz_cdiv_q(whole, mpq_numref(lo), mpq_denref(lo));
    mpq_set_z(result, whole);
    if (mpq_cmp(result, hi) > 0) { /* lo and hi lie strictly between two integers */
        mpq_t base, a, b;
        mpz_sub_ui(whole, whole, 1);
        mpq_inits(base, a, b, NULL);
        mpq_set_z(base, whole);
        mpq_sub(a, hi, base);
        mpq_sub(b, lo, base);
        mpq_inv(a, a);
        mpq_inv(b, b);
        rational_simplest(a, b, result);
        mpq_inv(result, result);
        mpq_add(result, result, base);
        mpq_clears(base, a, b, NULL);
    }
    mpz_clear(whole);
}
