/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Invariant of the reader: loops [0, loop_count) are closed, points from loop_start[loop_count] on
 * belong to the loop being read. */
#include "xy_io.h"

#include "mem.h"
#include "src.h"

struct reader {
    struct src src;
    struct polygon g;
    size_t point_cap, loop_cap;
    size_t loop_line; /* where the loop being read began */
};

/* Triangle's .poly begins with "vertices 2 attributes markers", all integers. */
static bool is_poly_header(const struct src *src) {
    struct src scan = *src;
    int64_t n;
    for (int i = 0; i < 4; i++)
        if (!src_int(&scan, "", i == 1 ? 2 : 0, i == 1 ? 2 : INT64_MAX, &n)) return false;
    return src_end_line(&scan);
}

static bool end_loop(struct reader *r) {
    struct polygon *g = &r->g;
    size_t n = g->point_count - g->loop_start[g->loop_count];
    if (n == 0) return true;
    if (n < 3)
        return err_set_at(&r->src.err, ERR_INPUT, r->src.name, r->loop_line, 1,
                          "expected a loop of three points or more, got %zu", n);
    if (!mem_grow(g->loop_start, &r->loop_cap, g->loop_count + 2, &r->src.err)) return false;
    g->loop_start[++g->loop_count] = g->point_count;
    return true;
}

static bool read_point(struct reader *r) {
    struct polygon *g = &r->g;
    double x = 0, y = 0;
    if (g->point_count == 0 && is_poly_header(&r->src))
        return src_fail(&r->src, r->src.at,
                        "expected 'x y', got the header of a .poly file; mkgrid --triangulation "
                        "reads those");
    if (!src_double(&r->src, "x", &x) || !src_double(&r->src, "y", &y) || !src_end_line(&r->src) ||
        !mem_grow(g->point, &r->point_cap, g->point_count + 1, &r->src.err))
        return false;
    if (g->point_count == g->loop_start[g->loop_count]) r->loop_line = r->src.line;
    g->point[g->point_count][0] = x;
    g->point[g->point_count++][1] = y;
    return true;
}

static bool read_line(struct reader *r) {
    struct src *src = &r->src;
    const char *word;
    size_t length;
    if (src_take(src, "HOLE")) return src_end_line(src) && end_loop(r);
    if (!src_word(src, &word, &length)) return src->comment || end_loop(r);
    src->at = word;
    return read_point(r);
}

static bool read_all(struct reader *r) {
    if (!mem_grow(r->g.loop_start, &r->loop_cap, 1, &r->src.err)) return false;
    r->g.loop_start[0] = 0;
    while (src_raw_line(&r->src))
        if (!read_line(r)) return false;
    if (r->src.err.kind || !end_loop(r)) return false;
    return r->g.loop_count > 0 || src_expected(&r->src, "a polygon");
}

bool xy_read_polygon(struct polygon *g, const char *path, struct err *err) {
    struct reader r = {0};
    bool ok;
    if (!src_open(&r.src, path, err)) return false;
    ok = read_all(&r) && polygon_build(&r.g, &r.src.err);
    if (!ok) {
        *err = r.src.err;
        polygon_free(&r.g);
    } else
        *g = r.g;
    src_close(&r.src);
    return ok;
}

static bool skip_columns(struct src *src) {
    const char *word;
    size_t length;
    while (src_word(src, &word, &length)) continue;
    return true;
}

bool xy_read_points(double (**point)[2], size_t *count, const char *path, struct err *err) {
    struct src src;
    size_t cap = 0;
    *point = NULL;
    *count = 0;
    if (!src_open(&src, path, err)) return false;
    while (src_line(&src) && mem_grow(*point, &cap, *count + 1, &src.err) &&
           src_double(&src, "x", &(*point)[*count][0]) &&
           src_double(&src, "y", &(*point)[*count][1]) && skip_columns(&src))
        ++*count;
    if (!src.err.kind && *count == 0) src_expected(&src, "a point");
    if (src.err.kind) {
        *err = src.err;
        free(*point);
        *point = NULL;
    }
    src_close(&src);
    return *point != NULL;
}
