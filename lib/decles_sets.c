/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closure of [14] figure 13, generalised (decles.md, step 2). Around a vertex v, in degree 5:
 *
 *            \   o   i   o   /            v  corner
 *             \    i   i    /             1  ring 1: edge corners
 *          e   2  c   c    2   e          2  ring 2: edge points, c: inner corners
 *               \    c    /               i  inner edge points: the extremes of the middle
 *                1       1                   conditions of the 2s, one on either side of an edge
 *             c    \   /    c
 *     --- 2 --- 1 -- v -- 1 --- 2 ---
 *
 *   corner, edge corner of v     rings 1 and 2
 *   edge point, next to a 1      ring 2          (and the i of its own edge)
 *   other edge point             the i of its own edge
 *   inner corner                 ring 2
 *   inner edge point             the opposite i
 *
 * where "ring 2" stands for all 2, c and i around v. Rings are marked when they are in D, so no
 * vertex is walked around twice. E grows with D: each new point brings the conditions it is in. */
#include "decles_sets.h"

#include "mem.h"

#include <string.h>

enum { RING_1 = 1, RING_2 = 2 };

bool decles_sets_init(struct decles_sets *sets, const struct grid *g, bool smooth,
                      struct err *err) {
    memset(sets, 0, sizeof *sets);
    sets->grid = g;
    sets->smooth = smooth;
    return blocks_init(&sets->blocks, g->point_count, err) &&
           mem_new(sets->mark, blocks_room(g->point_count), err) &&
           mem_new(sets->pinned, g->point_count, err) &&
           mem_new(sets->ring_done, g->vertex_count, err) &&
           mem_new(sets->is_in_e, (size_t)g->edge_count * (size_t)g->degree, err);
}

void decles_sets_free(struct decles_sets *sets) {
    blocks_free(&sets->blocks);
    free(sets->mark);
    free(sets->pinned);
    free(sets->ring_done);
    free(sets->is_in_e);
    free(sets->ring_vertex);
    free(sets->anchor);
    free(sets->derived);
    free(sets->condition);
    free(sets->row);
    free(sets->fixed);
}

static void add_condition(void *context, uint32_t e, int m) {
    struct decles_sets *s = context;
    uint64_t number = (uint64_t)e * (uint64_t)s->grid->degree + (uint64_t)m;
    s->seen++;
    if (!s->ok || s->is_in_e[number]) return;
    s->ok = mem_grow(s->condition, &s->cap_condition, s->condition_count + 1, s->err);
    if (!s->ok) return;
    s->is_in_e[number] = 1;
    s->condition[s->condition_count++] = number;
}

/* Adds the conditions of p to E; false if it has none. */
static bool add_conditions(struct decles_sets *s, uint32_t p) {
    s->seen = 0;
    if (s->smooth) c1_conditions_of(s->grid, p, add_condition, s);
    return s->seen > 0;
}

/* Puts p into D, with its conditions. What has no condition stays out unless it is a slave. */
static void derive(struct decles_sets *s, uint32_t p, bool is_slave) {
    INVARIANT(p < s->grid->point_count);
    if (!s->ok || decles_sets_pinned(s, p) || decles_mark(s, p)->role != ROLE_NONE) return;
    if (!add_conditions(s, p) && !is_slave) return;
    s->ok = s->ok && mem_grow(s->derived, &s->cap_derived, s->derived_count + 1, s->err);
    if (!s->ok) return;
    decles_mark_at(s, p)->role = ROLE_DERIVED;
    s->derived[s->derived_count++] = p;
}

static void derive_extremes(struct decles_sets *s, uint32_t e, int m) {
    struct c1_condition condition;
    if (!grid_edge_is_inner(s->grid, e)) return;
    condition = c1_condition(s->grid, e, m);
    derive(s, condition.point[0], false);
    derive(s, condition.point[1], false);
}

/* The extremes of the middle conditions of the point at r steps from a on edge e. */
static void derive_middle(struct decles_sets *s, uint32_t e, int r) {
    for (int m = r - 1; m <= r; m++)
        if (2 <= m && m <= s->grid->degree - 3) derive_extremes(s, e, m);
}

/* True if this ring of v is still to be done; it counts as done from now on. */
static bool begin_ring(struct decles_sets *s, uint32_t v, uint8_t ring) {
    if (!s->ok || (s->ring_done[v] & ring)) return false;
    if (s->ring_done[v] == 0) {
        s->ok = mem_grow(s->ring_vertex, &s->cap_ring, s->ring_count + 1, s->err);
        if (!s->ok) return false;
        s->ring_vertex[s->ring_count++] = v;
    }
    s->ring_done[v] |= ring;
    return true;
}

/* The point of triangle t with the given weights at its corner l and the two that follow it. */
static uint32_t point_at(const struct grid *g, uint32_t t, int l, int at_l, int at_next,
                         int at_last) {
    int weight[3];
    weight[l] = at_l;
    weight[(l + 1) % 3] = at_next;
    weight[(l + 2) % 3] = at_last;
    return grid_point(g, t, weight[0], weight[1], weight[2]);
}

static void derive_ring_2(struct decles_sets *s, uint32_t v) {
    const struct grid *g = s->grid;
    int d = g->degree;
    if (!begin_ring(s, v, RING_2)) return;
    for (uint32_t i = g->fan_start[v]; i < g->fan_start[v + 1]; i++) {
        uint32_t t = g->fan[i];
        int l = grid_corner(g, t, v);
        derive(s, point_at(g, t, l, d - 2, 1, 1), false);
        derive(s, point_at(g, t, l, d - 2, 2, 0), false);
        derive(s, point_at(g, t, l, d - 2, 0, 2), false);
        for (int side = 1; side <= 2; side++) {
            uint32_t e = g->triangle_edge[t][(l + side) % 3];
            if (g->edge_triangle[e][0] == t) derive_middle(s, e, g->edge[e][0] == v ? 2 : d - 2);
        }
    }
}

static void derive_rings(struct decles_sets *s, uint32_t v) {
    const struct grid *g = s->grid;
    int d = g->degree;
    if (!begin_ring(s, v, RING_1)) return;
    for (uint32_t i = g->fan_start[v]; i < g->fan_start[v + 1]; i++) {
        uint32_t t = g->fan[i];
        int l = grid_corner(g, t, v);
        derive(s, point_at(g, t, l, d - 1, 1, 0), false);
        derive(s, point_at(g, t, l, d - 1, 0, 1), false);
    }
    derive_ring_2(s, v);
}

/* Which of the three weights is w; the first such. */
static int corner_with(const struct grid_place *place, int w) {
    return place->weight[0] == w ? 0 : place->weight[1] == w ? 1 : 2;
}

/* The edge of p's triangle against which p has weight w, and how far p is from its end a. */
static uint32_t edge_against(const struct grid *g, const struct grid_place *place, int w, int *r) {
    uint32_t t = place->triangle, e = g->triangle_edge[t][corner_with(place, w)];
    *r = place->weight[grid_corner(g, t, g->edge[e][1])];
    return e;
}

/* What p, an anchor or a slave, makes derived. */
static void demand(struct decles_sets *s, uint32_t p) {
    const struct grid *g = s->grid;
    int d = g->degree, r;
    enum point_type type = c1_type(g, p);
    struct grid_place place = grid_place(g, p);
    uint32_t e;
    switch (type) {
    case TYPE_CORNER:
        derive_rings(s, p);
        break;
    case TYPE_EDGE_CORNER:
        derive_rings(s, g->triangle[place.triangle][corner_with(&place, d - 1)]);
        break;
    case TYPE_EDGE:
        e = edge_against(g, &place, 0, &r);
        derive_middle(s, e, r);
        if (r == 2) derive_ring_2(s, g->edge[e][0]);
        if (r == d - 2) derive_ring_2(s, g->edge[e][1]);
        break;
    case TYPE_INNER_CORNER:
        derive_ring_2(s, g->triangle[place.triangle][corner_with(&place, d - 2)]);
        break;
    case TYPE_INNER_EDGE:
        e = edge_against(g, &place, 1, &r);
        derive_extremes(s, e, r);
        break;
    case TYPE_INTERIOR:
        break;
    }
}

static bool add_anchors(struct decles_sets *s, const struct decles_edit *edit) {
    for (size_t i = 0; i < edit->anchor_count; i++) {
        uint32_t p = edit->anchor[i].point;
        INVARIANT(p < s->grid->point_count);
        if (decles_sets_pinned(s, p)) return err_set(s->err, ERR_REFUSAL, "anchor %u is pinned", p);
        if (decles_mark(s, p)->role == ROLE_ANCHOR)
            return err_set(s->err, ERR_INPUT, "point %u is an anchor twice", p);
        if (!mem_grow(s->anchor, &s->cap_anchor, s->anchor_count + 1, s->err)) return false;
        decles_mark_at(s, p)->role = ROLE_ANCHOR;
        s->anchor[s->anchor_count++] = p;
        add_conditions(s, p);
    }
    return true;
}

static int compare_points(const void *a, const void *b) {
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

static int compare_numbers(const void *a, const void *b) {
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Takes back the columns of A and F. */
static void forget_fixed(struct decles_sets *s) {
    for (size_t i = 0; i < s->fixed_count; i++) decles_mark_at(s, s->fixed[i])->column = 0;
    s->fixed_count = 0;
}

/* Sorts D and E, looks up E, and gives D, A and F their columns. */
static bool number(struct decles_sets *s) {
    uint64_t d = (uint64_t)s->grid->degree;
    if (!s->ok || !mem_grow(s->row, &s->cap_row, s->condition_count, s->err) ||
        !mem_grow(s->fixed, &s->cap_fixed, 4 * s->condition_count, s->err))
        return false;
    forget_fixed(s);
    if (s->derived_count > 1)
        qsort(s->derived, s->derived_count, sizeof *s->derived, compare_points);
    if (s->condition_count > 1)
        qsort(s->condition, s->condition_count, sizeof *s->condition, compare_numbers);
    for (size_t i = 0; i < s->derived_count; i++)
        decles_mark_at(s, s->derived[i])->column = (uint32_t)i + 1;
    for (size_t r = 0; r < s->condition_count; r++) {
        uint64_t n = s->condition[r];
        s->row[r] = c1_condition(s->grid, (uint32_t)(n / d), (int)(n % d));
        for (int i = 0; i < 4; i++) {
            uint32_t p = s->row[r].point[i];
            if (s->row[r].coefficient[i] == 0 || decles_mark(s, p)->column != 0) continue;
            s->fixed[s->fixed_count++] = p;
            decles_mark_at(s, p)->column = (uint32_t)s->fixed_count;
        }
    }
    return true;
}

bool decles_sets_begin(struct decles_sets *s, const struct decles_edit *edit, struct err *err) {
    s->anchor_count = s->slave_count = s->derived_count = s->condition_count = 0;
    s->fixed_count = s->ring_count = 0;
    s->ok = true;
    s->err = err;
    if (!add_anchors(s, edit)) return false;
    for (size_t i = 0; i < edit->slave_count; i++) derive(s, edit->slave[i], true);
    for (size_t i = 0; i < edit->wish_count; i++) derive(s, edit->wish[i].point, true);
    s->slave_count = s->derived_count;
    if (s->smooth && s->grid->degree >= 5) { /* below, only repair comes here, with all points */
        for (size_t i = 0; i < s->anchor_count; i++) demand(s, s->anchor[i]);
        for (size_t i = 0; i < s->slave_count; i++) demand(s, s->derived[i]);
    }
    return number(s);
}

bool decles_sets_add(struct decles_sets *s, const uint32_t *points, size_t n, struct err *err) {
    s->err = err;
    for (size_t i = 0; i < n; i++) derive(s, points[i], false);
    return number(s);
}

void decles_sets_clear(struct decles_sets *s) {
    forget_fixed(s);
    for (size_t i = 0; i < s->anchor_count; i++) decles_mark_at(s, s->anchor[i])->role = ROLE_NONE;
    for (size_t i = 0; i < s->derived_count; i++) {
        decles_mark_at(s, s->derived[i])->role = ROLE_NONE;
        decles_mark_at(s, s->derived[i])->column = 0;
    }
    for (size_t i = 0; i < s->condition_count; i++) s->is_in_e[s->condition[i]] = 0;
    for (size_t i = 0; i < s->ring_count; i++) s->ring_done[s->ring_vertex[i]] = 0;
    blocks_clear(&s->blocks);
}

bool decles_fixed_values(const struct decles_sets *s, const struct decles_edit *edit,
                         const struct c1_field *values, double **fixed, struct err *err) {
    size_t k = (size_t)values->k;
    double *x;
    if (!mem_new(x, s->fixed_count * k, err)) return false;
    for (size_t i = 0; i < s->fixed_count; i++)
        memcpy(x + i * k, values->q + values->stride * s->fixed[i], k * sizeof *x);
    for (size_t i = 0; i < edit->anchor_count; i++) {
        uint32_t column = decles_mark(s, edit->anchor[i].point)->column; /* 0: in no condition */
        if (column > 0) memcpy(x + (column - 1) * k, edit->anchor[i].to, k * sizeof *x);
    }
    *fixed = x;
    return true;
}

bool decles_matrix_init(struct int_matrix *m, const struct decles_sets *s, bool derived,
                        const bool *keep, struct err *err) {
    size_t n = 0, rows = 0;
    memset(m, 0, sizeof *m);
    if (!mem_new(m->start, s->condition_count + 1, err) ||
        !mem_new(m->col, 4 * s->condition_count, err) ||
        !mem_new(m->value, 4 * s->condition_count, err))
        return false;
    for (size_t r = 0; r < s->condition_count; r++) {
        if (keep && !keep[r]) continue;
        for (int i = 0; i < 4; i++) {
            uint32_t p = s->row[r].point[i];
            if (s->row[r].coefficient[i] == 0) continue;
            if ((decles_mark(s, p)->role == ROLE_DERIVED) != derived) continue;
            m->col[n] = decles_mark(s, p)->column - 1;
            m->value[n++] = s->row[r].coefficient[i];
        }
        m->start[++rows] = n;
    }
    m->rows = rows;
    m->cols = derived ? s->derived_count : s->fixed_count;
    return true;
}

void decles_matrix_free(struct int_matrix *m) {
    free(m->start);
    free(m->col);
    free(m->value);
}
