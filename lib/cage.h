/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cage - the simple polygons that integral curve coordinates are about.
 *
 * A cage has at least three vertices, and its sides meet only where one ends and the next begins,
 * which is decided exactly, for the vertices as they stand; its area exceeds 10^-14 of the square
 * of its diameter, and the longer side of its box is in 10^-100..10^100. The lengths and the area
 * below are rounded.
 *
 * A prepared cage is counter-clockwise and begins at its lowest vertex by (x, y), so that neither
 * where the user's list begins nor its sense has any effect on what is computed. Side k runs from
 * vertex k to vertex k + 1 (cyclic); a place on it is lambda in [0,1]. The deformed version of a
 * cage has as many vertices and the same sense, and begins where the other does: vertices of the
 * same number belong together.
 *
 *     given, clockwise     0   1   2   3        shift = 2, reversed
 *     prepared             2   1   0   3        given vertex = shift - prepared (modulo count) */
#ifndef CAGE_H
#define CAGE_H

#include "polygon.h"

#include <stdint.h>

struct cage {
    size_t count;           /* of vertices and sides, below 2^32 - 1 */
    double (*vertex)[2];    /* those of the polygon */
    struct polygon polygon; /* its one loop, built */
    bool reversed;          /* given clockwise */
    size_t shift;           /* number of vertex 0 as given */
    double area, perimeter;
    double diameter; /* of the bounding box: its diagonal */
};

/* Prepares n vertices as given, which are copied. Refusals (ERR_REFUSAL) name the vertices and
 * sides by their numbers as given, and where they lie. Freed by cage_free on success.
 * O(n log n). */
bool cage_init(struct cage *c, const double (*vertex)[2], size_t n, struct err *err) WARN_UNUSED;

/* The same for a deformed version of a prepared cage. */
bool cage_init_like(struct cage *c, const double (*vertex)[2], size_t n, const struct cage *source,
                    struct err *err) WARN_UNUSED;
void cage_free(struct cage *c); /* harmless on a zeroed struct */

/* The point at lambda of a side. Exact at both ends; else the error is some ulps. */
void cage_point(const struct cage *c, uint32_t side, double lambda, double p[2]);

enum cage_where { CAGE_OUTSIDE, CAGE_ON, CAGE_INSIDE };

/* Where a finite point lies. On the cage are points of a side, exactly, and points outside no
 * further away than rounding takes a point computed on one: 2^-48 of the largest coordinate; they
 * belong to the nearest side, and *side, *lambda say where. A vertex is lambda = 0. Cost: as
 * polygon_side. */
enum cage_where cage_find(const struct cage *c, const double p[2], uint32_t *side, double *lambda);

/* How far rounding may move a point: 2^-48 of the largest coordinate. */
double cage_rounding(const struct cage *c);

/* lambda of the point of a side that is nearest to p; at the end of the side, the next side and 0.
 */
double cage_foot(const struct cage *c, uint32_t *side, const double p[2]);

/* Exactly: is p inside or on the cage? */
static inline bool cage_has(const struct cage *c, const double p[2]) {
    return polygon_has(&c->polygon, p);
}

static inline uint32_t cage_next(const struct cage *c, uint32_t vertex) {
    return vertex + 1 < c->count ? vertex + 1 : 0;
}

/* Place of the prepared cage -> the same in the user's numbering, and back. */
void cage_to_given(const struct cage *c, uint32_t *side, double *lambda);
void cage_from_given(const struct cage *c, uint32_t *side, double *lambda);

#endif
