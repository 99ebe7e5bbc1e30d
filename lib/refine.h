/* SPDX-License-Identifier: GPL-3.0-or-later */
/* refine - conforming subdivision of a grid: the same map on smaller triangles.
 *
 * A marked triangle is split at the midpoints of its edges into four (red). Where that leaves the
 * midpoint of an edge hanging, the neighbour is split in two (green) if this is its only one and
 * its halves are whole, else in four. Each round divides the lattice step by 2, so vertices stay
 * integers. */
#ifndef REFINE_H
#define REFINE_H

#include "resample.h"

enum { REFINE_TIMES_MAX = 24 }; /* more rounds leave the lattice whatever the grid */

struct refine_request {
    int times;            /* rounds, 1..24; each splits the marked parts of the round before */
    const bool *triangle; /* mark: these triangles of the grid and all their parts; or NULL */
    const double *box;    /* mark: what meets this X0,Y0,X1,Y1 (world, nominal), closed; or NULL */
};                        /* both NULL: everything */

/* Fills *fine. The old vertices keep their numbers, new ones follow in the order of the triangles
 * they split; parts take the place of the triangle they come from. Refused (ERR_REFUSAL) when a
 * coordinate would exceed 2^24, or times*degree > 53 (do it in several steps). O(n) for a fixed
 * number of rounds. */
bool refine_spline(const struct spline *s, const struct refine_request *request,
                   struct spline *fine, struct err *err) WARN_UNUSED;

#endif
