/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matched cages: planted answers, and random pairs, of which the definition is checked: given
 * vertices are kept, inserted ones lie on their side, and lengths are divided in one proportion. */
#include "match.h"

#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERTICES_MAX = 60 };

struct list {
    size_t count;
    double vertex[VERTICES_MAX][2];
};

static bool match(struct match *m, const struct list *a, const struct list *b,
                  const struct match_anchor *anchor, size_t n, struct err *err) {
    const double(*const vertex[2])[2] = {a->vertex, b->vertex};
    return match_init(m, vertex, (size_t[2]){a->count, b->count}, anchor, n, err);
}

static const struct list letter = {6, {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
static const struct list square = {4, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}};

/* Both have the perimeter 8. */
static void test_letter_to_square(void **unused) {
    static const double expected[2][6][2] = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                                             {{0, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}}};
    static const uint32_t given[6] = {0, 1, MATCH_INSERTED, 2, MATCH_INSERTED, 3};
    struct match m;
    struct err err;
    (void)unused;
    assert_true(match(&m, &letter, &square, NULL, 0, &err));
    assert_int_equal(m.count, 6);
    for (uint32_t i = 0; i < 6; i++) {
        for (int k = 0; k < 2; k++) assert_memory_equal(m.vertex[k][i], expected[k][i], 16);
        assert_int_equal(m.given[i][0], i);
        assert_int_equal(m.given[i][1], given[i]);
    }
    match_free(&m);
}

/* The corner 2 of the letter goes to corner 2 of the square, and the rest follows. */
static void test_anchors(void **unused) {
    static const struct match_anchor anchor[] = {{{2, 2}}, {{5, 3}}, {{0, 0}}};
    struct match m;
    struct err err;
    (void)unused;
    assert_true(match(&m, &letter, &square, anchor, 3, &err));
    assert_int_equal(m.count, 7); /* 1 of the letter at 2/3 of 0..2, 1 of the square at 1/2 */
    for (size_t i = 0; i < m.count; i++)
        for (size_t n = 0; n < 3; n++)
            assert_int_equal(m.given[i][0] == anchor[n].vertex[0],
                             m.given[i][1] == anchor[n].vertex[1]);
    assert_int_equal(m.given[1][1], 1);
    assert_true(fabs(m.vertex[0][1][0] - 1.5) < 1e-15 && m.vertex[0][1][1] == 0);
    assert_int_equal(m.given[2][0], 1);
    assert_true(m.vertex[1][2][0] == 2 && fabs(m.vertex[1][2][1] - 2.0 / 3) < 1e-15);
    match_free(&m);
}

static void test_refusals(void **unused) {
    static const struct {
        size_t n;
        struct match_anchor anchor[4];
        enum err_kind kind;
        const char *message;
    } bad[] = {
        {1, {{{6, 0}}}, ERR_INPUT, "anchor 6:0: the source has vertices 0 to 5 only"},
        {2, {{{0, 0}}, {{5, 4}}}, ERR_INPUT, "anchor 5:4: the target has vertices 0 to 3 only"},
        {2, {{{1, 0}}, {{1, 2}}}, ERR_REFUSAL, "anchors 1:0 and 1:2 do not go together"},
        {2, {{{1, 2}}, {{3, 2}}}, ERR_REFUSAL, "anchors 1:2 and 3:2 do not go together"},
        {3, {{{5, 1}}, {{3, 2}}, {{0, 0}}}, ERR_REFUSAL, "anchors 5:1 and 0:0 do not go together"},
        {4,
         {{{0, 2}}, {{1, 3}}, {{2, 0}}, {{3, 2}}},
         ERR_REFUSAL,
         "anchors 3:2 and 0:2 do not go together"},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct match m;
        struct err err = {0};
        assert_false(match(&m, &letter, &square, bad[i].anchor, bad[i].n, &err));
        assert_int_equal(err.kind, bad[i].kind);
        if (strncmp(err.message, bad[i].message, strlen(bad[i].message)) != 0)
            fail_msg("'%s', not '%s'", err.message, bad[i].message);
        match_free(&m);
    }
}

static void random_list(struct list *l, uint64_t *state) {
    double x = 0, y = 0;
    l->count = (size_t)random_in(state, 3, VERTICES_MAX);
    for (size_t i = 0; i < l->count; i++) {
        x += random_unit(state) - 0.3;
        y += random_unit(state) + 0.01;
        l->vertex[i][0] = x;
        l->vertex[i][1] = y;
    }
}

/* Anchors in random order, the first pairs of ascending numbers, turned on the target. */
static size_t random_anchors(struct match_anchor *anchor, const struct list *a,
                             const struct list *b, uint64_t *state) {
    size_t least = a->count < b->count ? a->count : b->count;
    size_t n = (size_t)random_in(state, 0, (int64_t)least), i = 0, j = 0, turn;
    for (size_t k = 0; k < n; k++, i++, j++) {
        while (random_in(state, 0, 1) && i + (n - k) < a->count) i++;
        while (random_in(state, 0, 1) && j + (n - k) < b->count) j++;
        anchor[k] = (struct match_anchor){{i, j}};
    }
    turn = (size_t)random_in(state, 0, 100);
    for (size_t k = 0; k < n; k++) anchor[k].vertex[1] = (anchor[k].vertex[1] + turn) % b->count;
    for (size_t k = 0; k < n; k++) {
        size_t other = (size_t)random_in(state, 0, (int64_t)n - 1);
        struct match_anchor swap = anchor[k];
        anchor[k] = anchor[other];
        anchor[other] = swap;
    }
    return n;
}

static double distance(const double *a, const double *b) {
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* All given vertices, in their order, bit for bit. */
static bool keeps(const struct match *m, int k, const struct list *l) {
    uint32_t first = MATCH_INSERTED, expected = 0;
    size_t n = 0;
    for (size_t i = 0; i < m->count; i++) {
        uint32_t v = m->given[i][k];
        if (v == MATCH_INSERTED) continue;
        if (first == MATCH_INSERTED) expected = first = v;
        if (v != expected || memcmp(m->vertex[k][i], l->vertex[v], 16) != 0) return false;
        expected = (expected + 1) % (uint32_t)l->count;
        n++;
    }
    return n == l->count;
}

static bool is_anchor(const struct match *m, size_t i, const struct match_anchor *anchor,
                      size_t n) {
    for (size_t a = 0; a < n; a++)
        if (m->given[i][0] == anchor[a].vertex[0] && m->given[i][1] == anchor[a].vertex[1])
            return true;
    return n == 0 && m->given[i][0] == 0 && m->given[i][1] == 0;
}

/* From anchor to anchor, the lengths of both cages grow in proportion; with inserted vertices
 * beside the side by no more than rounding, the arcs are as long as without. */
static bool is_proportional(const struct match *m, const struct match_anchor *anchor, size_t n) {
    size_t first = 0, arcs = 0;
    while (!is_anchor(m, first, anchor, n)) first++;
    for (size_t i = first; i < first + m->count;) {
        double length[2] = {0, 0}, at[2] = {0, 0};
        size_t end = i;
        do {
            for (int k = 0; k < 2; k++)
                length[k] +=
                    distance(m->vertex[k][end % m->count], m->vertex[k][(end + 1) % m->count]);
            end++;
        } while (!is_anchor(m, end % m->count, anchor, n));
        for (; i < end; i++) {
            for (int k = 0; k < 2; k++)
                at[k] += distance(m->vertex[k][i % m->count], m->vertex[k][(i + 1) % m->count]) /
                         length[k];
            if (fabs(at[0] - at[1]) > 1e-11) return false;
        }
        arcs++;
    }
    return arcs == (n ? n : 1);
}

static double perimeter(const double (*v)[2], size_t n) {
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += distance(v[i], v[(i + 1) % n]);
    return sum;
}

static void check_again(uint64_t seed, const struct match *m, const struct match_anchor *anchor,
                        size_t n) {
    struct match_anchor moved[VERTICES_MAX];
    const double(*const vertex[2])[2] = {(const double(*)[2])m->vertex[0],
                                         (const double(*)[2])m->vertex[1]};
    struct match again;
    struct err err;
    size_t found = 0;
    for (size_t i = 0; i < m->count; i++)
        if (is_anchor(m, i, anchor, n)) moved[found++] = (struct match_anchor){{i, i}};
    check_seed(seed,
               match_init(&again, vertex, (size_t[2]){m->count, m->count}, moved, found, &err));
    check_seed(seed, again.count == m->count);
    for (int k = 0; k < 2; k++)
        check_seed(seed, memcmp(again.vertex[k], m->vertex[k], m->count * 16) == 0);
    match_free(&again);
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(5000); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct list l[2];
        struct match_anchor anchor[VERTICES_MAX];
        struct match m;
        struct err err;
        size_t anchors;
        for (int k = 0; k < 2; k++) random_list(&l[k], &state);
        anchors = random_anchors(anchor, &l[0], &l[1], &state);
        check_seed(seed, match(&m, &l[0], &l[1], anchor, anchors, &err));
        check_seed(seed, m.given[0][0] == 0);
        for (int k = 0; k < 2; k++) {
            check_seed(seed, keeps(&m, k, &l[k]));
            check_seed(seed, fabs(perimeter((const double(*)[2])m.vertex[k], m.count) -
                                  perimeter((const double(*)[2])l[k].vertex, l[k].count)) < 1e-10);
        }
        check_seed(seed, is_proportional(&m, anchor, anchors));
        check_again(seed, &m, anchor, anchors);
        match_free(&m);
    }
}

/* Cages far from the origin, given clockwise and from anywhere. */
static void test_cages(void **unused) {
    (void)unused;
    for (size_t turn = 0; turn < 4; turn++) {
        double far[6][2], quad[4][2];
        struct cage source, target;
        struct err err = {0};
        for (size_t i = 0; i < 6; i++)
            for (int c = 0; c < 2; c++) far[i][c] = letter.vertex[5 - i][c] / 3 + 1e6;
        for (size_t i = 0; i < 4; i++)
            for (int c = 0; c < 2; c++) quad[i][c] = square.vertex[(7 - i - turn) % 4][c];
        assert_true(cage_init(&source, (const double(*)[2])far, 6, &err));
        assert_true(cage_init(&target, (const double(*)[2])quad, 4, &err));
        assert_true(match_cages(&source, &target, NULL, 0, &err));
        assert_int_equal(source.count, 6); /* the corners of the square all find partners */
        assert_int_equal(target.count, 6);
        assert_true(source.reversed && target.reversed);
        cage_free(&source);
        cage_free(&target);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_letter_to_square),
        cmocka_unit_test(test_anchors),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_cages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
