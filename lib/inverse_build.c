/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch is halved until its pieces are tame or flat, at most a certain number of times; pieces of
 * triangles follow each other in the order of the triangles. */
#include "inverse.h"

#include "mem.h"

#include <math.h>

enum {
    CELLS_PER_PIECE = 4,
    HALVINGS_MIN =
        2, /* of a patch, in a row; more, up to HALVINGS_MAX, in a grid of few triangles */
    HALVINGS_MAX = 8,
    PIECES_MANY = 128 * 1024,
};

struct builder {
    struct inverse *inverse;
    double (*box)[4]; /* of each piece: x and y of the lowest and highest control points */
    struct dd (*room)[2];
    size_t piece_cap, bend_cap, box_cap;
    int degree, size, halvings;
};

/* ---- pieces */

static void set_box(const struct piece_net *net, int size, double box[4]) {
    for (int c = 0; c < 2; c++) box[c] = box[2 + c] = net->q[0][c].hi;
    for (int i = 1; i < size; i++)
        for (int c = 0; c < 2; c++) {
            box[c] = fmin(box[c], net->q[i][c].hi);
            box[2 + c] = fmax(box[2 + c], net->q[i][c].hi);
        }
}

static bool make_room(struct builder *b, struct err *err) {
    struct inverse *v = b->inverse;
    size_t n = (size_t)v->piece_count + 1;
    if (n == UINT32_MAX) return err_set(err, ERR_INPUT, "too many triangles for an inverse");
    return mem_grow(v->piece, &b->piece_cap, n, err) && mem_grow(b->box, &b->box_cap, n, err) &&
           mem_grow(v->bend, &b->bend_cap, n * (size_t)b->size, err);
}

/* Adds the pieces of a net that was made by `level` halvings. */
static bool add_pieces(struct builder *b, uint32_t t, const struct piece_net *net, int level,
                       struct err *err) {
    struct inverse *v = b->inverse;
    struct piece_net half[2];
    struct inverse_piece *p;
    if (!make_room(b, err)) return false;
    p = &v->piece[v->piece_count];
    p->triangle = t;
    piece_frame(&p->piece, b->degree, net, v->slack);
    piece_bend(&p->piece, b->degree, net, v->bend + (size_t)v->piece_count * (size_t)b->size);
    if (p->piece.tame || p->piece.flat || level == b->halvings) {
        set_box(net, b->size, b->box[v->piece_count++]);
        return true;
    }
    for (int h = 0; h < 2; h++) half[h].q = b->room + (2 * level + h + 1) * b->size;
    piece_halve(b->degree, net, p->piece.longest, half);
    return add_pieces(b, t, &half[0], level + 1, err) && add_pieces(b, t, &half[1], level + 1, err);
}

static bool make_pieces(struct builder *b, struct err *err) {
    struct inverse *v = b->inverse;
    uint32_t n = v->spline->grid.triangle_count;
    for (uint32_t t = 0; t < n; t++) {
        struct piece_net net = {.q = b->room};
        v->first[t] = v->piece_count;
        inverse_net(v, t, &net);
        if (!add_pieces(b, t, &net, 0, err)) return false;
    }
    v->first[n] = v->piece_count;
    return true;
}

/* ---- cells */

static void item_box(const void *builder, uint32_t i, double lo[2], double hi[2]) {
    const struct builder *b = builder;
    for (int c = 0; c < 2; c++) {
        lo[c] = b->box[i][c] - b->inverse->slack;
        hi[c] = b->box[i][2 + c] + b->inverse->slack;
    }
}

/* Does the rectangle lie on one side of what lies between two parallel lines? */
static bool item_misses(const void *builder, uint32_t i, const double x[2], const double y[2]) {
    const struct builder *b = builder;
    const struct piece *p = &b->inverse->piece[i].piece;
    for (int l = 0; l < 3; l++) {
        const double *n = p->normal[l];
        double most = n[0] * (x[n[0] > 0] - p->corner[0]) + n[1] * (y[n[1] > 0] - p->corner[1]);
        double least = n[0] * (x[n[0] < 0] - p->corner[0]) + n[1] * (y[n[1] < 0] - p->corner[1]);
        if (most < p->low[l] || least > p->high[l]) return true;
    }
    return false;
}

static bool make_cells(struct builder *b, struct err *err) {
    struct inverse *v = b->inverse;
    struct cells_items items = {v->piece_count, b, item_box, item_misses};
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    for (uint32_t i = 0; i < v->piece_count; i++) {
        double from[2], to[2];
        item_box(b, i, from, to);
        for (int c = 0; c < 2; c++) {
            lo[c] = fmin(lo[c], from[c]);
            hi[c] = fmax(hi[c], to[c]);
        }
    }
    return cells_init(&v->cells, lo, hi, &items, CELLS_PER_PIECE, "triangles", err);
}

/* ---- the whole */

/* The exponent of the largest |coordinate|. */
static int exponent_of(double (*xy)[2], uint32_t n) {
    double largest = 0;
    int e = 0;
    for (uint32_t i = 0; i < n; i++) largest = fmax(largest, fmax(fabs(xy[i][0]), fabs(xy[i][1])));
    (void)frexp(largest, &e);
    return e > -1000 ? e : -1000;
}

static void set_scale(struct inverse *v) {
    const struct grid *g = &v->spline->grid;
    int image = exponent_of(v->spline->phi, g->point_count);
    int domain = exponent_of(v->vertex, g->vertex_count);
    v->scale = ldexp(1, 1 - image);
    v->border = 16 * ldexp(PIECE_NEAR, domain > image ? domain - image : 0);
    v->slack = 2 * v->border + 0x1p-49;
}

/* Which components of which control points are where the identity has them. */
static bool find_moved(struct inverse *v, struct err *err) {
    const struct grid *g = &v->spline->grid;
    uint8_t *still;
    if (!mem_new(still, g->point_count, err)) return false;
    for (uint32_t p = 0; p < g->point_count; p++) {
        double nominal[2];
        grid_nominal(g, p, nominal);
        for (int c = 0; c < 2; c++)
            if (v->spline->phi[p][c] == nominal[c]) still[p] |= (uint8_t)(1 << c);
    }
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        uint32_t points[GRID_PATCH_MAX];
        grid_patch(g, t, points);
        for (int row = 0, i = 0; row <= g->degree; row++)
            for (int k = 0; k <= row; k++, i++) {
                int support = (row < g->degree) | (row > k) << 1 | (k > 0) << 2;
                for (int c = 0; c < 2; c++)
                    if (!(still[points[i]] >> c & 1)) v->moved[t][c] |= (uint8_t)(1 << support);
            }
    }
    free(still);
    return true;
}

bool inverse_init(struct inverse *v, const struct spline *s, bool one_to_one, struct err *err) {
    const struct grid *g = &s->grid;
    struct builder b = {.inverse = v, .degree = g->degree, .size = grid_patch_size(g->degree)};
    bool ok;
    *v = (struct inverse){.spline = s, .one_to_one = one_to_one};
    ok = mem_new(v->vertex, g->vertex_count, err) && mem_new(v->moved, g->triangle_count, err) &&
         mem_new(v->first, (size_t)g->triangle_count + 1, err) &&
         mem_new(b.room, (size_t)((2 * HALVINGS_MAX + 1) * b.size), err);
    for (uint32_t i = 0; ok && i < g->vertex_count; i++) grid_vertex(g, i, v->vertex[i]);
    if (ok) set_scale(v);
    b.halvings = HALVINGS_MIN;
    while (b.halvings < HALVINGS_MAX && (uint64_t)g->triangle_count << b.halvings < PIECES_MANY)
        b.halvings++;
    ok = ok && make_pieces(&b, err) && make_cells(&b, err) && find_moved(v, err);
    free(b.room);
    free(b.box);
    if (!ok) inverse_free(v);
    return ok;
}

void inverse_free(struct inverse *v) {
    free(v->first);
    free(v->piece);
    free(v->bend);
    free(v->vertex);
    free(v->moved);
    cells_free(&v->cells);
    *v = (struct inverse){0};
}
