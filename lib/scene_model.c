/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene_model.h"

#include "frame.h"
#include "mem.h"
#include "tessellate.h"

#include <string.h>

enum { BOTTOM, TOP };
static const uint32_t GLASS = 0x6f9fd840, EDGE = 0x27507fff, DOT[2] = {0x7a5195ff, 0xd55e00ff};

/* ---- models ---- */

static void cross(const double a[3], const double b[3], const double c[3], double n[3]) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    }
}

/* Triangle i of the fan of element e, as numbers of vertices. */
static void fan_triangle(const struct model *m, size_t e, size_t i, uint32_t corner[3]) {
    const uint32_t *index = m->index + m->start[e];
    corner[0] = index[0];
    corner[1] = index[i + 1];
    corner[2] = index[i + 2];
}

static size_t fan_size(const struct model *m, size_t e) {
    return m->kind[e] == 'f' ? m->start[e + 1] - m->start[e] - 2 : 0;
}

/* In the model's axes; the cross product is twice the area long. */
static void sum_normals(const struct model *m, double (*normal)[3]) {
    for (size_t e = 0; e < m->element_count; e++)
        for (size_t i = 0; i < fan_size(m, e); i++) {
            uint32_t v[3];
            double n[3];
            fan_triangle(m, e, i, v);
            cross(m->vertex[v[0]], m->vertex[v[1]], m->vertex[v[2]], n);
            for (int l = 0; l < 3; l++)
                for (int c = 0; c < 3; c++) normal[v[l]][c] += n[c];
        }
}

static void to_frame(const int axes[3], const double model[3], double frame[3]) {
    for (int c = 0; c < 3; c++) frame[c] = model[axes[c]];
}

static bool add_element(struct scene *s, const struct model *m, size_t e, const int axes[3],
                        double (*normal)[3], uint32_t colour, struct err *err) {
    const uint32_t *index = m->index + m->start[e];
    for (size_t i = 0; i < fan_size(m, e); i++) {
        struct scene_face face = {.colour = colour};
        uint32_t v[3];
        fan_triangle(m, e, i, v);
        for (int l = 0; l < 3; l++) {
            to_frame(axes, m->vertex[v[l]], face.corner[l]);
            if (normal) to_frame(axes, normal[v[l]], face.normal[l]);
        }
        if (!scene_add_face(s, &face, err)) return false;
    }
    for (size_t i = 0; m->kind[e] == 'l' && i + 1 < m->start[e + 1] - m->start[e]; i++) {
        struct scene_line line = {.width = 1.5, .colour = colour};
        for (int l = 0; l < 2; l++) to_frame(axes, m->vertex[index[i + (size_t)l]], line.end[l]);
        if (!scene_add_line(s, &line, err)) return false;
    }
    return true;
}

bool scene_add_model(struct scene *s, const struct model *model, const int axes[3], bool smooth,
                     uint32_t colour, struct err *err) {
    double(*normal)[3] = NULL;
    bool ok = !smooth || mem_new(normal, model->vertex_count, err);
    if (ok && smooth) sum_normals(model, normal);
    for (size_t e = 0; ok && e < model->element_count; e++)
        ok = add_element(s, model, e, axes, normal, colour, err);
    free(normal);
    return ok;
}

/* ---- prisms ---- */

struct prisms {
    struct scene *scene;
    struct tessellation t;
    struct err *err;
};

static void sample(const struct prisms *p, int sheet, uint32_t point, double at[3]) {
    to_frame(p->t.net.axes, p->t.sheet[sheet][point], at);
}

static bool add_pane(struct prisms *p, const double a[3], const double b[3], const double c[3]) {
    struct scene_face face = {.colour = GLASS};
    memcpy(face.corner[0], a, sizeof face.corner[0]);
    memcpy(face.corner[1], b, sizeof face.corner[1]);
    memcpy(face.corner[2], c, sizeof face.corner[2]);
    return scene_add_face(p->scene, &face, p->err);
}

static bool add_edge(struct prisms *p, const double a[3], const double b[3], double width) {
    struct scene_line line = {.width = width, .colour = EDGE};
    memcpy(line.end[0], a, sizeof line.end[0]);
    memcpy(line.end[1], b, sizeof line.end[1]);
    return scene_add_line(p->scene, &line, p->err);
}

static bool add_surface(struct prisms *p, int sheet, uint32_t triangle) {
    for (int row = 0; row < p->t.net.degree; row++)
        for (int place = 0; place <= 2 * row; place++) {
            uint32_t v[3];
            double at[3][3];
            tessellation_face(&p->t, triangle, row, place, v);
            for (int l = 0; l < 3; l++) sample(p, sheet, v[l], at[l]);
            if (!add_pane(p, at[0], at[1], at[2])) return false;
        }
    return true;
}

/* The edge opposite corner l: on each sheet; at the boundary also the wall between them. */
static bool add_side(struct prisms *p, uint32_t triangle, int l) {
    const bool boundary = !grid_edge_is_inner(&p->t.net, p->t.net.triangle_edge[triangle][l]);
    const double width = boundary ? 1.4 : 0.7;
    for (int step = 0; step < p->t.net.degree; step++) {
        uint32_t end[2];
        double at[2][2][3];
        tessellation_step(&p->t, triangle, l, step, end);
        for (int sheet = 0; sheet < p->t.sheets; sheet++) {
            for (int i = 0; i < 2; i++) sample(p, sheet, end[i], at[sheet][i]);
            if (!add_edge(p, at[sheet][0], at[sheet][1], width)) return false;
        }
        if (p->t.sheets < 2 || !boundary) continue;
        if (!add_pane(p, at[BOTTOM][0], at[BOTTOM][1], at[TOP][1]) ||
            !add_pane(p, at[BOTTOM][0], at[TOP][1], at[TOP][0]))
            return false;
        if (step == 0 && !add_edge(p, at[BOTTOM][0], at[TOP][0], width)) return false;
    }
    return true;
}

static bool add_dots(struct prisms *p, const struct spline *s) {
    for (uint32_t i = 0; i < s->grid.point_count; i++)
        for (int sheet = 0; sheet < p->t.sheets; sheet++) {
            struct scene_line dot = {.width = 1.6, .colour = DOT[s->sigma ? sheet : TOP]};
            for (int l = 0; l < 2; l++) {
                memcpy(dot.end[l], s->phi[i], sizeof s->phi[i]);
                if (s->sigma) dot.end[l][2] = s->sigma[i][sheet];
            }
            if (!scene_add_line(p->scene, &dot, p->err)) return false;
        }
    return true;
}

bool scene_add_prisms(struct scene *s, const struct spline *spline, int steps, struct err *err) {
    struct prisms p = {.scene = s, .err = err};
    bool ok;
    if (!tessellate(&p.t, spline, steps, err)) return false;
    ok = add_dots(&p, spline);
    for (uint32_t t = 0; ok && t < p.t.net.triangle_count; t++) {
        for (int sheet = 0; ok && sheet < p.t.sheets; sheet++) ok = add_surface(&p, sheet, t);
        for (int l = 0; ok && l < 3; l++) /* each inner edge once, from its lower triangle */
            if (p.t.net.edge_triangle[p.t.net.triangle_edge[t][l]][0] == t) ok = add_side(&p, t, l);
    }
    tessellation_free(&p.t);
    return ok;
}
