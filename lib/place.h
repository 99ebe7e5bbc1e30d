/* SPDX-License-Identifier: GPL-3.0-or-later */
/* place - where points lie in a grid: the triangle, and barycentric coordinates in it.
 *
 * A projection says which coordinates of a point are the grid's x, y and depth. Outside are points
 * outside the triangulation or, where depth counts, outside the interval [a,b] of the prisms. */
#ifndef PLACE_H
#define PLACE_H

#include "locate.h"

struct place {
    uint32_t triangle; /* GRID_NONE: outside */
    double b[3];       /* fl(fl(b0+b1)+b2) = 1 */
};

struct projection {
    int axes[3];
    bool has_depth;
    double depth[2];
};

struct projection projection_of_model(const struct grid *g); /* by the grid's plane and depth */
struct projection projection_of_plane(void); /* x and y are the grid's own; the third is nothing */

/* The weights of bottom and top at depth z: a[0] = (depth1 - z) / (depth1 - depth0), a[1] = (z -
 * depth0) / (depth1 - depth0); both in [0,1] for z in the interval, also where its length is too
 * large for a double. */
void depth_weights(const double depth[2], double z, double a[2]);

struct placer {
    struct projection projection;
    /* private */
    struct locator locator;
    uint32_t hint;
};

/* The grid is borrowed. */
bool placer_init(struct placer *p, const struct grid *g, const struct projection *projection,
                 struct err *err) WARN_UNUSED;
void placer_free(struct placer *p); /* harmless on a zeroed struct */

/* The place of a point; false, and place->triangle = GRID_NONE: outside. Fast for points near the
 * one before; the answer does not depend on it. */
bool placer_find(struct placer *p, const double point[3], struct place *place);

#endif
