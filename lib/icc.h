/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc - integral curve coordinates.
 *
 * A function on a cage (cage.h) that has one critical point inside, a maximum, names each point p
 * of the cage: the integral line through p, which runs from the cage to the maximum, is named by
 * the place (side, lambda) where it begins, and t says how far along the line p lies. Side k runs
 * from vertex k to vertex k + 1, lambda from 0 to 1 along it.
 *
 *        cage side k, lambda          p            maximum
 *               *---------------------*---------------*
 *             t = 1                   t             t = 0
 *
 * The same coordinates name a point of any cage with as many vertices; that is the deformation
 * (Huynh, "Bijective deformations in R^n via Integral Curve Coordinates", 2013). At t = 0 all sides
 * and lambdas name the maximum; it is written as 0 0 0. A vertex of the cage is lambda = 0 on the
 * side that begins there.
 *
 * Side numbers here are those of a prepared cage; cage_to_given makes them the user's. */
#ifndef ICC_H
#define ICC_H

#include <stdint.h>

struct icc_place {
    uint32_t side;
    double lambda, t; /* both in [0,1] */
};

#define ICC_OUTSIDE UINT32_MAX /* the side of a point outside, whose coordinates are none */

#endif
