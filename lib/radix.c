/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Least significant digit first: every pass is a stable counting sort by one digit, so that after
 * the pass on digit k the items are in order of their digits k..0. */
#include "radix.h"

#include <string.h>

enum { DIGIT_BITS = 11, DIGITS = 1 << DIGIT_BITS };

static unsigned digit_of(uint64_t key, unsigned shift) {
    return (unsigned)(key >> shift) & (DIGITS - 1);
}

static void sort_pass(const struct radix_item *from, struct radix_item *to, size_t n,
                      unsigned shift) {
    size_t place[DIGITS] = {0}, sum = 0;
    for (size_t i = 0; i < n; i++) place[digit_of(from[i].key, shift)]++;
    for (int d = 0; d < DIGITS; d++) {
        size_t count = place[d];
        place[d] = sum;
        sum += count;
    }
    for (size_t i = 0; i < n; i++) to[place[digit_of(from[i].key, shift)]++] = from[i];
}

void radix_sort(struct radix_item *items, struct radix_item *spare, size_t n) {
    struct radix_item *from = items, *to = spare;
    uint64_t differ = 0;
    for (size_t i = 1; i < n; i++) differ |= items[i].key ^ items[0].key;
    for (unsigned shift = 0; shift < 64; shift += DIGIT_BITS) {
        struct radix_item *swap = from;
        if (digit_of(differ, shift) == 0) continue;
        sort_pass(from, to, n, shift);
        from = to;
        to = swap;
    }
    if (from != items) memcpy(items, from, n * sizeof *items);
}
