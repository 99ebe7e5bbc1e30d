/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mesh_locate - which triangle of a mesh holds a point, exactly.
 *
 * The hinted triangle first, then cells, as in locate.h, whose meshes lie on lattices. A point on
 * a shared edge or corner belongs to the lowest triangle number, so the hint never shows in the
 * answer. Near O(1): 30 to 100 ns; about 40 bytes a triangle. Read-only after mesh_locator_init:
 * threads may share it, each with its own hint. */
#ifndef MESH_LOCATE_H
#define MESH_LOCATE_H

#include "cells.h"
#include "mesh.h"

struct mesh_locator {
    const struct mesh *mesh; /* borrowed */
    const double (*at)[2];   /* where its vertices lie: borrowed */
    /* private */
    struct cells cells; /* triangles by cells, the likeliest first in each list */
    uint32_t (*rim)[2]; /* boundary edges: triangle and edge */
    size_t rim_count;
};

/* A point is the exact sum of two doubles in each coordinate, |rest| <= half an ulp of `at`: where
 * a map crowds many triangles together, `at` alone would not tell where in one a point lies. */
struct mesh_point {
    double at[2], rest[2];
};

/* base + d, with what rounding would lose. */
struct mesh_point mesh_point(const double base[2], const double d[2]);

/* What a point is in terms of a triangle: the weighted mean of its corners. */
struct mesh_place {
    uint32_t triangle;
    double weight[3]; /* >= 0, not all 0; 0 where the point lies on the opposite edge */
};

/* All triangles are counter-clockwise at these places, none overlap, and those around a vertex form
 * one fan. */
bool mesh_locator_init(struct mesh_locator *l, const struct mesh *m, const double (*at)[2],
                       struct err *err) WARN_UNUSED;
void mesh_locator_free(struct mesh_locator *l); /* harmless on a zeroed struct */

/* False: p, finite, lies outside. *hint is any triangle, and becomes the one found. */
bool mesh_locate(const struct mesh_locator *l, const struct mesh_point *p, uint32_t *hint,
                 struct mesh_place *place);

/* The nearest place on the boundary. O(boundary edges). */
void mesh_locate_rim(const struct mesh_locator *l, const struct mesh_point *p,
                     struct mesh_place *place);

/* The mean at other places of the vertices: the map that is affine on each triangle. Exact at
 * corners; else the error is some ulps of the size of the triangle there. */
struct mesh_point mesh_mean(const struct mesh *m, const double (*at)[2],
                            const struct mesh_place *place);

#endif
