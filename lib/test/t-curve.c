/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: the curve's own value by the Bernstein sum in long double, against the cubics that were
 * drawn; curves that are cubic, raised to a higher degree. */
#include "curve.h"

#include "testing.h"

#include <math.h>
#include <string.h>

/* Any Bezier curve of one coordinate at x, by de Casteljau. */
static long double value(int n, const double (*q)[2], int c, long double x) {
    long double b[CURVE_DEGREE_MAX + 1];
    for (int i = 0; i <= n; i++) b[i] = q[i][c];
    for (int k = n; k > 0; k--)
        for (int i = 0; i < k; i++) b[i] = (1 - x) * b[i] + x * b[i + 1];
    return b[0];
}

static void random_curve(uint64_t *seed, int n, double (*q)[2]) {
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 2; c++) q[i][c] = 100 * random_unit(seed);
}

/* The pieces that are drawn halve the parameter again and again, so piece i of a curve covers an
 * interval that follows from how far the pieces have come: the largest dyadic one that fits. The
 * end of each piece is on the curve, at a parameter that the search below finds. */
static long double end_of_piece(int n, const double (*q)[2], long double from,
                                const double end[2]) {
    for (long double size = 1; size > 1e-5L; size /= 2) {
        long double x = from + size;
        if (x <= 1 && fabsl(value(n, q, 0, x) - end[0]) + fabsl(value(n, q, 1, x) - end[1]) < 1e-9L)
            return x;
    }
    return -1;
}

static void check_pieces(uint64_t seed, int n, const double (*q)[2], double tolerance) {
    struct drawing d;
    struct err err;
    long double from = 0;
    double at[2] = {q[0][0], q[0][1]};
    drawing_init(&d);
    drawing_move(&d, at[0], at[1]);
    curve_draw(&d, n, q, tolerance);
    assert_true(drawing_ok(&d, &err));
    for (size_t i = 1; i < d.op_count; i++) {
        const double(*p)[2] = (const double(*)[2])(d.point + 1 + 3 * (i - 1));
        double cubic[4][2] = {
            {at[0], at[1]}, {p[0][0], p[0][1]}, {p[1][0], p[1][1]}, {p[2][0], p[2][1]}};
        long double to;
        check_seed(seed, d.op[i] == DRAWING_CURVE);
        to = end_of_piece(n, q, from, p[2]);
        check_seed(seed, to > from);
        for (int k = 0; k <= 16; k++)
            for (int c = 0; c < 2; c++) {
                long double x = from + (to - from) * k / 16;
                long double gap =
                    value(3, (const double(*)[2])cubic, c, k / 16.0L) - value(n, q, c, x);
                check_seed(seed, fabsl(gap) <= tolerance + 1e-9L);
            }
        memcpy(at, p[2], sizeof at);
        from = to;
    }
    check_seed(seed, from == 1);
    drawing_free(&d);
}

static void cubics_stay_within_the_tolerance(void **unused) {
    (void)unused;
    for (int n = 2; n <= CURVE_DEGREE_MAX; n++)
        for (int i = 0; i < test_count(20); i++) {
            uint64_t seed = (uint64_t)(1000 * n + i), state = seed;
            double q[CURVE_DEGREE_MAX + 1][2];
            random_curve(&state, n, q);
            check_pieces(seed, n, (const double(*)[2])q, i % 2 ? 0.05 : 1);
        }
}

/* r_i = (i r_i-1 + (m - i) r_i) / m */
static void raise_degree(int m, double (*q)[2]) {
    for (int i = m; i >= 0; i--)
        for (int c = 0; c < 2; c++)
            q[i][c] = ((i > 0 ? i * q[i - 1][c] : 0) + (i < m ? (m - i) * q[i][c] : 0)) / m;
}

static void a_cubic_of_higher_degree_is_one_piece(void **unused) {
    (void)unused;
    for (int n = 1; n <= CURVE_DEGREE_MAX; n++) {
        struct drawing d;
        uint64_t seed = (uint64_t)n;
        double q[CURVE_DEGREE_MAX + 1][2];
        random_curve(&seed, n < 3 ? n : 3, q);
        for (int m = 4; m <= n; m++) raise_degree(m, q);
        drawing_init(&d);
        drawing_move(&d, q[0][0], q[0][1]);
        curve_draw(&d, n, (const double(*)[2])q, 1e-6);
        assert_int_equal(d.op_count, 2);
        assert_int_equal(d.op[1], n == 1 ? DRAWING_LINE : DRAWING_CURVE);
        drawing_free(&d);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cubics_stay_within_the_tolerance),
        cmocka_unit_test(a_cubic_of_higher_degree_is_one_piece),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
