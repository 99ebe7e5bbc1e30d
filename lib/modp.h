/* SPDX-License-Identifier: GPL-3.0-or-later */
/* modp - arithmetic modulo primes q = 2^61 - c, c small, of which there are as many as anybody can
 * use; c = 1 is the Mersenne prime. Residues are 0 <= a < q.
 *
 * A product is below 2^122. As 2^61 = c (mod q), its high part folds onto the low one as h*c, which
 * is below 2^91 for c < 2^30; a second fold leaves less than 2q. */
#ifndef MODP_H
#define MODP_H

#include "err.h"

#include <stdint.h>

__extension__ typedef unsigned __int128 modp_wide;

struct modp {
    uint64_t q, c; /* q = 2^61 - c, prime */
};

/* Every q exceeds 2^MODP_BITS. */
enum { MODP_BITS = 60 };

static inline uint64_t modp_add(struct modp m, uint64_t a, uint64_t b) {
    uint64_t s = a + b;
    return s >= m.q ? s - m.q : s;
}

static inline uint64_t modp_sub(struct modp m, uint64_t a, uint64_t b) {
    return a >= b ? a - b : a + m.q - b;
}

static inline uint64_t modp_mul(struct modp m, uint64_t a, uint64_t b) {
    const uint64_t low = (UINT64_C(1) << 61) - 1;
    modp_wide t = (modp_wide)a * b;
    modp_wide fold = (modp_wide)(uint64_t)(t >> 61) * m.c + ((uint64_t)t & low);
    uint64_t r = ((uint64_t)fold & low) + (uint64_t)(fold >> 61) * m.c;
    return r >= m.q ? r - m.q : r;
}

static inline uint64_t modp_of_int(struct modp m, int64_t a) {
    uint64_t r = a < 0 ? -(uint64_t)a : (uint64_t)a;
    if (r >= m.q) r %= m.q;
    return a < 0 && r ? m.q - r : r;
}

/* 1/a, a not 0. */
uint64_t modp_inverse(struct modp m, uint64_t a);

/* The denominator d, 0 < d <= limit, of the fraction n/d = a (mod q) with |n| <= limit; 0 if there
 * is none. At most one fraction exists if 2 limit^2 < q. */
uint64_t modp_denominator(struct modp m, uint64_t a, uint64_t limit);

/* The primes below 2^61 in descending order, found as they are asked for. */
struct modp_primes {
    uint32_t *c;
    size_t n, cap;
};

/* Prime number k, from 0. Fails only for lack of memory. */
bool modp_prime(struct modp_primes *primes, size_t k, struct modp *m, struct err *err) WARN_UNUSED;
void modp_primes_free(struct modp_primes *primes); /* harmless on a zeroed struct */

#endif
