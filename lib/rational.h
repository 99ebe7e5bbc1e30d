/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rational - from exact rationals (GMP) to doubles. */
#ifndef RATIONAL_H
#define RATIONAL_H

#include <gmp.h>

/* The double nearest to v, ties to even, subnormals included; 0 is +0. Too large gives infinity. */
double rational_round(const mpq_t v);

#endif
