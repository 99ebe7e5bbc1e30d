/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lists of a locator's cells are made as in a counting sort: all triangles of all cells, in
 * ascending order; then each list gives up the triangle to be tried first. A triangle is in the
 * lists of the cells of its bounding box that do not lie strictly outside one of its edges. */
#include "locate.h"

#include "mem.h"

enum {
    CELLS_PER_TRIANGLE = 8,
    PAIRS_PER_TRIANGLE = 64, /* with more, larger cells are taken: needles cross many */
};

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
        first[axis] = locator_column(l, axis, lo[axis]);
        last[axis] = locator_column(l, axis, hi[axis]);
    }
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
static void choose_cells(struct locator *l, double cells) {
    const double extent[2] = {l->hi[0] - l->lo[0], l->hi[1] - l->lo[1]};
    for (int axis = 0; axis < 2; axis++) {
        double n = ceil(sqrt(cells * (extent[axis] / extent[1 - axis])));
        l->size[axis] = n >= 1 && cells >= 1 ? (uint32_t)fmin(n, fmin(cells, INT32_MAX)) : 1;
        l->scale[axis] = l->size[axis] / extent[axis];
        if (l->scale[axis] > 0 && isfinite(l->scale[axis])) continue;
        l->size[axis] = 1; /* too large or too small for a scale */
        l->scale[axis] = 0;
    }
}

/* Sets the bounding box and the unit. */
static void measure(struct locator *l) {
    const struct grid *g = l->grid;
    double largest;
    box_of(g, 0, l->lo, l->hi);
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        double xy[2];
        grid_vertex(g, v, xy);
        for (int axis = 0; axis < 2; axis++) {
            l->lo[axis] = fmin(l->lo[axis], xy[axis]);
            l->hi[axis] = fmax(l->hi[axis], xy[axis]);
        }
    }
    largest = fmax(fmax(-l->lo[0], l->hi[0]), fmax(-l->lo[1], l->hi[1]));
    l->unit = largest > 0x1p900 || g->lattice.step > 0x1p900 ? 0x1p-200 : 1;
}

/* The largest |p| + |origin| + |step X| of predicate_side_filter's bound along an axis. */
static double magnitude(const struct locator *l, uint32_t t, int axis) {
    const struct lattice *k = &l->grid->lattice;
    double box = fmax(fabs(l->lo[axis]), fabs(l->hi[axis])), step = 0;
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

/* Does a box of cells lie strictly outside an edge? Its corner furthest to the inside, which is to
 * the left, decides. */
static bool is_outside(const struct locator_triangle *q, const double x[2], const double y[2]) {
    for (int e = 0; e < 3; e++)
        if (area(q, e, x[q->edge[e][1] < 0], y[q->edge[e][0] > 0]) < -q->bound) return true;
    return false;
}

/* The ends of column (row) number i, in units, wider than they can be by any rounding: a column is
 * off by less than 2^-19 of a cell, an end as computed here by some ulps of its own magnitude.
 * Infinite, so that nothing is outside, where there is one column without a scale. */
static void cell_ends(const struct locator *l, int axis, uint32_t i, double end[2]) {
    for (int k = 0; k < 2; k++) {
        double from_lo = (i + (k ? 1 + 0x1p-16 : -0x1p-16)) / l->scale[axis];
        double slack = 0x1p-50 * (fabs(l->lo[axis]) + fabs(from_lo));
        end[k] = (l->lo[axis] + from_lo + (k ? slack : -slack)) * l->unit;
    }
}

/* Counts triangle t in the lists of its cells, or with `put` puts it there. */
static void visit_cells(struct locator *l, uint32_t t, bool put) {
    uint32_t first[2], last[2];
    cells_of(l, t, first, last);
    for (uint32_t row = first[1]; row <= last[1]; row++) {
        double x[2], y[2];
        cell_ends(l, 1, row, y);
        for (uint32_t column = first[0]; column <= last[0]; column++) {
            uint32_t *at = &l->cell[(size_t)row * l->size[0] + column + 1].start;
            cell_ends(l, 0, column, x);
            if (is_outside(&l->triangle[t], x, y)) continue;
            if (put) l->item[*at] = t;
            ++*at;
        }
    }
}

/* Two passes over the triangles, as in a counting sort: lengths of the lists, then the lists. */
static void fill(struct locator *l, size_t cells) {
    uint32_t sum = 0;
    for (uint32_t t = 0; t < l->grid->triangle_count; t++) visit_cells(l, t, false);
    for (size_t c = 0; c < cells; c++) { /* where list c begins */
        uint32_t n = l->cell[c + 1].start;
        l->cell[c + 1].start = sum;
        sum += n;
    }
    for (uint32_t t = 0; t < l->grid->triangle_count; t++) visit_cells(l, t, true);
}

/* The item of cell c, of lists as `fill` leaves them, that is to be tried first: one that holds the
 * centre, as far as the filter can see. */
static uint32_t best_item(const struct locator *l, size_t c) {
    double x[2], y[2], cx, cy;
    cell_ends(l, 0, (uint32_t)(c % l->size[0]), x);
    cell_ends(l, 1, (uint32_t)(c / l->size[0]), y);
    cx = (x[0] + x[1]) / 2;
    cy = (y[0] + y[1]) / 2;
    for (uint32_t i = l->cell[c].start; i < l->cell[c + 1].start; i++) {
        const struct locator_triangle *q = &l->triangle[l->item[i]];
        if (area(q, 0, cx, cy) >= 0 && area(q, 1, cx, cy) >= 0 && area(q, 2, cx, cy) >= 0) return i;
    }
    return l->cell[c].start;
}

/* Takes the best item of each list out of it. */
static void choose_first(struct locator *l, size_t cells) {
    uint32_t kept = 0;
    for (size_t c = 0; c < cells; c++) {
        uint32_t start = l->cell[c].start, end = l->cell[c + 1].start, best = best_item(l, c);
        l->cell[c].first = start < end ? l->item[best] : GRID_NONE;
        l->cell[c].start = kept;
        for (uint32_t i = start; i < end; i++)
            if (i != best) l->item[kept++] = l->item[i];
    }
    l->cell[cells].start = kept;
}

bool locator_init(struct locator *l, const struct grid *g, struct err *err) {
    double cells = (double)g->triangle_count * CELLS_PER_TRIANGLE;
    uint64_t items;
    size_t n;
    *l = (struct locator){.grid = g};
    measure(l);
    for (;; cells /= 4) {
        choose_cells(l, cells);
        items = count_pairs(l);
        if (items <= (uint64_t)g->triangle_count * PAIRS_PER_TRIANGLE || cells < 1) break;
    }
    if (items > UINT32_MAX) return err_set(err, ERR_INPUT, "too many triangles to locate points");
    n = (size_t)l->size[0] * l->size[1];
    if (mem_new(l->triangle, g->triangle_count, err) && mem_new(l->cell, n + 1, err) &&
        mem_new(l->item, (size_t)items, err)) {
        for (uint32_t t = 0; t < g->triangle_count; t++) prepare_triangle(l, t);
        fill(l, n);
        choose_first(l, n);
        return true;
    }
    locator_free(l);
    return false;
}

void locator_free(struct locator *l) {
    free(l->triangle);
    free(l->cell);
    free(l->item);
    *l = (struct locator){0};
}
