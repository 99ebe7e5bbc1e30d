/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "err.h"
#include "mem.h"
#include "testing.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static void test_set_and_place(void **unused) {
    struct err err = {0};
    (void)unused;
    assert_false(err_set(&err, ERR_REFUSAL, "point %d", 17));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message, "point 17");
    assert_string_equal(err.file, "");
    assert_false(err_place(&err, "a.edits", 3, 4));
    assert_string_equal(err.file, "a.edits");
    assert_true(err.line == 3 && err.col == 4);
    assert_false(err_place(&err, "b.edits", 5, 6)); /* it has a place: kept */
    assert_string_equal(err.file, "a.edits");
    assert_true(err.line == 3 && err.col == 4);
    assert_false(err_set_at(&err, ERR_INPUT, "x.grid", 1, 0, "%s", "100% of it"));
    assert_string_equal(err.message, "100% of it");
    assert_true(err.kind == ERR_INPUT && err.line == 1 && err.col == 0);
}

static void test_long_names_and_messages(void **unused) {
    char name[2000];
    struct err err = {0};
    (void)unused;
    memset(name, 'n', sizeof name);
    strcpy(name + sizeof name - 10, "/end.grid");
    err_set_at(&err, ERR_INPUT, name, 1, 1, "%s", name);
    assert_int_equal(strlen(err.file), sizeof err.file - 1);
    assert_memory_equal(err.file, "...nnn", 6);
    assert_string_equal(err.file + strlen(err.file) - 9, "/end.grid");
    assert_int_equal(strlen(err.message), sizeof err.message - 1);
    name[sizeof err.file - 1] = '\0'; /* just fits */
    err_set_at(&err, ERR_INPUT, name, 1, 1, "x");
    assert_string_equal(err.file, name);
}

static void test_system_and_memory(void **unused) {
    struct err err = {0};
    (void)unused;
    errno = ENOENT;
    assert_false(err_system(&err, "open", "a.obj"));
    assert_string_equal(err.message, "cannot open a.obj: No such file or directory");
    assert_int_equal(err.kind, ERR_INPUT);
    assert_false(err_memory(&err));
    assert_string_equal(err.message, "out of memory");
}

/* A false invariant stops the process by SIGABRT, after one line on stderr. */
static void test_invariant(void **unused) {
    int ends[2], status;
    char text[200] = "";
    ssize_t length;
    pid_t child;
    (void)unused;
    INVARIANT(1 + 1 == 2);
    assert_int_equal(pipe(ends), 0);
    child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        signal(SIGABRT, SIG_DFL);
        INVARIANT(1 + 1 == 3);
        _exit(0);
    }
    close(ends[1]);
    length = read(ends[0], text, sizeof text - 1);
    close(ends[0]);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
    assert_true(length > 0 && strstr(text, "'1 + 1 == 3' is false"));
}

static void test_alloc(void **unused) {
    struct err err = {0};
    int *p;
    double(*q)[3];
    (void)unused;
    assert_true(mem_new(p, 0, &err));
    free(p);
    assert_true(mem_new(q, 1000, &err));
    for (int i = 0; i < 3000; i++) assert_true(q[i / 3][i % 3] == 0);
    free(q);
    assert_int_equal(err.kind, ERR_NONE);
    assert_null(mem_alloc(SIZE_MAX / 2, 3, &err));
    assert_string_equal(err.message, "out of memory");
}

static void test_grow(void **unused) {
    struct err err = {0};
    uint32_t *p = NULL, *before;
    size_t cap = 0, moves = 0;
    (void)unused;
    for (size_t n = 0; n < 100000; n++) {
        before = p;
        assert_true(mem_grow(p, &cap, n + 1, &err));
        assert_true(cap > n);
        moves += p != before || n == 0;
        p[n] = (uint32_t)n;
    }
    assert_true(moves < 40); /* by half at least each time */
    for (size_t n = 0; n < 100000; n++) assert_int_equal(p[n], n);
    before = p;
    assert_false(mem_grow(p, &cap, SIZE_MAX / 2, &err)); /* bytes overflow */
    assert_true(p == before && p[99999] == 99999);
    assert_int_equal(err.kind, ERR_INPUT);
    free(p);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_set_and_place),
        cmocka_unit_test(test_long_names_and_messages),
        cmocka_unit_test(test_system_and_memory),
        cmocka_unit_test(test_invariant),
        cmocka_unit_test(test_alloc),
        cmocka_unit_test(test_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
