/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stars: triangles around the vertex 0, whose images turn round it by a planted number of steps of
 * 15 degrees. */
#include "fans.h"
#include "injective.h"
#include "mem.h"

#include "testing.h"

#include <math.h>
#include <string.h>

/* n triangles of degree 1 around vertex 0: all of a turn if closed, else the last side is open. */
static void star(struct spline *s, uint32_t n, bool closed) {
    uint32_t rim = closed ? n : n + 1;
    struct grid g = {.degree = 1,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .vertex_count = rim + 1,
                     .triangle_count = n};
    struct err err;
    assert_true(mem_new(g.vertex, rim + 1, &err) && mem_new(g.triangle, n, &err));
    for (uint32_t i = 0; i < rim; i++) {
        double angle = 6.283185307179586 * i / (closed ? n : n + 2);
        g.vertex[i + 1][0] = (int32_t)(10000 * cos(angle));
        g.vertex[i + 1][1] = (int32_t)(10000 * sin(angle));
    }
    for (uint32_t t = 0; t < n; t++) {
        g.triangle[t][1] = t + 1;
        g.triangle[t][2] = t + 1 == rim ? 1 : t + 2;
    }
    assert_true(grid_build(&g, &err) && spline_identity(s, &g, &err));
}

/* Gives rim vertex i+1 the direction of angle[i] x 15 degrees; multiples of 24 are the same. */
static void turn_rim(struct spline *s, uint32_t rim, const int *angle) {
    for (uint32_t i = 0; i < rim; i++) {
        double x = 0.2617993877991494 * ((angle[i] + 24) % 24), length = 1 + i % 3;
        s->phi[i + 1][0] = length * cos(x);
        s->phi[i + 1][1] = length * sin(x);
    }
}

/* n steps of 1..11 that add up to `total`. */
static void random_steps(int *step, int n, int total, uint64_t *seed) {
    for (int i = 0; i < n; i++) step[i] = 1;
    for (int left = total - n; left > 0;) {
        int i = (int)random_in(seed, 0, n - 1);
        if (step[i] < 11) step[i]++, left--;
    }
}

static void test_stars(void **state) {
    uint64_t seed = 1;
    (void)state;
    for (int cases = test_count(300); cases > 0; cases--) {
        uint64_t start = seed;
        bool closed = random_bits(&seed) & 1;
        int n = (int)random_in(&seed, closed ? 5 : 1, 12), step[16], angle[16] = {0};
        int total = closed ? 24 * (int)random_in(&seed, 1, (11 * n - 1) / 24)
                           : (int)random_in(&seed, n, 11 * n);
        uint32_t turns;
        struct spline s;
        struct err err;
        enum fan_kind kind, expected;
        random_steps(step, n, total, &seed);
        angle[0] = (int)random_in(&seed, 0, 23);
        for (int i = 0; i < n; i++) angle[i + 1] = angle[i] + step[i];
        star(&s, (uint32_t)n, closed);
        turn_rim(&s, (uint32_t)(closed ? n : n + 1), angle);
        expected = closed ? (total == 24 ? FAN_SOUND : FAN_COVERS)
                          : (total < 24   ? FAN_SOUND
                             : total > 24 ? FAN_COVERS
                                          : FAN_CLOSES);
        /* rounded directions need not be the same */
        if (!closed && total % 24 == 0) memcpy(s.phi[n + 1], s.phi[1], sizeof s.phi[1]);
        kind = fan_of_vertex(&s, 0, &turns);
        check_seed(start, kind == expected);
        check_seed(start, turns == (uint32_t)(total / 24));
        check_seed(start, fans_worst(&s, &kind, &turns) == (kind == FAN_SOUND ? GRID_NONE : 0));
        if (kind != FAN_SOUND)
            check_seed(start, !injective_prove(&s, &err) && err.kind == ERR_REFUSAL);
        if (kind == FAN_SOUND && closed) check_seed(start, injective_prove(&s, &err));
        spline_free(&s);
    }
}

static void test_negative_corner(void **state) {
    const int angle[] = {0, 8, 16, 12, 20};
    uint32_t turns;
    struct spline s;
    (void)state;
    star(&s, 5, true);
    turn_rim(&s, 5, angle);
    assert_int_equal(fan_of_vertex(&s, 0, &turns), FAN_UNKNOWN);
    spline_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stars),
        cmocka_unit_test(test_negative_corner),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
