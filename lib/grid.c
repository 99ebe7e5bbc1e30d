/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of control points follow from the topology alone; nothing is stored per point.
 *
 *      0 .. V-1                 corners
 *      V + e*(d-1) + r          edges, r = 0..d-2 from a towards b
 *      V + E*(d-1) + t*n + r    interiors, n = (d-1)(d-2)/2, r by rows:
 *
 *                    0              corner 0 of the triangle
 *                   / \
 *                  . 0 .            i = d-2: 1 point
 *                 . 1 2 .           i = d-3: 2 points, j descending
 *                . 3 4 5 .          ...                         (d = 5)
 *               1---------2
 *
 * so row s = d-2-i begins at r = s(s+1)/2, and within it k-1 points come first. */
#include "grid.h"

#include "lattice.h"

bool grid_axes(const char *letters, size_t length, int axes[3]) {
    int got[2];
    if (length != 2) return false;
    for (int i = 0; i < 2; i++) {
        if (letters[i] < 'x' || letters[i] > 'z') return false;
        got[i] = letters[i] - 'x';
    }
    if (got[0] == got[1]) return false;
    axes[0] = got[0];
    axes[1] = got[1];
    axes[2] = 3 - got[0] - got[1];
    return true;
}

static uint32_t edge_points(const struct grid *g) {
    return (uint32_t)(g->degree - 1);
}

static uint32_t interior_points(const struct grid *g) {
    return (uint32_t)((g->degree - 1) * (g->degree - 2) / 2);
}

static uint32_t first_interior(const struct grid *g) {
    return g->vertex_count + g->edge_count * edge_points(g);
}

int grid_opposite(const struct grid *g, uint32_t t, uint32_t e) {
    const uint32_t *edge = g->triangle_edge[t];
    int l = edge[0] == e ? 0 : edge[1] == e ? 1 : 2;
    INVARIANT(edge[l] == e);
    return l;
}

/* Point with the given weights on edge l of triangle t, where weight[l] = 0. */
static uint32_t edge_point(const struct grid *g, uint32_t t, int l, const int weight[3]) {
    uint32_t e = g->triangle_edge[t][l];
    int far = grid_corner(g, t, g->edge[e][1]);
    return g->vertex_count + e * edge_points(g) + (uint32_t)(weight[far] - 1);
}

uint32_t grid_point(const struct grid *g, uint32_t t, int i, int j, int k) {
    int weight[3] = {i, j, k}, row = g->degree - 2 - i;
    INVARIANT(i >= 0 && j >= 0 && k >= 0 && i + j + k == g->degree);
    for (int l = 0; l < 3; l++)
        if (weight[l] == g->degree) return g->triangle[t][l];
    for (int l = 0; l < 3; l++)
        if (weight[l] == 0) return edge_point(g, t, l, weight);
    return first_interior(g) + t * interior_points(g) + (uint32_t)(row * (row + 1) / 2 + k - 1);
}

/* The first point on edge l of triangle t beyond its corner `from`, and the step to the next. */
static uint32_t walk_edge(const struct grid *g, uint32_t t, int l, int from, uint32_t *step) {
    uint32_t e = g->triangle_edge[t][l], first = g->vertex_count + e * edge_points(g);
    bool forward = g->edge[e][0] == g->triangle[t][from];
    *step = forward ? 1 : UINT32_MAX; /* modulo 2^32: one back */
    return forward ? first : first + edge_points(g) - 1;
}

/* Row r has the points i = d - r; its ends lie on edges 2 and 1, the last row on edge 0. What is
 * inside has consecutive numbers. */
void grid_patch(const struct grid *g, uint32_t t, uint32_t *points) {
    uint32_t inside = first_interior(g) + t * interior_points(g), step[3];
    uint32_t side2 = walk_edge(g, t, 2, 0, &step[2]), side1 = walk_edge(g, t, 1, 0, &step[1]);
    uint32_t side0 = walk_edge(g, t, 0, 1, &step[0]);
    int d = g->degree;
    *points++ = g->triangle[t][0];
    for (int r = 1; r < d; r++) {
        *points++ = side2;
        for (int k = 1; k < r; k++) *points++ = inside++;
        *points++ = side1;
        side2 += step[2];
        side1 += step[1];
    }
    *points++ = g->triangle[t][1];
    for (int k = 1; k < d; k++, side0 += step[0]) *points++ = side0;
    *points = g->triangle[t][2];
}

static uint32_t lowest(const uint32_t *triangle, uint32_t n) {
    uint32_t best = triangle[0];
    for (uint32_t i = 1; i < n; i++)
        if (triangle[i] < best) best = triangle[i];
    return best;
}

struct grid_place grid_place(const struct grid *g, uint32_t p) {
    struct grid_place place;
    uint32_t single, n;
    const uint32_t *triangle = grid_triangles_of(g, p, &single, &n);
    place.triangle = lowest(triangle, n);
    grid_weights(g, p, place.triangle, place.weight);
    return place;
}

const uint32_t *grid_triangles_of(const struct grid *g, uint32_t p, uint32_t *single, uint32_t *n) {
    INVARIANT(p < g->point_count);
    if (p < g->vertex_count) {
        *n = g->fan_start[p + 1] - g->fan_start[p];
        return g->fan + g->fan_start[p];
    }
    if (p < first_interior(g)) {
        uint32_t e = (p - g->vertex_count) / edge_points(g);
        *n = grid_edge_is_inner(g, e) ? 2 : 1;
        return g->edge_triangle[e];
    }
    *n = 1;
    *single = (p - first_interior(g)) / interior_points(g);
    return single;
}

/* Weights of the r-th interior point of a triangle. */
static void interior_weights(int degree, int r, int weight[3]) {
    int row = 0;
    while (r > row) r -= ++row;
    weight[0] = degree - 2 - row;
    weight[2] = r + 1;
    weight[1] = degree - weight[0] - weight[2];
}

void grid_weights(const struct grid *g, uint32_t p, uint32_t t, int weight[3]) {
    INVARIANT(p < g->point_count && t < g->triangle_count);
    weight[0] = weight[1] = weight[2] = 0;
    if (p < g->vertex_count) {
        weight[grid_corner(g, t, p)] = g->degree;
    } else if (p < first_interior(g)) {
        uint32_t e = (p - g->vertex_count) / edge_points(g);
        int r = (int)((p - g->vertex_count) % edge_points(g)) + 1;
        weight[grid_corner(g, t, g->edge[e][0])] = g->degree - r;
        weight[grid_corner(g, t, g->edge[e][1])] = r;
    } else {
        uint32_t r = p - first_interior(g);
        INVARIANT(r / interior_points(g) == t);
        interior_weights(g->degree, (int)(r % interior_points(g)), weight);
    }
}

/* The sum of weight * vertex / degree over n vertices. */
static void weigh(const struct grid *g, const uint32_t *vertex, const int *weight, int n,
                  double xy[2]) {
    int64_t sum[2] = {0, 0};
    for (int l = 0; l < n; l++)
        for (int c = 0; c < 2; c++) sum[c] += (int64_t)weight[l] * g->vertex[vertex[l]][c];
    xy[0] = lattice_coordinate(g->lattice.x0, g->lattice.step, sum[0], g->degree);
    xy[1] = lattice_coordinate(g->lattice.y0, g->lattice.step, sum[1], g->degree);
}

void grid_nominal(const struct grid *g, uint32_t p, double xy[2]) {
    if (p < g->vertex_count) {
        grid_vertex(g, p, xy);
    } else {
        struct grid_place place = grid_place(g, p);
        weigh(g, g->triangle[place.triangle], place.weight, 3, xy);
    }
}

void grid_nominals(const struct grid *g, double (*xy)[2]) {
    int d = g->degree;
    for (uint32_t v = 0; v < g->vertex_count; v++) grid_vertex(g, v, *xy++);
    for (uint32_t e = 0; e < g->edge_count; e++)
        for (int r = 1; r < d; r++) weigh(g, g->edge[e], (int[]){d - r, r}, 2, *xy++);
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int i = d - 2; i >= 1; i--)
            for (int j = d - 1 - i; j >= 1; j--)
                weigh(g, g->triangle[t], (int[]){i, j, d - i - j}, 3, *xy++);
}

void grid_vertex(const struct grid *g, uint32_t v, double xy[2]) {
    xy[0] = lattice_coordinate(g->lattice.x0, g->lattice.step, g->vertex[v][0], 1);
    xy[1] = lattice_coordinate(g->lattice.y0, g->lattice.step, g->vertex[v][1], 1);
}
