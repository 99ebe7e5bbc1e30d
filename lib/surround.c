/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rectangle of cells covers the dilated projection, with a ring of cells to spare around it. The
 * lattice's origin is where cells begin inside the ring, so vertices have no negative coordinates.
 * The model is painted on the cells, the
 * painted cells become the grid, and the locator finds every vertex in it, by exact predicates. */
#include "surround.h"

#include "locate.h"
#include "mem.h"
#include "paint.h"

#include <math.h>

struct frame {
    const struct model *model;
    int axes[3];
    double low[3], high[3]; /* of the model, in the grid's axes */
    double margin, cell;    /* world */
    double step, origin[2];
    int32_t side[2];   /* of a cell and height of a row in steps */
    int32_t first[2];  /* lines of the pattern */
    uint32_t cells[2]; /* with the ring */
};

struct canvas {
    const struct frame *frame;
    struct paint paint;
    double (*xy)[2]; /* of one element */
    size_t cap;
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
        bool overlaps = how->kind == PATTERN_HEX && c == 0; /* by half a cell, to both sides */
        f->cells[c] = (uint32_t)n + 2;
        f->first[c] = -f->side[c] + (overlaps ? f->side[c] / 2 : 0);
        f->origin[c] = (low[c] - floor(spare / 2) - f->side[c] - f->first[c]) * f->step + 0.0;
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

/* A vertex in lattice coordinates. */
static void project(const struct frame *f, size_t vertex, double xy[2]) {
    for (int c = 0; c < 2; c++)
        xy[c] = (f->model->vertex[vertex][f->axes[c]] - f->origin[c]) / f->step;
}

static bool paint_element(struct canvas *canvas, size_t e, struct err *err) {
    const struct model *m = canvas->frame->model;
    size_t n = m->start[e + 1] - m->start[e];
    if (!mem_grow(canvas->xy, &canvas->cap, n, err)) return false;
    for (size_t i = 0; i < n; i++) project(canvas->frame, m->index[m->start[e] + i], canvas->xy[i]);
    if (m->kind[e] == 'f')
        return paint_polygon(&canvas->paint, n, (const double(*)[2])canvas->xy, err);
    for (size_t i = 0; i < n; i++)
        paint_segment(&canvas->paint, canvas->xy[i], canvas->xy[i + 1 < n ? i + 1 : i]);
    return true;
}

/* Vertices that no element has are painted as points. */
static bool paint_loose_vertices(struct canvas *canvas, struct err *err) {
    const struct model *m = canvas->frame->model;
    size_t corners = m->element_count > 0 ? m->start[m->element_count] : 0;
    bool *used;
    if (!mem_new(used, m->vertex_count, err)) return false;
    for (size_t i = 0; i < corners; i++) used[m->index[i]] = true;
    for (size_t v = 0; v < m->vertex_count; v++) {
        double p[2];
        if (used[v]) continue;
        project(canvas->frame, v, p);
        paint_segment(&canvas->paint, p, p);
    }
    free(used);
    return true;
}

static bool paint_model(struct canvas *canvas, struct err *err) {
    for (size_t e = 0; e < canvas->frame->model->element_count; e++)
        if (!paint_element(canvas, e, err)) return false;
    return paint_loose_vertices(canvas, err);
}

/* Vertices and triangles of the painted cells. */
static bool triangulate(struct grid *g, const struct frame *f, const struct pattern *pattern,
                        struct surround_report *report, struct err *err) {
    struct canvas canvas = {.frame = f};
    size_t cells = (size_t)pattern->columns * pattern->ny;
    bool ok =
        paint_init(&canvas.paint, pattern, f->margin / f->step, err) && paint_model(&canvas, err);
    if (ok) {
        report->kept = 0;
        for (size_t c = 0; c < cells; c++) report->kept += canvas.paint.keep[c];
        report->added = paint_join_fans(&canvas.paint);
        ok = pattern_triangulate(pattern, canvas.paint.keep, g, err);
    }
    paint_free(&canvas.paint);
    free(canvas.xy);
    return ok;
}

static bool make_pattern(struct pattern *pattern, const struct frame *f, enum pattern_kind kind,
                         struct err *err) {
    int32_t last[2];
    for (int c = 0; c < 2; c++) last[c] = f->first[c] + (int32_t)f->cells[c] * f->side[c];
    return pattern_init(pattern, kind, f->cells, f->first, last, err);
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
    struct pattern pattern;
    double span;
    bool ok;
    INVARIANT(m->vertex_count > 0);
    measure(&f);
    if (!choose_cell(&f, how, &span, err) || !choose_lattice(&f, how, span, err) ||
        !choose_depth(&f, how, g, err))
        return false;
    g->lattice = (struct lattice){f.step, f.origin[0], f.origin[1]};
    if (!make_pattern(&pattern, &f, how->kind, err)) return false;
    ok = triangulate(g, &f, &pattern, report, err) && grid_build(g, err);
    pattern_free(&pattern);
    if (!ok) return false;
    report->margin = f.margin;
    report->cell = f.cell;
    if (check_inside(g, &f, err)) return true;
    grid_free(g);
    return false;
}
