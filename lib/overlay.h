/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlay - the common refinement of two triangulations of one domain, as combinatorics.
 *
 * The meshes have the same boundary: the same vertices on it, at the same places. A cell of the
 * overlay is where a triangle of the first meets one of the second in more than a line; it is a
 * convex polygon of 3 to 6 corners. The corners of all cells are
 *
 *     vertices of the first mesh, which lie in a triangle of the second,
 *     vertices of the second, which lie in a triangle of the first,
 *     vertices of both, at the same place,
 *     crossings of an edge of the first with an edge of the second.
 *
 * Everything is decided by signs of areas of three vertices of the meshes, which are doubles and
 * meant as they stand: no rounding enters, and nothing is assumed about how the meshes lie. Two
 * cells have whole edges in common or nothing. */
#ifndef OVERLAY_H
#define OVERLAY_H

#include "err.h"

#include <stdint.h>

struct overlay_mesh { /* borrowed */
    size_t vertex_count, triangle_count;
    const double (*at)[2];
    const uint32_t (*triangle)[3]; /* strictly counter-clockwise, edge to edge, connected */
};

enum overlay_kind { OVERLAY_BOTH, OVERLAY_FIRST, OVERLAY_SECOND, OVERLAY_CROSSING };

/* What a vertex of the overlay is in mesh 0 and 1: in[m] is a vertex, a triangle (closed) that has
 * it, or at a crossing the edge, as the lower of its half edges (halfedge.h). */
struct overlay_vertex {
    enum overlay_kind kind;
    uint32_t in[2];
};

struct overlay {
    size_t vertex_count, cell_count;
    struct overlay_vertex *vertex; /* by kind, then by in[0], in[1] */
    size_t *cell_start;  /* cell c: corner[cell_start[c] .. cell_start[c+1]), counter-clockwise */
    uint32_t *corner;    /* vertices */
    uint32_t (*cell)[2]; /* the triangles that meet there, one of each mesh */
};

/* Fewer than 2^31 / 3 triangles each. O(cells); about 1 us a cell. Freed by overlay_free in any
 * case. */
bool overlay_build(struct overlay *o, const struct overlay_mesh mesh[2],
                   struct err *err) WARN_UNUSED;
void overlay_free(struct overlay *o); /* harmless on a zeroed struct */

#endif
