/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rounds of red splits first, then the closure: red splits until every triangle has at most one
 * hanging midpoint and no deeper one, then one green split each.
 *
 *            v2                      v2
 *           /  \                    / | \
 *         m1 -- m0      red        /  |  \      green, edge 2 hangs
 *        /  \  /  \               /   |   \
 *      v0 -- m2 -- v1           v0 -- m -- v1
 *
 * Vertices carry coordinates of the finest lattice from the start. A midpoint exists once, found by
 * the numbers of the ends of its edge in a hash table. */
#include "refine.h"

#include "mem.h"

#include <math.h>
#include <string.h>

struct cell {
    uint32_t v[3];
    struct piece piece;
};

struct midpoint {
    uint32_t a, b, vertex; /* a < b; vertex = GRID_NONE: an empty slot */
};

struct mesh {
    struct lattice lattice;
    int32_t (*vertex)[2];
    size_t vertex_count, vertex_cap;
    struct cell *cell, *next; /* this round's triangles and the next one's */
    size_t cell_count, cell_cap, next_count, next_cap;
    struct midpoint *table; /* open addressing, at most half full */
    size_t table_size, table_used;
    struct err *err;
};

/* ---- midpoints --------------------------------------------------------------------------------
 */

static struct midpoint *slot_of(struct midpoint *table, size_t size, uint32_t a, uint32_t b) {
    uint64_t hash = ((uint64_t)a << 32 | b) * 0x9e3779b97f4a7c15u;
    size_t i = (size_t)(hash >> 20) & (size - 1);
    while (table[i].vertex != GRID_NONE && (table[i].a != a || table[i].b != b))
        i = (i + 1) & (size - 1);
    return &table[i];
}

static bool grow_table(struct mesh *m) {
    size_t size = m->table_size ? 2 * m->table_size : 1024;
    struct midpoint *table;
    if (!mem_new(table, size, m->err)) return false;
    for (size_t i = 0; i < size; i++) table[i].vertex = GRID_NONE;
    for (size_t i = 0; i < m->table_size; i++)
        if (m->table[i].vertex != GRID_NONE)
            *slot_of(table, size, m->table[i].a, m->table[i].b) = m->table[i];
    free(m->table);
    m->table = table;
    m->table_size = size;
    return true;
}

/* The midpoint of {a,b}, or GRID_NONE. */
static uint32_t find_midpoint(const struct mesh *m, uint32_t a, uint32_t b) {
    return slot_of(m->table, m->table_size, a < b ? a : b, a < b ? b : a)->vertex;
}

static bool make_midpoint(struct mesh *m, uint32_t a, uint32_t b, uint32_t *vertex) {
    struct midpoint *slot;
    *vertex = find_midpoint(m, a, b);
    if (*vertex != GRID_NONE) return true;
    if (2 * m->table_used >= m->table_size && !grow_table(m)) return false;
    if (!mem_grow(m->vertex, &m->vertex_cap, m->vertex_count + 1, m->err)) return false;
    *vertex = (uint32_t)m->vertex_count++;
    for (int c = 0; c < 2; c++) m->vertex[*vertex][c] = (m->vertex[a][c] + m->vertex[b][c]) / 2;
    slot = slot_of(m->table, m->table_size, a < b ? a : b, a < b ? b : a);
    *slot = (struct midpoint){a < b ? a : b, a < b ? b : a, *vertex};
    m->table_used++;
    return true;
}

/* ---- splits -----------------------------------------------------------------------------------
 */

static bool add_cell(struct mesh *m, const struct cell *cell) {
    if (m->next_count >= UINT32_MAX / 4)
        return err_set(m->err, ERR_REFUSAL, "the refined grid would have too many triangles");
    if (!mem_grow(m->next, &m->next_cap, m->next_count + 1, m->err)) return false;
    m->next[m->next_count++] = *cell;
    return true;
}

/* Corner `to` of the part becomes the middle of corners a and b of the whole. */
static void set_middle(struct cell *part, int to, const struct cell *whole, int a, int b,
                       uint32_t v) {
    part->v[to] = v;
    for (int l = 0; l < 3; l++)
        part->piece.corner[to][l] = (whole->piece.corner[a][l] + whole->piece.corner[b][l]) / 2;
}

static bool split_red(struct mesh *m, const struct cell *c) {
    uint32_t mid[3];
    struct cell centre = *c;
    for (int l = 0; l < 3; l++) {
        if (!make_midpoint(m, c->v[(l + 1) % 3], c->v[(l + 2) % 3], &mid[l])) return false;
        set_middle(&centre, l, c, (l + 1) % 3, (l + 2) % 3, mid[l]);
    }
    for (int l = 0; l < 3; l++) { /* the part at corner l */
        struct cell part = *c;
        int n = (l + 1) % 3, p = (l + 2) % 3;
        set_middle(&part, n, c, l, n, mid[p]);
        set_middle(&part, p, c, l, p, mid[n]);
        if (!add_cell(m, &part)) return false;
    }
    return add_cell(m, &centre);
}

/* Splits at the midpoint of edge l, which lies opposite corner l. */
static bool split_green(struct mesh *m, const struct cell *c, int l, uint32_t mid) {
    int n = (l + 1) % 3, p = (l + 2) % 3;
    struct cell first = *c, second = *c;
    set_middle(&first, p, c, n, p, mid);
    set_middle(&second, n, c, n, p, mid);
    return add_cell(m, &first) && add_cell(m, &second);
}

static void swap_lists(struct mesh *m) {
    struct cell *cell = m->cell;
    size_t cap = m->cell_cap;
    m->cell = m->next;
    m->cell_cap = m->next_cap;
    m->cell_count = m->next_count;
    m->next = cell;
    m->next_cap = cap;
    m->next_count = 0;
}

/* ---- what to split ----------------------------------------------------------------------------
 */

/* Do triangle and box share a point? They do not exactly when an edge of one separates them. */
static bool meets_box(const struct mesh *m, const struct cell *c, const double box[4]) {
    const double corner[4][2] = {
        {box[0], box[1]}, {box[2], box[1]}, {box[2], box[3]}, {box[0], box[3]}};
    for (int axis = 0; axis < 2; axis++) {
        double lo = INFINITY, hi = -INFINITY;
        for (int l = 0; l < 3; l++) {
            double origin = axis ? m->lattice.y0 : m->lattice.x0;
            double x = origin + m->lattice.step * m->vertex[c->v[l]][axis];
            lo = fmin(lo, x);
            hi = fmax(hi, x);
        }
        if (hi < box[axis] || lo > box[2 + axis]) return false;
    }
    for (int l = 0; l < 3; l++) {
        const int32_t *a = m->vertex[c->v[l]], *b = m->vertex[c->v[(l + 1) % 3]];
        int outside = 0;
        for (int k = 0; k < 4; k++) outside += predicate_side(&m->lattice, a, b, corner[k]) < 0;
        if (outside == 4) return false;
    }
    return true;
}

static bool is_marked(const struct mesh *m, const struct refine_request *r, const struct cell *c) {
    if (r->triangle && !r->triangle[c->piece.triangle]) return false;
    return !r->box || meets_box(m, c, r->box);
}

/* Counts the edges of a triangle with a midpoint on them; *edge is the last, *deep tells whether a
 * half of one has a midpoint in its turn. */
static int hanging(const struct mesh *m, const struct cell *c, int *edge, bool *deep) {
    int n = 0;
    *deep = false;
    for (int l = 0; l < 3; l++) {
        uint32_t a = c->v[(l + 1) % 3], b = c->v[(l + 2) % 3], mid = find_midpoint(m, a, b);
        if (mid == GRID_NONE) continue;
        n++;
        *edge = l;
        if (find_midpoint(m, a, mid) != GRID_NONE || find_midpoint(m, mid, b) != GRID_NONE)
            *deep = true;
    }
    return n;
}

static bool round_of_red(struct mesh *m, const struct refine_request *request) {
    for (size_t i = 0; i < m->cell_count; i++)
        if (is_marked(m, request, &m->cell[i]) ? !split_red(m, &m->cell[i])
                                               : !add_cell(m, &m->cell[i]))
            return false;
    swap_lists(m);
    return true;
}

static bool close_by_red(struct mesh *m, bool *changed) {
    *changed = false;
    for (size_t i = 0; i < m->cell_count; i++) {
        int edge;
        bool deep, red = hanging(m, &m->cell[i], &edge, &deep) > 1 || deep;
        if (red ? !split_red(m, &m->cell[i]) : !add_cell(m, &m->cell[i])) return false;
        *changed = *changed || red;
    }
    swap_lists(m);
    return true;
}

static bool close_by_green(struct mesh *m) {
    for (size_t i = 0; i < m->cell_count; i++) {
        const struct cell *c = &m->cell[i];
        int l = 0;
        bool deep, ok;
        if (hanging(m, c, &l, &deep) == 0)
            ok = add_cell(m, c);
        else
            ok = split_green(m, c, l, find_midpoint(m, c->v[(l + 1) % 3], c->v[(l + 2) % 3]));
        if (!ok) return false;
    }
    swap_lists(m);
    return true;
}

/* ---- from grid to mesh and back ---------------------------------------------------------------
 */

static bool mesh_init(struct mesh *m, const struct grid *g, int times, struct err *err) {
    int32_t scale = 1 << times;
    *m = (struct mesh){.lattice = g->lattice, .err = err};
    m->lattice.step /= scale;
    if (!grow_table(m) || !mem_grow(m->vertex, &m->vertex_cap, g->vertex_count, err)) return false;
    for (uint32_t v = 0; v < g->vertex_count; v++)
        for (int c = 0; c < 2; c++) {
            int64_t x = (int64_t)g->vertex[v][c] * scale;
            if (x > GRID_COORDINATE_MAX || x < -GRID_COORDINATE_MAX)
                return err_set(err, ERR_REFUSAL,
                               "refining %d times takes vertex %u beyond the lattice: expected "
                               "|coordinate| <= 2^24, got %lld",
                               times, v, (long long)x);
            m->vertex[v][c] = (int32_t)x;
        }
    m->vertex_count = g->vertex_count;
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        struct cell cell = {.piece = {.triangle = t}};
        for (int l = 0; l < 3; l++) {
            cell.v[l] = g->triangle[t][l];
            cell.piece.corner[l][l] = scale;
        }
        if (!add_cell(m, &cell)) return false;
    }
    swap_lists(m);
    return true;
}

static void mesh_free(struct mesh *m) {
    free(m->vertex);
    free(m->cell);
    free(m->next);
    free(m->table);
}

static bool mesh_to_grid(struct mesh *m, const struct grid *g, struct grid *fine,
                         struct piece **piece) {
    *fine = (struct grid){.degree = g->degree, .lattice = m->lattice, .has_depth = g->has_depth};
    memcpy(fine->axes, g->axes, sizeof fine->axes);
    memcpy(fine->depth, g->depth, sizeof fine->depth);
    fine->vertex_count = (uint32_t)m->vertex_count;
    fine->triangle_count = (uint32_t)m->cell_count;
    if (!mem_new(fine->triangle, m->cell_count, m->err) ||
        !mem_new(*piece, m->cell_count, m->err)) {
        grid_free(fine);
        return false;
    }
    for (size_t t = 0; t < m->cell_count; t++) {
        memcpy(fine->triangle[t], m->cell[t].v, sizeof m->cell[t].v);
        (*piece)[t] = m->cell[t].piece;
    }
    fine->vertex = m->vertex;
    m->vertex = NULL;
    return grid_build(fine, m->err);
}

bool refine_spline(const struct spline *s, const struct refine_request *request,
                   struct spline *fine, struct err *err) {
    struct mesh m;
    struct grid g = {0};
    struct piece *piece = NULL;
    bool ok, changed = true;
    INVARIANT(request->times >= 1 && request->times <= REFINE_TIMES_MAX);
    if (request->times * s->grid.degree > 53)
        return err_set(err, ERR_REFUSAL,
                       "cannot refine degree %d exactly %d times at once: expected times*degree <= "
                       "53; refine in several steps",
                       s->grid.degree, request->times);
    ok = mesh_init(&m, &s->grid, request->times, err);
    for (int i = 0; ok && i < request->times; i++) ok = round_of_red(&m, request);
    while (ok && changed) ok = close_by_red(&m, &changed);
    ok = ok && close_by_green(&m) && mesh_to_grid(&m, &s->grid, &g, &piece) &&
         resample_pieces(s, &g, piece, 1 << request->times, fine, err);
    mesh_free(&m);
    grid_free(&g);
    free(piece);
    return ok;
}
