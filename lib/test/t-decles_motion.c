/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Moved points against the affine map in exact rationals; quarter turns against what they are. */
#include "decles_motion.h"

#include "testing.h"

#include <gmp.h>
#include <math.h>

/* to = the double nearest to centre + a (x - cx) + b (y - cy), give or take 2^-40 of half an ulp.
 */
static bool is_rounded(double to, double centre, double a, double b, const double q[2],
                       const double c[2]) {
    const double factor[2] = {a, b};
    mpq_t sum, x, y;
    mpq_inits(sum, x, y, (mpq_ptr)NULL);
    mpq_set_d(sum, centre);
    for (int i = 0; i < 2; i++) {
        mpq_set_d(x, q[i]);
        mpq_set_d(y, c[i]);
        mpq_sub(x, x, y);
        mpq_set_d(y, factor[i]);
        mpq_mul(x, x, y);
        mpq_add(sum, sum, x);
    }
    mpq_set_d(x, to);
    mpq_sub(sum, sum, x);
    double off = fabs(mpq_get_d(sum)), ulp = nextafter(fabs(to), INFINITY) - fabs(to);
    mpq_clears(sum, x, y, (mpq_ptr)NULL);
    return off <= 0.5 * ulp * (1 + 0x1p-40);
}

/* Positions of all sizes, many of them near to each other or round. */
static double random_place(uint64_t *random) {
    double x = (random_unit(random) - 0.5) * ldexp(1, (int)random_in(random, -3, 20));
    return random_in(random, 0, 2) ? x : nearbyint(x);
}

static void rounded_once(void **state) {
    (void)state;
    for (int run = 0, n = test_count(20000); run < n; run++) {
        uint64_t seed = 100 + (uint64_t)run, random = seed;
        struct decles_motion m = {.kind = run % 2 ? DECLES_ROTATE : DECLES_SCALE};
        double q[2], to[2], theta = run % 3 ? 1 : 1 - random_unit(&random);
        for (int c = 0; c < 2; c++) {
            m.centre[c] = random_place(&random);
            q[c] = random_in(&random, 0, 3) ? random_place(&random)
                                            : m.centre[c] * (1 + 0x1p-30 * random_unit(&random));
        }
        m.degrees = 720 * random_unit(&random) - 360;
        m.factor = 1 / (random_unit(&random) + 0.1);
        struct decles_turn turn = decles_turn(&m, theta);
        decles_move(&m, theta, turn, q, 2, to);
        check_seed(seed, is_rounded(to[0], m.centre[0], turn.c, -turn.s, q, m.centre));
        check_seed(seed, is_rounded(to[1], m.centre[1], turn.s, turn.c, q, m.centre));
    }
}

static void translations(void **state) {
    (void)state;
    for (int run = 0, n = test_count(2000); run < n; run++) {
        uint64_t seed = 50000 + (uint64_t)run, random = seed;
        const double zero[2] = {0, 0};
        struct decles_motion m = {.kind = DECLES_TRANSLATE};
        double q[2], to[2], theta = run % 2 ? 1 : random_unit(&random);
        int k = 1 + run % 3 / 2;
        for (int c = 0; c < 2; c++) {
            m.by[c] = random_place(&random);
            q[c] = random_place(&random);
        }
        to[1] = 12345;
        decles_move(&m, theta, decles_turn(&m, theta), q, k, to);
        for (int c = 0; c < k; c++) {
            const double by[2] = {m.by[c], 0};
            check_seed(seed, is_rounded(to[c], q[c], theta, 0, by, zero));
        }
        check_seed(seed, k == 2 || to[1] == 12345);
    }
}

/* Points of a lattice turn onto points of the lattice, and four quarter turns lead back; other
 * points go where the exact turn rounds to, which is where a turn by -270 degrees goes too. */
static void quarter_turns(void **state) {
    (void)state;
    const double sines[4] = {0, 1, 0, -1};
    for (int run = 0, n = test_count(1000); run < n; run++) {
        uint64_t seed = 90000 + (uint64_t)run, random = seed;
        struct decles_motion m = {.kind = DECLES_ROTATE}, back = m;
        int turns = (int)random_in(&random, -8, 8);
        double s = sines[turns & 3], c = sines[(turns + 1) & 3], q[2], to[2], other[2];
        bool lattice = run % 2;
        for (int i = 0; i < 2; i++) {
            back.centre[i] = m.centre[i] = (double)random_in(&random, -100000, 100000) / 8;
            q[i] = lattice ? (double)random_in(&random, -100000, 100000) / 8
                           : random_unit(&random) * 1000;
        }
        m.degrees = 90 * turns;
        back.degrees = m.degrees + (turns > 0 ? -360 : 360);
        decles_move(&m, 1, decles_turn(&m, 1), q, 2, to);
        decles_move(&back, 1, decles_turn(&back, 1), q, 2, other);
        check_seed(seed, to[0] == other[0] && to[1] == other[1]);
        check_seed(seed, is_rounded(to[0], m.centre[0], c, -s, q, m.centre));
        check_seed(seed, is_rounded(to[1], m.centre[1], s, c, q, m.centre));
        if (!lattice) continue;
        check_seed(seed,
                   to[0] == m.centre[0] + c * (q[0] - m.centre[0]) - s * (q[1] - m.centre[1]));
        back.degrees = -m.degrees;
        decles_move(&back, 1, decles_turn(&back, 1), to, 2, other);
        check_seed(seed, q[0] == other[0] && q[1] == other[1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rounded_once),
        cmocka_unit_test(translations),
        cmocka_unit_test(quarter_turns),
    };
    return cmocka_run_group_tests_name("decles_motion", tests, NULL, NULL);
}
