/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_show.h"

#include "mem.h"
#include "segment.h"

#include <string.h>

const char *const icc_show_names[] = {"grid",      "values", "tree",  "grassfire",
                                      "triangles", "edges",  "image", NULL};

bool icc_show_has(enum icc_show what, bool method_grid) {
    bool of_both = what == ICC_SHOW_GRID || what == ICC_SHOW_VALUES || what == ICC_SHOW_TRIANGLES;
    return of_both || (what == ICC_SHOW_IMAGE) != method_grid;
}

struct show {
    const struct icc_grid *g;
    struct polylines_maker maker;
    uint32_t *layer; /* (grassfire) */
    struct icc_lines lines;
    struct err *err;
};

static bool add(struct show *s, const double grid[2]) {
    double p[2];
    icc_domain_to_world(&s->g->domain, grid, p);
    return polylines_point(&s->maker, p, s->err);
}

static bool add_vertex(struct show *s, uint32_t v) {
    double p[2];
    icc_domain_vertex(&s->g->domain, v, p);
    return polylines_point(&s->maker, p, s->err);
}

static bool begin(struct show *s, const char *word) {
    return polylines_word(&s->maker, word, strlen(word), s->err);
}

static bool has(const struct show *s, uint32_t v) {
    return icc_function_has(&s->g->function, v);
}

/* ---- of each vertex with a value --------------------------------------------------------------
 */

static bool show_vertex(struct show *s, uint32_t v) {
    const char *word = v == s->g->function.maximum ? "maximum"
                       : s->g->domain.inside[v]    ? "inside"
                                                   : "outside";
    return begin(s, word) && add_vertex(s, v);
}

/* f(child) = 0.95 f(parent) all the way down, as the thesis has it. */
static double cousin_value(double height) {
    double f = 10;
    for (double k = 0; k > height && f > 0; k--) f *= 0.95;
    return f;
}

static bool show_value(struct show *s, uint32_t v) {
    const struct icc_function *f = &s->g->function;
    double value = f->kind == ICC_COUSIN ? cousin_value(f->height[v]) : f->height[v];
    return polylines_number(&s->maker, value, s->err) && add_vertex(s, v);
}

static double depth_of(const struct icc_function *f, uint32_t v) {
    double depth = 0;
    for (; f->parent[v] != ICC_NO_VERTEX; v = f->parent[v]) depth++;
    return depth;
}

static bool show_parent(struct show *s, uint32_t v) {
    const struct icc_function *f = &s->g->function;
    if (f->parent[v] == ICC_NO_VERTEX) return true;
    return polylines_number(&s->maker, depth_of(f, v), s->err) && add_vertex(s, v) &&
           add_vertex(s, f->parent[v]);
}

static bool show_layer(struct show *s, uint32_t v) {
    return s->layer[v] == 0 ||
           (polylines_number(&s->maker, s->layer[v], s->err) && add_vertex(s, v));
}

/* ---- of each triangle with values -------------------------------------------------------------
 */

static void triangle_at(const struct show *s, uint32_t v, int upper, uint32_t corner[3]) {
    uint32_t nx = s->g->domain.nx;
    corner[0] = v;
    corner[1] = upper ? v + nx + 1 : v + 1;
    corner[2] = upper ? v + nx : v + nx + 1;
}

static bool show_triangles(struct show *s, uint32_t v) {
    for (int upper = 0; upper < 2; upper++) {
        uint32_t c[3];
        triangle_at(s, v, upper, c);
        if (!has(s, c[0]) || !has(s, c[1]) || !has(s, c[2])) continue;
        if (!begin(s, "triangle") || !add_vertex(s, c[0]) || !add_vertex(s, c[1]) ||
            !add_vertex(s, c[2]) || !add_vertex(s, c[0]))
            return false;
    }
    return true;
}

static bool show_unreached(struct show *s, uint32_t v, int upper) {
    const struct icc_field field = icc_grid_field(s->g);
    double p[2], world[2];
    icc_domain_vertex_grid(&s->g->domain, v, p);
    p[0] += upper ? 0.31 : 0.64; /* not the centre: lines from there run into vertices */
    p[1] += upper ? 0.66 : 0.29;
    icc_domain_to_world(&s->g->domain, p, world);
    if (!cage_has(s->g->cage, world)) return true;
    if (!icc_trace(&field, p, ICC_DOWNHILL, &s->lines.down, s->err)) return false;
    return s->lines.down.shared == SIZE_MAX || (begin(s, "unreached") && add(s, p));
}

static bool show_edges(struct show *s, uint32_t v) {
    const struct icc_field field = icc_grid_field(s->g);
    const uint32_t end[3] = {v + 1, v + s->g->domain.nx + 1, v + s->g->domain.nx};
    for (int k = 0; k < 3; k++) {
        enum icc_edge kind = icc_edge_kind(&field, v, k);
        if (kind != ICC_EDGE_COMPRESSION && kind != ICC_EDGE_EXPANSION) continue;
        if (!s->g->domain.inside[v] && !s->g->domain.inside[end[k]]) continue;
        if (!begin(s, kind == ICC_EDGE_COMPRESSION ? "compression" : "expansion") ||
            !add_vertex(s, v) || !add_vertex(s, end[k]))
            return false;
    }
    return show_unreached(s, v, 0) && show_unreached(s, v, 1);
}

/* ---- all of them ------------------------------------------------------------------------------
 */

static bool show_all(struct show *s, bool (*one)(struct show *, uint32_t)) {
    uint32_t n = icc_domain_size(&s->g->domain), nx = s->g->domain.nx;
    for (uint32_t v = nx; v + nx + 1 < n; v++)
        if (v % nx > 0 && has(s, v) && !one(s, v)) return false;
    return true;
}

bool icc_show_grid(const struct icc_grid *g, enum icc_show what, struct polylines *p,
                   struct err *err) {
    static bool (*const one[ICC_SHOW_KINDS])(struct show *, uint32_t) = {
        show_vertex, show_value, show_parent, show_layer, show_triangles, show_edges, NULL};
    struct show s = {.g = g, .maker = {.p = p}, .err = err};
    bool ok = true;
    INVARIANT(one[what]);
    *p = (struct polylines){0};
    if (what == ICC_SHOW_GRASSFIRE) {
        ok = mem_new(s.layer, icc_domain_size(&g->domain), err);
        if (ok) icc_domain_burn(&g->domain, s.layer);
    }
    ok = ok && show_all(&s, one[what]);
    if (ok) polylines_end(&s.maker);
    free(s.layer);
    icc_lines_free(&s.lines);
    return ok;
}

struct icc_place icc_show_place(const struct cage *cage, size_t i, size_t count) {
    double way = cage->perimeter * ((double)i / (double)count), length;
    uint32_t side = 0;
    for (;; side++) {
        length = segment_length(cage->vertex[side], cage->vertex[cage_next(cage, side)]);
        if (way < length || side + 1 == cage->count) break;
        way -= length;
    }
    return (struct icc_place){side, fmin(way / length, 1), 1};
}

static bool show_line(struct show *s, size_t i, size_t count) {
    const struct icc_field field = icc_grid_field(s->g);
    struct icc_place place = icc_show_place(s->g->cage, i, count);
    struct icc_line *up = &s->lines.up;
    double world[2], from[2];
    cage_point(s->g->cage, place.side, place.lambda, world);
    icc_domain_to_grid(&s->g->domain, world, from);
    if (!polylines_number(&s->maker, (double)i, s->err) ||
        !icc_trace(&field, from, ICC_UPHILL, up, s->err))
        return false;
    for (size_t k = 0; k < up->count; k++)
        if (!add(s, up->point[k])) return false;
    return true;
}

bool icc_show_grid_lines(const struct icc_grid *g, size_t count, struct polylines *p,
                         struct err *err) {
    struct show s = {.g = g, .maker = {.p = p}, .err = err};
    bool ok = true;
    *p = (struct polylines){0};
    for (size_t i = 0; ok && i < count; i++) ok = show_line(&s, i, count);
    if (ok) polylines_end(&s.maker);
    icc_lines_free(&s.lines);
    return ok;
}

bool icc_show(const struct icc_map *m, enum icc_show what, size_t lines, struct polylines *p,
              struct err *err) {
    if (m->rule.method == ICC_GRID)
        return lines > 0 ? icc_show_grid_lines(&m->grid[0], lines, p, err)
                         : icc_show_grid(&m->grid[0], what, p, err);
    return lines > 0 ? icc_show_ray_lines(&m->ray[0], lines, p, err)
                     : icc_show_ray(&m->ray[0], what, p, err);
}
