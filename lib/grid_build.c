/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The topology of a grid from its triangles, and everything that must hold.
 *
 * Half-edge h = 3t + l is edge l of triangle t, from corner l+1 to corner l+2. Sorted by their
 * pairs (a,b), a < b, stably, the half-edges of one edge become neighbours, lower triangle first:
 * one is a boundary edge; two must run in opposite directions; three cannot lie in a plane.
 *
 * Around a vertex v = corner l of t, counter-clockwise is across edge l+1, {v,q}:
 *
 *            q --- r                   next
 *           / \   /
 *     l+1  / t \ / next                A fan that is not closed begins at the one triangle whose
 *         p --- v                      edge l+2, {v,p}, is on the boundary. The walk from there, or
 *          l+2                         from the lowest triangle, must meet all triangles at v. */
#include "grid.h"

#include "mem.h"
#include "radix.h"

#include <math.h>

struct build {
    struct grid *g;
    struct grid_culprit *culprit;
    struct err *err;
};

static void blame(struct build *b, enum grid_record kind, uint32_t number) {
    b->culprit->kind = kind;
    b->culprit->number = number;
}

void grid_free(struct grid *g) {
    free(g->vertex);
    free(g->triangle);
    free(g->edge);
    free(g->edge_triangle);
    free(g->triangle_edge);
    free(g->fan_start);
    free(g->fan);
    *g = (struct grid){0};
}

/* Both ends of the used range must be finite in world units. */
static bool check_lattice(struct build *b) {
    const struct lattice *l = &b->g->lattice;
    double far = l->step * GRID_COORDINATE_MAX;
    bool ok = isfinite(l->step) && l->step > 0 && isfinite(l->x0) && isfinite(l->y0) &&
              isfinite(fabs(l->x0) + far) && isfinite(fabs(l->y0) + far);
    blame(b, GRID_BAD_LATTICE, 0);
    if (ok) return true;
    blame(b, GRID_BAD_LATTICE, 0);
    return err_set(b->err, ERR_INPUT,
                   "the lattice (step %.17g, origin %.17g %.17g) is not finite with step > 0",
                   l->step, l->x0, l->y0);
}

static bool check_frame(struct build *b) {
    const struct grid *g = b->g;
    int used = 0;
    for (int i = 0; i < 3; i++) {
        INVARIANT(g->axes[i] >= 0 && g->axes[i] < 3);
        used |= 1 << g->axes[i];
    }
    INVARIANT(used == 7);
    if (g->degree < 1 || g->degree > GRID_DEGREE_MAX)
        return err_set(b->err, ERR_INPUT, "degree %d is not in 1..%d", g->degree, GRID_DEGREE_MAX);
    if (g->has_depth &&
        !(isfinite(g->depth[0]) && isfinite(g->depth[1]) && g->depth[0] < g->depth[1]))
        return err_set(b->err, ERR_INPUT, "depth %.17g %.17g is not an interval a < b", g->depth[0],
                       g->depth[1]);
    if (g->vertex_count < 3 || g->triangle_count < 1)
        return err_set(b->err, ERR_INPUT, "a grid needs 3 vertices and a triangle");
    if (g->triangle_count > UINT32_MAX / 3 || g->vertex_count > UINT32_MAX - 2)
        return err_set(b->err, ERR_INPUT, "%u triangles and %u vertices are too many",
                       g->triangle_count, g->vertex_count);
    return check_lattice(b);
}

static bool check_coordinates(struct build *b) {
    const struct grid *g = b->g;
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        int32_t x = g->vertex[v][0], y = g->vertex[v][1];
        if (x >= -GRID_COORDINATE_MAX && x <= GRID_COORDINATE_MAX && y >= -GRID_COORDINATE_MAX &&
            y <= GRID_COORDINATE_MAX)
            continue;
        blame(b, GRID_BAD_VERTEX, v);
        return err_set(b->err, ERR_INPUT, "vertex %u (%d %d) is not in -2^24..2^24", v, x, y);
    }
    return true;
}

static bool check_triangles(struct build *b) {
    const struct grid *g = b->g;
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const uint32_t *c = g->triangle[t];
        int64_t area2;
        blame(b, GRID_BAD_TRIANGLE, t);
        for (int l = 0; l < 3; l++)
            if (c[l] >= g->vertex_count)
                return err_set(b->err, ERR_INPUT, "triangle %u has vertex %u, but there are %u", t,
                               c[l], g->vertex_count);
        area2 = predicate_area2(g->vertex[c[0]], g->vertex[c[1]], g->vertex[c[2]]);
        if (area2 > 0) continue;
        return err_set(b->err, ERR_INPUT, "triangle %u (%u %u %u) %s", t, c[0], c[1], c[2],
                       area2 < 0 ? "is clockwise" : "has no area");
    }
    return true;
}

/* Duplicate vertices are neighbours when sorted by their coordinates. */
static bool check_duplicates(struct build *b, struct radix_item *item, struct radix_item *spare) {
    const struct grid *g = b->g;
    uint32_t n = g->vertex_count;
    for (uint32_t v = 0; v < n; v++) {
        uint64_t x = (uint64_t)((int64_t)g->vertex[v][0] + GRID_COORDINATE_MAX);
        uint64_t y = (uint64_t)((int64_t)g->vertex[v][1] + GRID_COORDINATE_MAX);
        item[v] = (struct radix_item){x << 32 | y, v};
    }
    radix_sort(item, spare, n);
    for (uint32_t i = 1; i < n; i++) {
        uint32_t u = item[i - 1].value, v = item[i].value;
        if (item[i - 1].key != item[i].key) continue;
        blame(b, GRID_BAD_VERTEX, v);
        return err_set(b->err, ERR_INPUT, "vertices %u and %u are both at (%d %d)", u, v,
                       g->vertex[v][0], g->vertex[v][1]);
    }
    return true;
}

/* The 3T half-edges, sorted by (a,b), then by triangle. */
static void sort_half_edges(const struct grid *g, struct radix_item *item,
                            struct radix_item *spare) {
    uint32_t n = 3 * g->triangle_count;
    for (uint32_t h = 0; h < n; h++) {
        const uint32_t *c = g->triangle[h / 3];
        uint64_t p = c[(h + 1) % 3], q = c[(h + 2) % 3];
        item[h] = (struct radix_item){p < q ? p << 32 | q : q << 32 | p, h};
    }
    radix_sort(item, spare, n);
}

/* Makes edge e of the n half-edges at item. */
static bool make_edge(struct build *b, uint32_t e, const struct radix_item *item, uint32_t n) {
    struct grid *g = b->g;
    uint32_t p = (uint32_t)(item->key >> 32), q = (uint32_t)item->key;
    uint32_t t[3] = {0};
    bool same_way;
    for (uint32_t i = 0; i < n && i < 3; i++) t[i] = item[i].value / 3;
    blame(b, GRID_BAD_TRIANGLE, t[n < 3 ? n - 1 : 2]);
    if (n > 2)
        return err_set(b->err, ERR_INPUT, "edge {%u,%u} has more than two triangles: %u, %u, %u", p,
                       q, t[0], t[1], t[2]);
    g->edge[e][0] = p;
    g->edge[e][1] = q;
    g->edge_triangle[e][0] = t[0];
    g->edge_triangle[e][1] = n == 2 ? t[1] : GRID_NONE;
    for (uint32_t i = 0; i < n; i++) g->triangle_edge[t[i]][item[i].value % 3] = e;
    if (n == 1) return true;
    same_way =
        g->triangle[t[0]][(item[0].value + 1) % 3] == g->triangle[t[1]][(item[1].value + 1) % 3];
    return !same_way || err_set(b->err, ERR_INPUT,
                                "triangles %u and %u lie on the same side of their edge {%u,%u}",
                                t[0], t[1], p, q);
}

static bool make_edges(struct build *b, const struct radix_item *item) {
    struct grid *g = b->g;
    uint32_t n = 3 * g->triangle_count;
    for (uint32_t h = 0; h < n; h++) g->edge_count += h == 0 || item[h].key != item[h - 1].key;
    if (!mem_new(g->edge, g->edge_count, b->err) ||
        !mem_new(g->edge_triangle, g->edge_count, b->err) ||
        !mem_new(g->triangle_edge, g->triangle_count, b->err))
        return false;
    for (uint32_t h = 0, e = 0, end; h < n; h = end, e++) {
        for (end = h + 1; end < n && item[end].key == item[h].key;) end++;
        if (!make_edge(b, e, item + h, end - h)) return false;
    }
    return true;
}

/* Duplicates come first: they are why a triangle may have no area. Sorting needs room for
 * half-edges or vertices, whichever are more. */
static bool sort_and_make_edges(struct build *b) {
    uint32_t halves = 3 * b->g->triangle_count, vertices = b->g->vertex_count;
    uint32_t room = halves > vertices ? halves : vertices;
    struct radix_item *item = NULL, *spare = NULL;
    bool ok = mem_new(item, room, b->err) && mem_new(spare, room, b->err) &&
              check_duplicates(b, item, spare) && check_triangles(b);
    if (ok) {
        sort_half_edges(b->g, item, spare);
        ok = make_edges(b, item);
    }
    free(item);
    free(spare);
    return ok;
}

/* The triangle after t, counter-clockwise around v, or GRID_NONE. */
static uint32_t next_around(const struct grid *g, uint32_t v, uint32_t t) {
    uint32_t e = g->triangle_edge[t][(grid_corner(g, t, v) + 1) % 3];
    return g->edge_triangle[e][g->edge_triangle[e][0] == t];
}

/* Leaves in first[v] the triangle where the walk around v begins. */
static bool find_first(struct build *b, uint32_t *first) {
    const struct grid *g = b->g;
    for (uint32_t v = 0; v < g->vertex_count; v++) first[v] = GRID_NONE;
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++) {
            uint32_t v = g->triangle[t][l];
            if (grid_edge_is_inner(g, g->triangle_edge[t][(l + 2) % 3])) continue;
            if (first[v] == GRID_NONE) {
                first[v] = t;
                continue;
            }
            blame(b, GRID_BAD_TRIANGLE, t);
            return err_set(b->err, ERR_INPUT,
                           "the triangles around vertex %u form two fans: of triangle %u and of %u",
                           v, first[v], t);
        }
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++)
            if (first[g->triangle[t][l]] == GRID_NONE) first[g->triangle[t][l]] = t;
    return true;
}

/* The lowest triangle at v that is not in the fan. */
static uint32_t outside_fan(const struct grid *g, uint32_t v, uint32_t n) {
    const uint32_t *fan = g->fan + g->fan_start[v];
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        bool there = false;
        const uint32_t *c = g->triangle[t];
        if (c[0] != v && c[1] != v && c[2] != v) continue;
        for (uint32_t i = 0; i < n; i++) there = there || fan[i] == t;
        if (!there) return t;
    }
    return GRID_NONE;
}

static bool walk_fan(struct build *b, uint32_t v, uint32_t first) {
    struct grid *g = b->g;
    uint32_t begin = g->fan_start[v], total = g->fan_start[v + 1] - begin, n = 0, t = first;
    do {
        g->fan[begin + n++] = t;
        t = next_around(g, v, t);
    } while (t != GRID_NONE && t != first && n < total);
    if (n == total) return true;
    blame(b, GRID_BAD_TRIANGLE, outside_fan(g, v, n));
    return err_set(b->err, ERR_INPUT,
                   "the triangles around vertex %u form two fans: of triangle %u and of %u", v,
                   first, b->culprit->number);
}

static bool make_fans(struct build *b, uint32_t *first) {
    struct grid *g = b->g;
    uint32_t *start = g->fan_start;
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int l = 0; l < 3; l++) start[g->triangle[t][l] + 1]++;
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        blame(b, GRID_BAD_VERTEX, v);
        if (start[v + 1] == 0) return err_set(b->err, ERR_INPUT, "no triangle has vertex %u", v);
        start[v + 1] += start[v];
    }
    if (!find_first(b, first)) return false;
    for (uint32_t v = 0; v < g->vertex_count; v++)
        if (!walk_fan(b, v, first[v])) return false;
    return true;
}

static bool fans(struct build *b) {
    struct grid *g = b->g;
    uint32_t *first = NULL;
    bool ok = mem_new(g->fan_start, (size_t)g->vertex_count + 1, b->err) &&
              mem_new(g->fan, 3 * (size_t)g->triangle_count, b->err) &&
              mem_new(first, g->vertex_count, b->err) && make_fans(b, first);
    free(first);
    return ok;
}

/* Point numbers are 32 bits, of which GRID_NONE is none. */
static bool count_points(struct build *b) {
    struct grid *g = b->g;
    uint64_t d = (uint64_t)g->degree;
    uint64_t n =
        g->vertex_count + g->edge_count * (d - 1) + g->triangle_count * ((d - 1) * (d - 2) / 2);
    g->point_count = (uint32_t)n;
    blame(b, GRID_BAD_WHOLE, 0);
    return n < GRID_NONE ||
           err_set(b->err, ERR_INPUT, "the grid would have %llu control points, more than 2^32 - 2",
                   (unsigned long long)n);
}

bool grid_build_blaming(struct grid *g, struct grid_culprit *culprit, struct err *err) {
    struct build b = {g, culprit, err};
    bool ok;
    blame(&b, GRID_BAD_WHOLE, 0);
    ok = check_frame(&b) && check_coordinates(&b) && sort_and_make_edges(&b) && fans(&b) &&
         count_points(&b);
    if (!ok) grid_free(g);
    return ok;
}

bool grid_build(struct grid *g, struct err *err) {
    struct grid_culprit culprit;
    return grid_build_blaming(g, &culprit, err);
}
