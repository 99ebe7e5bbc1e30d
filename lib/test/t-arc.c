/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What doubles prove must hold exactly, also where it nearly fails; pieces are what they are said
 * to be; winding numbers against polylines. */
#include "arc.h"
#include "ray.h"

#include "curves.h"
#include "testing.h"

#include <math.h>
#include <string.h>

enum { POINTS = ARC_DEGREE_MAX + 1 };

static double noise(uint64_t *seed) {
    return 2 * random_unit(seed) - 1;
}

/* Straight or bent by little, large or small, far out or not; b begins at an end of a, or crosses
 * it, or runs beside it at a distance that may be tiny. */
static void random_pair(int d, double (*a)[2], double (*b)[2], uint64_t *seed) {
    double far = random_bits(seed) & 1 ? 1e6 * noise(seed) : 0;
    double size = ldexp(1, (int)random_in(seed, -40, 40));
    double bend = ldexp(1, (int)random_in(seed, -60, 0)),
           gap = ldexp(1, (int)random_in(seed, -60, 0));
    double turn = random_bits(seed) & 1 ? 0 : ldexp(noise(seed), (int)random_in(seed, -50, 2));
    double along = random_in(seed, 0, 2) == 0 ? d : 0;
    gap = random_bits(seed) & 1 ? 0 : gap;
    for (int i = 0; i <= d; i++)
        for (int c = 0; c < 2; c++) {
            double u = (double)i / d, v = c ? gap + u * sin(turn) : along / d + u * cos(turn);
            a[i][c] = size * (far + (c ? 0 : u) + bend * noise(seed));
            b[i][c] = size * (far + v + bend * noise(seed));
        }
    if (along > 0 && gap == 0) memcpy(b[0], a[d], sizeof b[0]);
}

/* A random piece, in doubles and in integers. */
static void random_piece(int d, struct arc *a, const struct arc_integers *whole, unsigned scale,
                         struct arc_integers *piece, int levels, uint64_t *seed) {
    mpz_t lo, hi;
    for (int k = 0; k < levels; k++) {
        struct arc half[2];
        arc_halve(d, a, half);
        *a = half[random_bits(seed) & 1];
    }
    mpz_init_set_ui(lo, a->index);
    mpz_init_set_ui(hi, a->index + 1);
    arc_integers_piece(d, whole, lo, hi, (unsigned)a->level, scale, piece);
    mpz_clears(lo, hi, NULL);
}

static void test_doubles_and_integers(void **state) {
    struct arc_integers whole[2], piece[2];
    uint64_t seed = 1;
    int proved[4] = {0}, exact[4] = {0};
    (void)state;
    for (int i = 0; i < 2; i++) {
        arc_integers_init(&whole[i]);
        arc_integers_init(&piece[i]);
    }
    for (int n = test_count(20000); n > 0; n--) {
        uint64_t start = seed;
        int d = (int)random_in(&seed, 1, n % 16 ? 6 : ARC_DEGREE_MAX), levels[2];
        double qa[POINTS][2], qb[POINTS][2];
        struct arc a, b;
        bool in_doubles[4], in_integers[4];
        random_pair(d, qa, qb, &seed);
        if (!arc_load(d, (const double(*)[2])qa, (const double(*)[2])qb, &a, &b)) continue;
        (void)arc_integers_load(d, (const double(*)[2])qa, (const double(*)[2])qb, &whole[0],
                                &whole[1]);
        for (int i = 0; i < 2; i++) levels[i] = (int)random_in(&seed, 0, 3);
        random_piece(d, &a, &whole[0], 3 * (unsigned)d, &piece[0], levels[0], &seed);
        random_piece(d, &b, &whole[1], 3 * (unsigned)d, &piece[1], levels[1], &seed);
        in_doubles[0] = arc_monotone(d, &a, NULL);
        in_doubles[1] = arc_monotone(d, &a, &b);
        in_doubles[2] = arc_apart(d, &a, &b);
        in_doubles[3] = arc_cross(d, &a, &b);
        in_integers[0] = arc_exact_monotone(d, &piece[0], NULL);
        in_integers[1] = arc_exact_monotone(d, &piece[0], &piece[1]);
        in_integers[2] = arc_exact_apart(d, &piece[0], &piece[1]);
        in_integers[3] = arc_exact_cross(d, &piece[0], &piece[1]);
        check_seed(start, !in_doubles[0] || in_integers[0]);
        check_seed(start, !in_doubles[1] || in_integers[1]);
        /* lines that separate differ, so that one may succeed and the other not */
        check_seed(start, !in_doubles[2] || !(in_doubles[3] || in_integers[3]));
        check_seed(start, !in_integers[2] || !(in_doubles[3] || in_integers[3]));
        for (int k = 0; k < 4; k++) {
            proved[k] += in_doubles[k];
            exact[k] += in_integers[k];
        }
    }
    for (int k = 0; k < 4; k++) assert_true(proved[k] > exact[k] / 2 && exact[k] > proved[k] / 2);
    for (int i = 0; i < 2; i++) {
        arc_integers_free(&whole[i]);
        arc_integers_free(&piece[i]);
    }
}

/* A curve of arcs that is closed: twists of a circle, run through some times. */
static int closed_curve(int d, double (*q)[POINTS][2], uint64_t *seed) {
    int arcs = (int)random_in(seed, 3, 9), turns = (int)random_in(seed, 1, 2);
    double wild = random_unit(seed);
    for (int i = 0; i < arcs; i++)
        for (int k = 0; k <= d; k++) {
            double angle = 6.283185307179586 * turns * (i + (double)k / d) / arcs;
            q[i][k][0] = cos(angle) + wild * noise(seed);
            q[i][k][1] = sin(angle) + wild * noise(seed);
        }
    for (int i = 0; i < arcs; i++) memcpy(q[(i + 1) % arcs][0], q[i][d], sizeof q[i][d]);
    return arcs;
}

/* The angle that an arc's polyline turns by as seen from p; its distance, too. */
static double angle_of(int d, const double (*q)[2], const double p[2], double *distance) {
    double sum = 0, from[2], to[2];
    curve_point(d, q, 0, from);
    for (int i = 1; i <= 200; i++) {
        curve_point(d, q, i / 200.0, to);
        sum += atan2((from[0] - p[0]) * (to[1] - p[1]) - (from[1] - p[1]) * (to[0] - p[0]),
                     (from[0] - p[0]) * (to[0] - p[0]) + (from[1] - p[1]) * (to[1] - p[1]));
        *distance = fmin(*distance, hypot(to[0] - p[0], to[1] - p[1]));
        memcpy(from, to, sizeof from);
    }
    return sum;
}

static void test_winding(void **state) {
    uint64_t seed = 4;
    int seen[7] = {0};
    (void)state;
    for (int n = test_count(500); n > 0; n--) {
        uint64_t start = seed;
        int d = (int)random_in(&seed, 1, 8), winding = 0, arcs;
        double q[9][POINTS][2], distance = 1, angle = 0;
        double p[2] = {1.2 * noise(&seed), 1.2 * noise(&seed)};
        arcs = closed_curve(d, q, &seed);
        if (random_in(&seed, 0, 3) == 0) p[1] = q[0][0][1]; /* level with a corner */
        for (int i = 0; i < arcs; i++) {
            angle += angle_of(d, (const double(*)[2])q[i], p, &distance);
            check_seed(start, ray_winding(d, (const double(*)[2])q[i], p, &winding));
        }
        if (distance < 0.05) continue;
        check_seed(start, winding == (int)lrint(angle / 6.283185307179586));
        seen[winding + 3]++;
    }
    assert_true(seen[3] > 0 && seen[4] > 0 && seen[5] > 0);
}

/* On the arc there is no answer. */
static void test_on_the_curve(void **state) {
    const double q[3][2] = {{0, 0}, {1, 0}, {1, 1}};
    int winding = 0;
    (void)state;
    assert_false(ray_winding(2, q, (double[2]){0.75, 0.25}, &winding));
    assert_true(ray_winding(2, q, (double[2]){0.75, 0.25 + 0x1p-40}, &winding));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_doubles_and_integers),
        cmocka_unit_test(test_winding),
        cmocka_unit_test(test_on_the_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
