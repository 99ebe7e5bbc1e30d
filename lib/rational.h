/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rational - exact rationals (GMP) and doubles. */
#ifndef RATIONAL_H
#define RATIONAL_H

#include <gmp.h>

/* The double nearest to v, ties to even, subnormals included; 0 is +0. Too large gives infinity. */
double rational_round(const mpq_t v);

/* n finite doubles as integers times a power of two, as large as can be: x[i] = m[i] 2^(what is
 * returned). All 0: 0. */
int rational_integers(int n, const double *x, mpz_t *m);

/* The fraction of least denominator in [lo, hi], 0 <= lo <= hi. */
void rational_simplest(mpq_t lo, mpq_t hi, mpq_t result);

#endif
