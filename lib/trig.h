/* SPDX-License-Identifier: GPL-3.0-or-later */
/* trig - correctly rounded functions for numbers that get printed: libm's last bits differ between
 * machines. Over MPFR; some microseconds a call. */
#ifndef TRIG_H
#define TRIG_H

/* Cosine and sine of an angle in degrees, each rounded correctly from the exact value, so multiples
 * of 30 and 45 degrees give the exact 0, 1/2 and 1. |degrees| finite. */
void trig_degrees(double degrees, double *cosine, double *sine);

/* base^exponent, base > 0, rounded correctly. */
double trig_pow(double base, double exponent);

#endif
