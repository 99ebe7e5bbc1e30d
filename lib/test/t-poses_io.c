/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "poses_io.h"

#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[40];

static int enter_folder(void **unused) {
    (void)unused;
    strcpy(folder, "/tmp/supple-poses-XXXXXX");
    return mkdtemp(folder) && chdir(folder) == 0 && mkdir("out", 0777) == 0 ? 0 : -1;
}

/* Nothing but these is left. */
static int leave_folder(void **unused) {
    static const char *const left[] = {"list", "a.xy", "b c.xy", "out/a.xy", "out/b c.xy"};
    (void)unused;
    for (size_t i = 0; i < sizeof left / sizeof *left; i++) unlink(left[i]);
    return rmdir("out") == 0 && chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

static void write_file(const char *path, const char *text, size_t length) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

static const char *extension;

static bool read_list(struct poses *p, const char *text, struct err *err) {
    write_file("list", text, strlen(text));
    return poses_read(p, "list", "out", extension, err);
}

static void test_read(void **unused) {
    struct poses p;
    struct err err;
    (void)unused;
    assert_true(read_list(&p, "# poses\n\n  a.xy\t# first\r\n/far/ b c.xy \r\nlast", &err));
    assert_int_equal(p.count, 3);
    assert_string_equal(p.pose[0].path, "a.xy");
    assert_string_equal(p.pose[0].output, "out/a.xy");
    assert_int_equal(p.pose[0].line, 3);
    assert_string_equal(p.pose[1].path, "/far/ b c.xy");
    assert_string_equal(p.pose[1].output, "out/ b c.xy");
    assert_string_equal(p.pose[2].output, "out/last");
    poses_free(&p);
}

static void test_extension(void **unused) {
    static const char *const names[][2] = {{"a.b.xy", "out/a.b.obj"},
                                           {"x.y/a", "out/a.obj"},
                                           {".xy", "out/.xy.obj"},
                                           {"b.", "out/b.obj"}};
    struct poses p;
    struct err err = {0};
    (void)unused;
    extension = ".obj";
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        assert_true(read_list(&p, names[i][0], &err));
        assert_string_equal(p.pose[0].output, names[i][1]);
        poses_free(&p);
    }
    assert_false(read_list(&p, "a.xy\na.dat\n", &err));
    assert_string_equal(err.message, "the output 'out/a.obj' is already that of line 1");
    poses_free(&p);
    extension = NULL;
}

static void test_refusals(void **unused) {
    static const struct {
        const char *text;
        enum err_kind kind;
        size_t line, col;
        const char *message;
    } bad[] = {
        {"", ERR_INPUT, 1, 1, "expected a file name, got end of file"},
        {"# none\n\n", ERR_INPUT, 3, 1, "expected a file name, got end of file"},
        {"a\n -\n", ERR_INPUT, 2, 2, "expected a file name, got '-': stdin cannot be a pose"},
        {"a\nb/\n", ERR_INPUT, 2, 1, "expected a file name, got the folder 'b/'"},
        {"x/a\nb\ny/a\nb\n", ERR_USAGE, 3, 1, "the output 'out/a' is already that of line 1"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct poses p;
        struct err err = {0};
        assert_false(read_list(&p, bad[i].text, &err));
        assert_string_equal(err.message, bad[i].message);
        assert_string_equal(err.file, "list");
        assert_int_equal(err.kind, bad[i].kind);
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
        poses_free(&p);
    }
}

/* What is read is not overwritten, be it a pose or another file. */
static void test_spares_input(void **unused) {
    struct poses p;
    struct err err = {0};
    (void)unused;
    write_file("out/a.xy", "", 0);
    assert_false(read_list(&p, "b\n./out/a.xy\n", &err));
    assert_int_equal(err.kind, ERR_USAGE);
    assert_string_equal(err.message, "'./out/a.xy', which is to be read, would be overwritten");
    poses_free(&p);
    assert_true(read_list(&p, "b\na.xy\n", &err));
    assert_true(poses_spare(&p, NULL, &err) && poses_spare(&p, "-", &err));
    assert_true(poses_spare(&p, "a.xy", &err) && poses_spare(&p, "list", &err));
    assert_false(poses_spare(&p, "out/../out/a.xy", &err));
    poses_free(&p);
}

static void write_pose(struct pose *pose, const char *text) {
    struct out out;
    struct err err;
    assert_true(out_open(&out, pose->output, &err));
    out_text(&out, text);
    assert_true(out_close_pending(&out, &pose->pending, &err));
}

/* All or nothing. */
static void test_commit(void **unused) {
    struct poses p;
    struct err err;
    (void)unused;
    for (int commit = 0; commit < 2; commit++) {
        assert_true(read_list(&p, "a.xy\nb c.xy\n", &err));
        for (size_t i = 0; i < p.count; i++) write_pose(&p.pose[i], "1 2\n");
        assert_true(access("out/a.xy", F_OK) < 0 && access("out/b c.xy", F_OK) < 0);
        if (commit) assert_true(poses_commit(&p, &err));
        poses_free(&p);
        assert_int_equal(access("out/a.xy", F_OK) == 0, commit);
        assert_int_equal(access("out/b c.xy", F_OK) == 0, commit);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_read, enter_folder, leave_folder),
        cmocka_unit_test_setup_teardown(test_extension, enter_folder, leave_folder),
        cmocka_unit_test_setup_teardown(test_refusals, enter_folder, leave_folder),
        cmocka_unit_test_setup_teardown(test_spares_input, enter_folder, leave_folder),
        cmocka_unit_test_setup_teardown(test_commit, enter_folder, leave_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
