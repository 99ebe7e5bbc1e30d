/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: the lines are planted, so the test knows each of them and where it begins. */
#include "src.h"
#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Opens the text through a pipe or a file, as the tests want both to behave like memory. */
enum way { MEMORY, TEMPORARY, WAYS };

struct input {
    struct src src;
    char path[40];
};

static void open_input(struct input *in, enum way way, const char *text, size_t length) {
    struct err err = {0};
    strcpy(in->path, "/tmp/supple-src-XXXXXX");
    if (way == MEMORY) {
        src_open_text(&in->src, "text", text, length);
        return;
    }
    int fd = mkstemp(in->path);
    FILE *file = fdopen(fd, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
    assert_true(src_open(&in->src, in->path, &err));
    unlink(in->path);
}

static void expect_line(struct src *src, const char *want) {
    size_t length = strlen(want);
    assert_true(src_raw_line(src));
    assert_int_equal(src->raw_end - src->begin, length);
    assert_memory_equal(src->begin, want, length);
}

static void test_lines(void **unused) {
    static const char text[] = "one\r\n\n# two\nthree # 3\r\n\t \nlast";
    (void)unused;
    for (enum way way = MEMORY; way < WAYS; way++) {
        struct input in;
        struct src *src = &in.src;
        open_input(&in, way, text, sizeof text - 1);
        expect_line(src, "one");
        assert_null(src->comment);
        expect_line(src, "");
        expect_line(src, "# two");
        assert_true(src->comment == src->begin && src->at == src->end);
        expect_line(src, "three # 3");
        assert_int_equal(src->comment - src->begin, 6);
        assert_int_equal(src->end - src->begin, 6);
        expect_line(src, "\t ");
        expect_line(src, "last"); /* no final newline */
        assert_int_equal(src->line, 6);
        assert_false(src_raw_line(src));
        assert_true(src->eof && !src->err.kind);
        assert_false(src_raw_line(src));
        assert_int_equal(src->line, 7);
        src_close(src);
    }
}

static void test_skips_lines_without_words(void **unused) {
    struct input in;
    struct src *src = &in.src;
    (void)unused;
    open_input(&in, MEMORY, "\n# c\n \t\r\n a b\n\n", 15);
    assert_true(src_line(src));
    assert_int_equal(src->line, 4);
    assert_true(src_take(src, "a") && !src_take(src, "c") && src_take(src, "b"));
    assert_true(src_end_line(src));
    assert_false(src_line(src));
    assert_true(src->eof && !src->err.kind);
    src_close(src);
}

static void test_empty(void **unused) {
    (void)unused;
    for (enum way way = MEMORY; way < WAYS; way++) {
        struct input in;
        open_input(&in, way, "", 0);
        assert_false(src_line(&in.src));
        assert_true(in.src.eof);
        assert_false(src_expect(&in.src, "grid"));
        assert_string_equal(in.src.err.message, "expected 'grid', got end of file");
        assert_int_equal(in.src.err.line, 1);
        src_close(&in.src);
    }
}

/* Text of random lines, longer and longer ones among them, so that every kind of boundary falls on
 * the ends of what one read gives: inside words, between CR and LF, right behind a line. */
struct planted {
    char *text;
    size_t length, count;
    size_t *start; /* count + 1 */
};

static void plant(struct planted *p, uint64_t seed, size_t total, size_t longest) {
    uint64_t state = seed;
    p->text = malloc(total + longest + 2);
    p->start = malloc((total + 2) * sizeof *p->start);
    assert_true(p->text && p->start);
    p->length = p->count = 0;
    while (p->length < total) {
        size_t n = random_bits(&state) % (random_bits(&state) % 100 ? 40 : longest);
        p->start[p->count++] = p->length;
        for (size_t i = 0; i < n; i++)
            p->text[p->length++] = (char)(random_bits(&state) % 64 ? 'a' + n % 26 : 0);
        if (random_bits(&state) % 2) p->text[p->length++] = '\r';
        p->text[p->length++] = '\n';
    }
    p->start[p->count] = p->length;
}

static size_t planted_length(const struct planted *p, size_t i) {
    size_t end = p->start[i + 1] - 1;
    return end - (end > p->start[i] && p->text[end - 1] == '\r') - p->start[i];
}

static void check_planted(uint64_t seed, enum way way, size_t total, size_t longest) {
    struct planted p;
    struct input in;
    plant(&p, seed, total, longest);
    open_input(&in, way, p.text, p.length);
    for (size_t i = 0; i < p.count; i++) {
        size_t length = planted_length(&p, i);
        check_seed(seed, src_raw_line(&in.src) && in.src.line == i + 1);
        check_seed(seed, (size_t)(in.src.raw_end - in.src.begin) == length);
        check_seed(seed, length == 0 || memcmp(in.src.begin, p.text + p.start[i], length) == 0);
    }
    check_seed(seed, !src_raw_line(&in.src) && in.src.eof && !in.src.err.kind);
    src_close(&in.src);
    free(p.text);
    free(p.start);
}

static void test_chunks(void **unused) {
    (void)unused;
    for (int seed = 1; seed <= test_count(12); seed++) {
        check_planted((uint64_t)seed, TEMPORARY, 5 << 20, 1000);
        check_planted((uint64_t)seed, TEMPORARY, 5 << 20, 3 << 20);
        check_planted((uint64_t)seed, MEMORY, 1 << 18, 1 << 16);
    }
}

/* A line of n characters, n around the powers of two that a buffer may have, then a second one. */
static void test_chunk_boundaries(void **unused) {
    enum { MOST = 1 << 20 };
    char *text = malloc(MOST + 40);
    (void)unused;
    assert_non_null(text);
    for (int power = 1 << 12; power <= MOST; power *= 2)
        for (int n = power - 4; n <= power + 4; n++) {
            struct input in;
            memset(text, 'x', (size_t)n);
            memcpy(text + n, "\r\nsecond", 8);
            open_input(&in, TEMPORARY, text, (size_t)n + 8);
            assert_true(src_raw_line(&in.src));
            assert_int_equal(in.src.raw_end - in.src.begin, n);
            expect_line(&in.src, "second");
            assert_false(src_raw_line(&in.src));
            assert_true(in.src.eof);
            src_close(&in.src);
        }
    free(text);
}

/* What reads, on a line, and the message where it fails. */
static void read_double(struct src *src) {
    double x;
    if (src_double(src, "x", &x)) src_end_line(src);
}

static void read_index(struct src *src) {
    int64_t n;
    if (src_int(src, "a vertex number", 0, 11, &n)) src_end_line(src);
}

static void read_keyword(struct src *src) {
    if (src_expect(src, "grid")) src_end_line(src);
}

static void read_any_int(struct src *src) {
    int64_t n;
    if (src_int(src, "an integer", INT64_MIN, INT64_MAX, &n)) src_end_line(src);
}

static void test_messages(void **unused) {
    static const struct {
        const char *text;
        void (*read)(struct src *);
        size_t col;
        const char *message;
    } table[] = {
        {"  ", read_double, 3, "expected x, got end of line"},
        {"1.5 # fine", read_double, 0, ""},
        {"+1.5e3\t", read_double, 0, ""},
        {" 1.5x", read_double, 2, "expected x, got '1.5x'"},
        {"1,5", read_double, 1, "expected x, got '1,5'"},
        {"\tnan", read_double, 2, "expected x, got 'nan'"},
        {"1e999", read_double, 1, "expected x, got a number that is too large"},
        {"1 2", read_double, 3, "expected the end of the line, got '2'"},
        {"1#2", read_double, 0, ""},
        {"0x1p3", read_double, 1, "expected x, got '0x1p3'"},
        {"\x01\xff'", read_double, 1, "expected x, got '\\x01\\xff''"},
        {"0123456789012345678901234567890123456789", read_keyword, 1,
         "expected 'grid', got '0123456789012345678901234567890123456789'"},
        {"01234567890123456789012345678901234567890", read_keyword, 1,
         "expected 'grid', got '0123456789012345678901234567890123456789...'"},
        {"gri", read_keyword, 1, "expected 'grid', got 'gri'"},
        {"grid1", read_keyword, 1, "expected 'grid', got 'grid1'"},
        {"grid", read_keyword, 0, ""},
        {"11", read_index, 0, ""},
        {"12", read_index, 1, "expected a vertex number in 0..11, got '12'"},
        {"-1", read_index, 1, "expected a vertex number in 0..11, got '-1'"},
        {"1.0", read_index, 1, "expected a vertex number in 0..11, got '1.0'"},
        {"99999999999999999999", read_index, 1,
         "expected a vertex number in 0..11, got '99999999999999999999'"},
        {"99999999999999999999", read_any_int, 1,
         "expected an integer, got a number that is too large"},
        {"-9223372036854775808", read_any_int, 0, ""},
        {"1-", read_any_int, 1, "expected an integer, got '1-'"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct input in;
        open_input(&in, MEMORY, table[i].text, strlen(table[i].text));
        src_raw_line(&in.src);
        table[i].read(&in.src);
        assert_string_equal(in.src.err.message, table[i].message);
        assert_int_equal(in.src.err.col, table[i].col);
        assert_int_equal(in.src.err.kind, table[i].col ? ERR_INPUT : ERR_NONE);
        src_close(&in.src);
    }
}

static void test_nul_bytes(void **unused) {
    static const char text[] = "a\0b 1\0\n2";
    const char *word;
    size_t length = 0;
    struct input in;
    double x;
    (void)unused;
    open_input(&in, MEMORY, text, sizeof text - 1);
    assert_true(src_line(&in.src) && src_word(&in.src, &word, &length));
    assert_int_equal(length, 3);
    assert_false(src_double(&in.src, "x", &x));
    assert_string_equal(in.src.err.message, "expected x, got '1\\x00'");
    assert_int_equal(in.src.err.col, 5);
    src_close(&in.src);
}

static void test_error_sticks(void **unused) {
    struct input in;
    const char *word;
    size_t length;
    int64_t n;
    (void)unused;
    open_input(&in, MEMORY, "1 2\n3\n", 6);
    assert_true(src_line(&in.src));
    assert_false(src_fail(&in.src, in.src.at + 2, "no %d", 7));
    assert_false(src_fail(&in.src, NULL, "later"));
    assert_false(src_expected(&in.src, "more"));
    assert_false(src_int(&in.src, "n", 0, 9, &n));
    assert_false(src_word(&in.src, &word, &length));
    assert_false(src_end_line(&in.src));
    assert_false(src_line(&in.src));
    assert_string_equal(in.src.err.message, "no 7");
    assert_string_equal(in.src.err.file, "text");
    assert_true(in.src.err.line == 1 && in.src.err.col == 3 && !in.src.eof);
    src_close(&in.src);
}

static void test_open_failures(void **unused) {
    struct src src;
    struct err err = {0};
    (void)unused;
    assert_false(src_open(&src, "/no/such/file", &err));
    assert_string_equal(err.message, "cannot open /no/such/file: No such file or directory");
    assert_false(src_open(&src, "/tmp", &err));
    assert_string_equal(err.message, "cannot read /tmp: Is a directory");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_skips_lines_without_words),
        cmocka_unit_test(test_empty),
        cmocka_unit_test(test_chunks),
        cmocka_unit_test(test_chunk_boundaries),
        cmocka_unit_test(test_messages),
        cmocka_unit_test(test_nul_bytes),
        cmocka_unit_test(test_error_sticks),
        cmocka_unit_test(test_open_failures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
