/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mesh - triangles between points whose coordinates are any doubles.
 *
 * Triangles are counter-clockwise. Edge e of a triangle is opposite corner e and runs from corner
 * e + 1 to corner e + 2:
 *
 *              2
 *             / \
 *       e 1  /   \  e 0        across[t][e]: the triangle on the other side of edge e,
 *           /     \            MESH_NONE on the boundary
 *          0-------1
 *             e 2
 *
 * Functions that need positions take them apart from the triangles, since a mesh and its image
 * under a map share the triangles. */
#ifndef MESH_H
#define MESH_H

#include "err.h"

#include <stdint.h>

#define MESH_NONE UINT32_MAX

enum { MESH_TRIANGLES_MAX = INT32_MAX / 3 * 2 }; /* 3 times that is below 2^32 */

struct mesh { /* arrays from mem.h */
    size_t vertex_count, triangle_count;
    double (*vertex)[2];
    uint32_t (*triangle)[3];
    uint32_t (*across)[3];
};

/* Makes `across`. Each edge has two triangles, which run along it in opposite directions, or one.
 * O(triangles). */
bool mesh_link(struct mesh *m, struct err *err) WARN_UNUSED;
void mesh_free(struct mesh *m); /* harmless on a zeroed struct */

/* Which corner of triangle t vertex v is. */
static inline int mesh_corner(const struct mesh *m, uint32_t t, uint32_t v) {
    const uint32_t *corner = m->triangle[t];
    return corner[0] == v ? 0 : corner[1] == v ? 1 : 2;
}

#endif
