/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grid - the domain triangulation T: topology, Bezier net, canonical numbering of control points.
 *
 * Vertices are integer lattice points (predicate.h), triangles are counter-clockwise. Triangles
 * share whole edges or nothing; an edge has one triangle (boundary) or two (inner); the triangles
 * around a vertex form one fan; every vertex is used. Holes and several components are allowed.
 *
 * Edges are pairs a < b of vertices, sorted by (a, b). Edge l of a triangle lies opposite its
 * corner l.
 *
 * There is one control point for each distinct nominal position (i u0 + j u1 + k u2) / degree,
 * numbered
 *   1. corners, one a vertex, in vertex order;
 *   2. for each edge {a,b} the degree-1 points from a towards b;
 *   3. for each triangle the points (i,j,k), i, j, k >= 1, i descending, then j descending.
 * The Bezier net of a triangle joins neighbouring nominal positions, those whose (i,j,k) differ by
 * moving one unit between two weights; the nets of all triangles together are the global net. */
#ifndef GRID_H
#define GRID_H

#include "err.h"
#include "predicate.h"

enum {
    GRID_DEGREE_MAX = 15,
    GRID_PATCH_MAX = (GRID_DEGREE_MAX + 1) * (GRID_DEGREE_MAX + 2) / 2,
    GRID_COORDINATE_MAX = 1 << 24,
};
#define GRID_NONE UINT32_MAX /* no triangle, no point */

struct grid {
    int degree;
    int axes[3]; /* model axes 0..2 that are the grid's x, y and depth; default 0, 1, 2 */
    struct lattice lattice;
    bool has_depth;
    double depth[2]; /* a < b */
    uint32_t vertex_count, triangle_count;
    int32_t (*vertex)[2];
    uint32_t (*triangle)[3];

    /* derived by grid_build */
    uint32_t edge_count, point_count;
    uint32_t (*edge)[2];          /* a < b */
    uint32_t (*edge_triangle)[2]; /* [0] < [1]; [1] = GRID_NONE on the boundary */
    uint32_t (*triangle_edge)[3]; /* [l]: the edge opposite corner l */
    uint32_t *fan_start, *fan;    /* fan[fan_start[v] .. fan_start[v+1]): triangles around vertex v,
                                     counter-clockwise, from the boundary if v is on it, else from the
                                     lowest number */
};

/* A control point as weights in a triangle; i + j + k = degree. */
struct grid_place {
    uint32_t triangle;
    int weight[3];
};

/* Which record of a grid an error is about. */
struct grid_culprit {
    enum grid_record { GRID_BAD_WHOLE, GRID_BAD_LATTICE, GRID_BAD_VERTEX, GRID_BAD_TRIANGLE } kind;
    uint32_t number;
};

/* Checks and completes a grid whose fields up to `triangle` are set (arrays from mem.h, owned by
 * the grid from now on, also on failure). Refusals name vertex or triangle numbers: ERR_INPUT, no
 * place. O(n). Overlapping triangles are not looked for (check-grid does). */
bool grid_build(struct grid *g, struct err *err) WARN_UNUSED;

/* The same; on ERR_INPUT, *culprit says which record is to blame (the later one of two). */
bool grid_build_blaming(struct grid *g, struct grid_culprit *culprit, struct err *err) WARN_UNUSED;
void grid_free(struct grid *g);

/* Axes from the two letters of a plane, e.g. "zy": different letters of xyz; the third is depth. */
bool grid_axes(const char *letters, size_t length, int axes[3]) WARN_UNUSED;

static inline int grid_patch_size(int degree) {
    return (degree + 1) * (degree + 2) / 2;
}

/* Number of the point with weights (i,j,k) in triangle t. O(1). */
uint32_t grid_point(const struct grid *g, uint32_t t, int i, int j, int k);

/* All points of triangle t, i descending, then j descending; grid_patch_size(degree) numbers. */
void grid_patch(const struct grid *g, uint32_t t, uint32_t *points);

/* The place of point p in the lowest triangle that has it. O(1), corners O(degree of the vertex).
 */
struct grid_place grid_place(const struct grid *g, uint32_t p);

/* The triangles that have point p: one, an edge's one or two, or a vertex's fan. *single is room
 * for the first case; the result is borrowed. O(1). */
const uint32_t *grid_triangles_of(const struct grid *g, uint32_t p, uint32_t *single, uint32_t *n);

/* Weights of point p in triangle t, which must have it. */
void grid_weights(const struct grid *g, uint32_t p, uint32_t t, int weight[3]);

/* Nominal position of point p in world units, rounded correctly from the exact rational. About 30
 * ns. Exact zeros are +0. */
void grid_nominal(const struct grid *g, uint32_t p, double xy[2]);

/* Those of all points, xy[point_count]; quicker than one by one. */
void grid_nominals(const struct grid *g, double (*xy)[2]);

/* World position of vertex v, rounded correctly. */
void grid_vertex(const struct grid *g, uint32_t v, double xy[2]);

static inline bool grid_edge_is_inner(const struct grid *g, uint32_t e) {
    return g->edge_triangle[e][1] != GRID_NONE;
}

/* The corner 0..2 of triangle t that is vertex v, which t must have. */
static inline int grid_corner(const struct grid *g, uint32_t t, uint32_t v) {
    const uint32_t *c = g->triangle[t];
    int l = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    INVARIANT(c[l] == v);
    return l;
}

/* The corner 0..2 of triangle t that lies opposite edge e. */
int grid_opposite(const struct grid *g, uint32_t t, uint32_t e);

#endif
