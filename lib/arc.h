/* SPDX-License-Identifier: GPL-3.0-or-later */
/* arc - Bezier curves in the plane, and what their control points prove.
 *
 *   A(t) = sum over i of q_i d!/(i!(d-i)!) (1-t)^(d-i) t^i,  0 <= t <= 1,  1 <= d <= 15
 *
 * A piece is A between two parameters, which are fractions over a power of two, as a curve with
 * control points of its own, by de Casteljau's averages. It lies in the convex hull of these, and
 * its derivative in the cone spanned by their differences. So
 *
 *   monotone: if the differences lie in an open half-plane m.x > 0, then m.A(t) increases, and the
 *             piece does not meet itself. If those of two pieces, of which one begins where the
 *             other ends, lie in one half-plane, then the pieces meet nowhere else.
 *   apart:    pieces do not meet if a line separates their control points.
 *   cross:    let m and n not be parallel: normal to the chord of B, and to that of A. If m.a_0 <
 *             m.b_j < m.a_d and n.b_0 < n.a_i < n.b_d for all i, j, or with either order reversed,
 *             then A(s) = B(t) somewhere within: m.(A(s) - B(t)) and n.(B(t) - A(s)) change signs
 *             between opposite sides of the square of (s,t) (Poincare-Miranda).
 *
 * arc_* decide this in doubles, with proved bounds of their errors: true is a proof, false means
 * nothing. arc_exact_* decide it in integers (GMP), for the directions that they try. */
#ifndef ARC_H
#define ARC_H

#include <gmp.h>
#include <stdbool.h>
#include <stdint.h>

enum { ARC_DEGREE_MAX = 15 };

/* index .. index + 1 over 2^level. Coordinates do not exceed 1 in magnitude. */
struct arc {
    int level;
    uint64_t index; /* level <= 60 */
    double c[ARC_DEGREE_MAX + 1][2];
};

/* Two whole curves, moved and scaled alike so that coordinates reach 1/2 but not 1, each within
 * 2^-52 of what is meant. False if all points are one, or nearer than doubles can tell. */
bool arc_load(int d, const double (*qa)[2], const double (*qb)[2], struct arc *a, struct arc *b);

/* The error of a coordinate of a piece: every halving adds d averages, each of which rounds by
 * 2^-53 at most; twice that is taken. */
static inline double arc_error(int d, int level) {
    return 0x1p-52 * (1 + level * d);
}

void arc_halve(int d, const struct arc *a, struct arc half[2]);

/* The larger side of the bounding box of the control points; their extent normal to the chord. */
double arc_size(int d, const struct arc *a);
double arc_width(int d, const struct arc *a);

/* One piece (b = NULL), or two. */
bool arc_monotone(int d, const struct arc *a, const struct arc *b);
bool arc_apart(int d, const struct arc *a, const struct arc *b);
bool arc_cross(int d, const struct arc *a, const struct arc *b);

/* Control points as integers: coordinates are c 2^exponent, for both arcs of a pair. */
struct arc_integers {
    mpz_t c[ARC_DEGREE_MAX + 1][2];
};
void arc_integers_init(struct arc_integers *x);
void arc_integers_free(struct arc_integers *x);

/* Returns the exponent. */
int arc_integers_load(int d, const double (*qa)[2], const double (*qb)[2], struct arc_integers *a,
                      struct arc_integers *b);

/* The piece between lo and hi over 2^level, times 2^scale; level * d <= scale. */
void arc_integers_piece(int d, const struct arc_integers *whole, const mpz_t lo, const mpz_t hi,
                        unsigned level, unsigned scale, struct arc_integers *piece);

bool arc_exact_monotone(int d, const struct arc_integers *a, const struct arc_integers *b);
bool arc_exact_apart(int d, const struct arc_integers *a, const struct arc_integers *b);
bool arc_exact_cross(int d, const struct arc_integers *a, const struct arc_integers *b);

/* The point at a rational parameter, in units of the integer coordinates. */
void arc_exact_point(int d, const struct arc_integers *a, const mpq_t t, mpq_t point[2]);

#endif
