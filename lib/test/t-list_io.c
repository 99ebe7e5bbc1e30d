/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "list_io.h"

#include "testing.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct filemap map_of(const char *text) {
    return (struct filemap){.name = "list", .data = text, .length = strlen(text)};
}

/* The copy of a text; the caller frees it. */
static char *copied(const char *text, const struct list_change *change, size_t count) {
    char path[] = "/tmp/t-list_io.XXXXXX", *copy = calloc(strlen(text) + 1000, 1);
    struct filemap f = map_of(text);
    struct err err = {0};
    struct out out;
    int fd = mkstemp(path);
    assert_true(fd >= 0 && copy);
    assert_true(out_open(&out, path, &err));
    assert_true(list_copy(&out, &f, count, change, &err));
    assert_true(out_close(&out, &err));
    close(fd);
    fd = open(path, O_RDONLY);
    assert_true(read(fd, copy, strlen(text) + 999) >= 0);
    close(fd);
    unlink(path);
    return copy;
}

static const char polygon[] = "# x y\r\n"
                              "1 2\r\n"
                              "\t-3.50\t+4e0  red  # here\r\n"
                              "\r\n"
                              " HOLE # round\n"
                              "  5 6 7 8#\n"
                              "\n"
                              "1e-400 -0";

static void reads_points_only(void **unused) {
    static const double expected[4][3] = {{1, 2, 0}, {-3.5, 4, 0}, {5, 6, 0}, {0, -0.0, 0}};
    static const size_t lines[4] = {2, 3, 6, 8};
    struct filemap f = map_of(polygon);
    struct obj_points p;
    struct err err = {0};
    assert_true(list_read(&p, &f, 2, &err));
    assert_int_equal(p.vertex_count, 4);
    assert_int_equal(p.normal_count, 0);
    assert_memory_equal(p.vertex, expected, sizeof expected);
    for (size_t i = 0; i < 4; i++) assert_int_equal(list_line(&f, 2, i), lines[i]);
    obj_points_free(&p);
    (void)unused;
}

static void replaces_numbers_only(void **unused) {
    double point[4][3] = {{10, 20, 0}, {0.1, 1e300, 0}, {-0.0, 1, 0}, {7, 8, 0}};
    double further[4][5] = {{1, 0, 0, 1, 1}, {2, 3, 4, 5, 6}, {0}, {9, 9, 9, 9, 9}};
    struct list_change change = {2, point, NULL, 0};
    char *copy = copied(polygon, &change, 4);
    assert_string_equal(copy, "# x y\r\n"
                              "10 20\r\n"
                              "\t0.1\t1e+300  red  # here\r\n"
                              "\r\n"
                              " HOLE # round\n"
                              "  -0 1 7 8#\n"
                              "\n"
                              "7 8");
    free(copy);
    change.further = further;
    copy = copied(polygon, &change, 4);
    assert_string_equal(copy, "# x y\r\n"
                              "10 20 1 0 0 1 1\r\n"
                              "\t0.1\t1e+300  red 2 3 4 5 6  # here\r\n"
                              "\r\n"
                              " HOLE # round\n"
                              "  -0 1 7 8 0 0 0 0 0#\n"
                              "\n"
                              "7 8 9 9 9 9 9");
    free(copy);
    (void)unused;
}

static void three_columns(void **unused) {
    const char *text = "1 2 3\n4 5 6 7 # 8\n";
    double point[2][3] = {{3, 2, 1}, {6, 5, 4}};
    struct list_change change = {3, point, NULL, 0};
    struct filemap f = map_of(text);
    struct obj_points p;
    struct err err = {0};
    char *copy = copied(text, &change, 2);
    assert_string_equal(copy, "3 2 1\n6 5 4 7 # 8\n");
    free(copy);
    assert_true(list_read(&p, &f, 3, &err));
    assert_true(p.vertex_count == 2 && p.vertex[1][2] == 6);
    obj_points_free(&p);
    (void)unused;
}

static void refusals(void **unused) {
    static const struct {
        int columns;
        const char *text, *message;
        size_t line, col;
    } bad[] = {
        {2, "", "expected a point x y, got end of file", 1, 1},
        {3, "# 1 2 3\n\n", "expected a point x y z, got end of file", 3, 1},
        {2, "1 2\n3\n", "expected y of a point, got end of line", 2, 2},
        {2, "1 2\n 3 nan", "expected y of a point, got 'nan'", 2, 4},
        {2, "1 0x2", "expected y of a point, got '0x2'", 1, 3},
        {2, "1 1e999", "expected y of a point, got a number that is too large", 1, 3},
        {2, "1,2", "expected x of a point, got '1,2'", 1, 1},
        {2, "hole", "expected x of a point, got 'hole'", 1, 1},
        {2, "1 2\nHOLE 1", "expected the end of the line, got '1'", 2, 6},
        {3, "1 2 3\nHOLE", "expected x of a point, got 'HOLE'", 2, 1},
        {3, "1 2 # 3", "expected z of a point, got end of line", 1, 5},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct filemap f = map_of(bad[i].text);
        struct obj_points p;
        struct err err = {0};
        assert_false(list_read(&p, &f, bad[i].columns, &err));
        assert_string_equal(err.message, bad[i].message);
        assert_int_equal(err.kind, ERR_INPUT);
        assert_string_equal(err.file, "list");
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
        assert_null(p.vertex);
    }
    (void)unused;
}

/* A text that has more or fewer points than when it was read. */
static void changed_meanwhile(void **unused) {
    double point[3][3] = {{0}};
    struct list_change change = {2, point, NULL, 0};
    for (size_t count = 1; count <= 3; count += 2) {
        struct filemap f = map_of("1 2\n3 4\n");
        struct err err = {0};
        struct out out;
        assert_true(out_open(&out, "/dev/null", &err));
        assert_false(list_copy(&out, &f, count, &change, &err));
        assert_non_null(strstr(err.message, "was changed"));
        out_discard(&out);
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_points_only), cmocka_unit_test(replaces_numbers_only),
        cmocka_unit_test(three_columns),     cmocka_unit_test(refusals),
        cmocka_unit_test(changed_meanwhile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
