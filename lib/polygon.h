/* SPDX-License-Identifier: GPL-3.0-or-later */
/* polygon - point in polygon, exactly.
 *
 * A polygon is a set of closed loops. Even-odd: a point is inside if a ray from it crosses the
 * loops an odd number of times, so a loop within a loop is a hole, whatever its orientation.
 * Vertices are doubles and are meant as they stand; no rounding enters the answer. */
#ifndef POLYGON_H
#define POLYGON_H

#include "err.h"

struct polygon {
    size_t point_count, loop_count;
    double (*point)[2]; /* all loops, one after the other */
    size_t *loop_start; /* loop l: point[loop_start[l] .. loop_start[l+1]), closed implicitly */

    /* derived by polygon_build */
    double lo[2], hi[2]; /* bounding box */
    size_t band_count;
    double band_scale;  /* bands a unit of y */
    size_t *band_start; /* band b: band_edge[band_start[b] .. band_start[b+1]) */
    size_t *band_edge;  /* number of the edge's first point */
    size_t *next;       /* next[i]: the other end of the edge that begins at point i */
};

/* Completes a polygon whose fields up to loop_start are set (arrays from mem.h, owned by the
 * polygon from now on, also on failure). There is a loop, and each has a point. O(points). */
bool polygon_build(struct polygon *g, struct err *err) WARN_UNUSED;
void polygon_free(struct polygon *g);

/* +1 inside, 0 on a loop, -1 outside; p finite. Near O(1) for round polygons, O(points) at worst.
 */
int polygon_side(const struct polygon *g, const double p[2]);

/* The same; where the answer is 0, *edge is the lowest-numbered edge (named by its first point)
 * that p lies on. */
int polygon_find(const struct polygon *g, const double p[2], size_t *edge);

/* Of the edges that p is no further from than `limit`, the nearest; the lowest of several. False:
 * there is none. Distances are rounded. */
bool polygon_near(const struct polygon *g, const double p[2], double limit, size_t *edge);

/* The first of a loop's points that are lowest by (x, y). */
size_t polygon_lowest(const struct polygon *g, size_t loop);

/* +1 for a counter-clockwise loop, -1 for a clockwise one: the turn at its lowest point, which is
 * convex. 0, for a spike there, or a wrong answer only if the loop is not simple. */
int polygon_sense(const struct polygon *g, size_t loop);

/* Inside or on a loop. */
static inline bool polygon_has(const struct polygon *g, const double p[2]) {
    return polygon_side(g, p) >= 0;
}

#endif
