/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Held against all pairs. */
#include "boxes.h"
#include "mem.h"

#include "testing.h"

#include <string.h>

enum { MAX = 300 };

struct seen {
    const struct box *box;
    uint8_t (*times)[MAX];
    int left; /* visits until the visitor has had enough; negative: never */
};

static bool see_pair(void *context, uint32_t i, uint32_t j) {
    struct seen *s = context;
    s->times[i < j ? i : j][i < j ? j : i]++;
    return --s->left != 0;
}

static bool see_one(void *context, uint32_t i) {
    struct seen *s = context;
    s->times[0][i]++;
    return --s->left != 0;
}

/* Coordinates are few, so that boxes touch and coincide. */
static struct box random_box(uint64_t *seed, int range, double scale) {
    struct box b;
    for (int c = 0; c < 2; c++) {
        int64_t lo = random_in(seed, -range, range);
        b.lo[c] = (double)lo * scale;
        b.hi[c] = (double)(lo + random_in(seed, 0, 3)) * scale;
    }
    return b;
}

static void test_random(void **state) {
    static uint8_t times[MAX][MAX];
    static const double scales[] = {1, 0.1, 1e-310, 4e306};
    uint64_t seed = 1;
    (void)state;
    for (int cases = test_count(200); cases > 0; cases--) {
        uint64_t start = seed;
        uint32_t n = (uint32_t)random_in(&seed, 0, MAX);
        int range = (int)random_in(&seed, 0, 40);
        double scale = scales[random_in(&seed, 0, 3)];
        struct box box[MAX] = {{{0}, {0}}}, query = random_box(&seed, range, scale);
        struct seen seen = {box, times, -1};
        struct boxes b;
        struct err err;
        for (uint32_t i = 0; i < n; i++) box[i] = random_box(&seed, range, scale);
        assert_true(boxes_init(&b, box, n, &err));
        memset(times, 0, sizeof times);
        check_seed(start, boxes_pairs(&b, see_pair, &seen));
        for (uint32_t i = 0; i < n; i++)
            for (uint32_t j = i; j < n; j++)
                check_seed(start, times[i][j] == (i < j && box_meets(&box[i], &box[j])));
        memset(times, 0, sizeof times);
        check_seed(start, boxes_query(&b, &query, see_one, &seen));
        for (uint32_t i = 0; i < n; i++)
            check_seed(start, times[0][i] == box_meets(&box[i], &query));
        boxes_free(&b);
    }
}

static void test_end_early(void **state) {
    static uint8_t times[MAX][MAX];
    struct box box[MAX] = {{{0}, {0}}};
    struct seen seen = {box, times, 5};
    struct boxes b;
    struct err err;
    (void)state;
    assert_true(boxes_init(&b, box, MAX, &err));
    assert_false(boxes_pairs(&b, see_pair, &seen));
    assert_int_equal(seen.left, 0);
    seen.left = 7;
    assert_false(boxes_query(&b, &box[0], see_one, &seen));
    assert_int_equal(seen.left, 0);
    boxes_free(&b);
}

static void test_box_of_points(void **state) {
    const double points[3][2] = {{1, 5}, {-2, 7}, {0, 6}};
    struct box b = box_of_points(3, points);
    (void)state;
    assert_true(b.lo[0] == -2 && b.hi[0] == 1 && b.lo[1] == 5 && b.hi[1] == 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_end_early),
        cmocka_unit_test(test_box_of_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
