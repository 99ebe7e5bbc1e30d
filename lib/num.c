/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "num.h"

#include "shim_num.h"

#include <string.h>

enum { SHORT = 8 }; /* bytes that has_blank looks at, as one integer */

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* For a number [s, end) that the double range does not hold: is it too large (or too small)?
 * Decides by the power of ten of its first non-zero digit. */
static bool is_too_large(const char *s, const char *end) {
    int64_t power = 0, exponent = 0;
    bool point = false, nonzero = false, negative = false;
    for (; s < end && *s != 'e' && *s != 'E'; s++) {
        if (*s == '.') point = true;
        if (!is_digit(*s)) continue;
        nonzero = nonzero || *s != '0';
        if (nonzero && !point) power++;
        if (!nonzero && point) power--;
    }
    for (; s < end; s++) {
        if (*s == '-') negative = true;
        if (is_digit(*s) && exponent < INT64_MAX / 20) exponent = 10 * exponent + (*s - '0');
    }
    return power + (negative ? -exponent : exponent) > 0;
}

/* Does a blank, or another byte below '!', stand among the SHORT bytes at s? In the difference such
 * a byte borrows from the next: then its top bit is set, which it was not before. */
static inline bool has_blank(const char *s) {
    uint64_t bytes;
    memcpy(&bytes, s, sizeof bytes);
    return ((bytes - 0x2121212121212121) & ~bytes & 0x8080808080808080) != 0;
}

/* Reads a number that ends within SHORT bytes, as most in a new grid do: n / 10^decimals, both of
 * them exact, so that one division rounds it correctly (Clinger, "How to read floating point
 * numbers accurately", 1990). False: it is longer, has an exponent, or is none. */
static inline bool read_short(const char *s, const char *end, double *x, const char **next) {
    static const double power[SHORT] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
    bool negative = s < end && *s == '-', point = false;
    int32_t n = 0, digits = 0, decimals = 0;
    if (end - s > SHORT && !has_blank(s)) return false;
    for (s += negative; s < end; s++) {
        if (is_digit(*s)) {
            n = 10 * n + (*s - '0');
            digits++;
            decimals += point;
        } else if (*s == '.' && !point) {
            point = true;
        } else {
            break;
        }
    }
    if (digits == 0 || (s < end && (*s == 'e' || *s == 'E'))) return false;
    *x = negative ? -(n / power[decimals]) : n / power[decimals];
    *next = s;
    return true;
}

enum num_status num_read(const char *s, const char *end, double *x, const char **next) {
    if (s < end && *s == '+') {
        s++;
        if (s < end && *s == '-') return NUM_NONE;
    }
    if (read_short(s, end, x, next)) return NUM_OK;
    switch (shim_num_read(s, end, x, next)) {
    case SHIM_NUM_OK:
        return NUM_OK;
    case SHIM_NUM_NONE:
        return NUM_NONE;
    case SHIM_NUM_RANGE:
        break;
    }
    if (is_too_large(s, *next)) return NUM_OVERFLOW;
    *x = *s == '-' ? -0.0 : 0.0;
    return NUM_OK;
}

enum num_status num_read_int(const char *s, const char *end, int64_t *n, const char **next) {
    bool negative = s < end && *s == '-', overflow = false;
    int64_t value = 0;
    if (s < end && (*s == '-' || *s == '+')) s++;
    if (s == end || !is_digit(*s)) return NUM_NONE;
    for (; s < end && is_digit(*s); s++) {
        int digit = *s - '0';
        overflow = overflow || __builtin_mul_overflow(value, 10, &value) ||
                   __builtin_sub_overflow(value, digit, &value); /* downwards, to reach INT64_MIN */
    }
    *next = s;
    if (overflow || (!negative && value == INT64_MIN)) return NUM_OVERFLOW;
    *n = negative ? value : -value;
    return NUM_OK;
}

size_t num_print(char buf[NUM_TEXT_MAX], double x, int digits) {
    return shim_num_print(buf, x, digits);
}

size_t num_print_int(char buf[NUM_TEXT_MAX], int64_t n) {
    char reversed[NUM_TEXT_MAX];
    uint64_t rest = n < 0 ? 0 - (uint64_t)n : (uint64_t)n;
    size_t count = 0, length = 0;
    do reversed[count++] = (char)('0' + rest % 10);
    while (rest /= 10);
    if (n < 0) buf[length++] = '-';
    while (count) buf[length++] = reversed[--count];
    return length;
}

double num_rounded(double x, int digits) {
    char text[NUM_TEXT_MAX];
    const char *next;
    if (digits > 0) num_read(text, text + num_print(text, x, digits), &x, &next);
    return x;
}
