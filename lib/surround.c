/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rectangle of cells covers the dilated projection, with a ring of cells to spare around it. Its
 * cells are painted in lattice units, in doubles, element by element:
 *
 *   - an edge or a vertex paints the cells nearer than the margin. Strip by strip, the part of the
 *     segment in the dilated strip gives a range of columns; centre and radius of a cell decide
 *     most cases, the distance to its sides the others;
 *
 *             strip   - - - - - - - - -
 *                     |  |  |  |/ |  |        margin above and below, left and right
 *                     - - - - / - - - -
 *   - a polygon also paints the cells within it that its edges left out. Those lie wholly inside or
 *     outside, so the winding number at one point in the middle decides; it comes from the
 *     crossings of the polygon with the middle line of the strip.
 *
 * A margin below 2^-30 of a cell counts as that much, so that rounding loses no cell; others shrink
 * by as much, so that a cell that only touches is not painted. Where two kept cells meet at a
 * vertex only, the smallest gap between them is filled, until every vertex has one fan; that stays
 * within the box of what was painted. Finally the locator finds all vertices, by exact predicates.
 */
#include "surround.h"

#include "locate.h"
#include "mem.h"

#include <math.h>
#include <string.h>

struct frame {
    const struct model *model;
    int axes[3];
    double low[3], high[3]; /* of the model, in the grid's axes */
    double margin, cell;    /* world */
    double step, origin[2]; /* lattice point (0,0) is the low corner inside the ring */
    int32_t side[2];        /* of a cell and height of a row in steps */
    uint32_t cells[2];      /* with the ring */
};

struct crossing {
    double x;
    int turn; /* +1: upwards */
};

struct painter {
    const struct frame *frame;
    struct pattern pattern;
    uint8_t *keep;
    double width, height, radius, reach; /* cell; dilation; from the centre to the far corners */
    struct crossing *crossing;
    size_t crossing_cap;
};

static void measure(struct frame *f) {
    const struct model *m = f->model;
    for (int c = 0; c < 3; c++) {
        f->low[c] = f->high[c] = m->vertex[0][f->axes[c]];
        for (size_t v = 1; v < m->vertex_count; v++) {
            double x = m->vertex[v][f->axes[c]];
            if (x < f->low[c]) f->low[c] = x;
            if (x > f->high[c]) f->high[c] = x;
        }
    }
}

/* Margin, and the wanted side of a cell. */
static bool choose_cell(struct frame *f, const struct surround *how, double *span,
                        struct err *err) {
    double extent = fmax(f->high[0] - f->low[0], f->high[1] - f->low[1]);
    f->margin = how->margin < 0 ? 0.05 * extent : how->margin;
    *span = extent + 2 * f->margin;
    if (*span == 0)
        return err_set(err, ERR_REFUSAL,
                       "the model is a single point in this plane: it needs a margin");
    f->cell = how->cell > 0 ? how->cell : *span / how->cells;
    if (!isfinite(*span + 4 * f->cell))
        return err_set(err, ERR_REFUSAL, "the model, its margin or its cells are too large");
    if (*span / f->cell > SURROUND_CELLS_MAX)
        return err_set(err, ERR_REFUSAL, "%.0f cells along the longer side are more than %d",
                       *span / f->cell, SURROUND_CELLS_MAX);
    return true;
}

/* Side of a cell in steps: so that N cells cover the longer side, or the nearest to a given one. */
static int32_t cell_steps(const struct frame *f, const struct surround *how, double longer) {
    double side = how->cell > 0 ? rint(how->cell / f->step) : ceil(longer / how->cells);
    int32_t s = side < 1 ? 1 : (int32_t)side;
    return how->kind == PATTERN_DIAGONAL ? s : s + s % 2; /* centres and midpoints */
}

/* Places the rectangle of cells on the lattice, in the middle of what it must cover. */
static bool choose_lattice(struct frame *f, const struct surround *how, double span,
                           struct err *err) {
    double low[2], steps[2], far = 0;
    int least = how->kind == PATTERN_DIAGONAL ? 1 : 2;
    for (int c = 0; c < 2; c++) far = fmax(far, fmax(fabs(f->low[c]), fabs(f->high[c])));
    if (!lattice_step(&how->lattice, span + 4 * f->cell, far + f->margin + 2 * f->cell, &f->step,
                      err))
        return false;
    if (f->cell / f->step < least)
        return err_set(err, ERR_REFUSAL,
                       "lattice too coarse: a cell of %g is less than %d steps of %g", f->cell,
                       least, f->step);
    for (int c = 0; c < 2; c++) {
        low[c] = floor((f->low[c] - f->margin) / f->step);
        steps[c] = ceil((f->high[c] + f->margin) / f->step) - low[c];
    }
    f->side[0] = f->side[1] = cell_steps(f, how, fmax(steps[0], steps[1]));
    if (how->kind == PATTERN_HEX) f->side[1] = (13 * f->side[0] + 7) / 15;
    for (int c = 0; c < 2; c++) {
        double n = fmax(1, ceil(steps[c] / f->side[c])), spare = n * f->side[c] - steps[c];
        f->cells[c] = (uint32_t)n + 2;
        f->origin[c] = (low[c] - floor(spare / 2)) * f->step + 0.0;
    }
    f->cell = f->side[0] * f->step;
    return true;
}

/* The grid's depth: none, as given, or the model's. */
static bool choose_depth(const struct frame *f, const struct surround *how, struct grid *g,
                         struct err *err) {
    char axis = "xyz"[f->axes[2]];
    if (how->flat) {
        g->has_depth = false;
    } else if (g->has_depth) {
        if (f->low[2] < g->depth[0] || f->high[2] > g->depth[1])
            return err_set(err, ERR_REFUSAL,
                           "the depth %g..%g does not hold the model's %c: %g..%g", g->depth[0],
                           g->depth[1], axis, f->low[2], f->high[2]);
    } else {
        g->has_depth = true;
        g->depth[0] = f->low[2] - f->margin;
        g->depth[1] = f->high[2] + f->margin;
        if (!(g->depth[0] < g->depth[1]))
            return err_set(err, ERR_REFUSAL,
                           "the model has no thickness along %c and no margin: give a margin or a "
                           "depth, or make a flat grid (--flat)",
                           axis);
    }
    return true;
}

/* Position of a vertex in steps from the low corner of the rectangle of cells. */
static void local(const struct painter *b, size_t vertex, double xy[2]) {
    const struct frame *f = b->frame;
    for (int c = 0; c < 2; c++)
        xy[c] = (f->model->vertex[vertex][f->axes[c]] - f->origin[c]) / f->step + f->side[c];
}

static double square(double x) {
    return x * x;
}

/* Squared distance of p from the segment ab. */
static double distance2(const double p[2], const double a[2], const double b[2]) {
    double dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2 : 0;
    if (t < 0) t = 0;
    if (t > 1) t = 1;
    return square(p[0] - a[0] - t * dx) + square(p[1] - a[1] - t * dy);
}

static double side_of(const double a[2], const double b[2], const double p[2]) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static bool cross(const double a[2], const double b[2], const double c[2], const double d[2]) {
    return (side_of(a, b, c) > 0) != (side_of(a, b, d) > 0) &&
           (side_of(c, d, a) > 0) != (side_of(c, d, b) > 0);
}

/* Is the segment ab nearer than r to the convex polygon? */
static bool is_near(const double a[2], const double b[2], int n, const double (*corner)[2],
                    double r) {
    bool inside = true;
    for (int i = 0; i < n; i++) {
        const double *c = corner[i], *d = corner[(i + 1) % n];
        inside = inside && side_of(c, d, a) >= 0;
        if (cross(a, b, c, d) || distance2(a, c, d) < r * r || distance2(b, c, d) < r * r ||
            distance2(c, a, b) < r * r)
            return true;
    }
    return inside;
}

static void centre_of(const struct painter *b, double column, double row, double centre[2]) {
    bool hex = b->pattern.kind == PATTERN_HEX;
    centre[0] = hex ? column * b->width / 2 : (column + 0.5) * b->width;
    centre[1] = (row + 0.5) * b->height;
}

static bool meets(const struct painter *b, uint32_t column, uint32_t row, const double p[2],
                  const double q[2]) {
    double centre[2], corner[4][2], d2;
    int32_t lattice[4][2];
    int n;
    centre_of(b, column, row, centre);
    d2 = distance2(centre, p, q);
    if (d2 < square(b->radius)) return true;
    if (d2 >= square(b->radius + b->reach)) return false;
    n = pattern_cell(&b->pattern, column, row, lattice);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) corner[i][c] = lattice[i][c] + b->frame->side[c];
    return is_near(p, q, n, (const double(*)[2])corner, b->radius);
}

static uint32_t clamp(double x, uint32_t n) {
    return x < 0 ? 0 : x > n - 1 ? n - 1 : (uint32_t)x;
}

/* The range of x of the part of pq between y0 and y1. */
static void clip(const double p[2], const double q[2], double y0, double y1, double x[2]) {
    double dy = q[1] - p[1], t0 = 0, t1 = 1, xp, xq;
    if (dy != 0) {
        t0 = fmax(0, fmin((y0 - p[1]) / dy, (y1 - p[1]) / dy));
        t1 = fmin(1, fmax((y0 - p[1]) / dy, (y1 - p[1]) / dy));
    }
    xp = p[0] + t0 * (q[0] - p[0]);
    xq = p[0] + t1 * (q[0] - p[0]);
    x[0] = fmin(xp, xq);
    x[1] = fmax(xp, xq);
}

/* The columns whose cells may meet x[0]..x[1]. */
static void columns_of(const struct painter *b, const double x[2], uint32_t range[2]) {
    bool hex = b->pattern.kind == PATTERN_HEX;
    double unit = hex ? b->width / 2 : b->width;
    range[0] = clamp(floor(x[0] / unit) - 1, b->pattern.columns);
    range[1] = clamp(floor(x[1] / unit) + 1, b->pattern.columns);
}

static void paint_segment(struct painter *b, const double p[2], const double q[2]) {
    double r = b->radius, low = fmin(p[1], q[1]) - r, high = fmax(p[1], q[1]) + r;
    uint32_t first = clamp(floor(low / b->height) - 1, b->pattern.ny);
    uint32_t last = clamp(floor(high / b->height) + 1, b->pattern.ny);
    for (uint32_t row = first; row <= last; row++) {
        uint8_t *keep = b->keep + (size_t)row * b->pattern.columns;
        uint32_t range[2];
        double x[2];
        clip(p, q, row * b->height - r, (row + 1) * b->height + r, x);
        x[0] -= r;
        x[1] += r;
        columns_of(b, x, range);
        for (uint32_t c = range[0]; c <= range[1]; c++)
            if (!keep[c]) keep[c] = meets(b, c, row, p, q);
    }
}

static int compare_crossings(const void *p, const void *q) {
    const struct crossing *a = p, *b = q;
    return (a->x > b->x) - (a->x < b->x);
}

/* Where the n vertices of a polygon, a closed line, cross the horizontal line y. */
static bool find_crossings(struct painter *b, const uint32_t *index, size_t n, double y,
                           size_t *count, struct err *err) {
    double p[2], q[2];
    *count = 0;
    local(b, index[n - 1], p);
    for (size_t i = 0; i < n; i++, memcpy(p, q, sizeof p)) {
        local(b, index[i], q);
        if ((p[1] <= y) == (q[1] <= y)) continue;
        if (!mem_grow(b->crossing, &b->crossing_cap, *count + 1, err)) return false;
        b->crossing[(*count)++] = (struct crossing){
            p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]), p[1] <= y ? 1 : -1};
    }
    qsort(b->crossing, *count, sizeof *b->crossing, compare_crossings);
    return true;
}

/* Paints the cells of a row whose middles lie in a polygon. */
static bool fill_row(struct painter *b, const uint32_t *index, size_t n, uint32_t row,
                     struct err *err) {
    double middle[2], unit = b->pattern.kind == PATTERN_HEX ? b->width / 2 : b->width;
    uint8_t *keep = b->keep + (size_t)row * b->pattern.columns;
    size_t count;
    int winding = 0;
    centre_of(b, 0, row, middle);
    if (!find_crossings(b, index, n, middle[1], &count, err)) return false;
    for (size_t i = 0; i + 1 < count; i++) {
        double first = ceil((b->crossing[i].x - middle[0]) / unit);
        double last = floor((b->crossing[i + 1].x - middle[0]) / unit);
        winding += b->crossing[i].turn;
        if (winding == 0 || first > last) continue;
        memset(keep + clamp(first, b->pattern.columns), 1, (size_t)(last - first) + 1);
    }
    return true;
}

static bool fill(struct painter *b, const uint32_t *index, size_t n, struct err *err) {
    double p[2], low = HUGE_VAL, high = -HUGE_VAL, first, last;
    for (size_t i = 0; i < n; i++) {
        local(b, index[i], p);
        low = fmin(low, p[1]);
        high = fmax(high, p[1]);
    }
    first = ceil(low / b->height - 0.5);
    last = floor(high / b->height - 0.5);
    for (double row = first; row <= last; row++)
        if (!fill_row(b, index, n, clamp(row, b->pattern.ny), err)) return false;
    return true;
}

static bool paint_element(struct painter *b, size_t e, struct err *err) {
    const struct model *m = b->frame->model;
    const uint32_t *index = m->index + m->start[e];
    size_t n = m->start[e + 1] - m->start[e];
    double p[2], q[2];
    local(b, index[m->kind[e] == 'f' ? n - 1 : 0], p);
    for (size_t i = 0; i < n; i++, memcpy(p, q, sizeof p)) {
        local(b, index[i], q);
        paint_segment(b, p, q);
    }
    return m->kind[e] != 'f' || fill(b, index, n, err);
}

/* Vertices that no element has are painted as points. */
static bool paint_loose_vertices(struct painter *b, struct err *err) {
    const struct model *m = b->frame->model;
    uint8_t *used;
    if (!mem_new(used, m->vertex_count, err)) return false;
    for (size_t i = 0; i < (m->element_count ? m->start[m->element_count] : 0); i++)
        used[m->index[i]] = 1;
    for (size_t v = 0; v < m->vertex_count; v++) {
        double p[2];
        if (used[v]) continue;
        local(b, v, p);
        paint_segment(b, p, p);
    }
    free(used);
    return true;
}

/* The n cells around vertex i of row j; NULL beyond the rectangle. */
static int cells_around(const struct painter *b, uint32_t i, uint32_t j, uint8_t *cell[6]) {
    const struct pattern *p = &b->pattern;
    int64_t column[6];
    int n = pattern_around(p, i, j, column);
    for (int k = 0; k < n; k++) {
        int64_t row = k < n / 2 ? j : (int64_t)j - 1;
        bool there = column[k] >= 0 && row >= 0 && row < p->ny;
        cell[k] = there ? b->keep + row * p->columns + column[k] : NULL;
    }
    return n;
}

/* Length of the gap that begins at cell k after a kept one, or 0 if none begins there. */
static int gap_at(uint8_t *const cell[6], int n, int k) {
    int length = 0;
    const uint8_t *before = cell[(k + n - 1) % n];
    if (!before || !*before) return 0;
    while (length < n && !(cell[(k + length) % n] && *cell[(k + length) % n])) length++;
    return length;
}

/* Fills the smallest gap if the kept cells around a vertex form several fans; returns the number of
 * cells that this took. */
static size_t join_fans(struct painter *b, uint32_t i, uint32_t j) {
    uint8_t *cell[6];
    int n = cells_around(b, i, j, cell), gaps = 0, best = 0, shortest = n;
    for (int k = 0; k < n; k++) {
        int length = gap_at(cell, n, k);
        gaps += length > 0;
        if (length == 0 || length >= shortest) continue;
        shortest = length;
        best = k;
    }
    if (gaps < 2) return 0;
    for (int k = 0; k < shortest; k++) {
        INVARIANT(cell[(best + k) % n]);
        *cell[(best + k) % n] = 1;
    }
    return (size_t)shortest;
}

static size_t join_all_fans(struct painter *b) {
    size_t added = 0, before;
    do {
        before = added;
        for (uint32_t j = 0; j <= b->pattern.ny; j++)
            for (uint32_t i = 0, n = pattern_row_vertices(&b->pattern, j); i < n; i++)
                added += join_fans(b, i, j);
    } while (added > before);
    return added;
}

static bool paint(struct painter *b, struct surround_report *report, struct err *err) {
    const struct frame *f = b->frame;
    size_t cells = (size_t)b->pattern.columns * b->pattern.ny;
    double tiny;
    if (!mem_new(b->keep, cells, err)) return false;
    b->width = f->side[0];
    b->height = f->side[1];
    b->reach = sqrt(b->width * b->width + b->height * b->height) / 2;
    tiny = b->width * 0x1p-30;
    b->radius = fmax(f->margin / f->step - tiny, tiny);
    for (size_t e = 0; e < f->model->element_count; e++)
        if (!paint_element(b, e, err)) return false;
    if (!paint_loose_vertices(b, err)) return false;
    report->kept = report->added = 0;
    for (size_t c = 0; c < cells; c++) report->kept += b->keep[c];
    report->added = join_all_fans(b);
    return true;
}

static bool triangulate(struct grid *g, const struct frame *f, enum pattern_kind kind,
                        struct surround_report *report, struct err *err) {
    struct painter b = {.frame = f};
    int32_t low[2], high[2];
    bool ok;
    for (int c = 0; c < 2; c++) {
        low[c] = -f->side[c];
        high[c] = low[c] + (int32_t)f->cells[c] * f->side[c];
    }
    ok = pattern_init(&b.pattern, kind, f->cells, low, high, err) && paint(&b, report, err) &&
         pattern_triangulate(&b.pattern, b.keep, g, err);
    pattern_free(&b.pattern);
    free(b.keep);
    free(b.crossing);
    return ok;
}

static bool check_inside(const struct grid *g, const struct frame *f, struct err *err) {
    struct locator locator;
    uint32_t hint = 0, t;
    bool ok = true;
    if (!locator_init(&locator, g, err)) return false;
    for (size_t v = 0; ok && v < f->model->vertex_count; v++) {
        const double *x = f->model->vertex[v];
        const double p[2] = {x[f->axes[0]], x[f->axes[1]]};
        double b[3];
        if (!locate(&locator, p, &hint, &t, b))
            ok = err_set(err, ERR_REFUSAL,
                         "vertex %zu (%g %g %g) does not lie within the grid: it needs a margin or "
                         "a finer lattice",
                         v + 1, x[0], x[1], x[2]);
    }
    locator_free(&locator);
    return ok;
}

bool surround_grid(struct grid *g, const struct model *m, const struct surround *how,
                   struct surround_report *report, struct err *err) {
    struct frame f = {.model = m, .axes = {g->axes[0], g->axes[1], g->axes[2]}};
    double span;
    INVARIANT(m->vertex_count > 0);
    measure(&f);
    if (!choose_cell(&f, how, &span, err) || !choose_lattice(&f, how, span, err) ||
        !choose_depth(&f, how, g, err))
        return false;
    g->lattice = (struct lattice){f.step, f.origin[0], f.origin[1]};
    if (!triangulate(g, &f, how->kind, report, err) || !grid_build(g, err)) return false;
    report->margin = f.margin;
    report->cell = f.cell;
    if (check_inside(g, &f, err)) return true;
    grid_free(g);
    return false;
}
