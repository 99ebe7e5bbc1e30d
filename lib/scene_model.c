/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene_model.h"

#include "mem.h"

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
        struct scene_face face = {.colour = colour, .pane = SCENE_MODEL};
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
