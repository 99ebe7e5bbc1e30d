/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reading goes down the records in their one order. The src error is sticky, so a function may read
 * all numbers of a line and look at the outcome once. Vertices and triangles go into arrays that
 * grow with what was read, whatever the counts say; with the last triangle the topology is built,
 * and tells how many points must follow. */
#include "grid_io.h"

#include "mem.h"
#include "record_io.h"

#include <stdio.h>
#include <zlib.h>

struct reader {
    struct src src;
    struct grid grid;
    bool plane, lattice;                               /* were there */
    size_t *vertex_line, *triangle_line, lattice_line; /* where a culprit stands */
};

static bool read_degree(struct reader *r) {
    int64_t degree = 0;
    if (!src_expect(&r->src, "degree") ||
        !src_int(&r->src, "a degree", 1, GRID_DEGREE_MAX, &degree) || !src_end_line(&r->src))
        return false;
    r->grid.degree = (int)degree;
    return record_next(&r->src);
}

static bool read_plane(struct reader *r) {
    const char *before, *word;
    size_t length;
    if (!src_take(&r->src, "plane")) return true;
    r->plane = true;
    before = r->src.at;
    if (!src_word(&r->src, &word, &length) || !grid_axes(word, length, r->grid.axes)) {
        r->src.at = before;
        return src_expected(&r->src, "two different letters of xyz");
    }
    return src_end_line(&r->src) && record_next(&r->src);
}

static bool read_lattice(struct reader *r) {
    struct lattice *l = &r->grid.lattice;
    const char *step;
    if (!src_take(&r->src, "lattice")) return true;
    r->lattice = true;
    step = r->src.at;
    if (!src_double(&r->src, "the step of the lattice", &l->step)) return false;
    if (!(l->step > 0)) {
        r->src.at = step;
        return src_expected(&r->src, "a step > 0");
    }
    r->lattice_line = r->src.line;
    return src_double(&r->src, "x0 of the lattice", &l->x0) &&
           src_double(&r->src, "y0 of the lattice", &l->y0) && src_end_line(&r->src) &&
           record_next(&r->src);
}

static bool read_depth(struct reader *r) {
    double *depth = r->grid.depth;
    const char *upper;
    if (!src_take(&r->src, "depth")) return true;
    r->grid.has_depth = true;
    if (!src_double(&r->src, "the lower end of the depth", &depth[0])) return false;
    upper = r->src.at;
    if (!src_double(&r->src, "the upper end of the depth", &depth[1])) return false;
    if (!(depth[0] < depth[1])) {
        r->src.at = upper;
        return src_expected(&r->src, "an upper end above the lower end");
    }
    return src_end_line(&r->src) && record_next(&r->src);
}

/* What may stand where `vertices` must, given what there was. */
static const char *expected_before_vertices(const struct reader *r) {
    if (r->grid.has_depth) return "'vertices'";
    if (r->lattice) return "'depth' or 'vertices'";
    if (r->plane) return "'lattice', 'depth' or 'vertices'";
    return "'plane', 'lattice', 'depth' or 'vertices'";
}

static bool read_vertices(struct reader *r) {
    struct src *src = &r->src;
    size_t cap = 0, line_cap = 0;
    uint32_t count;
    if (!record_count(src, "vertices", expected_before_vertices(r), 3, UINT32_MAX - 2, &count))
        return false;
    for (uint32_t v = 0; v < count; v++) {
        int64_t xy[2] = {0};
        if (!mem_grow(r->grid.vertex, &cap, (size_t)v + 1, &src->err) ||
            !mem_grow(r->vertex_line, &line_cap, (size_t)v + 1, &src->err) ||
            !src_int(src, "X of a vertex", -GRID_COORDINATE_MAX, GRID_COORDINATE_MAX, &xy[0]) ||
            !src_int(src, "Y of a vertex", -GRID_COORDINATE_MAX, GRID_COORDINATE_MAX, &xy[1]) ||
            !src_end_line(src))
            return false;
        r->grid.vertex[v][0] = (int32_t)xy[0];
        r->grid.vertex[v][1] = (int32_t)xy[1];
        r->vertex_line[v] = src->line;
        if (!record_next(src)) return false;
    }
    r->grid.vertex_count = count;
    return true;
}

/* Triangles, and the word that ends them. */
static bool read_triangles(struct reader *r) {
    struct src *src = &r->src;
    size_t cap = 0, line_cap = 0;
    uint32_t count;
    char expected[64];
    snprintf(expected, sizeof expected, "'triangles' after %u vertices", r->grid.vertex_count);
    if (!record_count(src, "triangles", expected, 1, UINT32_MAX / 3, &count)) return false;
    for (uint32_t t = 0; t < count; t++) {
        if (!mem_grow(r->grid.triangle, &cap, (size_t)t + 1, &src->err) ||
            !mem_grow(r->triangle_line, &line_cap, (size_t)t + 1, &src->err))
            return false;
        for (int l = 0; l < 3; l++) {
            int64_t v = 0;
            if (!src_int(src, "a vertex number", 0, (int64_t)r->grid.vertex_count - 1, &v))
                return false;
            r->grid.triangle[t][l] = (uint32_t)v;
        }
        r->triangle_line[t] = src->line;
        if (!src_end_line(src) || !record_next(src)) return false;
    }
    r->grid.triangle_count = count;
    snprintf(expected, sizeof expected, "'points' after %u triangles", count);
    return src_take(src, "points") || src_expected(src, expected);
}

/* Builds the topology; an error gets the line of its culprit. */
static bool build(struct reader *r) {
    struct grid_culprit culprit;
    size_t line = 0;
    if (grid_build_blaming(&r->grid, &culprit, &r->src.err)) return true;
    switch (culprit.kind) {
    case GRID_BAD_WHOLE:
        break;
    case GRID_BAD_LATTICE:
        line = r->lattice_line;
        break;
    case GRID_BAD_VERTEX:
        line = r->vertex_line[culprit.number];
        break;
    case GRID_BAD_TRIANGLE:
        line = r->triangle_line[culprit.number];
        break;
    }
    return err_place(&r->src.err, r->src.name, line, line ? 1 : 0);
}

static bool read_point(struct src *src, struct spline *s, uint32_t p) {
    return src_double(src, "x of a control point", &s->phi[p][0]) &&
           src_double(src, "y of a control point", &s->phi[p][1]) &&
           (!s->sigma || (src_double(src, "z0 of a control point", &s->sigma[p][0]) &&
                          src_double(src, "z1 of a control point", &s->sigma[p][1]))) &&
           src_end_line(src) && record_next(src);
}

static bool read_points(struct reader *r, struct spline *s) {
    struct src *src = &r->src;
    char expected[64];
    if (!record_exact_count(src, "points", r->grid.point_count,
                            "the number of control points of this grid") ||
        !spline_allocate(s, &r->grid, &src->err))
        return false;
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        if (!read_point(src, s, p)) return false;
    snprintf(expected, sizeof expected, "'end' after %u points", s->grid.point_count);
    return record_end(src, expected);
}

static bool read_all(struct reader *r, struct grid_file *file) {
    struct spline *s = &file->spline;
    return record_first(&r->src, "grid", &file->history) && read_degree(r) && read_plane(r) &&
           read_lattice(r) && read_depth(r) && read_vertices(r) && read_triangles(r) && build(r) &&
           read_points(r, s);
}

/* From r->src, which is open. */
static bool read_source(struct reader *r, struct grid_file *file, struct err *err) {
    bool ok = read_all(r, file);
    if (!ok) {
        *err = r->src.err;
        grid_file_free(file);
    }
    grid_free(&r->grid);
    free(r->vertex_line);
    free(r->triangle_line);
    src_close(&r->src);
    return ok;
}

static const struct reader fresh = {.grid = {.axes = {0, 1, 2}, .lattice = {1, 0, 0}}};

bool grid_read(struct grid_file *file, const char *path, struct err *err) {
    struct reader r = fresh;
    *file = (struct grid_file){0};
    return src_open(&r.src, path, err) && read_source(&r, file, err);
}

bool grid_read_text(struct grid_file *file, const char *name, const char *text, size_t length,
                    struct err *err) {
    struct reader r = fresh;
    *file = (struct grid_file){0};
    src_open_text(&r.src, name, text, length);
    return read_source(&r, file, err);
}

bool grid_is_text(const char *text, size_t length) {
    struct src src;
    bool is;
    src_open_text(&src, "", text, length);
    is = src_line(&src) && src_take(&src, "grid");
    src_close(&src);
    return is;
}

void grid_file_free(struct grid_file *file) {
    spline_free(&file->spline);
    free(file->history);
    *file = (struct grid_file){0};
}

/* BEFORE, then the numbers with blanks between. */
static void write_numbers(struct out *out, const char *before, const double *x, int n, int digits) {
    out_text(out, before);
    for (int i = 0; i < n; i++) {
        if (i > 0) out_char(out, ' ');
        out_double(out, x[i], digits);
    }
}

static void write_frame(struct out *out, const struct grid *g) {
    const struct lattice *l = &g->lattice;
    if (g->axes[0] != 0 || g->axes[1] != 1)
        out_format(out, "plane %c%c\n", "xyz"[g->axes[0]], "xyz"[g->axes[1]]);
    if (l->step != 1 || l->x0 != 0 || l->y0 != 0) {
        write_numbers(out, "lattice ", (double[]){l->step, l->x0, l->y0}, 3, 0);
        out_char(out, '\n');
    }
    if (g->has_depth) {
        write_numbers(out, "depth ", g->depth, 2, 0);
        out_char(out, '\n');
    }
}

static void write_triangulation(struct out *out, const struct grid *g) {
    out_format(out, "vertices %u\n", g->vertex_count);
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        out_int(out, g->vertex[v][0]);
        out_char(out, ' ');
        out_int(out, g->vertex[v][1]);
        out_char(out, '\n');
    }
    out_format(out, "triangles %u\n", g->triangle_count);
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++) {
            out_int(out, g->triangle[t][l]);
            out_char(out, l < 2 ? ' ' : '\n');
        }
}

/* All that the domain is, but the degree of the splines on it. */
static void write_domain(struct out *out, const struct grid *g) {
    write_frame(out, g);
    write_triangulation(out, g);
}

static void add_to_checksum(void *context, const char *bytes, size_t length) {
    uLong *sum = context;
    *sum = crc32_z(*sum, (const Bytef *)bytes, length);
}

bool grid_checksum(const struct grid *g, uint32_t *checksum, struct err *err) {
    uLong sum = crc32_z(0, NULL, 0);
    struct out out;
    if (!out_open_sink(&out, add_to_checksum, &sum, err)) return false;
    write_domain(&out, g);
    if (!out_close(&out, err)) return false;
    *checksum = (uint32_t)sum;
    return true;
}

void grid_write(struct out *out, const struct grid_file *file, const char *added, int digits) {
    const struct spline *s = &file->spline;
    record_write_first(out, "grid", file->history, added);
    out_format(out, "degree %d\n", s->grid.degree);
    write_domain(out, &s->grid);
    out_format(out, "points %u\n", s->grid.point_count);
    for (uint32_t p = 0; p < s->grid.point_count; p++) {
        write_numbers(out, "", s->phi[p], 2, digits);
        if (s->sigma) write_numbers(out, " ", s->sigma[p], 2, digits);
        out_char(out, '\n');
    }
    out_text(out, "end\n");
}
