/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cages against brute force in integers: what is simple, what lies where; numbers as given against
 * the vertices as given; each refusal with its witness. */
#include "cage.h"

#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERTICES_MAX = 40 };

struct list {
    size_t n;
    int64_t xy[VERTICES_MAX][2];
    double vertex[VERTICES_MAX][2];
};

static void to_doubles(struct list *l, double scale) {
    for (size_t i = 0; i < l->n; i++)
        for (int c = 0; c < 2; c++) l->vertex[i][c] = (double)l->xy[i][c] * scale;
}

static int64_t cross(const int64_t a[2], const int64_t b[2], const int64_t c[2]) {
    int64_t d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return (d > 0) - (d < 0);
}

static bool is_on(const int64_t a[2], const int64_t b[2], const int64_t p[2]) {
    return cross(a, b, p) == 0 &&
           (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}

static const int64_t *at(const struct list *l, size_t i) {
    return l->xy[i % l->n];
}

/* Do sides i and j meet elsewhere than where one ends and the next begins? */
static bool do_meet(const struct list *l, size_t i, size_t j) {
    const int64_t *a = at(l, i), *b = at(l, i + 1), *c = at(l, j), *d = at(l, j + 1);
    if (j == i + 1 && !(i == 0 && j + 1 == l->n)) return is_on(a, b, d) || is_on(c, d, a);
    if (i == 0 && j + 1 == l->n) return is_on(a, b, c) || is_on(c, d, b);
    return is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a) || is_on(c, d, b) ||
           (cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0);
}

static bool is_simple(const struct list *l) {
    for (size_t i = 0; i < l->n; i++)
        if (memcmp(at(l, i), at(l, i + 1), sizeof *l->xy) == 0) return false;
    for (size_t i = 0; i < l->n; i++)
        for (size_t j = i + 1; j < l->n; j++)
            if (do_meet(l, i, j)) return false;
    return true;
}

static int64_t area2(const struct list *l) {
    int64_t sum = 0;
    for (size_t i = 0; i < l->n; i++)
        sum += at(l, i)[0] * at(l, i + 1)[1] - at(l, i)[1] * at(l, i + 1)[0];
    return sum;
}

/* Mostly not simple. */
static void random_list(struct list *l, uint64_t *state) {
    l->n = (size_t)random_in(state, 3, 7);
    for (size_t i = 0; i < l->n; i++)
        for (int c = 0; c < 2; c++) l->xy[i][c] = random_in(state, 0, 5);
}

/* A simple list, made of others by exchanging the ends of sides that meet, which shortens it. */
static void random_cage(struct list *l, uint64_t *state) {
    do {
        l->n = (size_t)random_in(state, 3, VERTICES_MAX);
        for (size_t i = 0; i < l->n; i++)
            for (int c = 0; c < 2; c++) l->xy[i][c] = random_in(state, -40, 40);
        for (int round = 0; round < 500 && !is_simple(l); round++)
            for (size_t i = 0; i < l->n; i++)
                for (size_t j = i + 1; j < l->n; j++)
                    for (size_t a = i + 1, b = j; a < b && do_meet(l, i, j); a++, b--) {
                        int64_t t[2];
                        memcpy(t, l->xy[a], sizeof t);
                        memcpy(l->xy[a], l->xy[b], sizeof t);
                        memcpy(l->xy[b], t, sizeof t);
                    }
    } while (!is_simple(l));
}

static void test_simple(void **unused) {
    int sound = 0;
    (void)unused;
    for (int n = 0; n < test_count(20000); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct list l;
        struct cage c;
        struct err err = {0};
        bool ok;
        random_list(&l, &state);
        to_doubles(&l, 0x1p-20);
        ok = is_simple(&l);
        check_seed(seed, cage_init(&c, (const double(*)[2])l.vertex, l.n, &err) == ok);
        check_seed(seed, ok || err.kind == ERR_REFUSAL);
        if (ok) cage_free(&c), sound++;
    }
    assert_true(sound > 0);
}

/* The prepared cage is the given one: counter-clockwise from its lowest vertex, with numbers that
 * lead back; area and lengths. */
static void test_prepared(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(1000); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct list l;
        struct cage c;
        struct err err = {0};
        random_cage(&l, &state);
        to_doubles(&l, 0x1p-3);
        check_seed(seed, cage_init(&c, (const double(*)[2])l.vertex, l.n, &err));
        check_seed(seed, c.reversed == (area2(&l) < 0));
        check_seed(seed, c.area == fabs((double)area2(&l)) / 128);
        for (uint32_t k = 0; k < c.count; k++) {
            uint32_t side = k, back;
            double lambda = (double)random_in(&state, 0, 15) / 16, p[2], q[2], same = lambda;
            check_seed(seed, c.vertex[k][0] >= c.vertex[0][0]);
            cage_point(&c, k, lambda, p);
            cage_to_given(&c, &side, &lambda);
            const double *a = l.vertex[side], *b = l.vertex[(side + 1) % l.n];
            for (int i = 0; i < 2; i++) q[i] = a[i] + lambda * (b[i] - a[i]);
            check_seed(seed, p[0] == q[0] && p[1] == q[1] && lambda < 1);
            back = side;
            cage_from_given(&c, &back, &lambda);
            check_seed(seed, back == k && lambda == same);
        }
        cage_free(&c);
    }
}

/* Wherever the list begins and whichever way it runs, the same cage. */
static void test_canonical(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(300); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct list l;
        struct cage c, d, image;
        struct err err = {0};
        double turned[VERTICES_MAX][2], other[VERTICES_MAX][2];
        bool reversed = random_in(&state, 0, 1);
        random_cage(&l, &state);
        to_doubles(&l, 1);
        size_t shift = (size_t)random_in(&state, 0, (int64_t)l.n - 1);
        for (size_t i = 0; i < l.n; i++) {
            size_t j = reversed ? (shift + l.n - i) % l.n : (shift + i) % l.n;
            memcpy(turned[i], l.vertex[j], sizeof *turned);
            other[i][0] = -3 * turned[i][0]; /* a half turn: begins at another vertex */
            other[i][1] = -3 * turned[i][1];
        }
        check_seed(seed, cage_init(&c, (const double(*)[2])l.vertex, l.n, &err));
        check_seed(seed, cage_init(&d, (const double(*)[2])turned, l.n, &err));
        check_seed(seed, memcmp(c.vertex, d.vertex, l.n * sizeof *c.vertex) == 0);
        check_seed(seed, c.perimeter == d.perimeter && c.diameter == d.diameter);
        check_seed(seed, cage_init_like(&image, (const double(*)[2])other, l.n, &d, &err));
        for (size_t i = 0; i < l.n; i++)
            check_seed(seed, image.vertex[i][0] == -3 * c.vertex[i][0] &&
                                 image.vertex[i][1] == -3 * c.vertex[i][1]);
        cage_free(&image);
        cage_free(&c);
        cage_free(&d);
    }
}

static int winding(const struct list *l, const int64_t p[2]) {
    int turns = 0;
    for (size_t i = 0; i < l->n; i++) {
        const int64_t *a = at(l, i), *b = at(l, i + 1);
        if (is_on(a, b, p)) return 2;
        if (a[1] <= p[1] && b[1] > p[1] && cross(a, b, p) > 0) turns++;
        if (b[1] <= p[1] && a[1] > p[1] && cross(a, b, p) < 0) turns--;
    }
    return turns;
}

static void test_find(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(100); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct list l;
        struct cage c;
        struct err err = {0};
        random_cage(&l, &state);
        to_doubles(&l, 0.5);
        check_seed(seed, cage_init(&c, (const double(*)[2])l.vertex, l.n, &err));
        for (int i = 0; i < 500; i++) {
            int64_t q[2] = {random_in(&state, -42, 42), random_in(&state, -42, 42)};
            double p[2] = {0.5 * (double)q[0], 0.5 * (double)q[1]}, lambda = -1, r[2];
            int turns = winding(&l, q);
            uint32_t side = UINT32_MAX;
            enum cage_where where = cage_find(&c, p, &side, &lambda);
            check_seed(seed, (where == CAGE_OUTSIDE) == (turns == 0));
            check_seed(seed, (where == CAGE_ON) == (turns == 2));
            check_seed(seed, cage_has(&c, p) == (turns != 0));
            if (where != CAGE_ON) continue;
            cage_point(&c, side, lambda, r);
            check_seed(seed, lambda < 1 && fabs(r[0] - p[0]) < 1e-14 && fabs(r[1] - p[1]) < 1e-14);
        }
        cage_free(&c);
    }
}

/* Points computed on sides are on the cage or inside; a vertex is the beginning of a side; points
 * a little further out are outside. */
static void test_rounding(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(300); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct list l;
        struct cage c;
        struct err err = {0};
        random_cage(&l, &state);
        to_doubles(&l, 0.1);
        for (size_t i = 0; i < l.n; i++) l.vertex[i][0] += 1e4;
        if (!cage_init(&c, (const double(*)[2])l.vertex, l.n, &err)) continue;
        for (uint32_t k = 0; k < c.count; k++) {
            double lambda = random_unit(&state), found, p[2], out[2], r[2];
            const double *a = c.vertex[k], *b = c.vertex[cage_next(&c, k)];
            uint32_t side;
            cage_point(&c, k, lambda, p);
            if (cage_find(&c, p, &side, &found) == CAGE_ON) {
                cage_point(&c, side, found, r);
                check_seed(seed, fabs(r[0] - p[0]) + fabs(r[1] - p[1]) < 1e-10);
            } else
                check_seed(seed, cage_has(&c, p));
            check_seed(seed, cage_find(&c, a, &side, &found) == CAGE_ON && side == k && found == 0);
            for (int i = 0; i < 2; i++) out[i] = p[i] + (i ? -1e-9 : 1e-9) * (b[1 - i] - a[1 - i]);
            check_seed(seed,
                       cage_has(&c, out) || cage_find(&c, out, &side, &found) == CAGE_OUTSIDE);
        }
        cage_free(&c);
    }
}

static void check_refusal(const double (*v)[2], size_t n, const struct cage *source,
                          const char *message) {
    struct cage c;
    struct err err = {0};
    bool ok = source ? cage_init_like(&c, v, n, source, &err) : cage_init(&c, v, n, &err);
    assert_false(ok);
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message, message);
}

static void test_refusals(void **unused) {
    const double square[][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const double turned[][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const double bow[][2] = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    const double twice[][2] = {{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}};
    const double pinched[][2] = {{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}};
    const double touching[][2] = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
    const double spike[][2] = {{0, 0}, {4, 0}, {2, 0}, {2, 2}};
    const double line[][2] = {{0, 0}, {4, 4}, {2, 2}};
    const double thin[][2] = {{0, 0}, {1, 0}, {1, 1e-15}};
    const double huge[][2] = {{0, 0}, {1e300, 0}, {0, 1e300}};
    const double holed[][2] = {{0, 0}, {1, NAN}, {0, 1}};
    struct cage source;
    struct err err = {0};
    (void)unused;
    check_refusal(square, 2, NULL, "a cage has three vertices or more, got 2");
    check_refusal(holed, 3, NULL, "vertex 1 is not finite");
    check_refusal(twice, 5, NULL, "side 2 has no length: its ends are both at (1, 1)");
    check_refusal(bow, 4, NULL, "the cage is not simple: sides 0 and 2 cross at (1, 1)");
    check_refusal(pinched, 6, NULL, "the cage is not simple: vertices 1 and 4 are both at (2, 1)");
    check_refusal(touching, 5, NULL, "the cage is not simple: vertex 3, at (2, 0), lies on side 0");
    check_refusal(spike, 4, NULL, "the cage is not simple: vertex 2, at (2, 0), lies on side 0");
    check_refusal(line, 3, NULL, "all points lie on a line");
    check_refusal(thin, 3, NULL, "the cage has no area: 5e-16, at a diameter of 1");
    check_refusal(huge, 3, NULL, "the cage is 1e+300 x 1e+300 large, not in 1e-100..1e+100");
    assert_true(cage_init(&source, square, 4, &err));
    check_refusal(touching, 5, &source, "the cage has 5 vertices, but the source has 4");
    check_refusal(turned, 4, &source, "the cage is clockwise, but the source is not");
    cage_free(&source);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_simple),    cmocka_unit_test(test_prepared),
        cmocka_unit_test(test_canonical), cmocka_unit_test(test_find),
        cmocka_unit_test(test_rounding),  cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
