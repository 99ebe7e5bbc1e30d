/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first byte tells the length and the first payload bits; what the bytes spell must need that
 * length:
 *
 *     0xxxxxxx                              from U+0000
 *     110xxxxx 10xxxxxx                     from U+0080
 *     1110xxxx 10xxxxxx 10xxxxxx            from U+0800
 *     11110xxx 10xxxxxx 10xxxxxx 10xxxxxx   from U+10000 */
#include "utf8.h"

#include <stdint.h>

int utf8_length(const char *s, const char *end) {
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    uint32_t first = (unsigned char)*s, code;
    int n;
    if (first < 0x80) return 1;
    if (first < 0xc0 || first > 0xf7) return 0;
    n = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (end - s < n) return 0;
    code = first & (0x7fU >> n);
    for (int i = 1; i < n; i++) {
        uint32_t byte = (unsigned char)s[i];
        if ((byte & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte & 0x3f);
    }
    if (code < least[n] || code > 0x10ffff) return 0;
    if ((code >= 0xd800 && code <= 0xdfff) || code == 0xfffe || code == 0xffff) return 0;
    return n;
}
