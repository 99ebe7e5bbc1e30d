/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A mesh is a bag of triangles; neighbours are found by looking at all of them. */
#include "triangulations.h"

#include "testing.h"

#include <stdlib.h>
#include <string.h>

struct mesh {
    uint32_t vertices, triangles;
    int32_t (*v)[2];
    uint32_t (*t)[3];
};

static int64_t area2(const int32_t *a, const int32_t *b, const int32_t *c) {
    return (int64_t)(b[0] - a[0]) * (c[1] - a[1]) - (int64_t)(b[1] - a[1]) * (c[0] - a[0]);
}

static bool is_good(const struct mesh *m, uint32_t t) {
    return area2(m->v[m->t[t][0]], m->v[m->t[t][1]], m->v[m->t[t][2]]) > 0;
}

static bool has(const uint32_t *t, uint32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
}

static void *allocate(size_t n, size_t size) {
    void *p = calloc(n ? n : 1, size);
    INVARIANT(p);
    return p;
}

static void add_vertex(struct mesh *m, int x, int y) {
    m->v[m->vertices][0] = x;
    m->v[m->vertices++][1] = y;
}

static void add_triangle(struct mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    uint32_t *t = m->t[m->triangles++];
    t[0] = a;
    t[1] = b;
    t[2] = c;
}

static void add_square(struct mesh *m, const struct recipe *r, int x, int y) {
    uint32_t a = (uint32_t)(y * (r->nx + 1) + x), b = a + 1, d = a + (uint32_t)r->nx + 1, c = d + 1;
    if (r->crossed) {
        uint32_t centre = m->vertices;
        add_vertex(m, x * r->spacing + r->spacing / 2, y * r->spacing + r->spacing / 2);
        add_triangle(m, a, b, centre);
        add_triangle(m, b, c, centre);
        add_triangle(m, c, d, centre);
        add_triangle(m, d, a, centre);
    } else {
        add_triangle(m, a, b, c);
        add_triangle(m, a, c, d);
    }
}

static void make_squares(struct mesh *m, const struct recipe *r) {
    size_t squares = (size_t)(r->nx * r->ny), corners = (size_t)((r->nx + 1) * (r->ny + 1));
    m->v = allocate(2 * (corners + squares), sizeof *m->v);
    m->t = allocate(2 * 4 * squares, sizeof *m->t);
    for (int y = 0; y <= r->ny; y++)
        for (int x = 0; x <= r->nx; x++) add_vertex(m, x * r->spacing, y * r->spacing);
    for (int y = 0; y < r->ny; y++)
        for (int x = 0; x < r->nx; x++) add_square(m, r, x, y);
}

static void jitter(struct mesh *m, int spacing, uint64_t *seed) {
    for (uint32_t v = 0; v < m->vertices; v++) {
        int32_t old[2] = {m->v[v][0], m->v[v][1]};
        bool good = true;
        for (int c = 0; c < 2; c++)
            m->v[v][c] += (int32_t)random_in(seed, -spacing * 2 / 5, spacing * 2 / 5);
        for (uint32_t t = 0; t < m->triangles; t++)
            good = good && (!has(m->t[t], v) || is_good(m, t));
        if (!good) memcpy(m->v[v], old, sizeof old);
    }
}

/* Replaces the diagonal {p,q} of the quadrilateral of triangles p q r and q p s by {r,s}. */
static void flip(struct mesh *m, uint32_t t, int l) {
    uint32_t old[3], p = m->t[t][l], q = m->t[t][(l + 1) % 3], r = m->t[t][(l + 2) % 3];
    memcpy(old, m->t[t], sizeof old);
    for (uint32_t u = 0; u < m->triangles; u++)
        for (int k = 0; k < 3; k++) {
            uint32_t s = m->t[u][(k + 2) % 3], other[3] = {q, p, s};
            if (m->t[u][k] != q || m->t[u][(k + 1) % 3] != p) continue;
            memcpy(m->t[t], (uint32_t[3]){r, s, q}, sizeof old);
            memcpy(m->t[u], (uint32_t[3]){s, r, p}, sizeof old);
            if (is_good(m, t) && is_good(m, u)) return;
            memcpy(m->t[t], old, sizeof old);
            memcpy(m->t[u], other, sizeof other);
            return;
        }
}

/* The triangles around a vertex form fans: as many as there are triangles without a successor, or
 * none if they close. */
static bool has_one_fan(const struct mesh *m, uint32_t v) {
    int triangles = 0, ends = 0;
    for (uint32_t t = 0; t < m->triangles; t++) {
        bool followed = false;
        if (!has(m->t[t], v)) continue;
        int l = m->t[t][0] == v ? 0 : m->t[t][1] == v ? 1 : 2;
        for (uint32_t u = 0; u < m->triangles; u++)
            for (int k = 0; k < 3; k++)
                followed =
                    followed || (m->t[u][k] == v && m->t[u][(k + 1) % 3] == m->t[t][(l + 2) % 3]);
        triangles++;
        ends += !followed;
    }
    return triangles > 0 && ends <= 1;
}

static void remove_triangle(struct mesh *m, uint32_t t) {
    uint32_t gone[3], last = --m->triangles;
    bool good = true;
    memcpy(gone, m->t[t], sizeof gone);
    memcpy(m->t[t], m->t[last], sizeof gone);
    for (int l = 0; l < 3; l++) good = good && has_one_fan(m, gone[l]);
    if (good && last > 0) return;
    memcpy(m->t[last], m->t[t], sizeof gone);
    memcpy(m->t[t], gone, sizeof gone);
    m->triangles++;
}

static void duplicate(struct mesh *m, int shift) {
    uint32_t vertices = m->vertices, triangles = m->triangles;
    for (uint32_t v = 0; v < vertices; v++) add_vertex(m, m->v[v][0] + shift, m->v[v][1]);
    for (uint32_t t = 0; t < triangles; t++)
        add_triangle(m, m->t[t][0] + vertices, m->t[t][1] + vertices, m->t[t][2] + vertices);
}

/* Renumbers vertices, reorders triangles and turns them. */
static void shuffle(struct mesh *m, uint64_t *seed) {
    uint32_t *number = allocate(m->vertices, sizeof *number);
    for (uint32_t v = 0; v < m->vertices; v++) number[v] = v;
    for (uint32_t v = m->vertices - 1; v > 0; v--) {
        uint32_t u = (uint32_t)random_in(seed, 0, v), n = number[u];
        number[u] = number[v];
        number[v] = n;
    }
    int32_t(*moved)[2] = allocate(m->vertices, sizeof *moved);
    for (uint32_t v = 0; v < m->vertices; v++) memcpy(moved[number[v]], m->v[v], sizeof *moved);
    free(m->v);
    m->v = moved;
    for (uint32_t t = 0; t < m->triangles; t++) {
        uint32_t u = (uint32_t)random_in(seed, 0, t), swap[3],
                 first = (uint32_t)random_in(seed, 0, 2);
        for (uint32_t l = 0; l < 3; l++) swap[(l + first) % 3] = number[m->t[t][l]];
        memcpy(m->t[t], m->t[u], sizeof swap); /* m->t[u] is renumbered already, or is m->t[t] */
        memcpy(m->t[u], swap, sizeof swap);
    }
    free(number);
}

void triangulate(struct grid *g, const struct recipe *r, int degree, uint64_t seed) {
    struct mesh m = {0};
    make_squares(&m, r);
    if (r->jitter) jitter(&m, r->spacing, &seed);
    for (uint32_t i = 0, n = (uint32_t)r->flips * m.triangles; i < n; i++)
        flip(&m, (uint32_t)random_in(&seed, 0, m.triangles - 1), (int)random_in(&seed, 0, 2));
    for (int i = 0; i < r->removals; i++)
        remove_triangle(&m, (uint32_t)random_in(&seed, 0, m.triangles - 1));
    if (r->components > 1) duplicate(&m, (r->nx + 3) * r->spacing);
    if (r->shuffled) shuffle(&m, &seed);
    *g = (struct grid){.degree = degree, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
    g->vertex_count = m.vertices;
    g->triangle_count = m.triangles;
    g->vertex = m.v;
    g->triangle = m.t;
}

void random_grid(struct grid *g, int size, int degree, uint64_t seed) {
    struct err err = {0};
    uint64_t s = seed ^ 0x5bd1e995;
    struct recipe r = {.nx = (int)random_in(&s, 1, size),
                       .ny = (int)random_in(&s, 1, size),
                       .spacing = 2 * (int)random_in(&s, 1, 500),
                       .crossed = random_in(&s, 0, 2) == 0,
                       .jitter = random_in(&s, 0, 2) > 0,
                       .flips = (int)random_in(&s, 0, 1),
                       .components = random_in(&s, 0, 3) == 0 ? 2 : 1,
                       .shuffled = random_in(&s, 0, 1) == 0};
    r.removals = random_in(&s, 0, 1) ? (int)random_in(&s, 0, r.nx * r.ny / 2) : 0;
    triangulate(g, &r, degree, s);
    INVARIANT(grid_build(g, &err));
}
