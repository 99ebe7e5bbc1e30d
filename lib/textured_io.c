/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One pass; indices may lie ahead, so the largest of each kind is checked at the end. */
#include "textured_io.h"

#include "mem.h"
#include "obj_scan.h"

/* Indices of vertices, or of texture coordinates. */
struct list {
    const char *what;
    size_t cap, largest; /* index seen, and where */
    const char *largest_at;
};

struct reader {
    struct obj_scan scan;
    struct textured *t;
    struct list vertices, places;
    size_t face_cap;
};

static bool add_vertex(struct reader *r) {
    struct textured *t = r->t;
    return mem_grow(t->vertex, &r->vertices.cap, t->vertex_count + 1, &r->scan.err) &&
           obj_numbers(&r->scan, "a coordinate", 3, t->vertex[t->vertex_count++]) &&
           obj_more_numbers(&r->scan, "a weight or colour");
}

static bool add_place(struct reader *r) {
    struct textured *t = r->t;
    return mem_grow(t->place, &r->places.cap, t->place_count + 1, &r->scan.err) &&
           obj_numbers(&r->scan, "a texture coordinate", 2, t->place[t->place_count++]) &&
           obj_more_numbers(&r->scan, "a texture coordinate");
}

/* The index that a corner's number means. */
static bool resolve(struct reader *r, struct list *list, const struct obj_corner *corner,
                    int64_t number, size_t count, uint32_t *result) {
    size_t index;
    if (!obj_resolve(&r->scan, corner, list->what, number, count, &index)) return false;
    if (index >= UINT32_MAX)
        return obj_fail(&r->scan, corner->begin, "%s %zu does not exist", list->what, index + 1);
    if (!list->largest_at || index > list->largest) {
        list->largest = index;
        list->largest_at = corner->begin;
    }
    *result = (uint32_t)index;
    return true;
}

static bool next_corner(struct reader *r, uint32_t *vertex, uint32_t *place) {
    struct obj_corner corner;
    if (!obj_corner(&r->scan, &corner)) return false;
    if (corner.texture == 0)
        return obj_expected(&r->scan, corner.begin, "a corner with texture coordinate, v/vt");
    return resolve(r, &r->vertices, &corner, corner.vertex, r->t->vertex_count, vertex) &&
           resolve(r, &r->places, &corner, corner.texture, r->t->place_count, place);
}

static bool add_face(struct reader *r) {
    struct textured *t = r->t;
    struct textured_face face = {.sides = 1};
    uint32_t vertex, place;
    size_t corners = 0;
    for (; next_corner(r, &vertex, &place); corners++) {
        if (corners >= 3) { /* the last one, of which the last side was not the face's */
            face.vertex[1] = face.vertex[2];
            face.place[1] = face.place[2];
            face.sides = 0;
        }
        face.vertex[corners < 2 ? corners : 2] = vertex;
        face.place[corners < 2 ? corners : 2] = place;
        if (corners < 2) continue;
        if (t->face_count == UINT32_MAX - 1)
            return obj_fail(&r->scan, r->scan.line, "more than %u triangles", UINT32_MAX - 1);
        if (!mem_grow(t->face, &r->face_cap, t->face_count + 1u, &r->scan.err)) return false;
        face.sides |= 2;
        t->face[t->face_count++] = face;
    }
    if (r->scan.err.kind) return false;
    if (corners < 3)
        return obj_fail(&r->scan, r->scan.at, "expected 3 or more vertices, got %zu", corners);
    t->face[t->face_count - 1].sides |= 4;
    return true;
}

static bool check_list(struct reader *r, const struct list *list, size_t count) {
    return !list->largest_at || list->largest < count ||
           obj_fail(&r->scan, list->largest_at, "%s %zu does not exist: the model has %zu",
                    list->what, list->largest + 1, count);
}

static bool read_all(struct reader *r) {
    const struct textured *t = r->t;
    enum obj_kind kind;
    while ((kind = obj_next(&r->scan)) != OBJ_END) {
        bool ok = kind == OBJ_VERTEX    ? add_vertex(r)
                  : kind == OBJ_TEXTURE ? add_place(r)
                  : kind == OBJ_FACE    ? add_face(r)
                                        : true;
        if (!ok) return false;
    }
    if (r->scan.err.kind) return false;
    if (t->face_count == 0) return obj_expected(&r->scan, r->scan.end, "a face 'f v/vt v/vt v/vt'");
    return check_list(r, &r->vertices, t->vertex_count) &&
           check_list(r, &r->places, t->place_count);
}

bool textured_read(struct textured *t, const struct filemap *f, struct err *err) {
    struct reader r = {
        .t = t, .vertices = {.what = "vertex"}, .places = {.what = "texture coordinate"}};
    *t = (struct textured){0};
    obj_scan_init(&r.scan, f->name, f->data, f->length);
    if (read_all(&r)) return true;
    *err = r.scan.err;
    textured_free(t);
    return false;
}

void textured_free(struct textured *t) {
    free(t->vertex);
    free(t->place);
    free(t->face);
    *t = (struct textured){0};
}
