/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Both divisions walk down the Euclidean remainders of (q, a): r_k = s_k a (mod q), with |s_k|
 * growing as r_k falls, |s_k| r_(k-1) <= q. At r = 1, s is the inverse; at the first r <= limit,
 * r/s is the only candidate for a small fraction (Wang). */
#include "modp.h"

#include "mem.h"

#include <gmp.h>

/* The first primes 2^61 - c, so that small problems need no search. */
static const uint16_t first_c[] = {1,    31,   45,   229,  259,  283,  339,  391,  403,  465, 531,
                                   579,  675,  759,  799,  819,  829,  843,  859,  939,  985, 1015,
                                   1153, 1195, 1215, 1281, 1299, 1351, 1371, 1425, 1489, 1525};
enum { FIRST_COUNT = sizeof first_c / sizeof *first_c };

/* Descends to the first remainder <= limit; *s is its multiplier. */
static uint64_t descend(uint64_t q, uint64_t a, uint64_t limit, int64_t *s) {
    uint64_t r0 = q, r1 = a;
    int64_t s0 = 0, s1 = 1;
    while (r1 > limit) {
        uint64_t k = r0 / r1, r2 = r0 - k * r1;
        int64_t s2 = s0 - (int64_t)k * s1;
        r0 = r1, r1 = r2;
        s0 = s1, s1 = s2;
    }
    *s = s1;
    return r1;
}

uint64_t modp_inverse(struct modp m, uint64_t a) {
    int64_t s;
    uint64_t r = descend(m.q, a, 1, &s);
    INVARIANT(r == 1);
    return s < 0 ? m.q - (uint64_t)-s : (uint64_t)s;
}

uint64_t modp_denominator(struct modp m, uint64_t a, uint64_t limit) {
    int64_t s;
    uint64_t d;
    descend(m.q, a, limit, &s);
    d = s < 0 ? (uint64_t)-s : (uint64_t)s;
    return d <= limit ? d : 0;
}

static bool is_prime(uint64_t q) {
    mpz_t z;
    bool prime;
    mpz_init(z);
    mpz_import(z, 1, 1, sizeof q, 0, 0, &q);
    prime = mpz_probab_prime_p(z, 25) != 0; /* Baillie-PSW: no composite below 2^64 passes */
    mpz_clear(z);
    return prime;
}

static bool find_next(struct modp_primes *primes, struct err *err) {
    uint32_t c = primes->n ? primes->c[primes->n - 1] + 2 : first_c[0];
    if (!mem_grow(primes->c, &primes->cap, primes->n + 1, err)) return false;
    if (primes->n < FIRST_COUNT)
        c = first_c[primes->n];
    else
        while (!is_prime((UINT64_C(1) << 61) - c)) c += 2;
    INVARIANT(c < UINT32_C(1) << 30);
    primes->c[primes->n++] = c;
    return true;
}

bool modp_prime(struct modp_primes *primes, size_t k, struct modp *m, struct err *err) {
    while (primes->n <= k)
        if (!find_next(primes, err)) return false;
    m->c = primes->c[k];
    m->q = (UINT64_C(1) << 61) - m->c;
    return true;
}

void modp_primes_free(struct modp_primes *primes) {
    free(primes->c);
    *primes = (struct modp_primes){0};
}
