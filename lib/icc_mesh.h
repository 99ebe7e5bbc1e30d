/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_mesh - a triangulated cage, for method ray.
 *
 * Sides are cut into equal parts, 1, 2, 4, 8 and so on in number, points of a triangular lattice
 * fill the inside, and a constrained Delaunay triangulation joins them. Vertices on the cage, the
 * rim, come first:
 *
 *      start[0]             start[1]                start[2]
 *         v                    v                       v
 *         0    1    2    3     4     5     6     7     8  ...    rim vertex i of side k is at
 *         |------ side 0 ------|------- side 1 --------|         lambda = i / parts, of its parts
 *
 * All triangles are counter-clockwise and cover the cage once; its sides are unions of edges, but
 * for the rounding of rim vertices; no triangle has three corners on one side. Everything depends
 * on the prepared cage alone, and on the weights where it is too symmetric for that. */
#ifndef ICC_MESH_H
#define ICC_MESH_H

#include "cage.h"
#include "mesh.h"

enum { ICC_POINTS_MAX = 20000000 }; /* inside */

struct icc_mesh {
    struct mesh mesh;
    uint32_t rim_count;
    uint32_t *start; /* side_count + 1: the first rim vertex of each side, and rim_count */
    uint32_t *side;  /* of each rim vertex: the side that has it as any but its last vertex */
    size_t side_count;
};

/* How many inside points a cage of so many sides deserves when nobody says: 20 a side, at least 600
 * and at most 20000. */
size_t icc_mesh_points(size_t sides);

/* With about `points` inside points; where sides are so close, or far from the origin, that their
 * parts as rounded touch, sides remain uncut. weight: see cage_fill. About 5 us a point. */
bool icc_mesh_init(struct icc_mesh *m, const struct cage *cage, const double *weight, size_t points,
                   struct err *err) WARN_UNUSED;
void icc_mesh_free(struct icc_mesh *m); /* harmless on a zeroed struct */

/* lambda of rim vertex v on its side k. */
static inline double icc_mesh_lambda(const struct icc_mesh *m, uint32_t k, uint32_t v) {
    return (double)(v - m->start[k]) / (double)(m->start[k + 1] - m->start[k]);
}

#endif
