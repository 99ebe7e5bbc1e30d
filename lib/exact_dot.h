/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exact_dot - sums of products and their quotients, rounded once. */
#ifndef EXACT_DOT_H
#define EXACT_DOT_H

#include <stddef.h>

/* The double nearest to (sum over i < n of c[i] x[i]) / den, ties to even; an exact zero is +0.
 * c[i], x[i] finite, den > 0 finite; too large gives infinity. About 10 ns a term where 159 bits
 * decide the rounding, else a microsecond (GMP). */
double exact_dot(size_t n, const double *c, const double *x, double den);

#endif
