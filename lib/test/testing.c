/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include <stdlib.h>

int test_count(int n) {
    const char *text = getenv("SUPPLE_TEST_SCALE");
    long long scale = text ? strtoll(text, NULL, 10) : 100;
    long long count = n * scale / 100;
    return count < 1 ? 1 : (int)count;
}

uint64_t random_bits(uint64_t *state) {
    uint64_t z = *state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

int64_t random_in(uint64_t *state, int64_t lo, int64_t hi) {
    return lo + (int64_t)(random_bits(state) % ((uint64_t)hi - (uint64_t)lo + 1));
}

double random_unit(uint64_t *state) {
    return (double)(random_bits(state) >> 11) * 0x1p-53;
}

void check_failed(uint64_t seed, const char *condition, const char *file, int line) {
    print_error("seed %llu: %s\n", (unsigned long long)seed, condition);
    _fail(file, line);
}
