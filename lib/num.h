/* SPDX-License-Identifier: GPL-3.0-or-later */
/* num - decimal numbers as text, the same in every locale.
 *
 * Grammar: optional sign, digits with an optional point, optional exponent; no nan, inf, hex.
 * Reading is correctly rounded; too large is an error, too small the nearest subnormal or signed
 * zero; -0 is kept. Printing gives the shortest text that reads back to the same double, or a fixed
 * number of significant digits. Cost: about 20 ns to read (few digits: 8 ns), 60 ns to print. */
#ifndef NUM_H
#define NUM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { NUM_TEXT_MAX = 32 }; /* bytes that num_print may write */

enum num_status { NUM_OK, NUM_NONE, NUM_OVERFLOW };

/* Reads a number at [s, end); *next is past it unless NONE. */
enum num_status num_read(const char *s, const char *end, double *x, const char **next);

/* Reads an integer (optional sign, digits). OVERFLOW where it does not fit int64. */
enum num_status num_read_int(const char *s, const char *end, int64_t *n, const char **next);

/* Writes the number, no NUL; returns the length. digits = 0: shortest; 1..17: significant digits.
 */
size_t num_print(char buf[NUM_TEXT_MAX], double x, int digits);
size_t num_print_int(char buf[NUM_TEXT_MAX], int64_t n);

/* What num_print writes, as it reads back. */
double num_rounded(double x, int digits);

#endif
