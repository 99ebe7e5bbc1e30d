/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: glibc's strtod (correctly rounded) and printf, in the C locale. */
#include "num.h"
#include "testing.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum num_status read_text(const char *text, double *x, size_t *used) {
    const char *next = text;
    enum num_status status = num_read(text, text + strlen(text), x, &next);
    *used = (size_t)(next - text);
    return status;
}

static bool same_bits(double x, double y) {
    return memcmp(&x, &y, sizeof x) == 0;
}

static void check_read(const char *text, double want) {
    double x = 42;
    size_t used;
    if (read_text(text, &x, &used) != NUM_OK || used != strlen(text) || !same_bits(x, want))
        fail_msg("'%s': read %a with %zu characters, expected %a", text, x, used, want);
}

static double any_double(uint64_t *state) {
    for (;;) {
        uint64_t bits = random_bits(state);
        double x;
        memcpy(&x, &bits, sizeof x);
        if (isfinite(x)) return x;
    }
}

/* Everything printed reads back to the same bits, and no shorter text of the digits would. */
static void test_shortest_round_trip(void **unused) {
    uint64_t state = 1;
    (void)unused;
    for (int n = test_count(300000); n > 0; n--) {
        double x = any_double(&state);
        char text[NUM_TEXT_MAX + 1], longest[64];
        size_t length = num_print(text, x, 0);
        assert_true(length < NUM_TEXT_MAX);
        text[length] = '\0';
        check_read(text, x);
        assert_true(same_bits(strtod(text, NULL), x));
        snprintf(longest, sizeof longest, "%.17g", x);
        assert_true(length <= strlen(longest));
        check_read(longest, x);
    }
}

static void test_fixed_digits(void **unused) {
    uint64_t state = 2;
    (void)unused;
    for (int n = test_count(100000); n > 0; n--) {
        double x = any_double(&state);
        int digits = 1 + (int)(random_bits(&state) % 17);
        char text[NUM_TEXT_MAX], want[64];
        size_t length = num_print(text, x, digits);
        int wanted = snprintf(want, sizeof want, "%.*g", digits, x);
        assert_int_equal(length, wanted);
        assert_memory_equal(text, want, length);
    }
}

/* Decimal numbers of every shape and size against strtod. */
static void test_reads_as_strtod(void **unused) {
    uint64_t state = 3;
    (void)unused;
    for (int n = test_count(300000); n > 0; n--) {
        char text[400];
        int at = 0, whole = (int)(random_bits(&state) % 25);
        int part = (int)(random_bits(&state) % (n % 50 ? 25 : 320));
        int power = (int)(random_bits(&state) % 700) - 350;
        double want, x;
        size_t used;
        if (random_bits(&state) % 2) text[at++] = '-';
        for (int i = 0; i < whole; i++) text[at++] = (char)('0' + random_bits(&state) % 10);
        if (part) text[at++] = '.';
        for (int i = 0; i < part; i++) text[at++] = (char)('0' + random_bits(&state) % 10);
        if (!whole && !part) text[at++] = '0';
        text[at] = '\0';
        if (n % 3 == 0)
            snprintf(text + at, sizeof text - (size_t)at, "%c%d", n % 2 ? 'e' : 'E', power);
        want = strtod(text, NULL);
        if (isfinite(want))
            check_read(text, want);
        else
            assert_int_equal(read_text(text, &x, &used), NUM_OVERFLOW);
    }
}

static void test_ends_of_the_range(void **unused) {
    static const char *const small[] = {
        "4.9406564584124654e-324",
        "2.4703282292062328e-324",
        "2.4703282292062327e-324",
        "3e-324",
        "2e-324",
        "-2e-324",
        "1e-400",
        "-1e-400",
        "1e-99999999999999999999",
        "0e99999999999999999999",
        "-0e999",
        "2.2250738585072011e-308",
        "2.2250738585072014e-308",
        "1.7976931348623157e308",
        "179769313486231580793e288",
        "0.00000000000000000001e328",
    };
    static const char *const large[] = {
        "1.7976931348623159e308",
        "1e309",
        "-1e309",
        "1e99999999999999999999",
        "123456789012345678901234567890e290",
        "0.001e312",
        "100e9223372036854775807",
    };
    double x;
    size_t used;
    (void)unused;
    for (size_t i = 0; i < sizeof small / sizeof *small; i++)
        check_read(small[i], strtod(small[i], NULL));
    for (size_t i = 0; i < sizeof large / sizeof *large; i++) {
        assert_int_equal(read_text(large[i], &x, &used), NUM_OVERFLOW);
        assert_int_equal(used, strlen(large[i]));
    }
}

/* A million zeros before the point or behind it, balanced by the exponent. */
static void test_long_numbers(void **unused) {
    enum { ZEROS = 1000000 };
    char *text = malloc(ZEROS + 40);
    (void)unused;
    assert_non_null(text);
    memset(text, '0', ZEROS);
    memcpy(text, "0.", 2);
    snprintf(text + ZEROS, 40, "25e%d", ZEROS);
    check_read(text, 25);
    snprintf(text + ZEROS, 40, "25e%d", ZEROS - 1000);
    check_read(text, 0);
    memset(text, '0', ZEROS);
    text[0] = '7';
    snprintf(text + ZEROS, 40, "e-%d", ZEROS - 1);
    check_read(text, 7);
    text[ZEROS] = '\0';
    {
        double x;
        size_t used;
        assert_int_equal(read_text(text, &x, &used), NUM_OVERFLOW);
    }
    free(text);
}

static void test_grammar(void **unused) {
    static const struct {
        const char *text;
        size_t used; /* 0: no number */
        double value;
    } table[] = {
        {"1", 1, 1},       {"+1", 2, 1},      {"-1", 2, -1},       {"+-1", 0, 0},
        {"-+1", 0, 0},     {"--1", 0, 0},     {"++1", 0, 0},       {".5", 2, 0.5},
        {"5.", 2, 5},      {"-.5", 3, -0.5},  {".", 0, 0},         {"-", 0, 0},
        {"", 0, 0},        {"+", 0, 0},       {"nan", 0, 0},       {"NaN", 0, 0},
        {"inf", 0, 0},     {"-inf", 0, 0},    {"+infinity", 0, 0}, {"-nan(1)", 0, 0},
        {"0x10", 1, 0},    {"1e", 1, 1},      {"1e+", 1, 1},       {"1e5", 3, 1e5},
        {"1E-2", 4, 0.01}, {"1,5", 1, 1},     {"1_0", 1, 1},       {" 1", 0, 0},
        {"e5", 0, 0},      {".e5", 0, 0},     {"00012", 5, 12},    {"1.2.3", 3, 1.2},
        {"-0", 2, -0.0},   {"1e5.5", 3, 1e5}, {"1d5", 1, 1},       {"+.5e1", 5, 5},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double x = 42;
        size_t used = 0;
        enum num_status status = read_text(table[i].text, &x, &used);
        if (table[i].used == 0) {
            if (status != NUM_NONE) fail_msg("'%s' was read as %g", table[i].text, x);
        } else if (status != NUM_OK || used != table[i].used || !same_bits(x, table[i].value)) {
            fail_msg("'%s': status %d, %zu characters, %g", table[i].text, status, used, x);
        }
    }
}

/* Texts of a few characters against strtod, which takes leading blanks besides, and without a byte
 * that may be read behind them. */
static void test_short_texts(void **unused) {
    static const char letters[] = "0000112579..--+eE \t,";
    uint64_t state = 5;
    (void)unused;
    for (int n = test_count(500000); n > 0; n--) {
        size_t length = (size_t)random_in(&state, 1, 12);
        char text[16] = "", *exact = malloc(length), *end;
        const char *next;
        double x = 42, want;
        enum num_status status;
        assert_non_null(exact);
        for (size_t i = 0; i < length; i++)
            text[i] = letters[random_in(&state, 0, (int64_t)sizeof letters - 2)];
        memcpy(exact, text, length);
        want = strtod(text, &end);
        if (*text == ' ' || *text == '\t') end = text;
        status = num_read(exact, exact + length, &x, &next);
        if (status == NUM_NONE)
            assert_ptr_equal(end, text);
        else if (status == NUM_OVERFLOW)
            assert_true(isinf(want));
        else if (next - exact != end - text || !same_bits(x, want))
            fail_msg("'%s': %td characters, %a, expected %td, %a", text, next - exact, x,
                     end - text, want);
        free(exact);
    }
}

static void test_end_is_obeyed(void **unused) {
    const char *text = "123456789", *next;
    double x;
    int64_t n;
    (void)unused;
    for (int length = 1; length <= 9; length++) {
        double want = strtod(text, NULL);
        for (int i = length; i < 9; i++) want = floor(want / 10);
        assert_int_equal(num_read(text, text + length, &x, &next), NUM_OK);
        assert_true(x == want && next == text + length);
        assert_int_equal(num_read_int(text, text + length, &n, &next), NUM_OK);
        assert_true((double)n == want && next == text + length);
    }
    assert_int_equal(num_read(text, text, &x, &next), NUM_NONE);
    assert_int_equal(num_read_int(text, text, &n, &next), NUM_NONE);
}

static void test_integers(void **unused) {
    static const int64_t table[] = {0,         1,         -1,           9, 10, INT32_MAX,
                                    INT64_MAX, INT64_MIN, INT64_MIN + 1};
    static const char *const beyond[] = {"9223372036854775808", "-9223372036854775809",
                                         "+9223372036854775808", "99999999999999999999999999"};
    uint64_t state = 4;
    const char *next;
    int64_t n;
    (void)unused;
    for (int i = 0; i < test_count(100000); i++) {
        int64_t want =
            i < 9 ? table[i] : (int64_t)(random_bits(&state) >> random_bits(&state) % 64);
        char text[40], printed[NUM_TEXT_MAX];
        int length = snprintf(text, sizeof text, "%" PRId64, want);
        assert_int_equal(num_print_int(printed, want), length);
        assert_memory_equal(printed, text, (size_t)length);
        assert_int_equal(num_read_int(text, text + length, &n, &next), NUM_OK);
        assert_true(n == want && next == text + length);
    }
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(num_read_int(beyond[i], strchr(beyond[i], '\0'), &n, &next), NUM_OVERFLOW);
    assert_int_equal(num_read_int(beyond[2], beyond[2] + 1, &n, &next), NUM_NONE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shortest_round_trip),
        cmocka_unit_test(test_fixed_digits),
        cmocka_unit_test(test_reads_as_strtod),
        cmocka_unit_test(test_ends_of_the_range),
        cmocka_unit_test(test_long_numbers),
        cmocka_unit_test(test_grammar),
        cmocka_unit_test(test_short_texts),
        cmocka_unit_test(test_end_is_obeyed),
        cmocka_unit_test(test_integers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
