/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counts in headers are checked, never trusted: arrays grow with the records that are there. */
#include "triangle_io.h"

#include "mem.h"
#include "src.h"

#include <string.h>

enum { EXTRA_MAX = 1 << 20 };

struct reader {
    struct src src;
    struct triangulation *t;
    int64_t base; /* number of the first vertex, 0 or 1 */
};

static bool ends_in(const char *path, const char *suffix) {
    size_t n = strlen(path), k = strlen(suffix);
    return n > k && strcmp(path + n - k, suffix) == 0;
}

bool triangle_is_name(const char *path) {
    return ends_in(path, ".node") || ends_in(path, ".ele") || ends_in(path, ".poly");
}

static bool next_line(struct src *src, const char *what) {
    return src_line(src) || (!src->err.kind && src_expected(src, what));
}

/* An integer of a header that may be left out, as Triangle has it: 0 then. */
static bool optional_int(struct src *src, const char *what, int64_t hi, int64_t *n) {
    struct src ahead = *src;
    const char *word;
    size_t length;
    *n = 0;
    return !src_word(&ahead, &word, &length) || src_int(src, what, 0, hi, n);
}

/* The numbers that follow a record's own ones. */
static bool skip_extra(struct src *src, int64_t n) {
    double x;
    for (int64_t i = 0; i < n; i++)
        if (!src_double(src, "an attribute or a marker", &x)) return false;
    return src_end_line(src);
}

static bool read_number(struct reader *r, int64_t i, int64_t base) {
    int64_t n;
    return src_int(&r->src, "the number of the record", i + base, i + base, &n);
}

static bool read_vertex(struct reader *r, size_t *cap, int64_t extra) {
    struct triangulation *t = r->t;
    int64_t i = (int64_t)t->vertex_count;
    double p[2] = {0, 0};
    if (!next_line(&r->src, "a vertex")) return false;
    if (i == 0 && !src_int(&r->src, "the number of the first vertex", 0, 1, &r->base)) return false;
    if ((i > 0 && !read_number(r, i, r->base)) || !src_double(&r->src, "x", &p[0]) ||
        !src_double(&r->src, "y", &p[1]) || !skip_extra(&r->src, extra) ||
        !mem_grow(t->vertex, cap, t->vertex_count + 1, &r->src.err))
        return false;
    memcpy(t->vertex[t->vertex_count++], p, sizeof p);
    return true;
}

/* The header of vertices and, unless there are none, their lines. */
static bool read_vertices(struct reader *r) {
    int64_t n = 0, two, attributes = 0, markers = 0;
    size_t cap = 0;
    if (!next_line(&r->src, "the number of vertices") ||
        !src_int(&r->src, "the number of vertices", 0, UINT32_MAX - 2, &n) ||
        !src_int(&r->src, "the dimension", 2, 2, &two) ||
        !optional_int(&r->src, "the number of attributes", EXTRA_MAX, &attributes) ||
        !optional_int(&r->src, "the number of markers", 1, &markers) || !src_end_line(&r->src))
        return false;
    for (int64_t i = 0; i < n; i++)
        if (!read_vertex(r, &cap, attributes + markers)) return false;
    return true;
}

static bool read_corners(struct reader *r, uint32_t *corner, int n) {
    int64_t v = 0, last = (int64_t)r->t->vertex_count - 1 + r->base;
    for (int c = 0; c < n; c++) {
        if (!src_int(&r->src, "a vertex number", r->base, last, &v)) return false;
        corner[c] = (uint32_t)(v - r->base);
    }
    return true;
}

static bool read_triangles(struct reader *r) {
    struct triangulation *t = r->t;
    int64_t n = 0, corners = 0, attributes = 0;
    size_t cap = 0;
    if (!next_line(&r->src, "the number of triangles") ||
        !src_int(&r->src, "the number of triangles", 1, UINT32_MAX / 3, &n) ||
        !src_int(&r->src, "the corners of a triangle", 3, 6, &corners) ||
        (corners % 3 &&
         !src_fail(&r->src, NULL, "expected 3 or 6 corners of a triangle, got %d", (int)corners)) ||
        !optional_int(&r->src, "the number of attributes", EXTRA_MAX, &attributes) ||
        !src_end_line(&r->src))
        return false;
    for (int64_t i = 0; i < n; i++) {
        if (!next_line(&r->src, "a triangle") ||
            !mem_grow(t->triangle, &cap, (size_t)i + 1, &r->src.err) ||
            !read_number(r, i, r->base) || !read_corners(r, t->triangle[i], 3) ||
            !skip_extra(&r->src, corners - 3 + attributes))
            return false;
        t->triangle_count++;
    }
    return true;
}

/* Segments and holes have numbers from 0 or 1 like the vertices, by Triangle's manual; some writers
 * count otherwise, and nothing refers to them, so any number will do. */
static bool skip_number(struct reader *r) {
    int64_t n;
    return src_int(&r->src, "the number of the record", 0, UINT32_MAX, &n);
}

static bool read_segments(struct reader *r) {
    struct triangulation *t = r->t;
    int64_t n = 0, markers = 0;
    size_t cap = 0;
    if (!next_line(&r->src, "the number of segments") ||
        !src_int(&r->src, "the number of segments", 1, UINT32_MAX - 2, &n) ||
        !optional_int(&r->src, "the number of markers", 1, &markers) || !src_end_line(&r->src))
        return false;
    for (int64_t i = 0; i < n; i++) {
        if (!next_line(&r->src, "a segment") ||
            !mem_grow(t->segment, &cap, (size_t)i + 1, &r->src.err) || !skip_number(r) ||
            !read_corners(r, t->segment[i], 2) || !skip_extra(&r->src, markers))
            return false;
        t->segment_count++;
    }
    return true;
}

static bool read_holes(struct reader *r) {
    struct triangulation *t = r->t;
    int64_t n = 0;
    size_t cap = 0;
    if (!next_line(&r->src, "the number of holes") ||
        !src_int(&r->src, "the number of holes", 0, UINT32_MAX, &n) || !src_end_line(&r->src))
        return false;
    for (int64_t i = 0; i < n; i++) {
        if (!next_line(&r->src, "a hole") || !mem_grow(t->seed, &cap, (size_t)i + 1, &r->src.err) ||
            !skip_number(r) || !src_double(&r->src, "x", &t->seed[i][0]) ||
            !src_double(&r->src, "y", &t->seed[i][1]) || !src_end_line(&r->src))
            return false;
        t->seed_count++;
    }
    return true;
}

static bool at_end(struct reader *r) {
    if (!src_line(&r->src)) return r->src.err.kind == ERR_NONE;
    return src_expected(&r->src, "the end of the file");
}

/* Regional attributes and area limits may follow, and are not meant for us. */
static bool skip_rest(struct reader *r) {
    while (src_line(&r->src)) continue;
    return r->src.err.kind == ERR_NONE;
}

static bool node_part(struct reader *r) {
    return read_vertices(r) && at_end(r);
}

static bool ele_part(struct reader *r) {
    return read_triangles(r) && at_end(r);
}

static bool poly_part(struct reader *r) {
    return read_segments(r) && read_holes(r) && skip_rest(r);
}

static bool read_file(struct reader *r, const char *path, bool (*part)(struct reader *),
                      struct err *err) {
    bool ok;
    if (!src_open(&r->src, path, err)) return false;
    ok = part(r);
    if (!ok) *err = r->src.err;
    src_close(&r->src);
    return ok;
}

bool triangle_read_node(struct triangulation *t, const char *path, struct err *err) {
    struct reader r = {.t = t};
    *t = (struct triangulation){0};
    if (read_file(&r, path, node_part, err)) return true;
    triangulation_free(t);
    return false;
}

bool triangle_read_ele(struct triangulation *t, const char *path, const char *node,
                       struct err *err) {
    struct reader r = {.t = t};
    *t = (struct triangulation){0};
    if (read_file(&r, node, node_part, err) && read_file(&r, path, ele_part, err)) return true;
    triangulation_free(t);
    return false;
}

/* The vertices are in this file or, if there are none, in the other one, which is read before the
 * file goes on. */
static bool read_poly(struct reader *r, const char *node, struct err *err) {
    struct reader other = {.t = r->t};
    if (!read_vertices(r)) return false;
    if (r->t->vertex_count == 0) {
        if (!read_file(&other, node, node_part, err)) return false;
        r->base = other.base;
    }
    return poly_part(r);
}

bool triangle_read_poly(struct triangulation *t, const char *path, const char *node,
                        struct err *err) {
    struct reader r = {.t = t};
    bool ok;
    *t = (struct triangulation){0};
    if (!src_open(&r.src, path, err)) return false;
    ok = read_poly(&r, node, err);
    if (!ok && r.src.err.kind) *err = r.src.err;
    src_close(&r.src);
    if (!ok) triangulation_free(t);
    return ok;
}

/* NAME.node for NAME.ele or NAME.poly. */
static char *node_beside(const char *path, struct err *err) {
    size_t stem = (size_t)(strrchr(path, '.') - path);
    char *name;
    if (!mem_new(name, stem + sizeof ".node", err)) return NULL;
    memcpy(name, path, stem);
    memcpy(name + stem, ".node", sizeof ".node");
    return name;
}

bool triangle_read(struct triangulation *t, const char *path, struct err *err) {
    char *node;
    bool ok;
    if (ends_in(path, ".node")) return triangle_read_node(t, path, err);
    node = node_beside(path, err);
    ok = node &&
         (ends_in(path, ".ele") ? triangle_read_ele : triangle_read_poly)(t, path, node, err);
    free(node);
    return ok;
}
