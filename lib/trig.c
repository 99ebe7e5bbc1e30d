// SPDX-License-Identifier: GPL-3.0-or-later
/* Ziv's strategy: compute with p bits and a proved bound on the error; if both ends of the interval
 * round to the same double (subnormals included) that is the answer, else double p. It ends unless
 * the exact value is a double or halfway between two. By Niven's theorem sines of rational degrees
 * are rational only at multiples of 30 degrees, and those are answered from a table.
 *
 * Degrees are reduced without any error: fmod is exact, and so is each subtraction below, by
 * Sterbenz's lemma (y/2 <= x <= 2y makes x - y exact):
 *
 *     |degrees| -> r in [0,360) -> a = r - 90 q in [0,90) -> 90 - a where a > 45
 *
 * so that MPFR sees angles in [0,45] degrees only, where sine and cosine do not amplify the
 * relative error of the argument. */
#include "trig.h"

#include "err.h"

#include <math.h>
#include <mpfr.h>

/* Does every number within 2^(4-precision) of y, relatively, round to one double? */
static bool rounds_to(mpfr_t y, mpfr_prec_t precision, double *rounded) {
    mpfr_t error, end;
    mpfr_inits2(precision, error, end, (mpfr_ptr)NULL);
    mpfr_mul_2si(error, y, 4 - precision, MPFR_RNDA);
    mpfr_sub(end, y, error, MPFR_RNDZ);
    *rounded = mpfr_get_d(end, MPFR_RNDN);
    mpfr_add(end, y, error, MPFR_RNDA);
    bool same = *rounded == mpfr_get_d(end, MPFR_RNDN);
    mpfr_clears(error, end, (mpfr_ptr)NULL);
    return same;
}

/* cos or sin of 0 < a <= 45 degrees, a not 30. Errors, each relative and below 2^-precision: pi,
 * two operations, and the function; the argument's arrive multiplied by x tan x or x cot x <= 1. */
static double octant(double a, bool cosine) {
    double result = 0;
    bool done = false;
    for (mpfr_prec_t precision = 128; !done; precision *= 2) {
        mpfr_t y;
        mpfr_init2(y, precision);
        mpfr_const_pi(y, MPFR_RNDN);
        mpfr_mul_d(y, y, a, MPFR_RNDN);
        mpfr_div_ui(y, y, 180, MPFR_RNDN);
        if (cosine)
            mpfr_cos(y, y, MPFR_RNDN);
        else
            mpfr_sin(y, y, MPFR_RNDN);
        done = rounds_to(y, precision, &result);
        mpfr_clear(y);
    }
    return result;
}

/* Sine of 0 <= a <= 90 degrees. */
static double sine_of(double a) {
    if (a == 0) return 0;
    if (a == 30) return 0.5;
    if (a == 90) return 1;
    return a <= 45 ? octant(a, false) : octant(90 - a, true);
}

static double cosine_of(double a) {
    if (a == 0) return 1;
    if (a == 60) return 0.5;
    if (a == 90) return 0;
    return a <= 45 ? octant(a, true) : octant(90 - a, false);
}

void trig_degrees(double degrees, double *cosine, double *sine) {
    INVARIANT(isfinite(degrees));
    double r = fmod(fabs(degrees), 360);
    int q = (r >= 90) + (r >= 180) + (r >= 270);
    double a = r - 90.0 * q;
    double c = cosine_of(a), s = sine_of(a);
    const double turned[4][2] = {{c, s}, {-s, c}, {-c, -s}, {s, -c}};
    *cosine = turned[q][0] + 0.0; /* -0 + 0 = 0 */
    *sine = (degrees < 0 ? -turned[q][1] : turned[q][1]) + 0.0;
}

/* MPFR rounds pow correctly at any precision, but its exponents do not end where those of double
 * do, and rounding to 53 bits first and to a subnormal then would round twice. Hence towards zero
 * with many bits, and a sticky bit below them if anything was cut off: rounding that to nearest
 * cannot mistake it for a tie. */
double trig_pow(double base, double exponent) {
    INVARIANT(isfinite(base) && base > 0 && isfinite(exponent));
    mpfr_t x, y;
    mpfr_init2(x, 53);
    mpfr_init2(y, 128);
    mpfr_set_d(x, base, MPFR_RNDN);
    mpfr_set_d(y, exponent, MPFR_RNDN);
    int inexact = mpfr_pow(y, x, y, MPFR_RNDZ);
    mpfr_prec_round(y, 129, MPFR_RNDN);
    if (inexact) mpfr_nextabove(y);
    double result = mpfr_get_d(y, MPFR_RNDN);
    mpfr_clears(x, y, (mpfr_ptr)NULL);
    return result;
}
