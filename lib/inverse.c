/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A query first looks at the piece where the last one ended. If q has a preimage in it farther from
 * all edges of its triangle T than `slack`, then under a one-to-one map no other piece has a point
 * within `border` of q: a disk of radius (1 - kappa) slack around q is covered by the piece alone.
 * Otherwise the pieces in the cell of q are looked at, all of them in ascending order:
 *
 *   - a tame or flat piece has a preimage or none;
 *   - with any other piece, the whole patch is searched: halved, both halves searched in turn
 *     unless q is not near their hulls, until they are tame or flat.
 *
 * The first that has one within 2 ulp is the answer, else the one that is nearest, if it is within
 * `border`. */
#include "inverse.h"

#include "mem.h"

#include <math.h>
#include <string.h>

/* Each halving of an edge leaves a fourth of the bend along it, and 2^-52 of it is nothing, so
 * LEVELS in a row are plenty. A search takes some 100 in all, and 3,000 where the determinant is 0
 * on a line. Where an image is hardly wider than an ulp, as of a map onto a curve, points that are
 * off it by little can take millions: what is near after HALVINGS_MAX is not cut further. */
enum { LEVELS = 160, HALVINGS_MAX = 32768 };

struct query {
    const struct inverse *inverse;
    double q[2]; /* scaled */
    inverse_wanted *wanted;
    void *context;
    struct dd (*room)[2];
    int halvings;
    double miss; /* of the best place, infinite while there is none */
    struct place best;
};

void inverse_net(const struct inverse *v, uint32_t t, struct piece_net *net) {
    const struct grid *g = &v->spline->grid;
    uint32_t points[GRID_PATCH_MAX];
    grid_patch(g, t, points);
    for (int i = 0; i < grid_patch_size(g->degree); i++)
        for (int c = 0; c < 2; c++)
            net->q[i][c] = (struct dd){v->spline->phi[points[i]][c] * v->scale, 0};
    for (int i = 0; i < 9; i++) net->place[i / 3][i % 3] = i % 4 == 0;
}

/* Coordinates in a piece that are worth no more than half an ulp count as 0. */
static void drop_dust(const struct piece *p, const double local[3], double w[3]) {
    double size =
        fabs(p->side[0][0]) + fabs(p->side[0][1]) + fabs(p->side[1][0]) + fabs(p->side[1][1]);
    int most = 0;
    for (int l = 0; l < 3; l++) {
        w[l] = local[l];
        if (local[l] > local[most]) most = l;
    }
    for (int l = 0; l < 3; l++) {
        if (l == most || w[l] > 0x1p-20 || w[l] * size > PIECE_NEAR / 2) continue;
        w[most] += w[l];
        w[l] = 0;
    }
}

/* The place in its triangle of coordinates in a piece. Sums as in locate: fl(fl(b0+b1)+b2) = 1, and
 * what is 0 stays so. */
static void set_place(const struct inverse_piece *p, const double local[3], struct place *place) {
    const double(*corner)[3] = p->piece.place;
    double *b = place->b, w[3];
    drop_dust(&p->piece, local, w);
    for (int k = 0; k < 3; k++)
        b[k] = w[0] * corner[0][k] + w[1] * corner[1][k] + w[2] * corner[2][k];
    b[0] = b[1] == 0 && b[2] == 0 ? 1 : fmin(b[0], 1);
    b[1] = b[2] == 0 ? 1 - b[0] : fmin(b[1], 1 - b[0]);
    b[2] = b[2] == 0 ? 0 : 1 - (b[0] + b[1]);
    place->triangle = p->triangle;
}

/* Takes what piece_solve found in a piece. True: no other piece can do better. */
static bool offer(struct query *query, const struct inverse_piece *p, const double local[3],
                  double miss) {
    struct place place = {.triangle = p->triangle};
    if (!(miss <= query->inverse->border && miss < query->miss)) return false;
    set_place(p, local, &place);
    if (query->wanted && !query->wanted(query->context, &place)) return false;
    query->best = place;
    query->miss = miss;
    return miss <= 2 * PIECE_NEAR;
}

static bool try_piece(struct query *query, const struct inverse_piece *p, const double (*bend)[2]) {
    const struct inverse *v = query->inverse;
    double b[3], miss;
    return piece_solve(&p->piece, v->spline->grid.degree, bend, query->q, v->slack, b, &miss) &&
           offer(query, p, b, miss);
}

/* Searches a net that was made by `level` halvings; those of further ones go into the room. */
static bool search(struct query *query, uint32_t t, const struct piece_net *net, int level) {
    const struct inverse *v = query->inverse;
    int degree = v->spline->grid.degree, size = grid_patch_size(degree);
    struct inverse_piece p = {.triangle = t};
    double bend[PIECE_SIZE_MAX][2];
    struct piece_net half[2];
    if (!piece_box_is_near(degree, net, query->q, v->slack)) return false;
    piece_frame(&p.piece, degree, net, v->slack);
    if (!piece_is_near(&p.piece, query->q)) return false;
    piece_bend(&p.piece, degree, net, bend);
    if (level == LEVELS || query->halvings == HALVINGS_MAX) p.piece.flat = true;
    if (p.piece.tame || p.piece.flat) return try_piece(query, &p, (const double(*)[2])bend);
    query->halvings++;
    for (int h = 0; h < 2; h++) half[h].q = query->room + (2 * level + h + 1) * size;
    piece_halve(degree, net, p.piece.longest, half);
    return search(query, t, &half[0], level + 1) || search(query, t, &half[1], level + 1);
}

static const double (*bend_of(const struct inverse *v, uint32_t n))[2] {
    return (const double(*)[2])v->bend +
           (size_t)n * (size_t)grid_patch_size(v->spline->grid.degree);
}

/* Looks at piece n; *searched is the triangle that was searched last. */
static bool look(struct query *query, uint32_t n, uint32_t *searched) {
    const struct inverse *v = query->inverse;
    const struct inverse_piece *p = &v->piece[n];
    struct piece_net net = {.q = query->room};
    if (!piece_is_near(&p->piece, query->q)) return false;
    if (p->piece.tame || p->piece.flat) return try_piece(query, p, bend_of(v, n));
    if (p->triangle == *searched) return false;
    *searched = p->triangle;
    inverse_net(v, p->triangle, &net);
    return search(query, p->triangle, &net, 0);
}

/* The preimage in piece n, if q is there and nowhere else. */
static bool is_alone(struct query *query, uint32_t n) {
    const struct inverse *v = query->inverse;
    const struct inverse_piece *p = &v->piece[n];
    double b[3], miss;
    if (!p->piece.tame || !piece_is_near(&p->piece, query->q) ||
        !piece_solve(&p->piece, v->spline->grid.degree, bend_of(v, n), query->q, v->slack, b,
                     &miss))
        return false;
    for (int l = 0; l < 3; l++)
        if (!(b[l] * p->piece.height[l] > v->slack)) return false;
    set_place(p, b, &query->best);
    return true;
}

static struct query make_query(const struct inverse_cursor *c, const double q[2],
                               inverse_wanted *wanted, void *context) {
    double scale = c->inverse->scale;
    return (struct query){.inverse = c->inverse,
                          .q = {q[0] * scale, q[1] * scale},
                          .wanted = wanted,
                          .context = context,
                          .room = c->room,
                          .miss = INFINITY,
                          .best = {.triangle = GRID_NONE}};
}

bool inverse_find(struct inverse_cursor *c, const double q[2], inverse_wanted *wanted,
                  void *context, struct place *place) {
    const struct inverse *v = c->inverse;
    struct query query = make_query(c, q, wanted, context);
    uint32_t searched = GRID_NONE;
    size_t cell;
    *place = query.best;
    if (!cells_holds(&v->cells.raster, query.q)) return false;
    if (v->one_to_one && is_alone(&query, c->hint)) {
        if (wanted && !wanted(context, &query.best)) return false;
        *place = query.best;
        return true;
    }
    cell = cells_of(&v->cells.raster, query.q);
    for (uint32_t i = v->cells.start[cell]; i < v->cells.start[cell + 1]; i++)
        if (look(&query, v->cells.item[i], &searched)) {
            c->hint = v->cells.item[i];
            break;
        }
    *place = query.best;
    return place->triangle != GRID_NONE;
}

bool inverse_find_in(struct inverse_cursor *c, uint32_t t, const double q[2],
                     inverse_wanted *wanted, void *context, struct place *place) {
    const struct inverse *v = c->inverse;
    struct query query = make_query(c, q, wanted, context);
    uint32_t searched = GRID_NONE;
    for (uint32_t n = v->first[t]; n < v->first[t + 1]; n++)
        if (look(&query, n, &searched)) break;
    *place = query.best;
    return place->triangle != GRID_NONE;
}

void inverse_point(const struct inverse *v, const double q[2], const struct place *place,
                   double p[2]) {
    /* [s]: the subsets of the set of corners s, bit n standing for set n */
    static const uint8_t subsets[8] = {0, 0x02, 0x04, 0x0e, 0x10, 0x32, 0x54, 0xfe};
    const struct grid *g = &v->spline->grid;
    const uint32_t *corner = g->triangle[place->triangle];
    const double *b = place->b;
    const double *at[3] = {v->vertex[corner[0]], v->vertex[corner[1]], v->vertex[corner[2]]};
    int support = (b[0] != 0) | (b[1] != 0) << 1 | (b[2] != 0) << 2;
    for (int c = 0; c < 2; c++) {
        const int32_t x[3] = {g->vertex[corner[0]][c], g->vertex[corner[1]][c],
                              g->vertex[corner[2]][c]};
        double inner = b[1] * (x[1] - x[0]) + b[2] * (x[2] - x[0]);
        p[c] = at[0][c] + g->lattice.step * inner;
        if (support == 2 || support == 4) p[c] = at[support / 2][c];
        if (!(v->moved[place->triangle][c] & subsets[support])) p[c] = q[c];
    }
}

/* ---- cursors */

bool inverse_cursor_init(struct inverse_cursor *c, const struct inverse *v, struct err *err) {
    size_t size = (size_t)grid_patch_size(v->spline->grid.degree);
    *c = (struct inverse_cursor){.inverse = v};
    return mem_new(c->room, (2 * LEVELS + 1) * size, err);
}

void inverse_cursor_free(struct inverse_cursor *c) {
    free(c->room);
    *c = (struct inverse_cursor){0};
}

void inverse_cursor_hint(struct inverse_cursor *c, uint32_t t) {
    c->hint = c->inverse->first[t];
}
