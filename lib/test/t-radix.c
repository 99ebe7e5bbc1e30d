/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "radix.h"

#include "testing.h"

#include <stdlib.h>

static int compare(const void *a, const void *b) {
    const struct radix_item *p = a, *q = b;
    if (p->key != q->key) return p->key < q->key ? -1 : 1;
    return p->value < q->value ? -1 : p->value > q->value; /* values count up: stable */
}

static void test_against_qsort(void **state) {
    enum { MAX = 3000 };
    static struct radix_item item[MAX], spare[MAX], expect[MAX];
    int count = test_count(300);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        uint64_t s = seed, mask = random_bits(&s) & random_bits(&s) & random_bits(&s);
        size_t n = (size_t)random_in(&s, 0, MAX);
        if (seed % 3 == 0) mask = UINT64_MAX;
        for (size_t i = 0; i < n; i++)
            expect[i] = item[i] = (struct radix_item){random_bits(&s) & mask, (uint32_t)i};
        radix_sort(item, spare, n);
        qsort(expect, n, sizeof *expect, compare);
        for (size_t i = 0; i < n; i++)
            check_seed(seed, item[i].key == expect[i].key && item[i].value == expect[i].value);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_against_qsort)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
