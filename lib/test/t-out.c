/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out.h"
#include "testing.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* A scratch folder as the working directory, removed by leave_folder, which checks that nothing but
 * the named file is left in it. */
static char folder[40];

static int enter_folder(void **unused) {
    (void)unused;
    strcpy(folder, "/tmp/supple-out-XXXXXX");
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int leave_folder(void **unused) {
    (void)unused;
    return unlink("file") == 0 && chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

static void write_file(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static void expect_file(const char *path, const char *want) {
    char text[4000];
    FILE *file = fopen(path, "rb");
    size_t length;
    assert_non_null(file);
    length = fread(text, 1, sizeof text, file);
    fclose(file);
    assert_int_equal(length, strlen(want));
    assert_memory_equal(text, want, length);
}

static void test_writes_and_renames(void **unused) {
    struct out out;
    struct err err = {0};
    struct stat st;
    mode_t mask = umask(027);
    (void)unused;
    write_file("file", "old");
    assert_true(out_open(&out, "file", &err));
    out_text(&out, "grid ");
    out_int(&out, -1);
    out_char(&out, ' ');
    out_double(&out, 0.1, 0);
    out_char(&out, ' ');
    out_double(&out, 2.0 / 3, 3);
    out_format(&out, " %s=%d\n", "x", 7);
    expect_file("file", "old"); /* until it is closed */
    assert_true(out_close(&out, &err));
    expect_file("file", "grid -1 0.1 0.667 x=7\n");
    assert_true(stat("file", &st) == 0 && (st.st_mode & 0777) == 0640);
    out_discard(&out); /* harmless */
    umask(mask);
}

static void test_discard_keeps_old_file(void **unused) {
    struct out out;
    struct err err = {0};
    (void)unused;
    write_file("file", "old");
    assert_true(out_open(&out, "file", &err));
    out_text(&out, "new");
    out_discard(&out);
    expect_file("file", "old");
    out_discard(&out);
}

/* The full device takes the place of the temporary, as if the disk had filled up. */
static void test_full_disk_keeps_old_file(void **unused) {
    struct out out;
    struct err err = {0};
    (void)unused;
    write_file("file", "old");
    assert_true(out_open(&out, "file", &err));
    int full = open("/dev/full", O_WRONLY), keep = dup(out.fd);
    assert_true(full >= 0 && keep >= 0 && dup2(full, out.fd) >= 0);
    for (int i = 0; i < 300000; i++) out_text(&out, "new"); /* more than the buffer */
    assert_int_equal(out.err.kind, ERR_INPUT);
    assert_false(out_close(&out, &err));
    assert_string_equal(err.message, "cannot write file: No space left on device");
    expect_file("file", "old");
    close(full);
    close(keep);
}

static void test_device_is_written_directly(void **unused) {
    struct out out;
    struct err err = {0};
    (void)unused;
    write_file("file", "");
    assert_true(out_open(&out, "/dev/full", &err));
    out_text(&out, "x");
    assert_false(out_close(&out, &err));
    assert_string_equal(err.message, "cannot write /dev/full: No space left on device");
    memset(&err, 0, sizeof err);
    assert_true(out_open(&out, "/dev/null", &err));
    out_text(&out, "x");
    assert_true(out_close(&out, &err));
}

static void test_cannot_create(void **unused) {
    struct out out;
    struct err err = {0};
    (void)unused;
    write_file("file", "old");
    assert_false(out_open(&out, "no/such/folder", &err));
    assert_string_equal(err.message, "cannot create no/such/folder: No such file or directory");
    assert_false(out_open(&out, ".", &err));
    assert_string_equal(err.message, "cannot create .: Is a directory");
    out_discard(&out);
}

/* Pieces of every size give the bytes they would give in memory. */
static void test_pieces(void **unused) {
    enum { TOTAL = 3 << 20 };
    char *want = malloc(TOTAL), *got = malloc(TOTAL + 1);
    (void)unused;
    assert_true(want && got);
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(20); seed++) {
        struct out out;
        struct err err = {0};
        uint64_t state = seed;
        assert_true(out_open(&out, "file", &err));
        for (size_t at = 0; at < TOTAL;) {
            size_t most = random_bits(&state) % 50 ? 100 : (size_t)1 << 20;
            size_t n = random_bits(&state) % most;
            if (n > TOTAL - at) n = TOTAL - at;
            memset(want + at, (int)(random_bits(&state) % 256), n);
            out_bytes(&out, want + at, n);
            at += n;
        }
        assert_true(out_close(&out, &err));
        FILE *file = fopen("file", "rb");
        check_seed(seed, file && fread(got, 1, TOTAL + 1, file) == TOTAL);
        fclose(file);
        check_seed(seed, memcmp(want, got, TOTAL) == 0);
    }
    free(want);
    free(got);
}

/* Numbers that end up on the last bytes of the buffer. */
static void test_numbers_at_the_buffer_end(void **unused) {
    (void)unused;
    for (size_t before = (1 << 18) - 40; before <= 1 << 18; before++) {
        struct out out;
        struct err err = {0};
        char tail[100] = "";
        assert_true(out_open(&out, "file", &err));
        for (size_t i = 0; i < before; i++) out_char(&out, 'x');
        out_double(&out, -1.2345678901234568e-300, 17);
        out_int(&out, INT64_MIN);
        out_double(&out, 5, 0);
        assert_true(out_close(&out, &err));
        FILE *file = fopen("file", "rb");
        assert_true(file && fseek(file, (long)before, SEEK_SET) == 0);
        assert_true(fread(tail, 1, sizeof tail - 1, file) > 0);
        fclose(file);
        assert_string_equal(tail, "-1.2345678901234568e-300-92233720368547758085");
    }
}

static void test_zeroed_struct(void **unused) {
    struct out out = {0};
    (void)unused;
    write_file("file", "");
    out_discard(&out);
    assert_true(fcntl(STDIN_FILENO, F_GETFD) >= 0); /* descriptor 0 was not closed */
}

#define IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, enter_folder, leave_folder)

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_FOLDER(test_writes_and_renames),
        IN_FOLDER(test_discard_keeps_old_file),
        IN_FOLDER(test_full_disk_keeps_old_file),
        IN_FOLDER(test_device_is_written_directly),
        IN_FOLDER(test_cannot_create),
        IN_FOLDER(test_pieces),
        IN_FOLDER(test_numbers_at_the_buffer_end),
        IN_FOLDER(test_zeroed_struct),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
