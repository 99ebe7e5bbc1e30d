/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "triangulation_io.h"

#include "mem.h"
#include "obj_io.h"
#include "triangle_io.h"
#include "xy_io.h"

#include <string.h>

static bool is_xy_name(const char *path) {
    size_t n = strlen(path);
    return n > 3 && strcmp(path + n - 3, ".xy") == 0;
}

/* Faces only: lines and points of a model are nothing to triangulate. */
static bool take_faces(struct triangulation *t, const struct model *m, const char *path,
                       struct err *err) {
    size_t face = 0;
    for (size_t e = 0; e < m->element_count; e++) {
        if (m->kind[e] != 'f') continue;
        if (m->start[e + 1] - m->start[e] != 3)
            return err_set_at(err, ERR_INPUT, path, 0, 0,
                              "expected triangles, got face %zu (from 0) of %zu corners", face,
                              m->start[e + 1] - m->start[e]);
        memcpy(t->triangle[t->triangle_count++], m->index + m->start[e], sizeof *t->triangle);
        face++;
    }
    return t->triangle_count > 0 ||
           err_set_at(err, ERR_INPUT, path, 0, 0, "expected triangles, got a model without faces");
}

/* All vertices of triangles have the same third coordinate. */
static bool check_flat(const struct triangulation *t, const struct model *m, int depth,
                       const char *path, struct err *err) {
    const uint32_t *first = t->triangle[0];
    for (size_t i = 0; i < t->triangle_count; i++)
        for (int c = 0; c < 3; c++) {
            double z0 = m->vertex[first[0]][depth], z = m->vertex[t->triangle[i][c]][depth];
            if (z != z0)
                return err_set_at(err, ERR_REFUSAL, path, 0, 0,
                                  "expected a flat model, got %c = %.9g and %.9g (triangle %zu); "
                                  "name its plane with --plane",
                                  "xyz"[depth], z0, z, i);
        }
    return true;
}

static bool take_model(struct triangulation *t, const struct model *m, const char *path,
                       const int axes[3], struct err *err) {
    if (!mem_new(t->vertex, m->vertex_count, err) || !mem_new(t->triangle, m->element_count, err))
        return false;
    t->vertex_count = m->vertex_count;
    for (size_t v = 0; v < m->vertex_count; v++)
        for (int c = 0; c < 2; c++) t->vertex[v][c] = m->vertex[v][axes[c]];
    return take_faces(t, m, path, err) && check_flat(t, m, axes[2], path, err);
}

static bool read_obj(struct triangulation *t, const char *path, const int axes[3],
                     struct err *err) {
    struct model m;
    bool ok;
    if (!model_read(&m, path, err)) return false;
    ok = take_model(t, &m, strcmp(path, "-") == 0 ? "<stdin>" : path, axes, err);
    model_free(&m);
    return ok;
}

bool triangulation_read(struct triangulation *t, const char *path, const int axes[3],
                        struct err *err) {
    bool ok;
    *t = (struct triangulation){0};
    if (triangle_is_name(path)) return triangle_read(t, path, err);
    ok = is_xy_name(path) ? xy_read_points(&t->vertex, &t->vertex_count, path, err)
                          : read_obj(t, path, axes, err);
    if (!ok) triangulation_free(t);
    return ok;
}
