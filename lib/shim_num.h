/* SPDX-License-Identifier: GPL-3.0-or-later */
/* shim_num - the C face of std::from_chars and std::to_chars, which no locale changes. */
#ifndef SHIM_NUM_H
#define SHIM_NUM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum shim_num_status { SHIM_NUM_OK, SHIM_NUM_NONE, SHIM_NUM_RANGE };

/* Reads the longest decimal number at [s, end), no sign '+', no blanks. *next is past it. Letters
 * (inf, nan) are none. RANGE: the number is there, *x is not set. */
enum shim_num_status shim_num_read(const char *s, const char *end, double *x, const char **next);

/* Writes x at buf (room for 32 bytes), shortest if digits = 0, else that many significant digits
 * (1..17). Returns the length; no terminating NUL. */
size_t shim_num_print(char *buf, double x, int digits);

#ifdef __cplusplus
}
#endif
#endif
