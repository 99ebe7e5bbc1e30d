/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rational.h"

#include <mpfr.h>

/* Rounds v to odd at 64 bits first: rounding again, to 53 bits or to a subnormal, is then the same
 * as rounding once. */
double rational_round(const mpq_t v) {
    mpfr_t x;
    double result;
    mpfr_init2(x, 64);
    if (mpfr_set_q(x, v, MPFR_RNDZ) != 0) {
        mpfr_t odd;
        mpfr_init2(odd, 65);
        mpfr_set(odd, x, MPFR_RNDN);
        if (mpfr_sgn(x) > 0) /* one bit more than x has: always odd */
            mpfr_nextabove(odd);
        else
            mpfr_nextbelow(odd);
        mpfr_swap(x, odd);
        mpfr_clear(odd);
    }
    result = mpfr_zero_p(x) ? 0.0 : mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return result;
}
