/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The index against a look at all points, while points move: near, far, onto each other. */
#include "nearest.h"

#include "testing.h"

#include <math.h>
#include <stdlib.h>

static uint32_t brute_find(const double (*at)[2], uint32_t n, const double q[2], double scale) {
    uint32_t best = NEAREST_NONE;
    double best_d2 = 0;
    for (uint32_t p = 0; p < n; p++) {
        double dx = (at[p][0] - q[0]) * scale, dy = (at[p][1] - q[1]) * scale;
        double d2 = dx * dx + dy * dy;
        if (best == NEAREST_NONE || d2 < best_d2) {
            best = p;
            best_d2 = d2;
        }
    }
    return best;
}

/* Half of the coordinates are small integers, so that ties are common. */
static double coordinate(uint64_t *state, double scale) {
    switch (random_in(state, 0, 9)) {
    case 0:
        return scale * 1000 * (random_unit(state) - 0.5);
    case 1:
        return scale * 1e18 * (random_unit(state) - 0.5);
    case 2:
    case 3:
    case 4:
        return scale * 10 * random_unit(state);
    default:
        return scale * (double)random_in(state, 0, 10);
    }
}

struct boxed {
    uint32_t count, *times;
};

static void note(void *context, uint32_t p) {
    struct boxed *b = context;
    b->count++;
    b->times[p]++;
}

static void check_box(uint64_t seed, uint64_t *state, const struct nearest *index, double scale) {
    double lo[2], hi[2];
    struct boxed b = {.times = calloc(index->count + 1, sizeof *b.times)};
    for (int c = 0; c < 2; c++) {
        double x = coordinate(state, scale), y = coordinate(state, scale);
        lo[c] = fmin(x, y);
        hi[c] = fmax(x, y);
    }
    nearest_box(index, lo, hi, note, &b);
    for (uint32_t p = 0; p < index->count; p++) {
        const double *at = index->at[p];
        bool in = at[0] >= lo[0] && at[0] <= hi[0] && at[1] >= lo[1] && at[1] <= hi[1];
        check_seed(seed, b.times[p] == in);
    }
    free(b.times);
}

static void run_random(uint64_t seed) {
    static const double scales[] = {1, 0x1p-600, 0x1p600, 0x1p-40, 0x1p-1022};
    uint64_t state = seed;
    uint32_t n = (uint32_t)random_in(&state, 1, 300);
    double scale = scales[seed % 5], (*at)[2] = calloc(n, sizeof *at);
    struct nearest index;
    struct err err;
    for (uint32_t p = 0; p < n; p++)
        for (int c = 0; c < 2; c++) at[p][c] = coordinate(&state, scale);
    assert_true(nearest_init(&index, (const double(*)[2])at, n, &err));
    for (int i = 0; i < 600; i++) {
        double q[2] = {coordinate(&state, scale), coordinate(&state, scale)};
        uint32_t p = (uint32_t)random_in(&state, 0, n - 1);
        check_seed(seed,
                   nearest_find(&index, q) == brute_find((const double(*)[2])at, n, q,
                                                         1 / scale < 1e308 ? 1 / scale : 0x1p1000));
        if (i % 20 == 0) check_box(seed, &state, &index, scale);
        for (int c = 0; c < 2; c++) at[p][c] = coordinate(&state, scale);
        nearest_moved(&index, p);
    }
    nearest_free(&index);
    free(at);
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(300); n++) run_random((uint64_t)n);
}

static void test_shapes(void **unused) {
    enum { N = 1000 };
    static double at[N][2];
    (void)unused;
    for (int shape = 0; shape < 5; shape++) {
        struct nearest index;
        struct err err;
        uint64_t state = (uint64_t)shape;
        for (int p = 0; p < N; p++) {
            double x = random_unit(&state), y = random_unit(&state);
            at[p][0] = shape == 0 ? 3 : shape == 1 ? x : shape == 2 ? 3 : x;
            at[p][1] = shape == 0   ? 4
                       : shape == 1 ? 4
                       : shape == 2 ? y
                       : shape == 3 ? x
                                    : 1e-30 * y;
        }
        assert_true(nearest_init(&index, (const double(*)[2])at, N, &err));
        for (int i = 0; i < 200; i++) {
            double q[2] = {4 * random_unit(&state), 4 * random_unit(&state)};
            check_seed((uint64_t)shape,
                       nearest_find(&index, q) == brute_find((const double(*)[2])at, N, q, 1));
        }
        nearest_free(&index);
    }
}

static void test_none(void **unused) {
    struct nearest index;
    struct err err;
    (void)unused;
    assert_true(nearest_init(&index, NULL, 0, &err));
    assert_int_equal(nearest_find(&index, (double[2]){0, 0}), NEAREST_NONE);
    nearest_free(&index);
    nearest_free(&index);
}

/* Of a million points on a lattice, each found again; a search looks at few of them, or this would
 * take hours. All move far away in the middle of it. */
static void test_large(void **unused) {
    enum { SIDE = 1000 };
    double(*at)[2] = calloc((size_t)SIDE * SIDE, sizeof *at);
    struct nearest index;
    struct err err;
    (void)unused;
    for (uint32_t p = 0; p < SIDE * SIDE; p++) {
        at[p][0] = p % SIDE;
        at[p][1] = (double)(p / SIDE);
    }
    assert_true(nearest_init(&index, (const double(*)[2])at, SIDE * SIDE, &err));
    for (uint32_t p = 0; p < SIDE * SIDE; p += 7) {
        double q[2] = {at[p][0] + 0.4, at[p][1] - 0.4};
        if (nearest_find(&index, q) != p) fail_msg("point %u", p);
    }
    for (int turn = 0; turn < 2; turn++)
        for (uint32_t p = 0; p < SIDE * SIDE; p++) {
            at[p][0] += 1e6;
            nearest_moved(&index, p);
        }
    for (uint32_t p = 0; p < SIDE * SIDE; p += 7)
        if (nearest_find(&index, at[p]) != p) fail_msg("point %u", p);
    nearest_free(&index);
    free(at);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_shapes),
        cmocka_unit_test(test_none),
        cmocka_unit_test(test_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
