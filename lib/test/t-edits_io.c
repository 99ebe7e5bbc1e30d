/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parser: what it reads is written back and compared, statement by statement; every refusal has
 * its place and message. */
#include "edits_io.h"

#include "points_io.h"
#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool parse(struct script *script, const char *text, struct err *err) {
    return edits_parse(script, "test", text, strlen(text), err);
}

/* ---- round trips ---- */

static const struct {
    const char *text, *canonical; /* NULL: the same */
} statements[] = {
    {"move @12.5,-3 by 4 1.5 reach 3", NULL},
    {"move 17 23    by 4 1.5 within 2.5", "move 17 23 by 4 1.5 within 2.5"},
    {"move   12:0,2,3 to 130.5 41 # mandatory", "move 12:0,2,3 to 130.5 41"},
    {"move v@10,0 from 10 0 to 12 3 with 40-45", NULL},
    {"rotate @0,0 about 0 0 by 30 reach 8", "rotate @0,0 about 0 0 by 30 reach 8"},
    {"scale ^0,0 by 1.5 about 0 0 reach 5", "scale ^0,0 about 0 0 by 1.5 reach 5"},
    {"raise top @3,4 by 2 reach 4", NULL},
    {"raise bottom v^1e3,+4 to -2 within 0", "raise bottom v^1000,4 to -2 within 0"},
    {"raise both v:7 by 0", NULL},
    {"pin box:5,5,0,-0", "pin box:0,-0,5,5"},
    {"unpin 40-41 40-40 41", "unpin 40-41 40 41"},
    {"weight 5e-1 all", "weight 0.5 all"},
    {"move all with all within 3 reach 0 to 1 2 from 0 0",
     "move all from 0 0 to 1 2 reach 0 within 3 with all"},
    {"move 1 with 2 v:3 @4,5 by 1 2", "move 1 by 1 2 with 2 v:3 @4,5"},
    {"move 1 reach 2147483647 by -0 5e-324", "move 1 by -0 5e-324 reach 2147483647"},
    {"suggest 95 to 3 4", NULL},
    {"suggest 95 96 by 3 4", NULL},
    {"suggest 95 from 1 1 to 3 4", NULL},
    {"\tpin\t4294967294 0:0,0,4294967294\r", "pin 4294967294 0:0,0,4294967294"},
};

static char *text_of(const struct script *script, size_t i) {
    struct err err;
    char *text = edits_text(script, &script->statement[i], &err);
    assert_non_null(text);
    return text;
}

static void test_statements(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++) {
        const char *want = statements[i].canonical ? statements[i].canonical : statements[i].text;
        struct script script;
        struct err err;
        char *text;
        assert_true(parse(&script, statements[i].text, &err));
        assert_int_equal(script.statement_count, 1);
        assert_int_equal(script.block_count, 1);
        text = text_of(&script, 0);
        assert_string_equal(text, want);
        script_free(&script);
        assert_true(parse(&script, text, &err));
        free(text);
        text = text_of(&script, 0);
        assert_string_equal(text, want);
        free(text);
        script_free(&script);
    }
}

static void test_values(void **unused) {
    struct script s;
    struct err err;
    (void)unused;
    assert_true(parse(&s,
                      "move 3-5 box:4,3,2,1 from 1 2 to 3 4 reach 6 within 7 with v^8,9\n"
                      "\n  raise both 1:2,3,4 by 5\n",
                      &err));
    assert_int_equal(s.statement[0].target, SCRIPT_FROM_TO);
    assert_true(s.statement[0].from[1] == 2 && s.statement[0].to[0] == 3);
    assert_int_equal(s.statement[0].reach, 6);
    assert_true(s.statement[0].within == 7);
    assert_int_equal(s.statement[0].points.count, 2);
    assert_int_equal(s.statement[0].with.count, 1);
    assert_int_equal(s.selector[0].range.last, 5);
    assert_int_equal(s.selector[0].col, 6);
    assert_true(s.selector[1].box.lo[0] == 2 && s.selector[1].box.hi[1] == 3);
    assert_true(s.selector[2].nearest.nominal && s.selector[2].nearest.corner);
    assert_int_equal(s.statement[1].line, 3);
    assert_int_equal(s.statement[1].col, 3);
    assert_true(s.statement[1].bottom && s.statement[1].top && s.statement[1].by[0] == 5);
    assert_int_equal(s.selector[3].place.triangle, 1);
    assert_int_equal(s.selector[3].place.weight[2], 4);
    script_free(&s);
}

static void test_blocks(void **unused) {
    struct script s;
    struct err err;
    (void)unused;
    assert_true(parse(
        &s, "pin 1\nbegin # together\nmove 2 by 1 1\nsuggest 3 to 1 1\n end\nmove 4 by 0 0", &err));
    assert_int_equal(s.block_count, 3);
    assert_int_equal(s.block[1].first, 1);
    assert_int_equal(s.block[1].count, 2);
    assert_true(s.block[1].grouped && !s.block[0].grouped);
    assert_int_equal(s.block[1].line, 2);
    assert_int_equal(s.block[2].first, 3);
    script_free(&s);
    assert_true(parse(&s, "", &err));
    assert_int_equal(s.block_count, 0);
    script_free(&s);
}

/* Random statements, written by the test, read, and written by the library. */
static void put_random_word(FILE *to, uint64_t *state) {
    int a = (int)random_in(state, 0, 99), b = (int)random_in(state, 100, 999);
    switch (random_in(state, 0, 7)) {
    case 0:
        fprintf(to, " %d", a);
        break;
    case 1:
        fprintf(to, " %d-%d", a, b);
        break;
    case 2:
        fprintf(to, " %d:%d,%d,%d", a, b, a, b);
        break;
    case 3:
        fprintf(to, " v:%d", a);
        break;
    case 4:
        fprintf(to, " @%d.5,-%d", a, b);
        break;
    case 5:
        fprintf(to, " v^%d,-0.%d1", a, b);
        break;
    case 6:
        fprintf(to, " box:-%d,%d,%d,%d", b, a, a, b);
        break;
    default:
        fprintf(to, " all");
    }
}

static void put_random_statement(FILE *to, uint64_t *state) {
    static const char *const heads[] = {"move", "rotate", "scale", "raise top", "raise bottom"};
    static const char *const targets[] = {" by 1.5 -2", " about 3 4.25 by -30",
                                          " about 0 -1 by 0.125", " to 7", " by -7"};
    int verb = (int)random_in(state, 0, 4), words = (int)random_in(state, 1, 4);
    fputs(heads[verb], to);
    while (words-- > 0) put_random_word(to, state);
    fputs(targets[verb], to);
    if (random_in(state, 0, 1)) fprintf(to, " reach %d", (int)random_in(state, 0, 1000));
    if (random_in(state, 0, 1)) fprintf(to, " within %d.25", (int)random_in(state, 0, 1000));
    if (random_in(state, 0, 1)) {
        fputs(" with", to);
        put_random_word(to, state);
    }
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(5000); n++) {
        uint64_t state = (uint64_t)n;
        char *text = NULL, *again;
        size_t size;
        struct script script;
        struct err err;
        FILE *to = open_memstream(&text, &size);
        put_random_statement(to, &state);
        fclose(to);
        check_seed((uint64_t)n, parse(&script, text, &err));
        again = text_of(&script, 0);
        assert_string_equal(again, text);
        free(text);
        free(again);
        script_free(&script);
    }
}

/* ---- refusals ---- */

#define MOVE_CLAUSES "a clause of move (by, to, from, reach, within, with)"
#define VERBS        "move, rotate, scale, raise, suggest, pin, unpin, weight, begin or end"

static const struct {
    const char *text;
    size_t line, col;
    const char *message;
} bad[] = {
    {"\n mvoe 1 by 1 2", 2, 2, "expected " VERBS ", got 'mvoe'"},
    {"move", 1, 5, "expected POINTS, got end of line"},
    {"move by 1 2", 1, 6, "expected POINTS, got 'by'"},
    {"move x by 1 2", 1, 6, "expected POINTS, got 'x'"},
    {"move 1 x by 1 2", 1, 8, "expected POINTS or " MOVE_CLAUSES ", got 'x'"},
    {"move 1 about 1 2", 1, 8, "expected the end of the line or " MOVE_CLAUSES ", got 'about'"},
    {"move 1 by 1 2 3", 1, 15, "expected the end of the line or " MOVE_CLAUSES ", got '3'"},
    {"move 1 by 1", 1, 12, "expected a displacement DX DY, got end of line"},
    {"move 1 by 1 nan", 1, 13, "expected a displacement DX DY, got 'nan'"},
    {"move 1 by 1 1e999", 1, 13, "expected a displacement DX DY, got a number that is too large"},
    {"move 1", 1, 7, "expected 'by', 'to' or 'from', got end of line"},
    {"move 1 reach 3", 1, 15, "expected 'by', 'to' or 'from', got end of line"},
    {"move 1 from 1 2", 1, 16, "expected 'to' with 'from', got end of line"},
    {"move 1 by 1 2 to 3 4", 1, 15, "expected either 'by' or 'to', got both"},
    {"move 1 from 3 4 by 1 2", 1, 17, "expected either 'by' or 'to', got both"},
    {"move 1 by 1 2 by 1 2", 1, 15, "expected each clause once, got a second 'by'"},
    {"move 1 reach 1 by 1 2 reach 1", 1, 23, "expected each clause once, got a second 'reach'"},
    {"move 1 by 1 2 reach -1", 1, 21, "expected a number of steps in 0..2147483647, got '-1'"},
    {"move 1 by 1 2 reach 1.5", 1, 21, "expected a number of steps in 0..2147483647, got '1.5'"},
    {"move 1 by 1 2 within -0.5", 1, 22, "expected a distance >= 0, got '-0.5'"},
    {"move 1 by 1 2 with", 1, 19, "expected POINTS, got end of line"},
    {"move 1 by 1 2 with reach 3", 1, 20, "expected POINTS, got 'reach'"},
    {"rotate 1 by 30", 1, 15, "expected 'about', got end of line"},
    {"rotate 1 about 1 2", 1, 19, "expected 'by', got end of line"},
    {"rotate 1 about 1 by 30", 1, 18, "expected a position X Y, got 'by'"},
    {"scale 1 about 0 0 by 0", 1, 22, "expected a factor > 0, got '0'"},
    {"scale 1 about 0 0 by -2", 1, 22, "expected a factor > 0, got '-2'"},
    {"raise 1 by 2", 1, 7, "expected 'top', 'bottom' or 'both', got '1'"},
    {"raise both 1 to 2", 1, 14, "expected 'by' after 'both', got 'to'"},
    {"raise both 1", 1, 13, "expected 'by', got end of line"},
    {"raise top 1", 1, 12, "expected 'by' or 'to', got end of line"},
    {"weight 0 1", 1, 8, "expected a weight > 0, got '0'"},
    {"weight all", 1, 8, "expected a weight > 0, got 'all'"},
    {"pin 1 by 2", 1, 7, "expected the end of the line, got 'by'"},
    {"pin 1 2 y", 1, 9, "expected POINTS, got 'y'"},
    {"pin 5-3", 1, 5, "expected POINT, FIRST-LAST or TRIANGLE:I,J,K, got '5-3'"},
    {"pin 5-", 1, 5, "expected POINT, FIRST-LAST or TRIANGLE:I,J,K, got '5-'"},
    {"pin 4294967295", 1, 5, "expected POINT, FIRST-LAST or TRIANGLE:I,J,K, got '4294967295'"},
    {"pin 5:1,2", 1, 5, "expected POINT, FIRST-LAST or TRIANGLE:I,J,K, got '5:1,2'"},
    {"pin 5:1,2,-3", 1, 5, "expected POINT, FIRST-LAST or TRIANGLE:I,J,K, got '5:1,2,-3'"},
    {"pin 5:1,2,3,4", 1, 5, "expected POINT, FIRST-LAST or TRIANGLE:I,J,K, got '5:1,2,3,4'"},
    {"pin -5", 1, 5, "expected POINTS, got '-5'"},
    {"pin v:", 1, 5, "expected v:VERTEX, got 'v:'"},
    {"pin v7", 1, 5, "expected POINTS, got 'v7'"},
    {"pin @1", 1, 5, "expected @X,Y, got '@1'"},
    {"pin ^1,2,3", 1, 5, "expected ^X,Y, got '^1,2,3'"},
    {"pin v@1,inf", 1, 5, "expected v@X,Y, got 'v@1,inf'"},
    {"pin v^,", 1, 5, "expected v^X,Y, got 'v^,'"},
    {"pin box:1,2,3", 1, 5, "expected box:X0,Y0,X1,Y1, got 'box:1,2,3'"},
    {"pin allx", 1, 5, "expected POINTS, got 'allx'"},
    {"pin inside:", 1, 5, "expected inside:FILE.xy (a file, not stdin), got 'inside:'"},
    {"pin inside:-", 1, 5, "expected inside:FILE.xy (a file, not stdin), got 'inside:-'"},
    {"pin inside:no/such.xy", 1, 12, "cannot open no/such.xy: No such file or directory"},
    {"begin\nbegin", 2, 1, "expected 'end' of the block that begins on line 1, got 'begin'"},
    {"begin 2", 1, 7, "expected the end of the line, got '2'"},
    {"begin\nend", 2, 1, "expected a statement in the block, got 'end'"},
    {"end", 1, 1, "expected a statement, got 'end'"},
    {"begin\nmove 1 by 1 2\nend 2", 3, 5, "expected the end of the line, got '2'"},
    {"begin\nmove 1 by 1 2\n", 3, 1,
     "expected 'end' of the block that begins on line 1, got end of file"},
    {"begin\npin 3\nend", 2, 1, "expected 'pin' before 'begin', got it in a block"},
    {"begin\n weight 3 4\nend", 2, 2, "expected 'weight' before 'begin', got it in a block"},
};

static void test_refusals(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct script script;
        struct err err = {0};
        if (parse(&script, bad[i].text, &err)) fail_msg("accepted: %s", bad[i].text);
        assert_string_equal(err.message, bad[i].message);
        assert_string_equal(err.file, "test");
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
        assert_int_equal(err.kind, ERR_INPUT);
    }
}

/* ---- files ---- */

static bool read_text(struct script *script, const char *text, struct err *err) {
    char path[64];
    FILE *f;
    bool ok;
    snprintf(path, sizeof path, "/tmp/t-edits_io.%ld", (long)getpid());
    f = fopen(path, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    ok = edits_read(script, path, err);
    unlink(path);
    return ok;
}

static void test_files(void **unused) {
    static const struct {
        const char *text, *message;
    } refused[] = {
        {"", "expected 'edits', got end of file"},
        {"# only this\n", "expected 'edits', got end of file"},
        {"move 1 by 1 2\n", "expected 'edits', got 'move'"},
        {"edits 2\n", "expected '1', got '2'"},
        {"edits 1 1\n", "expected the end of the line, got '1'"},
    };
    struct script script;
    struct err err = {0};
    (void)unused;
    assert_true(read_text(&script, "edits 1", &err));
    assert_int_equal(script.block_count, 0);
    script_free(&script);
    assert_true(read_text(&script, "# a\r\n\r\nedits 1 # b\r\nmove 1 by 1 2\r\n", &err));
    assert_int_equal(script.block_count, 1);
    assert_int_equal(script.statement[0].line, 4);
    script_free(&script);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        assert_false(read_text(&script, refused[i].text, &err));
        assert_string_equal(err.message, refused[i].message);
    }
}

/* A polygon is read once, however often it is named. */
static void test_inside(void **unused) {
    char path[64], text[256];
    struct script script;
    struct err err = {0};
    FILE *f;
    (void)unused;
    snprintf(path, sizeof path, "/tmp/t-inside.%ld", (long)getpid());
    f = fopen(path, "wb");
    assert_non_null(f);
    fputs("0 0\n1 0\n0 1\n", f);
    fclose(f);
    snprintf(text, sizeof text, "pin inside:%s 1 inside:%s\n", path, path);
    assert_true(parse(&script, text, &err));
    unlink(path);
    assert_ptr_equal(script.selector[0].inside.polygon, script.selector[2].inside.polygon);
    assert_int_equal(script.selector[0].inside.polygon->point_count, 3);
    script_free(&script);
}

static void test_words(void **unused) {
    static const char *const points[] = {"17",  "17-45", "all",  "1:2,3,4",  "v:7", "@1,2", "^",
                                         "v@x", "v^1",   "box:", "inside:f", "1,2", "3-"};
    static const char *const files[] = {"a.grid", "./17", "-",      "17.grid", "v",
                                        "allx",   "",     "2worms", "boxes"};
    struct script script;
    struct err err = {0};
    (void)unused;
    for (size_t i = 0; i < sizeof points / sizeof *points; i++)
        assert_true(points_is_word(points[i]));
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        assert_false(points_is_word(files[i]));
    assert_true(script_init(&script, "", &err));
    assert_true(points_parse_word(&script, "17-45", &err));
    assert_int_equal(script.selector[0].range.last, 45);
    assert_false(points_parse_word(&script, "box:1", &err));
    assert_string_equal(err.message, "expected box:X0,Y0,X1,Y1, got 'box:1'");
    assert_int_equal(err.line, 0);
    assert_false(points_parse_word(&script, "1 2", &err));
    assert_false(points_parse_word(&script, "", &err));
    script_free(&script);
}

/* 100,000 statements, in linear time. */
static void test_long(void **unused) {
    enum { N = 100000 };
    char *text = NULL;
    size_t size;
    struct script script;
    struct err err;
    FILE *to = open_memstream(&text, &size);
    (void)unused;
    for (int i = 0; i < N; i++) fprintf(to, "move %d @%d,1 by 1 2 reach 3\n", i, i);
    fclose(to);
    assert_true(edits_parse(&script, "long", text, size, &err));
    assert_int_equal(script.statement_count, N);
    assert_int_equal(script.statement[N - 1].line, N);
    free(text);
    script_free(&script);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_statements), cmocka_unit_test(test_values),
        cmocka_unit_test(test_blocks),     cmocka_unit_test(test_random),
        cmocka_unit_test(test_refusals),   cmocka_unit_test(test_files),
        cmocka_unit_test(test_inside),     cmocka_unit_test(test_words),
        cmocka_unit_test(test_long),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
