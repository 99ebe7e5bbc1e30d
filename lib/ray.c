/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "ray.h"

#include "arc.h"

enum { LEVELS_MAX = 128 };

/* Where control points lie: bits of what is true of each. */
enum { LEFT = 1, RIGHT = 2, HIGH = 4, LOW = 8 };

/* What a piece adds if its control points are `common`; false if that cannot be told. */
static bool add(int common, bool begins_high, bool ends_high, int *winding) {
    if (common & (RIGHT | HIGH | LOW)) return true;
    if (common & LEFT) *winding += begins_high - ends_high;
    return common & LEFT;
}

static int sides_of(int x, int y) {
    return (x < 0 ? LEFT : x > 0 ? RIGHT : 0) | (y > 0 ? HIGH : LOW);
}

static int compare(double a, double b) {
    return (a > b) - (a < b);
}

/* Pieces of the arc, p as a curve that is one point. */
struct search {
    int d;
    struct arc_integers whole, point, piece, at;
    int winding;
};

static bool cross_piece(struct search *s, mpz_t lo, unsigned level) {
    int common = LEFT | RIGHT | HIGH | LOW, sides = 0;
    bool begins_high = false, known;
    mpz_t next;
    unsigned scale = level * (unsigned)s->d;
    mpz_init(next);
    mpz_add_ui(next, lo, 1);
    arc_integers_piece(s->d, &s->whole, lo, next, level, scale, &s->piece);
    for (int c = 0; c < 2; c++) mpz_mul_2exp(s->at.c[0][c], s->point.c[0][c], scale);
    for (int i = 0; i <= s->d; i++) {
        sides = sides_of(mpz_cmp(s->piece.c[i][0], s->at.c[0][0]),
                         mpz_cmp(s->piece.c[i][1], s->at.c[0][1]));
        common &= sides;
        if (i == 0) begins_high = sides & HIGH;
    }
    known = add(common, begins_high, sides & HIGH, &s->winding);
    if (!known && level < LEVELS_MAX) {
        mpz_mul_2exp(lo, lo, 1);
        mpz_add_ui(next, lo, 1);
        known = cross_piece(s, lo, level + 1) && cross_piece(s, next, level + 1);
        mpz_fdiv_q_2exp(lo, lo, 1);
    }
    mpz_clear(next);
    return known;
}

static bool cross_exactly(int d, const double (*q)[2], const double p[2], int *winding) {
    double point[ARC_DEGREE_MAX + 1][2];
    struct search s = {.d = d};
    mpz_t zero;
    bool known;
    for (int i = 0; i <= d; i++)
        for (int c = 0; c < 2; c++) point[i][c] = p[c];
    arc_integers_init(&s.whole);
    arc_integers_init(&s.point);
    arc_integers_init(&s.piece);
    arc_integers_init(&s.at);
    mpz_init(zero);
    (void)arc_integers_load(d, q, (const double(*)[2])point, &s.whole, &s.point);
    known = cross_piece(&s, zero, 0);
    *winding += s.winding;
    mpz_clear(zero);
    arc_integers_free(&s.whole);
    arc_integers_free(&s.point);
    arc_integers_free(&s.piece);
    arc_integers_free(&s.at);
    return known;
}

bool ray_winding(int d, const double (*q)[2], const double p[2], int *winding) {
    int common = LEFT | RIGHT | HIGH | LOW;
    for (int i = 0; i <= d; i++) common &= sides_of(compare(q[i][0], p[0]), compare(q[i][1], p[1]));
    return add(common, q[0][1] > p[1], q[d][1] > p[1], winding) || cross_exactly(d, q, p, winding);
}
