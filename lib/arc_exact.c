/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A piece's control point j is the blossom of the curve at d - j times the one end and j times the
 * other (Ramshaw): de Casteljau's scheme with another parameter in each round. With parameters n /
 * 2^level, a round multiplies by 2^level:  p_i <- (2^level - n) p_i + n p_i+1. */
#include "arc.h"

#include "rational.h"

void arc_integers_init(struct arc_integers *x) {
    for (int i = 0; i <= ARC_DEGREE_MAX; i++) mpz_inits(x->c[i][0], x->c[i][1], NULL);
}

void arc_integers_free(struct arc_integers *x) {
    for (int i = 0; i <= ARC_DEGREE_MAX; i++) mpz_clears(x->c[i][0], x->c[i][1], NULL);
}

int arc_integers_load(int d, const double (*qa)[2], const double (*qb)[2], struct arc_integers *a,
                      struct arc_integers *b) {
    enum { BOTH = 4 * (ARC_DEGREE_MAX + 1) };
    double x[BOTH] = {0};
    mpz_t m[BOTH];
    int each = 2 * (d + 1), n = 2 * each, exponent;
    for (int i = 0; i < n; i++) {
        x[i] = i < each ? qa[i / 2][i % 2] : qb[(i - each) / 2][i % 2];
        mpz_init(m[i]);
    }
    exponent = rational_integers(n, x, m);
    for (int i = 0; i < n; i++) {
        if (i < each)
            mpz_swap(a->c[i / 2][i % 2], m[i]);
        else
            mpz_swap(b->c[(i - each) / 2][i % 2], m[i]);
        mpz_clear(m[i]);
    }
    return exponent;
}

struct blossom {
    int d;
    mpz_t at[2], rest[2]; /* n and 2^level - n of both ends */
    mpz_t row[ARC_DEGREE_MAX + 1];
    mpz_t term;
};

/* Row 0 becomes control point j. */
static void evaluate(struct blossom *b, int j) {
    for (int k = 1; k <= b->d; k++) {
        int end = k <= j;
        for (int i = 0; i <= b->d - k; i++) {
            mpz_mul(b->term, b->row[i + 1], b->at[end]);
            mpz_mul(b->row[i], b->row[i], b->rest[end]);
            mpz_add(b->row[i], b->row[i], b->term);
        }
    }
}

void arc_integers_piece(int d, const struct arc_integers *whole, const mpz_t lo, const mpz_t hi,
                        unsigned level, unsigned scale, struct arc_integers *piece) {
    struct blossom b = {.d = d};
    mpz_inits(b.at[0], b.at[1], b.rest[0], b.rest[1], b.term, NULL);
    for (int i = 0; i <= d; i++) mpz_init(b.row[i]);
    mpz_set(b.at[0], lo);
    mpz_set(b.at[1], hi);
    for (int end = 0; end < 2; end++) {
        mpz_set_ui(b.rest[end], 1);
        mpz_mul_2exp(b.rest[end], b.rest[end], level);
        mpz_sub(b.rest[end], b.rest[end], b.at[end]);
    }
    for (int j = 0; j <= d; j++)
        for (int c = 0; c < 2; c++) {
            for (int i = 0; i <= d; i++) mpz_set(b.row[i], whole->c[i][c]);
            evaluate(&b, j);
            mpz_mul_2exp(piece->c[j][c], b.row[0], scale - level * (unsigned)d);
        }
    mpz_clears(b.at[0], b.at[1], b.rest[0], b.rest[1], b.term, NULL);
    for (int i = 0; i <= d; i++) mpz_clear(b.row[i]);
}

void arc_exact_point(int d, const struct arc_integers *a, const mpq_t t, mpq_t point[2]) {
    mpq_t row[ARC_DEGREE_MAX + 1], rest, term;
    mpq_inits(rest, term, NULL);
    for (int i = 0; i <= d; i++) mpq_init(row[i]);
    mpq_set_ui(rest, 1, 1);
    mpq_sub(rest, rest, t);
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i <= d; i++) mpq_set_z(row[i], a->c[i][c]);
        for (int k = 1; k <= d; k++)
            for (int i = 0; i <= d - k; i++) {
                mpq_mul(term, row[i + 1], t);
                mpq_mul(row[i], row[i], rest);
                mpq_add(row[i], row[i], term);
            }
        mpq_set(point[c], row[0]);
    }
    mpq_clears(rest, term, NULL);
    for (int i = 0; i <= d; i++) mpq_clear(row[i]);
}

struct vector {
    mpz_t c[2];
};

/* The sign of x cross y, or of the dot product. `term` is room. */
static int cross_sign(const struct vector *x, const struct vector *y, struct vector *term) {
    mpz_mul(term->c[0], x->c[0], y->c[1]);
    mpz_mul(term->c[1], x->c[1], y->c[0]);
    return mpz_cmp(term->c[0], term->c[1]);
}

static int dot_sign(const struct vector *x, const struct vector *y, struct vector *term) {
    mpz_mul(term->c[0], x->c[0], y->c[0]);
    mpz_mul(term->c[1], x->c[1], y->c[1]);
    mpz_add(term->c[0], term->c[0], term->c[1]);
    return mpz_sgn(term->c[0]);
}

/* Widens the cone from *low counter-clockwise to *high, of less than 180 degrees, to hold x; false
 * if that makes it 180 degrees or more. */
static bool widen(const struct vector **low, const struct vector **high, const struct vector *x,
                  struct vector *term) {
    int from_low, from_high;
    if (mpz_sgn(x->c[0]) == 0 && mpz_sgn(x->c[1]) == 0) return true;
    if (!*low) {
        *low = *high = x;
        return true;
    }
    from_low = cross_sign(*low, x, term);
    from_high = cross_sign(*high, x, term);
    if (from_low == 0) return dot_sign(*low, x, term) > 0;
    if (from_high == 0) return dot_sign(*high, x, term) > 0;
    if (from_low < 0 && from_high > 0) return false;
    if (from_low < 0) *low = x;
    if (from_high > 0) *high = x;
    return true;
}

static void vectors_init(int n, struct vector *x) {
    for (int i = 0; i < n; i++) mpz_inits(x[i].c[0], x[i].c[1], NULL);
}

static void vectors_clear(int n, struct vector *x) {
    for (int i = 0; i < n; i++) mpz_clears(x[i].c[0], x[i].c[1], NULL);
}

bool arc_exact_monotone(int d, const struct arc_integers *a, const struct arc_integers *b) {
    struct vector step[2 * ARC_DEGREE_MAX], term;
    const struct vector *low = NULL, *high = NULL;
    int n = b ? 2 * d : d;
    bool ok = true;
    vectors_init(n, step);
    vectors_init(1, &term);
    for (int i = 0; i < n && ok; i++) {
        const struct arc_integers *of = i < d ? a : b;
        for (int c = 0; c < 2; c++) mpz_sub(step[i].c[c], of->c[i % d + 1][c], of->c[i % d][c]);
        ok = widen(&low, &high, &step[i], &term);
    }
    vectors_clear(n, step);
    vectors_clear(1, &term);
    return ok && low;
}

/* Values m.c of the control points of an arc: first, last, least and greatest. */
struct values {
    mpz_t first, last, least, greatest;
};

static void values_along(const struct vector *m, int d, const struct arc_integers *a,
                         struct values *v) {
    mpz_t x;
    mpz_init(x);
    for (int i = 0; i <= d; i++) {
        mpz_mul(x, m->c[0], a->c[i][0]);
        mpz_addmul(x, m->c[1], a->c[i][1]);
        if (i == 0) mpz_set(v->first, x);
        if (i == d) mpz_set(v->last, x);
        if (i == 0 || mpz_cmp(x, v->least) < 0) mpz_set(v->least, x);
        if (i == 0 || mpz_cmp(x, v->greatest) > 0) mpz_set(v->greatest, x);
    }
    mpz_clear(x);
}

static void values_init(struct values *v) {
    mpz_inits(v->first, v->last, v->least, v->greatest, NULL);
}

static void values_clear(struct values *v) {
    mpz_clears(v->first, v->last, v->least, v->greatest, NULL);
}

static void chord_normal(int d, const struct arc_integers *a, struct vector *m) {
    mpz_sub(m->c[0], a->c[0][1], a->c[d][1]);
    mpz_sub(m->c[1], a->c[d][0], a->c[0][0]);
}

/* Along the axes and the normals of both chords. */
bool arc_exact_apart(int d, const struct arc_integers *a, const struct arc_integers *b) {
    struct values va, vb;
    struct vector m;
    bool apart = false;
    values_init(&va);
    values_init(&vb);
    vectors_init(1, &m);
    for (int i = 0; i < 4 && !apart; i++) {
        if (i < 2)
            for (int c = 0; c < 2; c++) mpz_set_ui(m.c[c], c == i);
        else
            chord_normal(d, i == 2 ? a : b, &m);
        values_along(&m, d, a, &va);
        values_along(&m, d, b, &vb);
        apart = mpz_cmp(va.greatest, vb.least) < 0 || mpz_cmp(vb.greatest, va.least) < 0;
    }
    values_clear(&va);
    values_clear(&vb);
    vectors_clear(1, &m);
    return apart;
}

/* Does a go from one side of b to the other, along m? */
static bool passes(int d, const struct arc_integers *a, const struct arc_integers *b,
                   const struct vector *m) {
    struct values va, vb;
    bool passes;
    values_init(&va);
    values_init(&vb);
    values_along(m, d, a, &va);
    values_along(m, d, b, &vb);
    passes = (mpz_cmp(va.first, vb.least) < 0 && mpz_cmp(va.last, vb.greatest) > 0) ||
             (mpz_cmp(va.last, vb.least) < 0 && mpz_cmp(va.first, vb.greatest) > 0);
    values_clear(&va);
    values_clear(&vb);
    return passes;
}

bool arc_exact_cross(int d, const struct arc_integers *a, const struct arc_integers *b) {
    struct vector ma, mb, term;
    bool cross;
    vectors_init(1, &ma);
    vectors_init(1, &mb);
    vectors_init(1, &term);
    chord_normal(d, a, &ma);
    chord_normal(d, b, &mb);
    cross = cross_sign(&ma, &mb, &term) != 0 && passes(d, a, b, &mb) && passes(d, b, a, &ma);
    vectors_clear(1, &ma);
    vectors_clear(1, &mb);
    vectors_clear(1, &term);
    return cross;
}
