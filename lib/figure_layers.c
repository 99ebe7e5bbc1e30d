/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "c1.h"
#include "curve.h"
#include "figure_panel.h"
#include "lettering.h"
#include "mem.h"
#include "net.h"
#include "palette.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double CURVE_TOLERANCE = 0.05;

double figure_size(const struct figure_panel *p, double part, double least, double most) {
    return fmin(fmax(part * p->spacing, least), most);
}

void figure_picture(const struct figure_panel *p) {
    const struct figure_image *image = p->content->image;
    size_t n = (size_t)image->width * image->height;
    double first[2], last[2];
    uint32_t *copy;
    if (!mem_new(copy, n, &p->drawing->err)) return;
    memcpy(copy, image->pixel, n * sizeof *copy);
    figure_page(p, image->frame, first);
    figure_page(p, image->frame + 2, last);
    drawing_place(p->drawing, image->width, image->height, copy, first, last);
}

/* ---- silhouette ---- */

static void trace_element(const struct figure_panel *p, const struct model *m, size_t e) {
    size_t n = m->start[e + 1] - m->start[e];
    const uint32_t *index = m->index + m->start[e];
    double area = 0;
    for (size_t i = 0; i < n; i++) {
        const double *a = m->vertex[index[i]], *b = m->vertex[index[(i + 1) % n]];
        area += a[0] * b[1] - a[1] * b[0];
    }
    for (size_t i = 0; i < n; i++) { /* faces all turn one way, or they would cancel */
        double at[2];
        figure_page(p, m->vertex[index[area < 0 ? n - 1 - i : i]], at);
        (i ? drawing_line : drawing_move)(p->drawing, at[0], at[1]);
    }
    if (m->kind[e] == 'f') drawing_close(p->drawing);
}

void figure_silhouette(const struct figure_panel *p) {
    const struct model *m = p->content->model[p->deformed];
    const uint32_t fill = p->content->image ? PALETTE_SHADOW & 0xffffff99 : PALETTE_SHADOW;
    for (size_t e = 0; e < m->element_count; e++)
        if (m->kind[e] == 'f') trace_element(p, m, e);
    drawing_paint(p->drawing, &(struct drawing_ink){.fill = fill});
    for (size_t e = 0; e < m->element_count; e++)
        if (m->kind[e] == 'l') trace_element(p, m, e);
    drawing_paint(p->drawing, &(struct drawing_ink){.stroke = PALETTE_SHADOW, .width = 1.5});
}

/* ---- growth ---- */

static void domain_place(const struct grid *g, uint32_t t, const double b[3], double at[2]) {
    at[0] = at[1] = 0;
    for (int l = 0; l < 3; l++) {
        double corner[2];
        grid_vertex(g, g->triangle[t][l], corner);
        for (int c = 0; c < 2; c++) at[c] += b[l] * corner[c];
    }
}

static void sample(struct spline_cursor *cursor, uint32_t t, const double b[3], double value[3],
                   double *det) {
    const struct grid *g = &cursor->spline->grid;
    double at[3] = {0}, jacobian[3][3];
    domain_place(g, t, b, at);
    if (g->has_depth) at[2] = g->depth[0];
    spline_cursor_evaluate(cursor, t, b, at, value, jacobian);
    *det = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
}

/* A small triangle of one colour, on the page. */
struct cell {
    uint32_t colour;
    double corner[3][2];
};

struct cells {
    struct cell *cell;
    size_t count, cap;
};

/* Adds the cell with the barycentric corners b, coloured by its middle: to 64 steps a channel, so
 * that many cells have the same colour and become one shape. */
static bool add_cell(struct cells *cells, const struct figure_panel *p,
                     struct spline_cursor *cursor, uint32_t t, double b[3][3], struct err *err) {
    double middle[3], value[3], det;
    struct cell *cell;
    if (!mem_grow(cells->cell, &cells->cap, cells->count + 1, err)) return false;
    cell = &cells->cell[cells->count++];
    for (int k = 0; k < 3; k++) {
        middle[k] = (b[0][k] + b[1][k] + b[2][k]) / 3;
        if (p->deformed)
            sample(cursor, t, b[k], value, &det);
        else
            domain_place(&cursor->spline->grid, t, b[k], value);
        figure_page(p, value, cell->corner[k]);
    }
    sample(cursor, t, middle, value, &det);
    cell->colour = palette_growth(det) & 0xfcfcfcff;
    return true;
}

static int compare_cells(const void *a, const void *b) {
    const struct cell *m = a, *n = b;
    const uint32_t fold = palette_growth(-1) & 0xfcfcfcff;
    if ((m->colour == fold) != (n->colour == fold)) return m->colour == fold ? 1 : -1; /* last */
    if (m->colour != n->colour) return m->colour < n->colour ? -1 : 1;
    for (int i = 0; i < 6; i++) { /* any order, but always the same */
        double x = m->corner[i / 2][i % 2], y = n->corner[i / 2][i % 2];
        if (x != y) return x < y ? -1 : 1;
    }
    return 0;
}

static void paint_cells(const struct figure_panel *p, struct cells *cells) {
    if (cells->count > 1) qsort(cells->cell, cells->count, sizeof *cells->cell, compare_cells);
    for (size_t i = 0; i < cells->count; i++) {
        uint32_t colour = cells->cell[i].colour;
        drawing_polygon(p->drawing, 3, (const double(*)[2])cells->cell[i].corner);
        if (i + 1 == cells->count || cells->cell[i + 1].colour != colour)
            drawing_paint(p->drawing,
                          &(struct drawing_ink){.fill = colour, .stroke = colour, .width = 0.4});
    }
}

/* The cells of triangle t: corner k of cell (i, j) is (i, j) plus a unit of the k-th barycentric
 * coordinate; of a cell upside down, (i+1, j+1) less a unit of it. */
static bool add_triangle(struct cells *cells, const struct figure_panel *p,
                         struct spline_cursor *cursor, uint32_t t, int steps, struct err *err) {
    for (int i = 0; i < steps; i++)
        for (int j = 0; i + j < steps; j++)
            for (int down = 0; down < (i + j + 1 < steps ? 2 : 1); down++) {
                double b[3][3];
                for (int k = 0; k < 3; k++) {
                    int bi = i + (down ? k != 0 : k == 0), bj = j + (down ? k != 1 : k == 1);
                    b[k][0] = bi / (double)steps;
                    b[k][1] = bj / (double)steps;
                    b[k][2] = (steps - bi - bj) / (double)steps;
                }
                if (!add_cell(cells, p, cursor, t, b, err)) return false;
            }
    return true;
}

bool figure_growth(const struct figure_panel *p, struct err *err) {
    const struct spline *s = p->content->spline;
    struct spline_cursor cursor;
    struct cells cells = {0};
    double side = p->spacing * s->grid.degree; /* of a triangle, about */
    int steps = (int)fmin(fmax(side / 7, 2), 32);
    bool ok = spline_cursor_init(&cursor, s, err);
    for (uint32_t t = 0; ok && t < s->grid.triangle_count; t++)
        ok = add_triangle(&cells, p, &cursor, t, steps, err);
    if (ok) paint_cells(p, &cells);
    free(cells.cell);
    spline_cursor_free(&cursor);
    return ok;
}

/* ---- edges, net, points ---- */

static void trace_edge(const struct figure_panel *p, uint32_t e) {
    const struct grid *g = &p->content->spline->grid;
    const int d = g->degree;
    uint32_t t = g->edge_triangle[e][0];
    int from = grid_corner(g, t, g->edge[e][0]), to = grid_corner(g, t, g->edge[e][1]);
    double q[GRID_DEGREE_MAX + 1][2];
    for (int k = 0; k <= d; k++) {
        int weight[3] = {0};
        weight[from] = d - k;
        weight[to] += k;
        figure_page(p, p->point[grid_point(g, t, weight[0], weight[1], weight[2])], q[k]);
    }
    drawing_move(p->drawing, q[0][0], q[0][1]);
    if (p->deformed)
        curve_draw(p->drawing, d, (const double(*)[2])q, CURVE_TOLERANCE);
    else
        drawing_line(p->drawing, q[d][0], q[d][1]);
}

void figure_edges(const struct figure_panel *p, bool boundary) {
    const struct grid *g = &p->content->spline->grid;
    for (uint32_t e = 0; e < g->edge_count; e++)
        if (!boundary || !grid_edge_is_inner(g, e)) trace_edge(p, e);
    drawing_paint(p->drawing,
                  &(struct drawing_ink){.stroke = PALETTE_INK, .width = boundary ? 1.8 : 0.8});
}

/* The lines of constant i, j or k in the net of each triangle; those on edges once a triangle. */
void figure_net(const struct figure_panel *p) {
    const struct grid *g = &p->content->spline->grid;
    const int d = g->degree;
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++)
            for (int fixed = 0; fixed < d; fixed++)
                for (int k = 0; k <= d - fixed; k++) {
                    double at[2];
                    figure_page(p, p->point[net_line_point(g, t, l, fixed, k)], at);
                    (k ? drawing_line : drawing_move)(p->drawing, at[0], at[1]);
                }
    drawing_paint(p->drawing, &(struct drawing_ink){.stroke = PALETTE_PALE, .width = 0.4});
}

void figure_type_mark(struct drawing *d, double x, double y, double size, enum point_type type) {
    static const double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const double up[3][2] = {{-1.1, 0.8}, {1.1, 0.8}, {0, -1.2}};
    struct drawing_ink ink = {
        .fill = palette_category((uint32_t)type), .stroke = PALETTE_INK, .width = 0.4};
    int n = type == TYPE_EDGE || type == TYPE_EDGE_CORNER ? 4 : 3;
    if (type == TYPE_CORNER || type == TYPE_INTERIOR)
        drawing_disc(d, x, y, type == TYPE_CORNER ? 1.3 * size : 0.8 * size);
    else
        for (int i = 0; i < n; i++) {
            const double *at = n == 4 ? square[i] : up[i];
            (i ? drawing_line : drawing_move)(d, x + size * at[0] * 0.9, y + size * at[1] * 0.9);
            if (i == n - 1) drawing_close(d);
        }
    drawing_paint(d, &ink);
}

void figure_points(const struct figure_panel *p) {
    const struct grid *g = &p->content->spline->grid;
    const bool types = figure_shows(p, FIGURE_TYPES);
    const double size = figure_size(p, 0.16, 0.8, types ? 4.5 : 3);
    for (uint32_t i = 0; i < g->point_count; i++) {
        double at[2];
        figure_page(p, p->point[i], at);
        if (types)
            figure_type_mark(p->drawing, at[0], at[1], size, c1_type(g, i));
        else
            drawing_disc(p->drawing, at[0], at[1], size);
    }
    drawing_paint(p->drawing, &(struct drawing_ink){.fill = PALETTE_INK});
}

/* ---- quadrilateral conditions ---- */

static void trace_quad(const struct figure_panel *p, uint32_t e, int m) {
    static const int round[4] = {0, 2, 1, 3}; /* an extreme, an edge point, and so on */
    struct c1_condition condition = c1_condition(&p->content->spline->grid, e, m);
    double corner[4][2];
    for (int i = 0; i < 4; i++) figure_page(p, p->point[condition.point[round[i]]], corner[i]);
    drawing_polygon(p->drawing, 4, (const double(*)[2])corner);
}

void figure_quads(const struct figure_panel *p) {
    const struct grid *g = &p->content->spline->grid;
    const struct edit_trace *edit = p->content->edit;
    const uint32_t d = (uint32_t)g->degree;
    const struct drawing_ink ink = {.fill = 0xf0e44280, .stroke = 0xb8a800ff, .width = 0.5};
    if (edit)
        for (size_t i = 0; i < edit->condition_count; i++) {
            trace_quad(p, (uint32_t)(edit->condition[i] / d), (int)(edit->condition[i] % d));
            drawing_paint(p->drawing, &ink);
        }
    else
        for (uint32_t e = 0; e < g->edge_count; e++)
            for (int m = 0; grid_edge_is_inner(g, e) && m < g->degree; m++) {
                trace_quad(p, e, m);
                drawing_paint(p->drawing, &ink);
            }
}

/* ---- labels ---- */

static void label(const struct figure_panel *p, const double xy[2], double size, double aside,
                  uint32_t colour, uint32_t number) {
    const enum lettering_align align = aside > 0 ? LETTERING_LEFT : LETTERING_CENTRE;
    char text[16];
    double at[2];
    figure_page(p, xy, at);
    at[0] += aside;
    at[1] += aside > 0 ? -aside : size / 2;
    (void)snprintf(text, sizeof text, "%u", number);
    lettering_halo(p->drawing, at[0], at[1], size, align, 0xffffffd0, text);
    lettering(p->drawing, at[0], at[1], size, align, colour, text);
}

void figure_labels(const struct figure_panel *p) {
    const struct grid *g = &p->content->spline->grid;
    if (figure_shows(p, FIGURE_POINTS) || figure_shows(p, FIGURE_TYPES) ||
        figure_shows(p, FIGURE_NET)) {
        double size = figure_size(p, 0.28, 2.5, 8);
        for (uint32_t i = 0; i < g->point_count; i++)
            label(p, p->point[i], size, 0.5 * size, PALETTE_INK, i);
        return;
    }
    double size = figure_size(p, 0.6, 4, 11);
    for (uint32_t v = 0; v < g->vertex_count; v++)
        label(p, p->point[v], size, 0.4 * size, PALETTE_INK, v);
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        double middle[2] = {0};
        for (int l = 0; l < 3; l++)
            for (int c = 0; c < 2; c++) middle[c] += p->point[g->triangle[t][l]][c] / 3;
        label(p, middle, size, 0, palette_category(0), t);
    }
}
