/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sum is kept in three doubles, s0 + s1 + s2, off by less than n 2^-156 of the largest term.
 * Then q = fl(s0/den) leaves the exact remainder s0 - q den, so that the value is q + c with c =
 * (s0 - q den + s1 + s2)/den. If q + c rounds to the same double with c a little smaller and a
 * little larger, that double is the answer (Ziv's test). Ties, which averages of neighbouring
 * doubles often are, fail it; where the three doubles hold the exact sum, they need no test. Else,
 * and near the ends of the exponent range, where error-free transforms fail, rationals decide. */
#include "exact_dot.h"

#include "dd.h"
#include "rational.h"

#include <math.h>
#include <stdbool.h>

static double by_rationals(size_t n, const double *c, const double *x, double den) {
    mpq_t sum, term, factor;
    double result;
    mpq_inits(sum, term, factor, NULL);
    for (size_t i = 0; i < n; i++) {
        mpq_set_d(term, x[i]);
        mpq_set_d(factor, c[i]);
        mpq_mul(term, term, factor);
        mpq_add(sum, sum, term);
    }
    mpq_set_d(factor, den);
    mpq_div(sum, sum, factor);
    result = rational_round(sum);
    mpq_clears(sum, term, factor, NULL);
    return result;
}

static bool is_power_of_two(double x) {
    int exponent;
    return frexp(x, &exponent) == 0.5;
}

/* Products are multiples of 2^-106 of the smallest, and so are their partial sums: an error below
 * that is none. */
static bool is_exact(size_t n, double size, double smallest) {
    return (double)n * 0x1p-150 * size < 0x1p-106 * smallest;
}

double exact_dot(size_t n, const double *c, const double *x, double den) {
    struct td sum = {{0, 0, 0}};
    double size = 0, smallest = INFINITY, q, correction, margin, down, up;
    struct dd back;
    for (size_t i = 0; i < n; i++) {
        double term = fabs(c[i] * x[i]);
        if (c[i] == 0 || x[i] == 0) continue;
        if (term < smallest) smallest = term;
        size += term;
        td_add_product(&sum, c[i], x[i]);
    }
    if (size == 0 && smallest == INFINITY) return 0;
    if (!(smallest > 0x1p-800 && size < 0x1p900) || !(den > 0x1p-60 && den < 0x1p60))
        return by_rationals(n, c, x, den);
    td_renormalise(&sum);
    if (sum.s[2] == 0 && is_power_of_two(den) && is_exact(n, size, smallest))
        return (sum.s[0] + sum.s[1]) / den;
    q = sum.s[0] / den;
    back = dd_two_prod(q, den);
    correction = (((sum.s[0] - back.hi) - back.lo) + sum.s[1]) / den;
    /* rounding of the three operations that make the correction, and of the sum */
    margin = 0x1p-51 * fabs(correction) + 0x1p-150 * (double)n * size / den;
    down = q + (correction - margin);
    up = q + (correction + margin);
    if (sum.s[0] == 0 || down != up) return by_rationals(n, c, x, den);
    return down;
}
