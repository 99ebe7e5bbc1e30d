/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Buckets are square cells over the bounding box; each lists, in ascending order, the triangles
 * that meet it. The cell of a point is a monotone function of its coordinates, also as rounded, so
 * a triangle that holds a point is always in the point's list.
 *
 * A point is looked for in the hinted triangle (coherent input), then in its bucket. In a long
 * list, where triangles are much smaller than elsewhere, a walk is tried first. It goes from
 * triangle to triangle across an edge that has the point strictly on its other side:
 *
 *          /\
 *         / t\  e  \         p lies right of e as seen from t: go on in u
 *        /____\  u  \  . p
 *
 * A walk may leave the triangulation through a hole, and turn in circles where it is not Delaunay;
 * so it has a limited number of steps, and the list decides. */
#include "locate.h"

#include "mem.h"

#include <string.h>

enum {
    LONG_LIST = 24, /* of which a walk is tried before a scan */
    CELLS_PER_TRIANGLE = 4,
    PAIRS_PER_TRIANGLE = 64, /* with more, larger cells are taken: needles cross many */
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
        int sign = predicate_side(&l->grid->lattice, l->corner[t][(e + 1) % 3],
                                  l->corner[t][(e + 2) % 3], p);
        if (sign < 0) return e;
        if (sign == 0) view->zero |= 1U << e;
        if (sign == 0 || view->area[e] < 0) view->area[e] = 0;
    }
    return NO_EDGE;
}

/* Returns an edge that has p strictly outside, or NO_EDGE: then *view is complete. All three sides
 * are computed before any is judged, since for scattered points a wrongly predicted branch costs
 * more than a side. */
static inline int look(const struct locator *l, uint32_t t, const double p[2], struct view *view) {
    const struct lattice *lattice = &l->grid->lattice;
    const int32_t(*v)[2] = (const int32_t(*)[2])l->corner[t];
    double b0, b1, b2;
    view->area[0] = predicate_side_filter(lattice, v[1], v[2], p, &b0);
    view->area[1] = predicate_side_filter(lattice, v[2], v[0], p, &b1);
    view->area[2] = predicate_side_filter(lattice, v[0], v[1], p, &b2);
    view->zero = 0;
    if ((view->area[0] > b0) & (view->area[1] > b1) & (view->area[2] > b2)) return NO_EDGE;
    if ((view->area[0] < -b0) | (view->area[1] < -b1) | (view->area[2] < -b2))
        return view->area[0] < -b0 ? 0 : view->area[1] < -b1 ? 1 : 2;
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

static uint32_t column(const struct locator *l, int axis, double x) {
    double c = (x - l->origin[axis]) * l->scale[axis];
    if (!(c > 0)) return 0;
    return c >= l->size[axis] ? l->size[axis] - 1 : (uint32_t)c;
}

static uint32_t search_bucket(const struct locator *l, const double p[2], struct view *view) {
    size_t cell = (size_t)column(l, 1, p[1]) * l->size[0] + column(l, 0, p[0]);
    const uint32_t *item = l->item + l->start[cell];
    uint32_t n = l->start[cell + 1] - l->start[cell];
    if (n >= LONG_LIST) {
        uint32_t t = walk(l, item[0], p, n, view);
        if (t != GRID_NONE) return t;
    }
    for (uint32_t i = 0; i < n; i++)
        if (look(l, item[i], p, view) == NO_EDGE) return item[i];
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
static void barycentric(const struct grid *g, uint32_t t, const struct view *view, double b[3]) {
    const uint32_t *v = g->triangle[t];
    double area = g->lattice.step *
                  (double)predicate_area2(g->vertex[v[0]], g->vertex[v[1]], g->vertex[v[2]]);
    b[0] = fmin(view->area[0] / area, 1);
    b[1] = fmin(view->area[1] / area, 1 - b[0]);
    b[2] = 1 - (b[0] + b[1]);
    if (view->zero & 4) {
        if (view->zero & 2) b[0] = 1; /* at corner 0, whatever the division rounded to */
        b[1] = 1 - b[0];
        b[2] = 0;
    }
}

bool locate(const struct locator *l, const double p[2], uint32_t *hint, uint32_t *t, double b[3]) {
    const struct grid *g = l->grid;
    struct view view;
    uint32_t found = *hint;
    if (look(l, found, p, &view) != NO_EDGE) found = search_bucket(l, p, &view);
    if (found == GRID_NONE) return false;
    if (view.zero) {
        uint32_t first = lowest(g, found, view.zero);
        INVARIANT(first == found || look(l, first, p, &view) == NO_EDGE);
        found = first;
    }
    barycentric(g, found, &view, b);
    *hint = *t = found;
    return true;
}

/* The bounding box of triangle t, rounded monotonely. */
static void box_of(const struct grid *g, uint32_t t, double lo[2], double hi[2]) {
    grid_vertex(g, g->triangle[t][0], lo);
    hi[0] = lo[0];
    hi[1] = lo[1];
    for (int l = 1; l < 3; l++) {
        double xy[2];
        grid_vertex(g, g->triangle[t][l], xy);
        for (int axis = 0; axis < 2; axis++) {
            lo[axis] = fmin(lo[axis], xy[axis]);
            hi[axis] = fmax(hi[axis], xy[axis]);
        }
    }
}

/* The cells of triangle t's bounding box: columns first[0]..last[0], rows first[1]..last[1]. */
static void cells_of(const struct locator *l, uint32_t t, uint32_t first[2], uint32_t last[2]) {
    double lo[2], hi[2];
    box_of(l->grid, t, lo, hi);
    for (int axis = 0; axis < 2; axis++) {
        first[axis] = column(l, axis, lo[axis]);
        last[axis] = column(l, axis, hi[axis]);
    }
}

/* Does cell (x, y) lie strictly outside an edge of triangle t? Its corner furthest to the inside
 * decides. The cell is taken larger than it can be by any rounding: column() is off by less than
 * 2^-19 of a cell, the corner computed here by some ulps of its own magnitude. */
static bool is_outside(const struct locator *l, uint32_t t, uint32_t x, uint32_t y) {
    const uint32_t cell[2] = {x, y};
    for (int e = 0; e < 3; e++) {
        const int32_t *a = l->corner[t][(e + 1) % 3], *b = l->corner[t][(e + 2) % 3];
        bool upper[2] = {b[1]<a[1], b[0]> a[0]}; /* inside is to the left of a->b */
        double corner[2];
        for (int k = 0; k < 2; k++) {
            double off = upper[k] ? 1 + 0x1p-16 : -0x1p-16;
            double from_origin = (cell[k] + off) / l->scale[k];
            double slack = 0x1p-50 * (fabs(l->origin[k]) + fabs(from_origin));
            corner[k] = l->origin[k] + from_origin + (upper[k] ? slack : -slack);
        }
        if (isfinite(corner[0]) && isfinite(corner[1]) &&
            predicate_side(&l->grid->lattice, a, b, corner) < 0)
            return true;
    }
    return false;
}

/* The number of pairs of a triangle and a cell of its bounding box. */
static uint64_t count_pairs(const struct locator *l) {
    uint64_t n = 0;
    for (uint32_t t = 0; t < l->grid->triangle_count; t++) {
        uint32_t first[2], last[2];
        cells_of(l, t, first, last);
        n += (uint64_t)(last[0] - first[0] + 1) * (last[1] - first[1] + 1);
    }
    return n;
}

/* Chooses square cells, in all about `cells`, over the bounding box of the grid. */
static void choose_cells(struct locator *l, const double lo[2], const double hi[2], double cells) {
    double side = sqrt((hi[0] - lo[0]) / cells * (hi[1] - lo[1]));
    for (int axis = 0; axis < 2; axis++) {
        double n = ceil((hi[axis] - lo[axis]) / side);
        l->size[axis] = n >= 1 && cells >= 1 ? (uint32_t)fmin(n, cells) : 1;
        l->origin[axis] = lo[axis];
        l->scale[axis] = l->size[axis] / (hi[axis] - lo[axis]);
    }
}

static void bounding_box(const struct grid *g, double lo[2], double hi[2]) {
    box_of(g, 0, lo, hi);
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        double xy[2];
        grid_vertex(g, v, xy);
        for (int axis = 0; axis < 2; axis++) {
            lo[axis] = fmin(lo[axis], xy[axis]);
            hi[axis] = fmax(hi[axis], xy[axis]);
        }
    }
}

/* Two passes over the triangles, as in a counting sort: lengths of the lists, then the lists. */
static void fill(struct locator *l, size_t cells) {
    uint32_t sum = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t t = 0; t < l->grid->triangle_count; t++) {
            uint32_t first[2], last[2];
            cells_of(l, t, first, last);
            for (uint32_t y = first[1]; y <= last[1]; y++)
                for (uint32_t x = first[0]; x <= last[0]; x++) {
                    if (is_outside(l, t, x, y)) continue;
                    uint32_t *at = &l->start[(size_t)y * l->size[0] + x + 1];
                    if (pass == 1) l->item[*at] = t;
                    ++*at;
                }
        }
        for (size_t c = 0; pass == 0 && c < cells; c++) { /* start[c+1]: where list c begins */
            uint32_t n = l->start[c + 1];
            l->start[c + 1] = sum;
            sum += n;
        }
    }
}

bool locator_init(struct locator *l, const struct grid *g, struct err *err) {
    double lo[2], hi[2], cells = (double)g->triangle_count * CELLS_PER_TRIANGLE;
    uint64_t items;
    size_t n;
    *l = (struct locator){.grid = g};
    if (!mem_new(l->corner, g->triangle_count, err)) return false;
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int k = 0; k < 3; k++) memcpy(l->corner[t][k], g->vertex[g->triangle[t][k]], 8);
    bounding_box(g, lo, hi);
    for (;; cells /= 4) {
        choose_cells(l, lo, hi, cells);
        items = count_pairs(l);
        if (items <= (uint64_t)g->triangle_count * PAIRS_PER_TRIANGLE || cells < 1) break;
    }
    if (items > UINT32_MAX) return err_set(err, ERR_INPUT, "too many triangles to locate points");
    n = (size_t)l->size[0] * l->size[1];
    if (mem_new(l->start, n + 1, err) && mem_new(l->item, (size_t)items, err)) {
        fill(l, n);
        return true;
    }
    locator_free(l);
    return false;
}

void locator_free(struct locator *l) {
    free(l->corner);
    free(l->start);
    free(l->item);
    *l = (struct locator){0};
}
