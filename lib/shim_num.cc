// SPDX-License-Identifier: GPL-3.0-or-later
#include "shim_num.h"

#include <charconv>

enum shim_num_status shim_num_read(const char *s, const char *end, double *x, const char **next) {
    const char *digits = s < end && *s == '-' ? s + 1 : s;
    if (digits == end || ((*digits < '0' || *digits > '9') && *digits != '.')) return SHIM_NUM_NONE;
    std::from_chars_result r = std::from_chars(s, end, *x);
    *next = r.ptr;
    if (r.ec == std::errc::invalid_argument) return SHIM_NUM_NONE;
    return r.ec == std::errc() ? SHIM_NUM_OK : SHIM_NUM_RANGE;
}

size_t shim_num_print(char *buf, double x, int digits) {
    std::to_chars_result r =
        digits > 0 ? std::to_chars(buf, buf + 32, x, std::chars_format::general, digits)
                   : std::to_chars(buf, buf + 32, x);
    return static_cast<size_t>(r.ptr - buf);
}
