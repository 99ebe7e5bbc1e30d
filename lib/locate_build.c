/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A triangle is in the lists of the cells of its bounding box that do not lie strictly outside one
 * of its edges; then each list gives up the triangle to be tried first. */
#include "locate.h"

#include "mem.h"

enum { CELLS_PER_TRIANGLE = 8 };

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

/* Sets the bounding box and the unit. */
static void measure(struct locator *l) {
    const struct grid *g = l->grid;
    double largest;
    double *lo = l->raster.lo, *hi = l->raster.hi;
    box_of(g, 0, lo, hi);
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        double xy[2];
        grid_vertex(g, v, xy);
        for (int axis = 0; axis < 2; axis++) {
            lo[axis] = fmin(lo[axis], xy[axis]);
            hi[axis] = fmax(hi[axis], xy[axis]);
        }
    }
    largest = fmax(fmax(-lo[0], hi[0]), fmax(-lo[1], hi[1]));
    l->unit = largest > 0x1p900 || g->lattice.step > 0x1p900 ? 0x1p-200 : 1;
}

/* The largest |p| + |origin| + |step X| of predicate_side_filter's bound along an axis. */
static double magnitude(const struct locator *l, uint32_t t, int axis) {
    const struct lattice *k = &l->grid->lattice;
    double box = fmax(fabs(l->raster.lo[axis]), fabs(l->raster.hi[axis])), step = 0;
    for (int c = 0; c < 3; c++)
        step = fmax(step, fabs(k->step * l->unit * locator_corner(l, t, c)[axis]));
    return box * l->unit + fabs(axis ? k->y0 : k->x0) * l->unit + step;
}

static void prepare_triangle(const struct locator *l, uint32_t t) {
    const struct lattice *k = &l->grid->lattice;
    struct locator_triangle *q = &l->triangle[t];
    const int32_t *v[3];
    double mx = magnitude(l, t, 0), my = magnitude(l, t, 1);
    for (int c = 0; c < 3; c++) v[c] = locator_corner(l, t, c);
    q->area = k->step * l->unit * (double)predicate_area2(v[0], v[1], v[2]);
    q->bound = q->radius = 0;
    for (int c = 0; c < 3; c++) {
        const int32_t *from = v[(c + 1) % 3], *to = v[(c + 2) % 3];
        q->corner[c][0] = k->x0 * l->unit + k->step * l->unit * v[c][0];
        q->corner[c][1] = k->y0 * l->unit + k->step * l->unit * v[c][1];
        for (int axis = 0; axis < 2; axis++) {
            q->edge[c][axis] = to[axis] - from[axis];
            q->radius += fabs(q->corner[c][axis] - q->corner[0][axis]);
        }
        q->bound = fmax(q->bound, 0x1p-50 * (fabs(q->edge[c][0]) * my + fabs(q->edge[c][1]) * mx));
    }
}

/* Twice the signed area, over step, of edge e of a triangle and the point (x, y), in units. */
static double area(const struct locator_triangle *q, int e, double x, double y) {
    const double *from = q->corner[(e + 1) % 3], *edge = q->edge[e];
    return edge[0] * (y - from[1]) - edge[1] * (x - from[0]);
}

/* Does a rectangle lie strictly outside an edge? Its corner furthest to the inside, which is to the
 * left, decides. */
static bool is_outside(const struct locator *l, uint32_t t, const double x[2], const double y[2]) {
    const struct locator_triangle *q = &l->triangle[t];
    for (int e = 0; e < 3; e++) {
        double corner_x = x[q->edge[e][1] < 0] * l->unit, corner_y = y[q->edge[e][0] > 0] * l->unit;
        if (area(q, e, corner_x, corner_y) < -q->bound) return true;
    }
    return false;
}

static void item_box(const void *locator, uint32_t t, double lo[2], double hi[2]) {
    box_of(((const struct locator *)locator)->grid, t, lo, hi);
}

static bool item_misses(const void *locator, uint32_t t, const double x[2], const double y[2]) {
    return is_outside(locator, t, x, y);
}

/* The item of cell c that is to be tried first: one that holds the centre, as far as the filter can
 * see. */
static uint32_t best_item(const struct locator *l, const struct cells *cells, size_t c) {
    double x[2], y[2], cx, cy;
    cells_rectangle(&cells->raster, c, x, y);
    cx = (x[0] + x[1]) / 2 * l->unit;
    cy = (y[0] + y[1]) / 2 * l->unit;
    for (uint32_t i = cells->start[c]; i < cells->start[c + 1]; i++) {
        const struct locator_triangle *q = &l->triangle[cells->item[i]];
        if (area(q, 0, cx, cy) >= 0 && area(q, 1, cx, cy) >= 0 && area(q, 2, cx, cy) >= 0) return i;
    }
    return cells->start[c];
}

/* Takes over the lists, and the best item of each list out of it. */
static bool choose_first(struct locator *l, struct cells *cells, struct err *err) {
    size_t n = (size_t)cells->raster.size[0] * cells->raster.size[1];
    uint32_t kept = 0;
    l->raster = cells->raster;
    if (!mem_new(l->cell, n + 1, err)) return false;
    for (size_t c = 0; c < n; c++) {
        uint32_t start = cells->start[c], end = cells->start[c + 1], best = best_item(l, cells, c);
        l->cell[c].first = start < end ? cells->item[best] : GRID_NONE;
        l->cell[c].start = kept;
        for (uint32_t i = start; i < end; i++)
            if (i != best) cells->item[kept++] = cells->item[i];
    }
    l->cell[n].start = kept;
    l->item = cells->item;
    cells->item = NULL;
    return true;
}

bool locator_init(struct locator *l, const struct grid *g, struct err *err) {
    struct cells_items items = {g->triangle_count, l, item_box, item_misses};
    struct cells cells = {0};
    bool ok;
    *l = (struct locator){.grid = g};
    measure(l);
    ok = mem_new(l->triangle, g->triangle_count, err);
    for (uint32_t t = 0; ok && t < g->triangle_count; t++) prepare_triangle(l, t);
    ok = ok &&
         cells_init(&cells, l->raster.lo, l->raster.hi, &items, CELLS_PER_TRIANGLE, "triangles",
                    err) &&
         choose_first(l, &cells, err);
    cells_free(&cells);
    if (!ok) locator_free(l);
    return ok;
}

void locator_free(struct locator *l) {
    free(l->triangle);
    free(l->cell);
    free(l->item);
    *l = (struct locator){0};
}
