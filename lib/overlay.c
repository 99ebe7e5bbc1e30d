/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A cell is bounded by pieces of the edges of its two triangles: of each edge, what lies in the
 * other triangle. The line of an edge pq goes through the other triangle from a gate, E, to
 * another, L, and the piece runs from the later of p, E to the earlier of q, L:
 *
 *              /\                  A gate is in an edge of the other triangle or at a corner of it.
 *      p      /  \      q          It shows in the sides of pq on which the corners lie: going
 * round
 *      *-----E----L-----*          counter-clockwise, from left to right at E, from right to left
 *           /______\               at L. Whether p comes before E is the side of p on which the
 * edge of the gate lies.
 *
 * Pieces are joined, end to beginning, to the cell. Its neighbours lie across the edges of the
 * pieces: those across edges of the second mesh are visited at once (they share the triangle of the
 * first), those across edges of the first when the turn of their triangle comes. Cells in a
 * triangle are connected through edges of the second mesh, because a triangle is convex, and one
 * cell is known at the boundary, so none is missed.
 *
 * Vertices are known by keys, kind, in[0], in[1] in one number, until all are there; then they are
 * sorted and numbered. */
#include "overlay.h"

#include "halfedge.h"
#include "mem.h"
#include "predicate.h"
#include "radix.h"

#define IN_BITS 31
#define IN_MAX  (UINT32_C(1) << IN_BITS)

struct work {
    const struct overlay_mesh *mesh;
    struct overlay *o;
    uint32_t *twin[2];
    uint32_t *host[2]; /* of a vertex of mesh m: a triangle of the other that has it */
    uint32_t *start;   /* of a triangle of the first: one of the second that it meets, or NONE */
    uint32_t *seen;    /* of a triangle of the second: the last of the first that it was met with */
    uint32_t *todo[2]; /* stacks: triangles of each mesh that are to be visited */
    size_t todo_count[2];
    uint64_t *key; /* of o->corner */
    size_t corner_count, corner_cap, cell_cap, start_cap;
};

/* Two triangles; sign[m][c][e]: on which side of edge e of the other is corner c of that of mesh m?
 */
struct meeting {
    uint32_t triangle[2];
    int sign[2][3][3];
};

/* Where a line enters or leaves a triangle. */
struct gate {
    int corner; /* of the triangle; -1: within an edge */
    int edge;   /* that the line goes through there */
};

struct piece {
    uint64_t from, to;    /* keys */
    uint32_t halfedge[2]; /* of each mesh, of which it is a piece, or NONE */
};

static uint64_t key_of(enum overlay_kind kind, uint32_t in0, uint32_t in1) {
    return (uint64_t)kind << 2 * IN_BITS | (uint64_t)in0 << IN_BITS | in1;
}

static uint64_t vertex_key(int m, uint32_t v) {
    return m == 0 ? key_of(OVERLAY_FIRST, v, 0) : key_of(OVERLAY_SECOND, 0, v);
}

static uint64_t pair_key(enum overlay_kind kind, int m, uint32_t own, uint32_t other) {
    return m == 0 ? key_of(kind, own, other) : key_of(kind, other, own);
}

static uint32_t edge_of(const struct work *w, int m, uint32_t halfedge) {
    uint32_t twin = w->twin[m][halfedge];
    return twin < halfedge ? twin : halfedge; /* NONE is the largest number */
}

static const double *place(const struct work *w, int m, uint32_t triangle, int corner) {
    return w->mesh[m].at[w->mesh[m].triangle[triangle][corner]];
}

static void meet(const struct work *w, struct meeting *x) {
    for (int m = 0; m < 2; m++)
        for (int e = 0; e < 3; e++) {
            const double *a = place(w, !m, x->triangle[!m], (e + 1) % 3);
            const double *b = place(w, !m, x->triangle[!m], (e + 2) % 3);
            for (int c = 0; c < 3; c++)
                x->sign[m][c][e] = predicate_orient(a, b, place(w, m, x->triangle[m], c));
        }
}

/* Where a line enters the triangle whose corners lie on these sides of it. Where it runs along an
 * edge, in the sense of that edge, it enters at the edge's beginning; against its sense never. */
static bool enters(const int side[3], struct gate *g) {
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, i = (j + 2) % 3;
        *g = (struct gate){-1, i};
        if (side[j] > 0 && side[k] < 0) return true;
        *g = (struct gate){j, k};
        if (side[i] > 0 && side[j] == 0 && side[k] <= 0) return true;
    }
    return false;
}

static bool leaves(const int side[3], struct gate *g) {
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, i = (j + 2) % 3;
        *g = (struct gate){-1, i};
        if (side[j] < 0 && side[k] > 0) return true;
        *g = (struct gate){j, i};
        if (side[i] <= 0 && side[j] == 0 && side[k] > 0) return true;
    }
    return false;
}

/* The end of a piece: the corner of edge e of mesh m's triangle, or the gate if the corner lies
 * before it (or behind it), outside the edge of the gate. */
static uint64_t end_key(const struct work *w, const struct meeting *x, int m, int e, int corner,
                        const struct gate *g) {
    int side = x->sign[m][corner][g->edge];
    uint32_t t = x->triangle[m], other = x->triangle[!m];
    uint32_t v = w->mesh[m].triangle[t][corner];
    uint32_t gate_vertex = g->corner < 0 ? 0 : w->mesh[!m].triangle[other][g->corner];
    if (side > 0 || (side == 0 && g->corner < 0)) return vertex_key(m, v);
    if (side == 0) return pair_key(OVERLAY_BOTH, m, v, gate_vertex);
    if (g->corner >= 0) return vertex_key(!m, gate_vertex);
    return pair_key(OVERLAY_CROSSING, m, edge_of(w, m, 3 * t + (uint32_t)e),
                    edge_of(w, !m, 3 * other + (uint32_t)g->edge));
}

/* The piece of edge e of mesh m's triangle; false if there is none. Where edges of both run
 * together, it belongs to the first mesh. */
static bool cut(const struct work *w, const struct meeting *x, int m, int e, struct piece *piece) {
    int from = (e + 1) % 3, to = (e + 2) % 3, side[3], along = -1;
    struct gate in, out;
    for (int c = 0; c < 3; c++) side[c] = x->sign[!m][c][e];
    for (int c = 0; c < 3; c++)
        if (side[c] > 0 && side[(c + 1) % 3] == 0 && side[(c + 2) % 3] == 0) along = c;
    if ((m == 1 && along >= 0) || !enters(side, &in) || !leaves(side, &out)) return false;
    if (x->sign[m][to][in.edge] <= 0 || x->sign[m][from][out.edge] <= 0) return false;
    piece->from = end_key(w, x, m, e, from, &in);
    piece->to = end_key(w, x, m, e, to, &out);
    piece->halfedge[m] = 3 * x->triangle[m] + (uint32_t)e;
    piece->halfedge[!m] = along < 0 ? HALFEDGE_NONE : 3 * x->triangle[!m] + (uint32_t)along;
    return true;
}

/* Vertices of the meshes that are corners here lie in these triangles. */
static void note_hosts(struct work *w, const struct meeting *x, uint64_t key) {
    uint32_t in0 = (uint32_t)(key >> IN_BITS) % IN_MAX, in1 = (uint32_t)key % IN_MAX;
    enum overlay_kind kind = (enum overlay_kind)(key >> 2 * IN_BITS);
    if (kind == OVERLAY_FIRST && w->host[0][in0] == HALFEDGE_NONE) w->host[0][in0] = x->triangle[1];
    if (kind == OVERLAY_SECOND && w->host[1][in1] == HALFEDGE_NONE)
        w->host[1][in1] = x->triangle[0];
}

static bool add_cell(struct work *w, const struct meeting *x, const struct piece *piece, int n,
                     struct err *err) {
    struct overlay *o = w->o;
    int at = 0;
    if (!mem_grow(w->key, &w->corner_cap, w->corner_count + (size_t)n, err) ||
        !mem_grow(o->cell, &w->cell_cap, o->cell_count + 1, err) ||
        !mem_grow(o->cell_start, &w->start_cap, o->cell_count + 2, err))
        return false;
    INVARIANT(n >= 3);
    for (int i = 0; i < n; i++) {
        int next = 0;
        w->key[w->corner_count++] = piece[at].from;
        note_hosts(w, x, piece[at].from);
        while (next < n && piece[next].from != piece[at].to) next++;
        INVARIANT(next < n && (next == 0) == (i == n - 1));
        at = next;
    }
    for (int m = 0; m < 2; m++) o->cell[o->cell_count][m] = x->triangle[m];
    o->cell_start[++o->cell_count] = w->corner_count;
    return true;
}

/* The neighbour across a piece is left to be visited. */
static void visit_later(struct work *w, const struct meeting *x, const struct piece *p) {
    uint32_t next[2];
    for (int m = 0; m < 2; m++) {
        next[m] = x->triangle[m];
        if (p->halfedge[m] == HALFEDGE_NONE) continue;
        if (w->twin[m][p->halfedge[m]] == HALFEDGE_NONE) return;
        next[m] = w->twin[m][p->halfedge[m]] / 3;
    }
    if (next[0] != x->triangle[0]) {
        if (w->start[next[0]] != HALFEDGE_NONE) return;
        w->start[next[0]] = next[1];
        w->todo[0][w->todo_count[0]++] = next[0];
    } else if (w->seen[next[1]] != next[0]) {
        w->seen[next[1]] = next[0];
        w->todo[1][w->todo_count[1]++] = next[1];
    }
}

static bool visit(struct work *w, uint32_t first, uint32_t second, struct err *err) {
    struct meeting x = {.triangle = {first, second}};
    struct piece piece[6];
    int n = 0;
    meet(w, &x);
    for (int m = 0; m < 2; m++)
        for (int e = 0; e < 3; e++) n += cut(w, &x, m, e, &piece[n]);
    for (int i = 0; i < n; i++) visit_later(w, &x, &piece[i]);
    return add_cell(w, &x, piece, n, err);
}

/* All cells in triangle t of the first mesh. */
static bool visit_triangle(struct work *w, uint32_t t, struct err *err) {
    w->todo[1][w->todo_count[1]++] = w->start[t];
    w->seen[w->start[t]] = t;
    while (w->todo_count[1] > 0)
        if (!visit(w, t, w->todo[1][--w->todo_count[1]], err)) return false;
    return true;
}

static uint32_t boundary_halfedge(const struct work *w, int m, uint32_t from) {
    uint32_t h = from;
    while (h < 3 * w->mesh[m].triangle_count && w->twin[m][h] != HALFEDGE_NONE) h++;
    INVARIANT(h < 3 * w->mesh[m].triangle_count);
    return h;
}

static bool same_edge(const struct work *w, uint32_t first, uint32_t second) {
    for (int end = 1; end < 3; end++) {
        const double *a = place(w, 0, first / 3, (int)(first + (uint32_t)end) % 3);
        const double *b = place(w, 1, second / 3, (int)(second + (uint32_t)end) % 3);
        if (a[0] != b[0] || a[1] != b[1]) return false;
    }
    return true;
}

/* At an edge of the boundary the triangles of both meshes meet. */
static bool visit_all(struct work *w, struct err *err) {
    uint32_t first = boundary_halfedge(w, 0, 0), second = boundary_halfedge(w, 1, 0);
    while (!same_edge(w, first, second)) second = boundary_halfedge(w, 1, second + 1);
    w->start[first / 3] = second / 3;
    w->todo[0][w->todo_count[0]++] = first / 3;
    while (w->todo_count[0] > 0)
        if (!visit_triangle(w, w->todo[0][--w->todo_count[0]], err)) return false;
    return true;
}

static struct overlay_vertex vertex_of(const struct work *w, uint64_t key) {
    struct overlay_vertex v = {(enum overlay_kind)(key >> 2 * IN_BITS),
                               {(uint32_t)(key >> IN_BITS) % IN_MAX, (uint32_t)key % IN_MAX}};
    if (v.kind == OVERLAY_FIRST) v.in[1] = w->host[0][v.in[0]];
    if (v.kind == OVERLAY_SECOND) v.in[0] = w->host[1][v.in[1]];
    return v;
}

static bool number_vertices(struct work *w, struct err *err) {
    struct radix_item *item = NULL, *spare = NULL;
    struct overlay *o = w->o;
    size_t n = w->corner_count, cap = 0;
    bool ok = n < UINT32_MAX || err_set(err, ERR_REFUSAL, "the overlay has more than 2^32 corners");
    ok = ok && mem_new(item, n, err) && mem_new(spare, n, err) && mem_new(o->corner, n, err);
    if (ok) {
        for (size_t i = 0; i < n; i++) item[i] = (struct radix_item){w->key[i], (uint32_t)i};
        radix_sort(item, spare, n);
    }
    for (size_t i = 0; ok && i < n; i++) {
        if (i == 0 || item[i].key != item[i - 1].key) {
            ok = mem_grow(o->vertex, &cap, o->vertex_count + 1, err);
            if (ok) o->vertex[o->vertex_count++] = vertex_of(w, item[i].key);
        }
        if (ok) o->corner[item[i].value] = (uint32_t)(o->vertex_count - 1);
    }
    free(item);
    free(spare);
    return ok;
}

static bool fill(uint32_t **array, size_t n, struct err *err) {
    if (!mem_new(*array, n, err)) return false;
    for (size_t i = 0; i < n; i++) (*array)[i] = HALFEDGE_NONE;
    return true;
}

static bool prepare(struct work *w, struct err *err) {
    for (int m = 0; m < 2; m++) {
        const struct overlay_mesh *mesh = &w->mesh[m];
        INVARIANT(3 * mesh->triangle_count < IN_MAX && mesh->vertex_count < IN_MAX);
        if (!halfedge_twins(&w->twin[m], mesh->triangle, mesh->triangle_count, err) ||
            !fill(&w->host[m], mesh->vertex_count, err) ||
            !mem_new(w->todo[m], mesh->triangle_count, err))
            return false;
    }
    if (!mem_grow(w->o->cell_start, &w->start_cap, 1, err)) return false;
    w->o->cell_start[0] = 0;
    return fill(&w->start, w->mesh[0].triangle_count, err) &&
           fill(&w->seen, w->mesh[1].triangle_count, err);
}

bool overlay_build(struct overlay *o, const struct overlay_mesh mesh[2], struct err *err) {
    struct work w = {.mesh = mesh, .o = o};
    bool ok;
    *o = (struct overlay){0};
    ok = prepare(&w, err) && visit_all(&w, err) && number_vertices(&w, err);
    for (int m = 0; m < 2; m++) {
        free(w.twin[m]);
        free(w.host[m]);
        free(w.todo[m]);
    }
    free(w.start);
    free(w.seen);
    free(w.key);
    return ok;
}

void overlay_free(struct overlay *o) {
    free(o->vertex);
    free(o->cell_start);
    free(o->corner);
    free(o->cell);
    *o = (struct overlay){0};
}
