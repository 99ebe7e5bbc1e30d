/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: exact distances to the result and to both of its neighbours, in rationals. */
#include "lattice.h"

#include "spline.h"
#include "testing.h"
#include "triangulations.h"

#include <gmp.h>
#include <math.h>
#include <string.h>

/* |x - v| */
static void distance(mpq_t r, double x, const mpq_t v) {
    mpq_set_d(r, x);
    mpq_sub(r, r, v);
    mpq_abs(r, r);
}

static bool is_even(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 1) == 0;
}

/* Is x the double nearest to v, ties to even, with the sign of v where it underflows? */
static bool is_nearest(double x, const mpq_t v) {
    mpq_t mine, other;
    bool ok = isfinite(x) && (x != 0 || !signbit(x) == (mpq_sgn(v) >= 0));
    mpq_inits(mine, other, NULL);
    for (int side = -1; ok && side <= 1; side += 2) {
        double neighbour = nextafter(x, side > 0 ? HUGE_VAL : -HUGE_VAL);
        if (!isfinite(neighbour)) continue;
        distance(mine, x, v);
        distance(other, neighbour, v);
        int order = mpq_cmp(mine, other);
        ok = order < 0 || (order == 0 && is_even(x));
    }
    mpq_clears(mine, other, NULL);
    return ok;
}

static void exact(mpq_t v, double origin, double step, int64_t n, int d) {
    mpq_t o;
    mpq_init(o);
    mpq_set_d(o, origin);
    mpq_set_d(v, step);
    mpz_mul_si(mpq_numref(v), mpq_numref(v), n);
    mpz_mul_si(mpq_denref(v), mpq_denref(v), d);
    mpq_canonicalize(v);
    mpq_add(v, v, o);
    mpq_clear(o);
}

static double random_step(uint64_t *s) {
    switch (random_in(s, 0, 4)) {
    case 0:
        return ldexp(1, (int)random_in(s, -40, 40));
    case 1:
        return 0.1 * (double)random_in(s, 1, 99);
    case 2:
        return ldexp(1 + random_unit(s), (int)random_in(s, -1074, 960));
    case 3:
        return ldexp((double)random_in(s, 1, 1 << 20), (int)random_in(s, -1074, -1000));
    default:
        return ldexp(1 + random_unit(s), (int)random_in(s, -30, 30));
    }
}

static double random_origin(uint64_t *s, double step, int64_t n, int d) {
    switch (random_in(s, 0, 5)) {
    case 0:
        return 0;
    case 1:
        return step * (double)random_in(s, -1000000, 1000000);
    case 2: /* cancels */
        return -step * (double)n / d;
    case 3: /* cancels but for the last bits */
        return nextafter(-step * (double)n / d, INFINITY);
    case 4: /* far above: ties and near ties */
        return ldexp(step, (int)random_in(s, 20, 60)) * (double)random_in(s, -9, 9);
    default:
        return (random_unit(s) - 0.5) * ldexp(1, (int)random_in(s, -40, 40));
    }
}

static void test_rounding(void **state) {
    int count = test_count(300000);
    uint64_t s = 7;
    mpq_t v;
    (void)state;
    mpq_init(v);
    for (int i = 0; i < count; i++) {
        uint64_t seed = s;
        int d = (int)random_in(&s, 1, 15);
        int64_t n = random_in(&s, -15 * (1 << 24), 15 * (1 << 24)) >> random_in(&s, 0, 27);
        double step = random_step(&s), origin = random_origin(&s, step, n, d);
        if (!isfinite(origin)) continue;
        exact(v, origin, step, n, d);
        check_seed(seed, is_nearest(lattice_coordinate(origin, step, n, d), v));
    }
    mpq_clear(v);
}

static void test_identity(void **state) {
    int count = test_count(60);
    mpq_t v;
    (void)state;
    mpq_init(v);
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        struct grid g;
        struct spline spline;
        struct err err = {0};
        uint64_t s = seed;
        random_grid(&g, 4, (int)random_in(&s, 1, 7), seed);
        g.lattice.step = ldexp(1 + random_unit(&s), (int)random_in(&s, -9, 9));
        g.lattice.x0 = 100 * random_unit(&s);
        g.lattice.y0 = -1e6 * random_unit(&s);
        g.has_depth = seed % 2;
        g.depth[0] = -3.5;
        g.depth[1] = 12;
        assert_true(spline_identity(&spline, &g, &err));
        assert_null(g.vertex);
        for (uint32_t p = 0; p < spline.grid.point_count; p++) {
            struct grid_place at = grid_place(&spline.grid, p);
            for (int c = 0; c < 2; c++) {
                int64_t n = 0;
                for (int l = 0; l < 3; l++)
                    n += at.weight[l] * spline.grid.vertex[spline.grid.triangle[at.triangle][l]][c];
                exact(v, c ? spline.grid.lattice.y0 : spline.grid.lattice.x0,
                      spline.grid.lattice.step, n, spline.grid.degree);
                check_seed(seed, is_nearest(spline.phi[p][c], v));
                check_seed(seed, !spline.sigma || spline.sigma[p][c] == (c ? 12 : -3.5));
            }
        }
        check_seed(seed, (spline.sigma != NULL) == (seed % 2));
        spline_free(&spline);
    }
    mpq_clear(v);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rounding),
        cmocka_unit_test(test_identity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
