/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With p = step*n and o = origin*d the value is (o + p)/d. Products and sum are split exactly,
 *
 *      p = p1 + p2,   o = o1 + o2,   o1 + p1 = s + t,      low = t + (p2 + o2) up to rounding,
 *
 * and q = fl(s/d) leaves the exact remainder s - q d, so that the value is q + c with
 * c = ((s - q d) + low)/d up to an error far below 2^-96 (|o1| + |p1|)/d. If q + c rounds to the
 * same double with c a little smaller and a little larger, that double is the answer (Ziv's test).
 * Else, and near the ends of the exponent range where the splits are not exact, rationals decide.
 */
#include "lattice.h"

#include "rational.h"

#include <math.h>

static double by_rationals(double origin, double step, int64_t n, int d) {
    mpq_t v, o;
    double result;
    mpq_inits(v, o, NULL);
    mpq_set_si(o, n, (unsigned long)d);
    mpq_canonicalize(o);
    mpq_set_d(v, step);
    mpq_mul(v, v, o);
    mpq_set_d(o, origin);
    mpq_add(v, v, o);
    result = rational_round(v);
    mpq_clears(v, o, NULL);
    return result;
}

/* Zero, or far enough from both ends of the exponent range for exact splits. */
static bool is_ordinary(double x) {
    double m = fabs(x);
    return m == 0 || (m > 0x1p-800 && m < 0x1p900);
}

double lattice_coordinate(double origin, double step, int64_t n, int d) {
    double p1 = step * (double)n, o1 = origin * (double)d;
    double p2, o2, s, t, low, q, c, margin, down, up, back;
    if (!is_ordinary(p1) || !is_ordinary(o1)) return by_rationals(origin, step, n, d);
    p2 = fma(step, (double)n, -p1);
    o2 = fma(origin, (double)d, -o1);
    s = o1 + p1; /* two_sum */
    back = s - o1;
    t = (o1 - (s - back)) + (p1 - back);
    low = t + (p2 + o2);
    q = s / (double)d;
    if (low == 0 && p2 == 0 && o2 == 0 && t == 0) return q + 0.0; /* one rounding in all */
    c = (fma(-q, (double)d, s) + low) / (double)d;
    margin = 0x1p-96 * (fabs(o1) + fabs(p1)) / (double)d;
    down = q + (c - margin);
    up = q + (c + margin);
    return down == up ? down : by_rationals(origin, step, n, d);
}

bool lattice_step(const struct lattice_choice *choice, double span, double far, double *step,
                  struct err *err) {
    int span_exponent, far_exponent, exponent;
    *step = choice->step;
    if (*step > 0 && span / *step < ldexp(1, choice->bits)) return true;
    if (*step > 0)
        return err_set(err, ERR_REFUSAL, "lattice too fine: %.6g steps of %g are not below 2^%d",
                       span / *step, *step, choice->bits);
    frexp(span, &span_exponent); /* span < 2^span_exponent */
    frexp(far, &far_exponent);
    exponent = span_exponent - choice->bits;
    if (exponent < far_exponent - 53) exponent = far_exponent - 53;
    if (exponent < -1074) exponent = -1074;
    *step = ldexp(1, exponent);
    return true;
}

double lattice_nearest(double x, double step) {
    return rint(x / step) * step + 0.0;
}
