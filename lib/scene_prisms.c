/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene_prisms.h"

#include "c1.h"
#include "net.h"
#include "tessellate.h"

#include <string.h>

enum { BOTTOM, TOP };
static const uint32_t GLASS = 0x6f9fd840, EDGE = 0x27507fff, QUAD = 0xf0e442ff,
                      CONTROL[2] = {0x7a5195ff, 0xd55e00ff};

const char *const scene_prisms_layer_names[] = {"glass", "triangles", "points",
                                                "net",   "quads",     NULL};

struct prisms {
    struct scene *scene;
    const struct spline *spline;
    const struct scene_prisms_options *options;
    struct tessellation t;
    struct err *err;
};

static bool shows(const struct prisms *p, enum scene_prisms_layer layer) {
    return p->options->layers >> layer & 1;
}

static void sample(const struct prisms *p, int sheet, uint32_t point, double at[3]) {
    for (int c = 0; c < 3; c++) at[c] = p->t.sheet[sheet][point][p->t.net.axes[c]];
}

static void control_point(const struct prisms *p, int sheet, uint32_t point, double at[3]) {
    memcpy(at, p->spline->phi[point], sizeof p->spline->phi[point]);
    at[2] = p->spline->sigma ? p->spline->sigma[point][sheet] : 0;
}

static bool add_face(struct prisms *p, const double a[3], const double b[3], const double c[3],
                     uint32_t colour) {
    struct scene_face face = {.colour = colour};
    memcpy(face.corner[0], a, sizeof face.corner[0]);
    memcpy(face.corner[1], b, sizeof face.corner[1]);
    memcpy(face.corner[2], c, sizeof face.corner[2]);
    return scene_add_face(p->scene, &face, p->err);
}

static bool add_line(struct prisms *p, const double a[3], const double b[3], double width,
                     uint32_t colour) {
    struct scene_line line = {.width = width, .colour = colour};
    memcpy(line.end[0], a, sizeof line.end[0]);
    memcpy(line.end[1], b, sizeof line.end[1]);
    return scene_add_line(p->scene, &line, p->err);
}

static uint32_t control_colour(const struct prisms *p, int sheet) {
    return CONTROL[p->spline->sigma ? sheet : TOP];
}

/* ---- surfaces and walls ---- */

static bool add_surface(struct prisms *p, int sheet, uint32_t triangle) {
    for (int row = 0; row < p->t.net.degree; row++)
        for (int place = 0; place <= 2 * row; place++) {
            uint32_t v[3];
            double at[3][3];
            tessellation_face(&p->t, triangle, row, place, v);
            for (int l = 0; l < 3; l++) sample(p, sheet, v[l], at[l]);
            if (!add_face(p, at[0], at[1], at[2], GLASS)) return false;
        }
    return true;
}

/* Between the surfaces, over one step of an edge of the boundary: at[sheet][end]. */
static bool add_wall(struct prisms *p, double at[2][2][3]) {
    return add_face(p, at[BOTTOM][0], at[BOTTOM][1], at[TOP][1], GLASS) &&
           add_face(p, at[BOTTOM][0], at[TOP][1], at[TOP][0], GLASS);
}

/* The edge opposite corner l, on each sheet; at the boundary also the wall and its upright. */
static bool add_side(struct prisms *p, uint32_t triangle, int l) {
    const bool boundary = !grid_edge_is_inner(&p->t.net, p->t.net.triangle_edge[triangle][l]);
    const bool lines = shows(p, PRISMS_TRIANGLES), wall = p->t.sheets == 2 && boundary;
    const double width = boundary ? 1.4 : 0.7;
    for (int step = 0; step < p->t.net.degree; step++) {
        uint32_t end[2];
        double at[2][2][3];
        tessellation_step(&p->t, triangle, l, step, end);
        for (int sheet = 0; sheet < p->t.sheets; sheet++) {
            for (int i = 0; i < 2; i++) sample(p, sheet, end[i], at[sheet][i]);
            if (lines && !add_line(p, at[sheet][0], at[sheet][1], width, EDGE)) return false;
        }
        if (wall && shows(p, PRISMS_GLASS) && !add_wall(p, at)) return false;
        if (wall && lines && step == 0 && !add_line(p, at[BOTTOM][0], at[TOP][0], width, EDGE))
            return false;
    }
    return true;
}

static bool add_triangle(struct prisms *p, uint32_t triangle) {
    for (int sheet = 0; shows(p, PRISMS_GLASS) && sheet < p->t.sheets; sheet++)
        if (!add_surface(p, sheet, triangle)) return false;
    for (int l = 0; l < 3; l++) /* each inner edge once, from its lower triangle */
        if (p->t.net.edge_triangle[p->t.net.triangle_edge[triangle][l]][0] == triangle &&
            !add_side(p, triangle, l))
            return false;
    return true;
}

/* ---- control points ---- */

static bool add_points(struct prisms *p, int sheet) {
    const double width = shows(p, PRISMS_NET) ? 5 : 1.6;
    for (uint32_t i = 0; i < p->spline->grid.point_count; i++) {
        double at[3];
        control_point(p, sheet, i, at);
        if (!add_line(p, at, at, width, control_colour(p, sheet))) return false;
    }
    return true;
}

/* The lines of the net of triangle t that keep one index. */
static bool add_net(struct prisms *p, int sheet, uint32_t t) {
    const struct grid *g = &p->spline->grid;
    for (int l = 0; l < 3; l++)
        for (int fixed = 0; fixed < g->degree; fixed++)
            for (int k = 0; k < g->degree - fixed; k++) {
                double at[2][3];
                for (int i = 0; i < 2; i++)
                    control_point(p, sheet, net_line_point(g, t, l, fixed, k + i), at[i]);
                if (!add_line(p, at[0], at[1], 0.9, control_colour(p, sheet))) return false;
            }
    return true;
}

/* The conditions of the inner edge e: an extreme and both points on the edge, twice. */
static bool add_quads(struct prisms *p, int sheet, uint32_t e) {
    for (int m = 0; m < p->spline->grid.degree; m++) {
        struct c1_condition condition = c1_condition(&p->spline->grid, e, m);
        double at[4][3];
        for (int i = 0; i < 4; i++) control_point(p, sheet, condition.point[i], at[i]);
        if (!add_face(p, at[0], at[2], at[3], QUAD) || !add_face(p, at[1], at[3], at[2], QUAD))
            return false;
    }
    return true;
}

static bool add_controls(struct prisms *p, int sheet) {
    const struct grid *g = &p->spline->grid;
    if (shows(p, PRISMS_POINTS) && !add_points(p, sheet)) return false;
    for (uint32_t t = 0; shows(p, PRISMS_NET) && t < g->triangle_count; t++)
        if (!add_net(p, sheet, t)) return false;
    for (uint32_t e = 0; shows(p, PRISMS_QUADS) && e < g->edge_count; e++)
        if (grid_edge_is_inner(g, e) && !add_quads(p, sheet, e)) return false;
    return true;
}

bool scene_add_prisms(struct scene *s, const struct spline *spline,
                      const struct scene_prisms_options *options, struct err *err) {
    struct prisms p = {.scene = s, .spline = spline, .options = options, .err = err};
    bool ok = true;
    if (!tessellate(&p.t, spline, options->steps, err)) return false;
    for (int sheet = 0; ok && sheet < p.t.sheets; sheet++)
        if (p.t.sheets == 1 || options->sheets >> sheet & 1) ok = add_controls(&p, sheet);
    for (uint32_t t = 0; ok && t < p.t.net.triangle_count; t++) ok = add_triangle(&p, t);
    tessellation_free(&p.t);
    return ok;
}
