/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "textured_io.h"

#include "testing.h"

#include <string.h>

static bool parse(struct textured *t, const char *text, struct err *err) {
    const struct filemap f = {.name = "x.obj", .data = text, .length = strlen(text)};
    *err = (struct err){0};
    return textured_read(t, &f, err);
}

static void check_face(const struct textured *t, uint32_t f, const uint32_t vertex[3],
                       const uint32_t place[3], int sides) {
    assert_memory_equal(t->face[f].vertex, vertex, sizeof t->face[f].vertex);
    assert_memory_equal(t->face[f].place, place, sizeof t->face[f].place);
    assert_int_equal(t->face[f].sides, sides);
}

#define LIST(...) ((const uint32_t[3]){__VA_ARGS__})

static void faces(void **unused) {
    struct textured t;
    struct err err;
    double lo[2], hi[2];
    assert_true(parse(&t,
                      "# all that is understood\r\n"
                      "v 0 0 0\nv 4 0 0 0.5 0.5 0.5\nv 4 4 -1\nv 0 4 9\nv 99 99 99\n"
                      "vt 0 0\nvt 1 0 0.5\nvn 0 0 1\nusemtl x\n"
                      "f 1/1 2/2/1 3/3\n" /* vt 3 lies ahead */
                      "f -5/-2 -4/-1 \\\n-3/3 -2/4\n"
                      "vt 1 1\nvt 0.25 -1\nvt 7\\\n 8\n"
                      "l 1/1 2/2\n"
                      "f 1/1 2/2 3/3 4/4 1/2\n",
                      &err));
    assert_int_equal(t.vertex_count, 5);
    assert_int_equal(t.place_count, 5);
    assert_int_equal(t.face_count, 6);
    assert_true(t.vertex[3][2] == 9 && t.place[3][0] == 0.25 && t.place[3][1] == -1);
    check_face(&t, 0, LIST(0, 1, 2), LIST(0, 1, 2), 7);
    check_face(&t, 1, LIST(0, 1, 2), LIST(0, 1, 2), 3);
    check_face(&t, 2, LIST(0, 2, 3), LIST(0, 2, 3), 6);
    check_face(&t, 3, LIST(0, 1, 2), LIST(0, 1, 2), 3);
    check_face(&t, 4, LIST(0, 2, 3), LIST(0, 2, 3), 2);
    check_face(&t, 5, LIST(0, 3, 0), LIST(0, 3, 1), 6);
    textured_box(&t, (const int[2]){2, 0}, lo, hi);
    assert_true(lo[0] == -1 && hi[0] == 9 && lo[1] == 0 && hi[1] == 4);
    textured_pattern_box(&t, lo, hi);
    assert_true(lo[0] == 0 && hi[0] == 1 && lo[1] == -1 && hi[1] == 1);
    textured_free(&t);
    (void)unused;
}

static void errors(void **unused) {
    static const struct {
        const char *text;
        size_t line, col;
        const char *message;
    } cases[] = {
        {"", 1, 1, "expected a face 'f v/vt v/vt v/vt', got end of file"},
        {"v 0 0 0\n", 2, 1, "expected a face 'f v/vt v/vt v/vt', got end of file"},
        {"v 0 0 0\nvt 0 0\nf 1/1 1 1/1\n", 3, 7,
         "expected a corner with texture coordinate, v/vt, got '1'"},
        {"v 0 0 0\nvt 0 0\nf 1//1 1/1 1/1\n", 3, 3,
         "expected a corner with texture coordinate, v/vt, got '1//1'"},
        {"v 0 0 0\nvt 0 0\nf 1/1 1/2 1/1\n", 3, 7,
         "texture coordinate 2 does not exist: the model has 1"},
        {"v 0 0 0\nvt 0 0\nf 1/1 3/1 1/1\n", 3, 7, "vertex 3 does not exist: the model has 1"},
        {"v 0 0 0\nvt 0 0\nf 1/1 1/-2 1/1\n", 3, 7,
         "texture coordinate -2 does not exist: 1 before this line"},
        {"v 0 0 0\nvt 0 0\nf 1/1 1/1\n", 3, 10, "expected 3 or more vertices, got 2"},
        {"vt 0\n", 1, 5, "expected a texture coordinate, got end of line"},
        {"vt 0 nan\n", 1, 6, "expected a texture coordinate, got 'nan'"},
        {"vt 0 1 x\n", 1, 8, "expected a texture coordinate, got 'x'"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct textured t;
        struct err err;
        assert_false(parse(&t, cases[i].text, &err));
        assert_string_equal(err.message, cases[i].message);
        assert_string_equal(err.file, "x.obj");
        assert_int_equal(err.line, cases[i].line);
        assert_int_equal(err.col, cases[i].col);
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(faces), cmocka_unit_test(errors)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
