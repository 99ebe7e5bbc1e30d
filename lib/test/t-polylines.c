/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is made, written and read is the same. */
#include "polylines_io.h"

#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void make(struct polylines *p, uint64_t seed) {
    static const char *const words[] = {"inside", "edge", "a", "x1"};
    struct polylines_maker m = {.p = p};
    struct err err;
    uint64_t state = seed;
    *p = (struct polylines){0};
    for (int64_t l = random_in(&state, 1, 30); l > 0; l--) {
        const char *word = words[random_in(&state, 0, 3)];
        if (random_in(&state, 0, 1))
            assert_true(polylines_number(&m, random_unit(&state) - 0.5, &err));
        else
            assert_true(polylines_word(&m, word, strlen(word), &err));
        for (int64_t n = random_in(&state, 1, 9); n > 0; n--) {
            double q[2] = {random_unit(&state), (double)random_in(&state, -5, 5)};
            assert_true(polylines_point(&m, q, &err));
        }
    }
    polylines_end(&m);
}

static void there_and_back(void **unused) {
    char path[] = "/tmp/supple-lines.XXXXXX";
    int fd = mkstemp(path);
    (void)unused;
    assert_true(fd >= 0);
    close(fd);
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(100); seed++) {
        struct polylines a, b;
        struct out out;
        struct err err = {0};
        make(&a, seed);
        assert_true(out_open(&out, path, &err));
        polylines_write(&out, &a, 0);
        assert_true(out_close(&out, &err));
        assert_true(polylines_read(&b, path, &err));
        check_seed(seed, a.line_count == b.line_count && a.point_count == b.point_count);
        check_seed(seed, a.name_count == b.name_count);
        check_seed(seed, memcmp(a.range, b.range, sizeof a.range) == 0);
        check_seed(seed, memcmp(a.start, b.start, (a.line_count + 1) * sizeof *a.start) == 0);
        check_seed(seed, memcmp(a.point, b.point, a.point_count * sizeof *a.point) == 0);
        check_seed(seed, memcmp(a.name_of, b.name_of, a.line_count * sizeof *a.name_of) == 0);
        check_seed(seed, memcmp(a.value, b.value, a.line_count * sizeof *a.value) == 0);
        for (size_t i = 0; i < a.name_count; i++)
            check_seed(seed, strcmp(a.name[i], b.name[i]) == 0);
        polylines_free(&a);
        polylines_free(&b);
    }
    unlink(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(there_and_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
