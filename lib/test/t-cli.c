/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli.h"
#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { KEY_RECT = 256, KEY_CELLS, KEY_VERBOSE };

static const struct cli_option options[] = {
    {'d', "degree", "D", "degree of the patches"},
    {KEY_RECT, "rect", "X0,Y0,X1,Y1", "the rectangle"},
    {KEY_CELLS, "cells", "NXxNY", "cells across and up"},
    {'p', "pattern", "NAME", "diagonal, cross or hex"},
    {'m', "model", "FILE", "a grid around this model"},
    {KEY_VERBOSE, "verbose", "[=N]", "say more"},
    {'n', "dry-run", NULL, "change nothing"},
    {'o', "output", "FILE", "write to FILE"},
    {0},
};
static const struct cli_program program = {.name = "prog",
                                           .synopsis = "[OPTION]... [A] [B]",
                                           .options = options,
                                           .epilogue = "examples:\n  prog a\n  prog b\n"};
static const char *const patterns[] = {"diagonal", "cross", "hex", NULL};

/* Splits a line at blanks into a command line of the program; '_' stands for a blank in a word. */
struct line {
    char text[400];
    char *argv[40];
    struct cli cli;
    struct err err;
};

static void start(struct line *l, const char *words) {
    int argc = 1;
    char *rest = NULL;
    *l = (struct line){.argv = {(char *)(uintptr_t) "prog"}};
    snprintf(l->text, sizeof l->text, "%s", words);
    for (char *w = strtok_r(l->text, " ", &rest); w; w = strtok_r(NULL, " ", &rest)) {
        for (char *c = w; *c; c++)
            if (*c == '_') *c = ' ';
        l->argv[argc++] = w;
    }
    cli_init(&l->cli, &program, argc, l->argv);
}

static int next(struct line *l) {
    return cli_next(&l->cli, &l->err);
}

static void test_options_and_operands(void **unused) {
    struct line l;
    (void)unused;
    for (int round = 0; round < 2; round++) { /* getopt forgets the first */
        start(&l, "a -d 5 --rect=1,2,3,4 b -np hex --verb --verbose=3 -- -x");
        assert_int_equal(next(&l), 'd');
        assert_string_equal(l.cli.value, "5");
        assert_int_equal(next(&l), KEY_RECT);
        assert_string_equal(l.cli.value, "1,2,3,4");
        assert_int_equal(next(&l), 'n');
        assert_null(l.cli.value);
        assert_int_equal(next(&l), 'p');
        assert_string_equal(l.cli.value, "hex");
        assert_int_equal(next(&l), KEY_VERBOSE);
        assert_null(l.cli.value);
        assert_int_equal(next(&l), KEY_VERBOSE);
        assert_string_equal(l.cli.value, "3");
        assert_int_equal(next(&l), CLI_END);
        assert_int_equal(l.cli.operand_count, 3);
        assert_string_equal(cli_operand(&l.cli, 0), "a");
        assert_string_equal(cli_operand(&l.cli, 2), "-x");
        assert_string_equal(cli_operand(&l.cli, 3), "-");
        assert_int_equal(l.err.kind, ERR_NONE);
    }
}

static void test_misuse(void **unused) {
    static const char *const table[][2] = {
        {"--bogus", "unknown option '--bogus'; try prog --help"},
        {"a --bogus=3 b", "unknown option '--bogus=3'; try prog --help"},
        {"--ver", "unknown option '--ver'; try prog --help"}, /* --verbose or --version */
        {"-x", "unknown option '-x'; try prog --help"},
        {"a b -nxd c", "unknown option '-x'; try prog --help"},
        {"-d", "missing argument of '-d'; try prog --help"},
        {"a -nd", "missing argument of '-d'; try prog --help"},
        {"a --degree", "missing argument of '--degree'; try prog --help"},
        {"--dry-run=yes", "surplus argument of '--dry-run=yes'; try prog --help"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct line l;
        int key;
        start(&l, table[i][0]);
        while ((key = next(&l)) >= 0) {
        }
        assert_int_equal(key, CLI_STOP);
        assert_int_equal(l.err.kind, ERR_USAGE);
        assert_string_equal(l.err.message, table[i][1]);
    }
}

/* Reads the value of the only option by its kind. */
static bool read_value(struct line *l, double *x, int64_t *n) {
    int index;
    switch (next(l)) {
    case 'd':
        return cli_int(&l->cli, 1, 15, n, &l->err);
    case KEY_RECT:
        return cli_doubles(&l->cli, 4, x, &l->err);
    case KEY_CELLS:
        return cli_cells(&l->cli, 1000, n, &l->err);
    case 'p':
        return cli_choice(&l->cli, patterns, &index, &l->err) && (*n = index, true);
    case KEY_VERBOSE:
        return cli_double(&l->cli, 0, 2.5, x, &l->err);
    default:
        return false;
    }
}

static void test_sets_of_names(void **unused) {
    static const struct {
        const char *line;
        unsigned set; /* 0: refused */
    } table[] = {{"-p hex", 4},           {"-p cross,diagonal", 3},
                 {"-p hex,hex", 4},       {"-p hex,", 0},
                 {"-p ,hex", 0},          {"-p he", 0},
                 {"-p diagonal,hexx", 0}, {"-p diagonal,cross,hex", 7}};
    (void)unused;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct line l;
        unsigned set = 0;
        start(&l, table[i].line);
        assert_int_equal(next(&l), 'p');
        assert_int_equal(cli_names(&l.cli, patterns, &set, &l.err), table[i].set != 0);
        assert_int_equal(set, table[i].set);
        if (set == 0) assert_non_null(strstr(l.err.message, "of diagonal, cross, hex, got '"));
    }
}

static void test_values(void **unused) {
    struct line l;
    double x[4];
    int64_t n[2];
    (void)unused;
    start(&l, "--rect -1.5,+2,1e3,.25");
    assert_true(read_value(&l, x, n));
    assert_true(x[0] == -1.5 && x[1] == 2 && x[2] == 1000 && x[3] == 0.25);
    start(&l, "-d15");
    assert_true(read_value(&l, x, n) && n[0] == 15);
    start(&l, "--cells 16x1000");
    assert_true(read_value(&l, x, n) && n[0] == 16 && n[1] == 1000);
    start(&l, "-p cross");
    assert_true(read_value(&l, x, n) && n[0] == 1);
    start(&l, "--verbose=2.5");
    assert_true(read_value(&l, x, n) && x[0] == 2.5);
}

static void test_bad_values(void **unused) {
    static const char *const table[][3] = {
        {"-d", "degree", "an integer in 1..15"},
        {"--rect=", "rect", "4 numbers separated by commas (X0,Y0,X1,Y1)"},
        {"--cells=", "cells", "two integers in 1..1000 as in 16x12"},
        {"-p", "pattern", "one of diagonal, cross, hex"},
        {"--verbose=", "verbose", "a number in 0..2.5"},
    };
    static const char *const values[][16] = {
        {"0", "16", "-1", "5.0", "5x", "0x5", "99999999999999999999", "1e1", "5,", "_5"},
        {"1,2,3", "1,2,3,4,5", "1,2,3,4,", "1,,3,4", "1;2;3;4", "1,2,3,nan", "1,2,3,1e999",
         "1,2,3,4_", "a", "1,2,3,0x4"},
        {"16", "16x", "x12", "16x12x3", "16,12", "0x12", "16x0", "-1x2", "16x1001", "16X12",
         "99999999999999999999x1"},
        {"Hex", "he", "hexa", "_hex"},
        {"2.6", "-0.1", "nan", "inf", "1e999", "1,5", "1_"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        for (const char *const *v = values[i]; *v; v++) {
            struct line l;
            char words[100], want[300], value[40];
            double x[5];
            int64_t n[2];
            snprintf(words, sizeof words, "%s%s", table[i][0], *v);
            start(&l, words);
            if (read_value(&l, x, n)) fail_msg("%s was taken", words);
            snprintf(value, sizeof value, "%s", *v);
            for (char *c = value; *c; c++)
                if (*c == '_') *c = ' ';
            snprintf(want, sizeof want, "--%s: expected %s, got '%s'; try prog --help", table[i][1],
                     table[i][2], value);
            assert_string_equal(l.err.message, want);
            assert_int_equal(l.err.kind, ERR_USAGE);
        }
}

static void test_operand_counts(void **unused) {
    static const struct {
        const char *words;
        int min, max;
        const char *message; /* NULL: fine */
    } table[] = {
        {"", 0, 1, NULL},
        {"a", 1, 1, NULL},
        {"a -", 1, 2, NULL},
        {"a", 1, 2, NULL},
        {"", 0, 0, NULL},
        {"", 1, 2, "missing operand; usage: prog [OPTION]... [A] [B]"},
        {"a b c", 1, 2, "surplus operand 'c'; try prog --help"},
        {"- -", 1, 2, "two inputs from stdin; usage: prog [OPTION]... [A] [B]"},
        {"-", 1, 2, "two inputs from stdin; usage: prog [OPTION]... [A] [B]"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct line l;
        bool ok;
        start(&l, table[i].words);
        assert_int_equal(next(&l), CLI_END);
        ok = cli_check_operands(&l.cli, table[i].min, table[i].max, &l.err);
        assert_int_equal(ok, table[i].message == NULL);
        if (!ok) {
            assert_string_equal(l.err.message, table[i].message);
            assert_int_equal(l.err.kind, ERR_USAGE);
        }
    }
}

static void check_history(const char *words, const char *want) {
    struct line l;
    char *text;
    start(&l, words);
    while (next(&l) >= 0) {
    }
    text = cli_history(&l.cli, &l.err);
    assert_non_null(text);
    assert_string_equal(text, want);
    free(text);
}

static void test_history(void **unused) {
    (void)unused;
    check_history("", "prog");
    check_history("-d5 -o out.grid b/a.grid", "prog --degree 5 a.grid");
    check_history("x.edits --output=out.grid -", "prog x.edits");
    check_history("-m /a/b/worm.obj -n", "prog --model worm.obj --dry-run");
    check_history("--verb --verbose=2 c/", "prog --verbose --verbose=2 c/");
    check_history("-p move_@0,0 -p ^1 -p a*",
                  "prog --pattern 'move @0,0' --pattern ^1 --pattern 'a*'");
    check_history("-p it's -p a\nb\x7f.", "prog --pattern 'it'\\''s' --pattern 'a b .'");
    check_history("-p # -- -q a", "prog --pattern '#' -q a");
}

/* The quoted words mean to a shell what they were. */
static void test_history_is_shell(void **unused) {
    static const char chars[] = "ab'\"\\$`!*?[]{}()<>|;&~#=^%@:, ";
    (void)unused;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(100); seed++) {
        uint64_t state = seed;
        struct line l;
        char word[20] = "", command[200], got[100] = "";
        size_t n = 1 + random_bits(&state) % 15;
        for (size_t i = 0; i < n; i++) word[i] = chars[random_bits(&state) % (sizeof chars - 1)];
        start(&l, "--pattern=_");
        l.argv[1] = l.text;
        snprintf(l.text, sizeof l.text, "--pattern=%s", word);
        while (next(&l) >= 0) {
        }
        char *text = cli_history(&l.cli, &l.err);
        check_seed(seed, text && strncmp(text, "prog --pattern ", 15) == 0);
        snprintf(command, sizeof command, "printf %%s %s", text + 15);
        FILE *shell = popen(command, "r");
        check_seed(seed, shell && fread(got, 1, sizeof got - 1, shell) == n);
        check_seed(seed, pclose(shell) == 0 && strcmp(got, word) == 0);
        free(text);
    }
}

/* Runs cli_next and cli_finish in a child whose stdout is the given file and whose stderr comes
 * back as text. Returns the exit status. */
static int run_child(const char *words, const char *out, struct err err, char *text, size_t room) {
    int ends[2], status;
    size_t length;
    pid_t child;
    assert_int_equal(pipe(ends), 0);
    fflush(stdout);
    child = fork();
    if (child == 0) {
        struct line l;
        dup2(ends[1], STDERR_FILENO);
        if (!freopen(out, "w", stdout)) _exit(99);
        start(&l, words);
        l.err = err;
        while (next(&l) >= 0) {
        }
        _exit(cli_finish(&l.cli, &l.err));
    }
    close(ends[1]);
    FILE *from = fdopen(ends[0], "r");
    assert_non_null(from);
    length = fread(text, 1, room - 1, from);
    text[length] = '\0';
    fclose(from);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void test_finish(void **unused) {
    char text[2000];
    struct err none = {0}, placed = {0}, wild = {0};
    (void)unused;
    assert_int_equal(run_child("a", "/dev/null", none, text, sizeof text), 0);
    assert_string_equal(text, "");
    err_set_at(&placed, ERR_REFUSAL, "a.grid", 3, 5, "expected x");
    assert_int_equal(run_child("a", "/dev/null", placed, text, sizeof text), 3);
    assert_string_equal(text, "prog: a.grid:3:5: expected x\n");
    err_set_at(&wild, ERR_INPUT, "a\nb", 3, 0, "x\ty\x7f");
    assert_int_equal(run_child("a", "/dev/null", wild, text, sizeof text), 1);
    assert_string_equal(text, "prog: a b:3: x y \n");
    assert_int_equal(run_child("--help", "/dev/full", none, text, sizeof text), 1);
    assert_string_equal(text, "prog: cannot write <stdout>: No space left on device\n");
    assert_int_equal(run_child("--help", "/dev/null", none, text, sizeof text), 0);
    assert_int_equal(run_child("-V", "/dev/full", none, text, sizeof text), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_options_and_operands),
        cmocka_unit_test(test_misuse),
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_sets_of_names),
        cmocka_unit_test(test_bad_values),
        cmocka_unit_test(test_operand_counts),
        cmocka_unit_test(test_history),
        cmocka_unit_test(test_history_is_shell),
        cmocka_unit_test(test_finish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
