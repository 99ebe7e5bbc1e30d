/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fans - how often the images of the triangles around a vertex wind round its image.
 *
 * At a vertex v, the image of an edge {v,w} leaves in the direction e = q - q_v, q being the edge
 * corner next to v: degree times e is the derivative. Where det grad phi > 0 at v in a triangle of
 * its fan, the two edges of that triangle satisfy e_i x e_i+1 > 0: the image of the triangle's
 * corner is a sector of an angle in (0,180), left of e_i. So the angles of a fan e_0 .. e_m add up
 * to 360 degrees times a whole number around an inner vertex, where e_m = e_0, and it is 1 exactly
 * if phi is one-to-one near v: then the sectors cover a neighbourhood once. A fan may wind twice
 * although all its triangles are positive. Around a boundary vertex the sectors are disjoint if the
 * sum is less than 360 degrees, and overlap if it is more.
 *
 * The sum is a number of turns, counted where directions pass that of the x axis, and the angle
 * from e_0 to e_m; all signs are exact. */
#ifndef FANS_H
#define FANS_H

#include "spline.h"

enum fan_kind {
    FAN_SOUND,   /* once around, or on the boundary less than 360 degrees */
    FAN_COVERS,  /* more than that: phi is not one-to-one near the vertex */
    FAN_CLOSES,  /* on the boundary, exactly 360 degrees: both boundary edges leave alike */
    FAN_UNKNOWN, /* a corner is not positive */
};

/* *turns, the multiples of 360 degrees that the sum reaches, is set unless FAN_UNKNOWN. */
enum fan_kind fan_of_vertex(const struct spline *s, uint32_t v, uint32_t *turns);

/* A vertex that is FAN_COVERS, else one that is FAN_CLOSES, else one that is FAN_UNKNOWN, the
 * lowest of them; GRID_NONE if all are sound. 20 ns a corner. */
uint32_t fans_worst(const struct spline *s, enum fan_kind *kind, uint32_t *turns);

#endif
