/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One pass over the text. A positive index may name a vertex that only comes later: all that is
 * kept about them is where the largest stands, to be checked at the end. */
#include "obj_io.h"

#include "filemap.h"
#include "mem.h"
#include "obj_scan.h"

struct reader {
    struct obj_scan scan;
    struct model *model;
    size_t vertex_cap, start_cap, kind_cap, index_cap;
    size_t index_count;
    size_t largest; /* index seen, and where */
    const char *largest_at;
};

static bool add_vertex(struct reader *r) {
    struct model *m = r->model;
    struct err *err = &r->scan.err;
    if (m->vertex_count == UINT32_MAX - 1)
        return obj_fail(&r->scan, r->scan.line, "more than %u vertices", UINT32_MAX - 1);
    if (!mem_grow(m->vertex, &r->vertex_cap, m->vertex_count + 1, err)) return false;
    return obj_numbers(&r->scan, "a coordinate", 3, m->vertex[m->vertex_count++]) &&
           obj_more_numbers(&r->scan, "a weight or colour");
}

/* Ends an element with the indices read since the last one. */
static bool end_element(struct reader *r, char kind) {
    struct model *m = r->model;
    struct err *err = &r->scan.err;
    if (!mem_grow(m->kind, &r->kind_cap, m->element_count + 1, err) ||
        !mem_grow(m->start, &r->start_cap, m->element_count + 2, err))
        return false;
    m->kind[m->element_count++] = kind;
    m->start[m->element_count] = r->index_count;
    return true;
}

static bool add_corner(struct reader *r, const struct obj_corner *corner) {
    struct model *m = r->model;
    size_t index;
    if (!obj_resolve(&r->scan, corner, "vertex", corner->vertex, m->vertex_count, &index) ||
        !mem_grow(m->index, &r->index_cap, r->index_count + 1, &r->scan.err))
        return false;
    if (index >= r->largest) {
        r->largest = index;
        r->largest_at = corner->begin;
    }
    m->index[r->index_count++] = (uint32_t)index;
    return true;
}

/* The corners of an f, l or p statement, of which there must be `least`; every corner of p is an
 * element of its own. */
static bool add_elements(struct reader *r, char kind, size_t least) {
    size_t first = r->index_count;
    struct obj_corner corner;
    while (obj_corner(&r->scan, &corner)) {
        if (!add_corner(r, &corner)) return false;
        if (kind == 'p' && !end_element(r, kind)) return false;
    }
    if (r->scan.err.kind) return false;
    if (r->index_count - first < least)
        return obj_fail(&r->scan, r->scan.at, "expected %zu or more vertices, got %zu", least,
                        r->index_count - first);
    return kind == 'p' || end_element(r, kind);
}

static bool read_statement(struct reader *r, enum obj_kind kind) {
    switch (kind) {
    case OBJ_VERTEX:
        return add_vertex(r);
    case OBJ_FACE:
        return add_elements(r, 'f', 3);
    case OBJ_LINE:
        return add_elements(r, 'l', 2);
    case OBJ_POINT:
        return add_elements(r, 'p', 1);
    default:
        return true;
    }
}

static bool read_all(struct reader *r) {
    struct model *m = r->model;
    enum obj_kind kind;
    if (!mem_grow(m->start, &r->start_cap, 1, &r->scan.err)) return false;
    m->start[0] = 0;
    while ((kind = obj_next(&r->scan)) != OBJ_END)
        if (!read_statement(r, kind)) return false;
    if (m->vertex_count == 0) return obj_expected(&r->scan, r->scan.end, "a vertex line 'v x y z'");
    if (r->largest_at && r->largest >= m->vertex_count)
        return obj_fail(&r->scan, r->largest_at, "vertex %zu does not exist: the model has %zu",
                        r->largest + 1, m->vertex_count);
    return true;
}

bool model_read(struct model *m, const char *path, struct err *err) {
    struct reader r = {.model = m};
    struct filemap file;
    bool ok;
    *m = (struct model){0};
    if (!filemap_open(&file, path, err)) return false;
    obj_scan_init(&r.scan, file.name, file.data, file.length);
    ok = read_all(&r);
    if (!ok) {
        *err = r.scan.err;
        model_free(m);
    }
    filemap_close(&file);
    return ok;
}

void model_free(struct model *m) {
    free(m->vertex);
    free(m->start);
    free(m->index);
    free(m->kind);
    *m = (struct model){0};
}
