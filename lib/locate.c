/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A point is looked for in the hinted triangle (coherent input), then in its cell. Where many small
 * triangles share a cell, a walk is tried first. It goes from triangle to triangle across an edge
 * that has the point strictly on its other side:
 *
 *          /\
 *         / t\  e  \         p lies right of e as seen from t: go on in u
 *        /____\  u  \  . p
 *
 * A walk may leave the triangulation through a hole, and turn in circles where it is not Delaunay;
 * so it has a limited number of steps, and the list decides. */
#include "locate.h"

enum {
    LONG_LIST = 24, /* of which a walk is tried before a scan */
    NO_EDGE = 3,
};

/* What a triangle knows about a point inside it: area[e], over step, of the triangle of the point
 * and edge e, and which are exactly zero (bit e). */
struct view {
    double area[3];
    unsigned zero;
};

/* Settles what the filter left open. Returns as look does. */
static int look_closely(const struct locator *l, uint32_t t, const double p[2], struct view *view) {
    for (int e = 0; e < 3; e++) {
        int sign = predicate_side(&l->grid->lattice, locator_corner(l, t, e + 1),
                                  locator_corner(l, t, e + 2), p);
        if (sign < 0) return e;
        if (sign == 0) view->zero |= 1U << e;
        if (sign == 0 || view->area[e] < 0) view->area[e] = 0;
    }
    return NO_EDGE;
}

/* Returns an edge that has p, a point of the bounding box, strictly outside, or NO_EDGE: then *view
 * is complete. All three sides are computed before any is judged, since for scattered points a
 * wrongly predicted branch costs more than a side. */
static inline int look(const struct locator *l, uint32_t t, const double p[2], struct view *view) {
    const struct locator_triangle *q = &l->triangle[t];
    double x = p[0] * l->unit, y = p[1] * l->unit, bound = q->bound, *area = view->area;
    area[0] = q->edge[0][0] * (y - q->corner[1][1]) - q->edge[0][1] * (x - q->corner[1][0]);
    area[1] = q->edge[1][0] * (y - q->corner[2][1]) - q->edge[1][1] * (x - q->corner[2][0]);
    area[2] = q->edge[2][0] * (y - q->corner[0][1]) - q->edge[2][1] * (x - q->corner[0][0]);
    view->zero = 0;
    if ((area[0] > bound) & (area[1] > bound) & (area[2] > bound)) return NO_EDGE;
    if ((area[0] < -bound) | (area[1] < -bound) | (area[2] < -bound))
        return area[0] < -bound ? 0 : area[1] < -bound ? 1 : 2;
    return look_closely(l, t, p, view);
}

static uint32_t neighbour(const struct grid *g, uint32_t t, int edge) {
    const uint32_t *pair = g->edge_triangle[g->triangle_edge[t][edge]];
    return pair[0] == t ? pair[1] : pair[0];
}

/* Walks from t by at most `steps` edges; GRID_NONE if that does not lead to p. */
static uint32_t walk(const struct locator *l, uint32_t t, const double p[2], uint32_t steps,
                     struct view *view) {
    for (uint32_t i = 0; i <= steps && t != GRID_NONE; i++) {
        int edge = look(l, t, p, view);
        if (edge == NO_EDGE) return t;
        t = neighbour(l->grid, t, edge);
    }
    return GRID_NONE;
}

static uint32_t search_cell(const struct locator *l, const double p[2], struct view *view) {
    const struct locator_cell *cell = &l->cell[cells_of(&l->raster, p)];
    uint32_t n = cell[1].start - cell[0].start, t = cell->first;
    if (t == GRID_NONE || look(l, t, p, view) == NO_EDGE) return t;
    if (n >= LONG_LIST) {
        t = walk(l, t, p, n, view);
        if (t != GRID_NONE) return t;
    }
    for (const uint32_t *item = l->item + cell->start; n > 0; n--, item++)
        if (look(l, *item, p, view) == NO_EDGE) return *item;
    return GRID_NONE;
}

/* The lowest triangle that has the point that t has. */
static uint32_t lowest(const struct grid *g, uint32_t t, unsigned zero) {
    static const int edge_of[8] = {0, 0, 1, 2, 2, 1, 0, 0}; /* bits -> the edge, or the corner */
    int l = edge_of[zero];
    uint32_t best = t, v, other;
    if (zero == 1 || zero == 2 || zero == 4) {
        other = neighbour(g, t, l);
        return other < t ? other : t;
    }
    v = g->triangle[t][l];
    for (uint32_t i = g->fan_start[v]; i < g->fan_start[v + 1]; i++)
        if (g->fan[i] < best) best = g->fan[i];
    return best;
}

/* b_e = area_e / area, b2 as what is left to 1; where p lies on edge 2, b1 instead. fl(x + fl(1 -
 * x)) = 1 for every double x in [0,1] (ties go to even), which gives the promised sum. */
static void barycentric(double area, const struct view *view, double b[3]) {
    b[0] = fmin(view->area[0] / area, 1);
    b[1] = fmin(view->area[1] / area, 1 - b[0]);
    b[2] = 1 - (b[0] + b[1]);
    if (view->zero & 4) {
        if (view->zero & 2) b[0] = 1; /* at corner 0, whatever the division rounded to */
        b[1] = 1 - b[0];
        b[2] = 0;
    }
}

/* Can p lie in triangle t? A rough test, before a hint is looked at more closely. */
static inline bool is_near(const struct locator *l, uint32_t t, const double p[2]) {
    const struct locator_triangle *q = &l->triangle[t];
    return fabs(p[0] * l->unit - q->corner[0][0]) + fabs(p[1] * l->unit - q->corner[0][1]) <=
           q->radius;
}

bool locate(const struct locator *l, const double p[2], uint32_t *hint, uint32_t *t, double b[3]) {
    const struct grid *g = l->grid;
    struct view view;
    uint32_t found = *hint;
    if (!cells_holds(&l->raster, p)) return false;
    if (!is_near(l, found, p) || look(l, found, p, &view) != NO_EDGE)
        found = search_cell(l, p, &view);
    if (found == GRID_NONE) return false;
    if (view.zero) {
        uint32_t first = lowest(g, found, view.zero);
        INVARIANT(first == found || look(l, first, p, &view) == NO_EDGE);
        found = first;
    }
    barycentric(l->triangle[found].area, &view, b);
    *hint = *t = found;
    return true;
}
