/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plane_map - a triangulation whose vertices have places in two planes: the map from one to the
 * other that is affine on each triangle. As it stands it has no folds if all triangles are strictly
 * counter-clockwise in both and the boundaries are simple; then it is one to one. */
#ifndef PLANE_MAP_H
#define PLANE_MAP_H

#include "err.h"

#include <stdint.h>

struct plane_map { /* arrays from mem.h */
    size_t vertex_count, triangle_count;
    double (*at[2])[2]; /* in the source, in the target */
    uint32_t (*triangle)[3];
};

void plane_map_free(struct plane_map *p); /* harmless on a zeroed struct */

/* The first triangle from `from` on that is not strictly counter-clockwise in that plane, or
 * triangle_count. Exact. */
size_t plane_map_flipped(const struct plane_map *p, int plane, size_t from);

/* Proves that the map has no folds; else refuses (precision), with the place. O(n log n) for the
 * boundary, 20 ns a triangle. */
bool plane_map_prove(const struct plane_map *p, struct err *err) WARN_UNUSED;

/* Halves triangles at their longest sides, as the source has them, until none has more than
 * `max_area` there. Midpoints are rounded to so many digits in the target (joint.h); a triangle of
 * which that would turn a half over remains. Refuses more than max_triangles. O(triangles). */
bool plane_map_split(struct plane_map *p, double max_area, size_t max_triangles, int digits,
                     struct err *err) WARN_UNUSED;

/* Area over the squares of the sides, rounded; 0 where it is not counter-clockwise. */
double plane_map_roundness(const double a[2], const double b[2], const double c[2]);

#endif
