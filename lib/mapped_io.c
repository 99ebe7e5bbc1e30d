/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mapped_io.h"

#include "list_io.h"
#include "mem.h"
#include "obj_copy.h"

#include <string.h>

static bool open_points(struct mapped *m, const char *path, bool many, struct err *err) {
    struct vertices *v = &m->vertices;
    if (!vertices_open(v, path, m->model ? VERTICES_OBJ : VERTICES_XY, err)) return false;
    m->places.count = v->points.vertex_count;
    if (many) {
        if (!mem_new(m->given, m->places.count, err)) return false;
        memcpy(m->given, v->points.vertex, m->places.count * sizeof *m->given);
    }
    return m->use != ICC_NAME || mem_new(m->places.place, m->places.count, err);
}

bool mapped_open(struct mapped *m, const char *path, const struct cage *source, bool many,
                 struct err *err) {
    if (m->use == ICC_ASK)
        return filemap_open(&m->vertices.file, path, err) &&
               places_read(&m->places, &m->vertices.file, source, err);
    return open_points(m, path, many, err);
}

void mapped_close(struct mapped *m) {
    free(m->given);
    places_free(&m->places);
    vertices_close(&m->vertices);
    *m = (struct mapped){0};
}

bool mapped_map(struct mapped *m, struct icc_map *map, const char *cage_name,
                struct progress *progress, struct err *err) {
    struct icc_batch batch = {.count = m->places.count,
                              .points =
                                  m->use == ICC_ASK ? m->places.point : m->vertices.points.vertex,
                              .axes = {m->axes[0], m->axes[1]},
                              .places = m->places.place,
                              .progress = progress};
    if (m->given) memcpy(batch.points, m->given, batch.count * sizeof *batch.points);
    if (!icc_map_batch(map, &batch, err)) return false;
    return batch.outside == 0 || m->use == ICC_ASK || m->keep_outside ||
           vertices_refuse(&m->vertices, cage_name, batch.outside, batch.first, err);
}

bool mapped_write(struct out *out, const struct mapped *m, const struct cage *source,
                  struct err *err) {
    const struct vertices *v = &m->vertices;
    const struct obj_change model = {
        .vertex = v->points.vertex, .normals = OBJ_NORMALS_KEEP, .digits = m->digits};
    const struct list_change list = {.columns = 2, .point = v->points.vertex, .digits = m->digits};
    if (m->use == ICC_NAME) return places_name(out, &v->file, &m->places, source, m->digits, err);
    if (m->use == ICC_ASK) return places_ask(out, &v->file, &m->places, m->digits, err);
    return m->model ? obj_copy(out, &v->file, &v->points, &model, err)
                    : list_copy(out, &v->file, v->points.vertex_count, &list, err);
}
