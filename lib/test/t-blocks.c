/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places in random order against a plain array. */
#include "blocks.h"

#include "testing.h"

#include <stdlib.h>

static void like_an_array(void **state) {
    (void)state;
    for (int run = 0, n = test_count(200); run < n; run++) {
        uint64_t seed = 100 + (uint64_t)run, random = seed;
        uint32_t items = (uint32_t)random_in(&random, 1, 3000);
        struct blocks b;
        struct err err;
        uint32_t *kept = NULL, *plain = calloc(items, sizeof *plain);
        assert_true(blocks_init(&b, items, &err) && mem_new(kept, blocks_room(items), &err));
        for (int round = 0; round < 3; round++) {
            for (int64_t touches = random_in(&random, 0, 500); touches > 0; touches--) {
                uint32_t i = (uint32_t)random_in(&random, 0, items - 1);
                size_t at = blocks_place(&b, i);
                check_seed(seed, at < blocks_room(items) && at < (size_t)b.count * BLOCK);
                check_seed(seed, kept[at] == plain[i] && blocks_find(&b, i) == at);
                kept[at] = plain[i] = (uint32_t)random_in(&random, 1, 1000);
            }
            for (uint32_t i = 0; i < items; i++) {
                size_t at = blocks_find(&b, i);
                check_seed(seed, (at == SIZE_MAX ? 0 : kept[at]) == plain[i]);
                if (at != SIZE_MAX) kept[at] = 0;
                plain[i] = 0;
            }
            blocks_clear(&b);
            check_seed(seed, b.count == 0);
            for (uint32_t i = 0; i < items; i++) check_seed(seed, blocks_find(&b, i) == SIZE_MAX);
        }
        blocks_free(&b);
        free(kept);
        free(plain);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(like_an_array)};
    return cmocka_run_group_tests_name("blocks", tests, NULL, NULL);
}
