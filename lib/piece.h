/* SPDX-License-Identifier: GPL-3.0-or-later */
/* piece - a triangular part of a plane Bezier patch, and the point of it that goes to a given one.
 *
 *   f(b) = c + b1 s1 + b2 s2 + e(b)
 *
 * b are barycentric coordinates in the piece, c = f(1,0,0) its first corner, s1, s2 lead to the
 * other two, and e, its bend, is a Bezier form that vanishes there (but for rounding: c, s1, s2 are
 * doubles, and e makes up for that). Call T the triangle c, c+s1, c+s2. As a map of T,
 *
 *   G(w) = w + e(w),    w = c + b1 s1 + b2 s2 in T,    dG = I + K,    K = (de/db1, de/db2) (s1
 * s2)^-1
 *
 * The coefficients of K are differences of those of e; the largest norm of theirs, kappa, bounds
 * |K| on all of T. A piece with kappa <= 1/4 is called tame. Then G is one-to-one on T, and
 *
 *   |w* - (w + r)| <= ratio |r|,    r = q - G(w),    ratio = kappa / (1 - kappa) <= 1/3       (1)
 *
 * for the w* with G(w*) = q, if T has one. Newton's step from w followed by the nearest point of T
 * brings w nearer to w*, by a factor of at least 2 kappa / (1 - kappa) <= 2/3, and converges
 * quadratically. So it finds w*, or (1) proves that there is none: w + r lies too far outside T.
 * A piece that is not tame is halved. Halving again and again ends with tame pieces, or with flat
 * ones: |e| so small that f is c + b1 s1 + b2 s2 to all intents, be T a triangle, a segment or a
 * point.
 *
 * All lengths here are those of one patch among others with coordinates below 2 in magnitude. */
#ifndef PIECE_H
#define PIECE_H

#include "dd.h"

#include <stdbool.h>

enum {
    PIECE_DEGREE_MAX = 15,
    PIECE_SIZE_MAX = (PIECE_DEGREE_MAX + 1) * (PIECE_DEGREE_MAX + 2) / 2,
};
#define PIECE_NEAR 0x1p-52 /* a residual that rounding may explain */

/* The Bezier net of a piece, in the order of grid_patch, and where it lies in its patch. */
struct piece_net {
    struct dd (*q)[2];
    double place[3][3]; /* barycentric coordinates of the piece's corners */
};

/* Distances are from the lines through two corners of T, positive on the side of the third:
 * d_l = normal[l] . (p - corner), less `offset` for l = 0, opposite the first corner. */
struct piece {
    double normal[3][2];    /* of length 1, or 0 where two corners coincide */
    double low[3], high[3]; /* normal . (q - corner) of all control points and what is near them */
    double corner[2], side[2][2]; /* c, s1, s2 */
    double offset;
    double height[3]; /* of T over its edges; not positive: T is flat or turned over */
    double ratio;     /* of (1), in a tame piece */
    double place[3][3];
    bool tame, flat;
    int longest; /* the edge to be halved, if neither */
};

/* All of a piece but tame, flat, ratio and longest. `slack` is how near the hull of the control
 * points a point must be to be looked at; it also covers rounding, so slack >= 2^-49. */
void piece_frame(struct piece *p, int degree, const struct piece_net *net, double slack);

/* The rest of it, and the coefficients of its bend, two a control point. */
void piece_bend(struct piece *p, int degree, const struct piece_net *net, double (*bend)[2]);

/* False: q is not within `slack` of f. */
static inline bool piece_is_near(const struct piece *p, const double q[2]) {
    double x = q[0] - p->corner[0], y = q[1] - p->corner[1];
    double d0 = p->normal[0][0] * x + p->normal[0][1] * y;
    double d1 = p->normal[1][0] * x + p->normal[1][1] * y;
    double d2 = p->normal[2][0] * x + p->normal[2][1] * y;
    return (d0 >= p->low[0]) & (d0 <= p->high[0]) & (d1 >= p->low[1]) & (d1 <= p->high[1]) &
           (d2 >= p->low[2]) & (d2 <= p->high[2]);
}

/* False: q is not within `slack` of the box of the control points. To all edges of a needle, what
 * is beyond its ends is near. */
bool piece_box_is_near(int degree, const struct piece_net *net, const double q[2], double slack);

/* Where a tame or flat piece takes the value q: b >= 0 with sum 1, and *miss = |f(b) - q|, 0 if
 * that is nothing but rounding. False: f is proved to stay farther than slack / 2 from q. */
bool piece_solve(const struct piece *p, int degree, const double (*bend)[2], const double q[2],
                 double slack, double b[3], double *miss);

/* The nets of both halves, cut through the middle of edge l, opposite corner l. */
void piece_halve(int degree, const struct piece_net *net, int l, struct piece_net half[2]);

/* Twice the area of the triangle of two vectors. */
static inline double piece_area(const double a[2], const double b[2]) {
    return a[0] * b[1] - a[1] * b[0];
}

#endif
