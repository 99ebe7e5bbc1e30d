/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles_motion - where a motion takes points: anchors (theta = 1) and suggestions (theta < 1).
 *
 *      translate    q + theta by
 *      rotate       centre + M (q - centre),  M = ((c, -s), (s, c)), a turn by theta*degrees
 *      scale        the same with M = factor^theta
 *
 * c and s are correctly rounded; the rest is done in double-double and rounded once. So all points
 * of a motion follow the same affine map but for half an ulp each: affine maps keep the C1
 * conditions, roundings on the way would not. Quarter turns are exact where the result is a double.
 */
#ifndef DECLES_MOTION_H
#define DECLES_MOTION_H

#include "decles.h"

struct decles_turn { /* M */
    double c, s;
};

/* M of a motion for theta; (1, 0) for a translation. Some microseconds. */
struct decles_turn decles_turn(const struct decles_motion *motion, double theta);

/* Moves q, k components (k = 2 but for translations), to `to`. Not finite if a number on the way is
 * beyond 2^990. */
void decles_move(const struct decles_motion *motion, double theta, struct decles_turn turn,
                 const double *q, int k, double to[2]);

/* (1 - share) from + share to, within an ulp of it; `from` or `to` itself for share 0 or 1. */
double decles_between(double from, double to, double share);

#endif
