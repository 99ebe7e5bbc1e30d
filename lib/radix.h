/* SPDX-License-Identifier: GPL-3.0-or-later */
/* radix - stable sorting of 64-bit keys in linear time. */
#ifndef RADIX_H
#define RADIX_H

#include <stddef.h>
#include <stdint.h>

struct radix_item {
    uint64_t key;
    uint32_t value;
};

/* Sorts n items by key; equal keys keep their order. `spare` is room for n items; its contents
 * change. Bits that are the same in all keys cost nothing: O(n) for each 11 bits that differ. */
void radix_sort(struct radix_item *items, struct radix_item *spare, size_t n);

#endif
