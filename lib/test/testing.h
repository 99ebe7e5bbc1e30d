/* SPDX-License-Identifier: GPL-3.0-or-later */
/* testing - what the unit tests share: cmocka, seeds, random numbers. */
#ifndef TESTING_H
#define TESTING_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* n, scaled by the environment's SUPPLE_TEST_SCALE (percent, default 100), at least 1. */
int test_count(int n);

/* Uniform random numbers, the same on every machine (splitmix64). The state is any seed. */
uint64_t random_bits(uint64_t *state);
int64_t random_in(uint64_t *state, int64_t lo, int64_t hi); /* lo <= n <= hi */
double random_unit(uint64_t *state);                        /* [0, 1), 53 bits */

/* Fails the test, naming the seed, unless the condition is true. */
#define check_seed(seed, condition)                                                                \
    ((condition) ? (void)0 : check_failed((seed), #condition, __FILE__, __LINE__))
void check_failed(uint64_t seed, const char *condition, const char *file, int line);

#endif
