/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the first triangle of its cell a point is walked to, across edges that have it strictly on
 * their other side. A walk may leave the mesh where its boundary is not convex, and turn in circles
 * where it is not Delaunay; so it has a limited number of steps, and the cell's list decides. */
#include "mesh_locate.h"

#include "dd.h"
#include "mem.h"
#include "predicate.h"
#include "segment.h"

#include <math.h>

enum {
    NO_EDGE = 3,
    HINT_STEPS = 1,
};

#define LEAST 0x1p-1022 /* what stands for a positive area that was rounded to 0 or below */

struct mesh_point mesh_point(const double base[2], const double d[2]) {
    struct dd x = dd_two_sum(base[0], d[0]), y = dd_two_sum(base[1], d[1]);
    return (struct mesh_point){{x.hi, y.hi}, {x.lo, y.lo}};
}

/* ---- one triangle ---- */

static const double *corner(const struct mesh_locator *l, uint32_t t, int k) {
    return l->at[l->mesh->triangle[t][k % 3]];
}

/* Settles what the filter left open. Returns as look does. */
static int look_closely(const struct mesh_locator *l, uint32_t t, const struct mesh_point *p,
                        double area[3]) {
    for (int e = 0; e < 3; e++) {
        int sign = predicate_orient_sum(corner(l, t, e + 1), corner(l, t, e + 2), p->at, p->rest);
        if (sign < 0) return e;
        area[e] = sign == 0 ? 0 : fmax(area[e], LEAST);
    }
    return NO_EDGE;
}

/* Returns an edge that has p strictly outside, or NO_EDGE: then area[e] is twice that of p and edge
 * e, and 0 exactly if p lies on the edge. */
static inline int look(const struct mesh_locator *l, uint32_t t, const struct mesh_point *p,
                       double area[3]) {
    const double *a = corner(l, t, 0), *b = corner(l, t, 1), *c = corner(l, t, 2);
    double bound[3];
    area[0] = predicate_orient_filter(b, c, p->at, p->rest, &bound[0]);
    area[1] = predicate_orient_filter(c, a, p->at, p->rest, &bound[1]);
    area[2] = predicate_orient_filter(a, b, p->at, p->rest, &bound[2]);
    if ((area[0] > bound[0]) & (area[1] > bound[1]) & (area[2] > bound[2])) return NO_EDGE;
    for (int e = 0; e < 3; e++)
        if (area[e] < -bound[e]) return e;
    return look_closely(l, t, p, area);
}

/* ---- finding ---- */

/* Walks from t by at most `steps` edges; MESH_NONE if that does not lead to p. */
static uint32_t walk(const struct mesh_locator *l, uint32_t t, const struct mesh_point *p,
                     uint32_t steps, double area[3]) {
    for (uint32_t i = 0; i <= steps && t != MESH_NONE; i++) {
        int edge = look(l, t, p, area);
        if (edge == NO_EDGE) return t;
        t = l->mesh->across[t][edge];
    }
    return MESH_NONE;
}

static uint32_t search_cell(const struct mesh_locator *l, const struct mesh_point *p,
                            double area[3]) {
    const struct cells *c = &l->cells;
    size_t cell = cells_of(&c->raster, p->at);
    uint32_t first = c->start[cell], end = c->start[cell + 1], t;
    if (first == end || !cells_holds(&c->raster, p->at)) return MESH_NONE;
    t = walk(l, c->item[first], p, end - first, area);
    for (uint32_t i = first; t == MESH_NONE && i < end; i++)
        if (look(l, c->item[i], p, area) == NO_EDGE) t = c->item[i];
    return t;
}

/* The lowest triangle around corner k of t. */
static uint32_t lowest_around(const struct mesh *m, uint32_t t, int k) {
    uint32_t v = m->triangle[t][k], best = t, u = t;
    for (int turn = 1; turn <= 2;
         turn++) { /* one way round, the other if that meets the boundary */
        for (u = m->across[t][(k + turn) % 3]; u != MESH_NONE && u != t;
             u = m->across[u][(mesh_corner(m, u, v) + turn) % 3])
            if (u < best) best = u;
        if (u == t) break;
    }
    return best;
}

/* The lowest triangle that has the point that t has, which lies on an edge of t. */
static uint32_t lowest(const struct mesh *m, uint32_t t, const double area[3]) {
    int e = area[0] == 0 ? 0 : area[1] == 0 ? 1 : 2;
    int f = area[2] == 0 ? 2 : area[1] == 0 ? 1 : 0;
    uint32_t other = m->across[t][e];
    if (e != f) return lowest_around(m, t, 3 - e - f);
    return other < t ? other : t;
}

bool mesh_locate(const struct mesh_locator *l, const struct mesh_point *p, uint32_t *hint,
                 struct mesh_place *place) {
    double *area = place->weight;
    uint32_t t = walk(l, *hint, p, HINT_STEPS, area);
    if (t == MESH_NONE) t = search_cell(l, p, area);
    if (t == MESH_NONE) return false;
    if (area[0] == 0 || area[1] == 0 || area[2] == 0) {
        t = lowest(l->mesh, t, area);
        int edge = look(l, t, p, area);
        INVARIANT(edge == NO_EDGE);
    }
    *hint = place->triangle = t;
    return true;
}

void mesh_locate_rim(const struct mesh_locator *l, const struct mesh_point *p,
                     struct mesh_place *place) {
    double best = INFINITY, lambda;
    for (size_t i = 0; i < l->rim_count; i++) {
        uint32_t t = l->rim[i][0], e = l->rim[i][1];
        double d =
            segment_distance2(corner(l, t, (int)e + 1), corner(l, t, (int)e + 2), p->at, &lambda);
        if (!(d < best)) continue;
        best = d;
        place->triangle = t;
        place->weight[e] = 0;
        place->weight[(e + 1) % 3] = 1 - lambda;
        place->weight[(e + 2) % 3] = lambda;
    }
}

/* From the corner with the largest weight: x_a + sum w_k (x_k - x_a) / sum w_k. */
struct mesh_point mesh_mean(const struct mesh *m, const double (*at)[2],
                            const struct mesh_place *place) {
    const double *w = place->weight;
    const uint32_t *v = m->triangle[place->triangle];
    int a = w[0] >= w[1] ? (w[0] >= w[2] ? 0 : 2) : (w[1] >= w[2] ? 1 : 2);
    int b = (a + 1) % 3, c = (a + 2) % 3;
    double sum = w[0] + w[1] + w[2], wb = w[b] / sum, wc = w[c] / sum, d[2];
    const double *xa = at[v[a]], *xb = at[v[b]], *xc = at[v[c]];
    for (int k = 0; k < 2; k++) d[k] = wb * (xb[k] - xa[k]) + wc * (xc[k] - xa[k]);
    return mesh_point(xa, d);
}

/* ---- building ---- */

static void box_of(const void *context, uint32_t t, double lo[2], double hi[2]) {
    const struct mesh_locator *l = context;
    const double *a = corner(l, t, 0), *b = corner(l, t, 1), *c = corner(l, t, 2);
    for (int k = 0; k < 2; k++) {
        lo[k] = fmin(a[k], fmin(b[k], c[k]));
        hi[k] = fmax(a[k], fmax(b[k], c[k]));
    }
}

/* Does a rectangle lie strictly outside an edge? Its corner furthest to the inside, which is to the
 * left, decides. */
static bool misses(const void *context, uint32_t t, const double x[2], const double y[2]) {
    const struct mesh_locator *l = context;
    for (int e = 0; e < 3; e++) {
        const double *a = corner(l, t, e + 1), *b = corner(l, t, e + 2);
        double inner[2] = {x[b[1] < a[1]], y[b[0] > a[0]]}, none[2] = {0, 0}, bound;
        if (predicate_orient_filter(a, b, inner, none, &bound) < -bound) return true;
    }
    return false;
}

/* Brings the triangle that holds the centre of a cell, if any does, to the front of its list. */
static void choose_first(struct cells *c, const struct mesh_locator *l, size_t cell) {
    uint32_t first = c->start[cell], end = c->start[cell + 1];
    struct mesh_point centre = {{0, 0}, {0, 0}};
    double x[2], y[2], area[3];
    cells_rectangle(&c->raster, cell, x, y);
    centre.at[0] = x[0] + (x[1] - x[0]) / 2;
    centre.at[1] = y[0] + (y[1] - y[0]) / 2;
    for (uint32_t i = first; i < end; i++) {
        uint32_t t = c->item[i];
        if (look(l, t, &centre, area) != NO_EDGE) continue;
        c->item[i] = c->item[first];
        c->item[first] = t;
        return;
    }
}

static bool find_cells(struct mesh_locator *l, struct err *err) {
    const struct cells_items items = {(uint32_t)l->mesh->triangle_count, l, box_of, misses};
    double lo[2], hi[2], low[2], high[2];
    box_of(l, 0, lo, hi);
    for (uint32_t t = 1; t < l->mesh->triangle_count; t++) {
        box_of(l, t, low, high);
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], low[k]);
            hi[k] = fmax(hi[k], high[k]);
        }
    }
    if (!cells_init(&l->cells, lo, hi, &items, 1, "triangles", err)) return false;
    size_t n = (size_t)l->cells.raster.size[0] * l->cells.raster.size[1];
    for (size_t cell = 0; cell < n; cell++) choose_first(&l->cells, l, cell);
    return true;
}

static bool find_rim(struct mesh_locator *l, struct err *err) {
    const struct mesh *m = l->mesh;
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1 && !mem_new(l->rim, l->rim_count, err)) return false;
        l->rim_count = 0;
        for (uint32_t t = 0; t < m->triangle_count; t++)
            for (uint32_t e = 0; e < 3; e++) {
                if (m->across[t][e] != MESH_NONE) continue;
                if (pass == 1) l->rim[l->rim_count][0] = t, l->rim[l->rim_count][1] = e;
                l->rim_count++;
            }
    }
    return true;
}

bool mesh_locator_init(struct mesh_locator *l, const struct mesh *m, const double (*at)[2],
                       struct err *err) {
    *l = (struct mesh_locator){.mesh = m, .at = at};
    if (find_cells(l, err) && find_rim(l, err)) return true;
    mesh_locator_free(l);
    return false;
}

void mesh_locator_free(struct mesh_locator *l) {
    cells_free(&l->cells);
    free(l->rim);
    *l = (struct mesh_locator){0};
}
