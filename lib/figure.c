/* SPDX-License-Identifier: GPL-3.0-or-later */
/*  The page:   MARGIN | panel | GAP | panel | MARGIN
 *              legend                                 */
#include "figure.h"

#include "c1.h"
#include "figure_panel.h"
#include "lettering.h"
#include "mem.h"
#include "palette.h"

#include <math.h>
#include <string.h>

static const double MARGIN = 14, GAP = 28, TITLE = 18;

const char *const figure_layer_names[] = {"triangles", "net",  "points",   "types",   "quads",
                                          "labels",    "sets", "jacobian", "outline", NULL};
const char *const figure_side_names[] = {"domain", "deformed", "both", NULL};

/* ---- what is shown ---- */

static void widen(struct figure_panel *p, const double xy[2]) {
    for (int c = 0; c < 2; c++) {
        p->lo[c] = fmin(p->lo[c], xy[c]);
        p->hi[c] = fmax(p->hi[c], xy[c]);
    }
}

/* All control points, or those of the domain's boundary and inner edges where only the curves are
 * drawn: the patches lie in the hull of the former anyway. */
static void measure_spline(struct figure_panel *p) {
    const struct spline *s = p->content->spline;
    for (uint32_t i = 0; i < s->grid.point_count; i++) widen(p, p->point[i]);
    for (size_t i = 0; p->deformed && p->content->edit && i < p->content->edit->move_count; i++) {
        widen(p, p->content->edit->move[i].from);
        widen(p, p->content->edit->move[i].wish);
    }
}

static void measure(struct figure_panel *p) {
    const struct figure_content *content = p->content;
    const struct model *model = content->model[p->deformed];
    p->lo[0] = p->lo[1] = INFINITY;
    p->hi[0] = p->hi[1] = -INFINITY;
    if (content->spline) measure_spline(p);
    for (size_t v = 0; model && v < model->vertex_count; v++) widen(p, model->vertex[v]);
    if (content->image) {
        widen(p, content->image->frame);
        widen(p, content->image->frame + 2);
    }
    for (size_t i = 0; content->lines && i < content->lines->point_count; i++) {
        const double *at = content->lines->point[i], r = p->options->lines.square / 2;
        widen(p, (double[]){at[0] - r, at[1] - r});
        widen(p, (double[]){at[0] + r, at[1] + r});
    }
}

/* The side of a square for each control point. */
static double net_spacing(const struct figure_panel *p) {
    double area = 0;
    const struct spline *s = p->content->spline;
    if (!s) return 0;
    for (uint32_t t = 0; t < s->grid.triangle_count; t++) {
        const uint32_t *c = s->grid.triangle[t];
        area += (double)predicate_area2(s->grid.vertex[c[0]], s->grid.vertex[c[1]],
                                        s->grid.vertex[c[2]]);
    }
    return s->grid.lattice.step * sqrt(area / 2 / s->grid.point_count);
}

/* ---- the page ---- */

static bool draw_panel(const struct figure_panel *p, struct err *err) {
    if (p->content->image) figure_picture(p);
    if (figure_shows(p, FIGURE_JACOBIAN) && !figure_growth(p, err)) return false;
    if (p->content->model[p->deformed]) figure_silhouette(p);
    if (figure_shows(p, FIGURE_QUADS)) figure_quads(p);
    if (figure_shows(p, FIGURE_TRIANGLES)) figure_edges(p, false);
    if (figure_shows(p, FIGURE_OUTLINE)) figure_edges(p, true);
    if (figure_shows(p, FIGURE_NET)) figure_net(p);
    if (figure_shows(p, FIGURE_POINTS) || figure_shows(p, FIGURE_TYPES)) figure_points(p);
    if (figure_shows(p, FIGURE_SETS) && p->content->edit) figure_sets(p);
    if (figure_shows(p, FIGURE_LABELS)) figure_labels(p);
    if (p->content->lines) figure_lines(p);
    return true;
}

/* Sets scale and places; returns the height of the panels. */
static double arrange(struct figure_panel *panel, int n, const struct figure_options *options,
                      double top) {
    const double right = options->layers >> FIGURE_LABELS & 1 ? MARGIN : 0; /* for numbers there */
    double width = 0, height = 0, x = MARGIN;
    double room = options->width - 2 * MARGIN - (n - 1) * GAP - n * right;
    for (int i = 0; i < n; i++) width += fmax(panel[i].hi[0] - panel[i].lo[0], 0);
    for (int i = 0; i < n; i++) height = fmax(height, panel[i].hi[1] - panel[i].lo[1]);
    for (int i = 0; i < n; i++) {
        panel[i].scale = width > 0    ? fmin(room / width, 4 * room / height)
                         : height > 0 ? room / height
                                      : 1;
        panel[i].at[0] = x;
        panel[i].at[1] = top;
        panel[i].spacing = panel[i].scale * net_spacing(&panel[i]);
        x += GAP + right + panel[i].scale * (panel[i].hi[0] - panel[i].lo[0]);
    }
    return panel[0].scale * height;
}

static void write_titles(const struct figure_panel *panel, int n) {
    for (int i = 0; n > 1 && i < n; i++)
        lettering(panel[i].drawing, panel[i].at[0], MARGIN + 9, 10, LETTERING_LEFT, PALETTE_INK,
                  panel[i].deformed ? "deformed" : "domain");
}

static bool draw_page(struct figure_panel *panel, int n, const struct figure_options *options,
                      struct err *err) {
    struct drawing *d = panel[0].drawing;
    double labels = options->layers >> FIGURE_LABELS & 1 ? TITLE / 2 : 0;
    double top = MARGIN + (n > 1 ? TITLE : 0) + labels,
           y = top + arrange(panel, n, options, top) + MARGIN;
    if (!isfinite(y) || !(panel[0].scale > 0))
        return err_set(err, ERR_REFUSAL, "what is to be drawn extends beyond the range of numbers");
    write_titles(panel, n);
    for (int i = 0; i < n; i++)
        if (!draw_panel(&panel[i], err)) return false;
    if (options->legend) y = figure_legend(&panel[n - 1], y);
    d->width = options->width;
    d->height = ceil(y);
    return drawing_ok(d, err);
}

bool figure_draw(struct drawing *d, const struct figure_content *content,
                 const struct figure_options *wanted, struct err *err) {
    struct figure_panel panel[2] = {{0}};
    const struct spline *s = content->spline;
    struct figure_options options = *wanted;
    double(*nominal)[2] = NULL;
    bool ok = !s || mem_new(nominal, s->grid.point_count, err);
    int n = s && options.side == FIGURE_BOTH ? 2 : 1;
    for (uint32_t i = 0; ok && s && i < s->grid.point_count; i++)
        grid_nominal(&s->grid, i, nominal[i]);
    if (!s) options.layers = 0;
    drawing_init(d);
    for (int i = 0; ok && i < n; i++) {
        bool deformed = s && (n == 2 ? i == 1 : options.side == FIGURE_DEFORMED);
        panel[i] = (struct figure_panel){
            .drawing = d, .content = content, .options = &options, .deformed = deformed};
        if (s) panel[i].point = deformed ? (const double(*)[2])s->phi : (const double(*)[2])nominal;
        measure(&panel[i]);
    }
    ok = ok && draw_page(panel, n, &options, err);
    free(nominal);
    return ok;
}
