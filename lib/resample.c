/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each new control point is a row of integer coefficients times the old patch, over one
 * denominator.
 *
 * A blossom's row: the argument p = (x0,x1,x2) turns a form of degree n into one of degree n - 1,
 * so taken together the coefficients are those of the product of linear forms
 *
 *      (A0 X + A1 Y + A2 Z)^i (B0 X + B1 Y + B2 Z)^j (C0 X + C1 Y + C2 Z)^k
 *
 * (monomial X^a Y^b Z^c belongs to q_abc), over sum^degree. Pieces of the same shape share their
 * rows: a small table keeps the last ones. */
#include "resample.h"

#include "exact_dot.h"
#include "mem.h"

#include <string.h>

enum { SHAPES = 64 };

struct rows {
    bool valid;
    int32_t corner[3][3];
    int64_t coefficient[]; /* patch size x patch size */
};

struct resampler {
    const struct spline *from;
    struct spline *to;
    int from_size, to_size; /* points of a patch */
    double denominator;
    bool *done; /* points of `to` that are set: those on edges and corners come up again */
};

/* Place of the monomial with exponents a, b, c in the order of grid_patch. */
static int monomial(int degree, int a, int b) {
    int s = degree - a;
    return s * (s + 1) / 2 + s - b;
}

/* to = from * (l0 X + l1 Y + l2 Z); from has the given degree. */
static void multiply(int degree, const int64_t *from, const int32_t l[3], int64_t *to) {
    memset(to, 0, (size_t)grid_patch_size(degree + 1) * sizeof *to);
    for (int a = degree; a >= 0; a--)
        for (int b = degree - a; b >= 0; b--) {
            int64_t c = *from++;
            to[monomial(degree + 1, a + 1, b)] += c * l[0];
            to[monomial(degree + 1, a, b + 1)] += c * l[1];
            to[monomial(degree + 1, a, b)] += c * l[2];
        }
}

/* Row of the blossom at corner 0 i times, corner 1 j times, corner 2 the rest. */
static void blossom_row(int degree, const int32_t corner[3][3], int i, int j, int64_t *row) {
    int64_t product[GRID_PATCH_MAX] = {1}, next[GRID_PATCH_MAX];
    for (int n = 0; n < degree; n++) {
        multiply(n, product, corner[n < i ? 0 : n < i + j ? 1 : 2], next);
        memcpy(product, next, sizeof product);
    }
    memcpy(row, product, (size_t)grid_patch_size(degree) * sizeof *row);
}

static void blossom_rows(int degree, const int32_t corner[3][3], int64_t *row) {
    for (int i = degree; i >= 0; i--)
        for (int j = degree - i; j >= 0; j--, row += grid_patch_size(degree))
            blossom_row(degree, corner, i, j, row);
}

/* One component of one new point; x: the old patch of that component. */
static double apply_row(const struct resampler *r, const int64_t *row, const double *x) {
    double c[GRID_PATCH_MAX], y[GRID_PATCH_MAX];
    size_t n = 0;
    for (int i = 0; i < r->from_size; i++)
        if (row[i] != 0) {
            c[n] = (double)row[i];
            y[n++] = x[i];
        }
    if (n == 1 && c[0] == r->denominator) return y[0]; /* keeps -0 */
    return exact_dot(n, c, y, r->denominator);
}

/* Sets the points of triangle `t` of the new grid from triangle `old` of the old one. */
static void resample_patch(const struct resampler *r, uint32_t old, uint32_t t,
                           const int64_t *rows) {
    uint32_t from[GRID_PATCH_MAX], to[GRID_PATCH_MAX];
    double x[4][GRID_PATCH_MAX];
    bool depth = r->from->sigma != NULL;
    grid_patch(&r->from->grid, old, from);
    grid_patch(&r->to->grid, t, to);
    for (int i = 0; i < r->from_size; i++)
        for (int c = 0; c < 2; c++) {
            x[c][i] = r->from->phi[from[i]][c];
            if (depth) x[2 + c][i] = r->from->sigma[from[i]][c];
        }
    for (int i = 0; i < r->to_size; i++, rows += r->from_size) {
        if (r->done[to[i]]) continue;
        r->done[to[i]] = true;
        for (int c = 0; c < 2; c++) {
            r->to->phi[to[i]][c] = apply_row(r, rows, x[c]);
            if (depth) r->to->sigma[to[i]][c] = apply_row(r, rows, x[2 + c]);
        }
    }
}

static bool resampler_init(struct resampler *r, const struct spline *s, struct grid *g,
                           struct spline *to, struct err *err) {
    *r = (struct resampler){.from = s,
                            .to = to,
                            .from_size = grid_patch_size(s->grid.degree),
                            .to_size = grid_patch_size(g->degree)};
    if (!spline_allocate(to, g, err)) return false;
    if (mem_new(r->done, to->grid.point_count, err)) return true;
    spline_free(to);
    return false;
}

/* A place for the rows of a shape: which one is a matter of speed only. */
static size_t shape_slot(const int32_t corner[3][3]) {
    uint32_t hash = 0;
    for (int l = 0; l < 9; l++) hash = (hash ^ (uint32_t)corner[l / 3][l % 3]) * 2654435761u;
    return (hash >> 16) % SHAPES;
}

bool resample_pieces(const struct spline *s, struct grid *g, const struct piece *piece, int32_t sum,
                     struct spline *fine, struct err *err) {
    struct resampler r;
    size_t size = (size_t)grid_patch_size(s->grid.degree);
    size_t row_bytes = sizeof(struct rows) + size * size * sizeof(int64_t);
    char *table = mem_alloc(SHAPES, row_bytes, err);
    if (!table || !resampler_init(&r, s, g, fine, err)) {
        free(table);
        return false;
    }
    r.denominator = 1;
    for (int i = 0; i < s->grid.degree; i++) r.denominator *= sum;
    for (uint32_t t = 0; t < fine->grid.triangle_count; t++) {
        struct rows *rows = (void *)(table + shape_slot(piece[t].corner) * row_bytes);
        if (!rows->valid || memcmp(rows->corner, piece[t].corner, sizeof rows->corner) != 0) {
            blossom_rows(s->grid.degree, piece[t].corner, rows->coefficient);
            memcpy(rows->corner, piece[t].corner, sizeof rows->corner);
            rows->valid = true;
        }
        resample_patch(&r, piece[t].triangle, t, rows->coefficient);
    }
    free(table);
    free(r.done);
    return true;
}

static int64_t binomial(int n, int k) {
    int64_t value = 1;
    if (k < 0 || k > n) return 0;
    for (int i = 1; i <= k; i++) value = value * (n - k + i) / i;
    return value;
}

static void elevation_rows(int from, int to, int64_t *row) {
    for (int i = to; i >= 0; i--)
        for (int j = to - i; j >= 0; j--)
            for (int a = from; a >= 0; a--)
                for (int b = from - a; b >= 0; b--)
                    *row++ = binomial(i, a) * binomial(j, b) * binomial(to - i - j, from - a - b);
}

bool resample_degree(const struct spline *s, int degree, struct spline *raised, struct err *err) {
    struct resampler r;
    struct grid g = {0};
    int64_t *rows = NULL;
    bool ok = false;
    size_t size = (size_t)grid_patch_size(s->grid.degree) * (size_t)grid_patch_size(degree);
    INVARIANT(degree >= s->grid.degree && degree <= GRID_DEGREE_MAX);
    if (!resample_copy_grid(&s->grid, &g, err)) return false;
    g.degree = degree;
    if (!grid_build(&g, err)) goto out;
    if (!mem_new(rows, size, err) || !resampler_init(&r, s, &g, raised, err)) goto out;
    elevation_rows(s->grid.degree, degree, rows);
    r.denominator = (double)binomial(degree, s->grid.degree);
    for (uint32_t t = 0; t < s->grid.triangle_count; t++) resample_patch(&r, t, t, rows);
    free(r.done);
    ok = true;
out:
    grid_free(&g);
    free(rows);
    return ok;
}

bool resample_copy_grid(const struct grid *g, struct grid *copy, struct err *err) {
    *copy = (struct grid){.degree = g->degree,
                          .lattice = g->lattice,
                          .has_depth = g->has_depth,
                          .vertex_count = g->vertex_count,
                          .triangle_count = g->triangle_count};
    memcpy(copy->axes, g->axes, sizeof copy->axes);
    memcpy(copy->depth, g->depth, sizeof copy->depth);
    if (!mem_new(copy->vertex, g->vertex_count, err) ||
        !mem_new(copy->triangle, g->triangle_count, err)) {
        grid_free(copy);
        return false;
    }
    memcpy(copy->vertex, g->vertex, g->vertex_count * sizeof *g->vertex);
    memcpy(copy->triangle, g->triangle, g->triangle_count * sizeof *g->triangle);
    return true;
}
