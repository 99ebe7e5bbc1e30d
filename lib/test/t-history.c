/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include "testing.h"

#include <stdlib.h>
#include <string.h>

static void is_next(const char **at, const char *expected) {
    const char *text, *end;
    assert_true(history_next(at, &text, &end));
    assert_int_equal(end - text, strlen(expected));
    assert_memory_equal(text, expected, strlen(expected));
}

static void lines(void **state) {
    const char *at = "# mkgrid --rect\n#bare\n#  two blanks\n#\n# \n# # twice\n# open", *text, *end;
    (void)state;
    is_next(&at, "mkgrid --rect");
    is_next(&at, "bare");
    is_next(&at, " two blanks");
    is_next(&at, "");
    is_next(&at, "");
    is_next(&at, "# twice");
    is_next(&at, "open");
    assert_false(history_next(&at, &text, &end));
    assert_false(history_next(&at, &text, &end));
}

static void one_more(void **state) {
    struct err err = {0};
    char *first = history_add(NULL, "one", &err), *second;
    (void)state;
    assert_non_null(first);
    assert_string_equal(first, "# one\n");
    second = history_add(first, "two 100%", &err);
    assert_non_null(second);
    assert_string_equal(second, "# one\n# two 100%\n");
    free(first);
    free(second);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines),
        cmocka_unit_test(one_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
