/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: an encoder, over all code points; and counts of the well-formed sequences among all byte
 * strings of three bytes, by the table of the Unicode standard. */
#include "utf8.h"

#include "testing.h"

static int encode(uint32_t code, char *s) {
    if (code < 0x80) {
        s[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        s[0] = (char)(0xc0 | code >> 6);
        s[1] = (char)(0x80 | (code & 63));
        return 2;
    }
    if (code < 0x10000) {
        s[0] = (char)(0xe0 | code >> 12);
        s[1] = (char)(0x80 | (code >> 6 & 63));
        s[2] = (char)(0x80 | (code & 63));
        return 3;
    }
    s[0] = (char)(0xf0 | code >> 18);
    s[1] = (char)(0x80 | (code >> 12 & 63));
    s[2] = (char)(0x80 | (code >> 6 & 63));
    s[3] = (char)(0x80 | (code & 63));
    return 4;
}

static void every_code_point(void **state) {
    (void)state;
    for (uint32_t code = 0; code < 0x200000; code++) {
        char s[4];
        int n = encode(code, s);
        bool sound = code <= 0x10ffff && !(code >= 0xd800 && code <= 0xdfff) && code != 0xfffe &&
                     code != 0xffff;
        if (utf8_length(s, s + n) != (sound ? n : 0)) fail_msg("U+%04X", code);
        if (n > 1 && utf8_length(s, s + n - 1) != 0) fail_msg("U+%04X, cut", code);
    }
}

/* A first byte and two more: how many of the 65536 are well-formed, characters of three bytes. */
static int three_bytes(int first) {
    int count = 0;
    for (int second = 0; second < 256; second++)
        for (int third = 0; third < 256; third++) {
            char s[] = {(char)first, (char)second, (char)third};
            count += utf8_length(s, s + 3) == 3;
        }
    return count;
}

static void byte_strings(void **state) {
    (void)state;
    for (int first = 0; first < 256; first++) {
        int expected = first < 0xe0 || first > 0xef ? 0 : 64 * 64;
        if (first == 0xe0 || first == 0xed) expected = 32 * 64; /* overlong; surrogates */
        if (first == 0xef) expected -= 2;                       /* U+FFFE, U+FFFF */
        assert_int_equal(three_bytes(first), expected);
    }
    for (int first = 0x80; first < 0xc0; first++) {
        const char s[] = {(char)first, '\x80'};
        assert_int_equal(utf8_length(s, s + 2), 0);
    }
    for (int first = 0xc0; first < 0xe0; first++) {
        const char s[] = {(char)first, '\xbf', '\x7f'};
        assert_int_equal(utf8_length(s, s + 3), first < 0xc2 ? 0 : 2);
        assert_int_equal(utf8_length(s, s + 1), 0);
    }
    for (int first = 0xf5; first < 0x100; first++) {
        const char s[] = {(char)first, '\x80', '\x80', '\x80', '\x80', '\x80'};
        assert_int_equal(utf8_length(s, s + 6), 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_code_point),
        cmocka_unit_test(byte_strings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
