/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: the parallelogram clipped by each square of the board in turn, in long doubles. */
#include "checker.h"

#include "testing.h"

#include <math.h>
#include <string.h>

struct outline {
    int n;
    long double p[16][2];
};

/* Keeps the part of the outline where sign * (p[axis] - at) >= 0. */
static void clip(struct outline *o, int axis, long double at, int sign) {
    struct outline in = *o;
    o->n = 0;
    for (int i = 0; i < in.n; i++) {
        const long double *a = in.p[i], *b = in.p[(i + 1) % in.n];
        long double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
        if (da >= 0) memcpy(o->p[o->n++], a, sizeof *o->p);
        if ((da >= 0) == (db >= 0)) continue;
        for (int k = 0; k < 2; k++) o->p[o->n][k] = a[k] + (b[k] - a[k]) * (da / (da - db));
        o->n++;
    }
}

static long double area(const struct outline *o) {
    long double sum = 0;
    for (int i = 0; i < o->n; i++) {
        const long double *a = o->p[0], *b = o->p[i], *c = o->p[(i + 1) % o->n];
        sum += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }
    return fabsl(sum) / 2;
}

static struct outline parallelogram(const double c[2], const double u[2], const double v[2]) {
    static const int sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    struct outline o = {.n = 4};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            o.p[i][k] =
                c[k] + (sign[i][0] * (long double)u[k] + sign[i][1] * (long double)v[k]) / 2;
    return o;
}

/* The area of odd squares in it. */
static long double odd_area(const struct outline *o) {
    long double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, sum = 0;
    for (int i = 0; i < o->n; i++)
        for (int k = 0; k < 2; k++) {
            low[k] = fminl(low[k], floorl(o->p[i][k]));
            high[k] = fmaxl(high[k], ceill(o->p[i][k]));
        }
    for (long x = (long)low[0]; x < high[0]; x++)
        for (long y = (long)low[1]; y < high[1]; y++) {
            struct outline square = *o;
            if ((x + y) % 2 == 0) continue;
            clip(&square, 0, x, 1);
            clip(&square, 0, x + 1, -1);
            clip(&square, 1, y, 1);
            clip(&square, 1, y + 1, -1);
            sum += area(&square);
        }
    return sum;
}

static double coordinate(double size, uint64_t *state) {
    double x = (random_unit(state) - 0.5) * size;
    return random_in(state, 0, 2) ? x : floor(2 * x) / 2; /* often on lines */
}

static void random_footprint(double c[2], double u[2], double v[2], uint64_t *state) {
    double size = ldexp(1, (int)random_in(state, -12, 2));
    for (int k = 0; k < 2; k++) {
        c[k] = coordinate(random_in(state, 0, 5) ? 20 : 1e5, state);
        u[k] = coordinate(size, state);
        v[k] = coordinate(size, state);
        while (fabs(u[k]) + fabs(v[k]) >= CHECKER_LONG) u[k] /= 2;
    }
    if (random_in(state, 0, 4) == 0) u[1] = v[0] = 0;
}

static void parallelograms(void **unused) {
    int compared = 0;
    for (int i = 0; i < test_count(20000); i++) {
        uint64_t seed = 0xc4ec0000 + (uint64_t)i, state = seed;
        double c[2], u[2], v[2], back[2], got, next[2], long_side, tolerance;
        struct outline o;
        random_footprint(c, u, v, &state);
        o = parallelogram(c, u, v);
        got = checker_share(c, u, v);
        check_seed(seed, got >= 0 && got <= 1);
        if (area(&o) <= 1e-6L * (fabs(u[0]) + fabs(v[0])) * (fabs(u[1]) + fabs(v[1]))) continue;
        compared++;
        long_side = fabs(u[0]) + fabs(u[1]) + fabs(v[0]) + fabs(v[1]);
        tolerance = 1e-12 + 1e-14 * long_side / (double)area(&o); /* corners are rounded */
        check_seed(seed, fabs(got - (double)(odd_area(&o) / area(&o))) < tolerance);
        for (int k = 0; k < 2; k++) {
            next[k] = c[k] + (k == i % 2);
            back[k] = -u[k];
        }
        check_seed(seed, fabs(checker_share(next, u, v) - (1 - got)) < 1e5 * tolerance);
        check_seed(seed, fabs(checker_share(c, v, u) - got) < 2 * tolerance);
        check_seed(seed, fabs(checker_share(c, back, v) - got) < 2 * tolerance);
    }
    assert_true(compared > test_count(20000) / 2);
    (void)unused;
}

/* The footprints of a picture's pixels tile a large parallelogram: what they show adds up. */
static void pictures(void **unused) {
    enum { SIDE = 24 };
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = 0xa11d0000 + (uint64_t)i, state = seed;
        double c[2], u[2], v[2], sum = 0, wide_u[2], wide_v[2];
        struct outline whole;
        random_footprint(c, u, v, &state);
        for (int k = 0; k < 2; k++) {
            wide_u[k] = SIDE * u[k];
            wide_v[k] = SIDE * v[k];
        }
        whole = parallelogram(c, wide_u, wide_v);
        if (area(&whole) <= 1e-3L * (fabs(u[0]) + fabs(v[0])) * (fabs(u[1]) + fabs(v[1]))) continue;
        for (int p = 0; p < SIDE * SIDE; p++) {
            double x = p % SIDE - (SIDE - 1) / 2.0, y = p / SIDE - (SIDE - 1) / 2.0;
            const double at[2] = {c[0] + x * u[0] + y * v[0], c[1] + x * u[1] + y * v[1]};
            sum += checker_share(at, u, v);
        }
        check_seed(seed,
                   fabs(sum / (SIDE * SIDE) - (double)(odd_area(&whole) / area(&whole))) < 1e-8);
    }
    (void)unused;
}

static void limits(void **unused) {
    const double c[2] = {0.5, 0.5}, odd[2] = {-0.5, 0.5}, far[2] = {1e300, -1e300};
    const double none[2] = {0, 0}, unit[2] = {0.1, 0.2}, more[2] = {0.2, 0.4},
                 lengthy[2] = {100, 0};
    assert_true(checker_share(c, none, none) == 0 && checker_share(odd, none, none) == 1);
    assert_true(checker_share(c, unit, more) == 0); /* no area */
    assert_true(checker_share(c, lengthy, unit) == 0.5);
    assert_true(checker_share(far, unit, unit) == 0);
    assert_true(checker_share(c, (const double[2]){NAN, 0}, unit) == 0.5);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallelograms),
        cmocka_unit_test(pictures),
        cmocka_unit_test(limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
