/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlay_map - the map that two meshes of one domain make, on the cells of their overlay.
 *
 * Mesh m is the image of a domain in which its vertices lie at x[m]. To a point of the first domain
 * belongs the point of the second that has the same image; that is affine on each cell of the
 * overlay, and no cell turns over. So the cells, triangulated, are a piecewise affine map without
 * folds, of which no more is wrong than rounding makes of the vertices' places. */
#ifndef OVERLAY_MAP_H
#define OVERLAY_MAP_H

#include "joint.h"
#include "overlay_place.h"

struct overlay_map {
    const struct overlay *overlay; /* all borrowed */
    const struct overlay_mesh *mesh;
    const double (*x[2])[2];
    struct joint_meaning
        meaning; /* of a joint made of it: what its vertices mean; refers to this */
};

/* Completes m, whose borrowed fields are set, and makes the map: the vertices are those of the
 * overlay, their places rounded. */
bool overlay_map(struct overlay_map *m, struct plane_map *map, struct err *err) WARN_UNUSED;

#endif
