/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Longest-edge bisection (Rivara 1984). A triangle is halved together with its neighbour across its
 * longest side, if that is the neighbour's longest side too; else the neighbour comes first, and so
 * on along a path of ever longer sides:
 *
 *         c                 c             t = abc becomes abm' = bcm and cam, where m is the middle
 *        /|\               /|\            of its longest side ab; edge e of t is ab, its half edges
 *       / | \             / | \           are 3t+e and the twin.
 *      a-----b    ->     a--m--b
 *
 * Sides are compared by length, then by the numbers of their vertices, so the path ends. */
#include "plane_map.h"

#include "halfedge.h"
#include "mem.h"
#include "num.h"
#include "predicate.h"

#include <string.h>

struct splitter {
    struct plane_map *p;
    uint32_t *twin;
    size_t at_cap[2], triangle_cap, twin_cap;
    size_t max_triangles;
    int digits;
};

static const uint32_t (*triangles(const struct splitter *s))[3] {
    return (const uint32_t(*)[3])s->p->triangle;
}

static double area(const struct plane_map *p, uint32_t t) {
    const double *a = p->at[0][p->triangle[t][0]], *b = p->at[0][p->triangle[t][1]],
                 *c = p->at[0][p->triangle[t][2]];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

static bool is_longer(const struct splitter *s, uint32_t g, uint32_t h) {
    uint32_t v[2][2] = {{halfedge_from(triangles(s), g), halfedge_to(triangles(s), g)},
                        {halfedge_from(triangles(s), h), halfedge_to(triangles(s), h)}};
    double length2[2];
    for (int i = 0; i < 2; i++) {
        const double *a = s->p->at[0][v[i][0]], *b = s->p->at[0][v[i][1]];
        length2[i] = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
        if (v[i][0] > v[i][1]) {
            uint32_t swap = v[i][0];
            v[i][0] = v[i][1];
            v[i][1] = swap;
        }
    }
    if (length2[0] != length2[1]) return length2[0] > length2[1];
    return v[0][0] != v[1][0] ? v[0][0] > v[1][0] : v[0][1] > v[1][1];
}

static uint32_t longest(const struct splitter *s, uint32_t t) {
    uint32_t best = 3 * t;
    for (uint32_t h = 3 * t + 1; h < 3 * t + 3; h++)
        if (is_longer(s, h, best)) best = h;
    return best;
}

/* The side that is to be halved first. */
static uint32_t end_of_path(const struct splitter *s, uint32_t t) {
    uint32_t h = longest(s, t);
    while (s->twin[h] != HALFEDGE_NONE) {
        uint32_t g = longest(s, s->twin[h] / 3);
        if (g == s->twin[h]) break;
        h = g;
    }
    return h;
}

/* Are the halves of h's triangle, cut at m, sound? */
static bool is_sound(const struct splitter *s, uint32_t h, uint32_t m) {
    uint32_t a = halfedge_from(triangles(s), h), b = halfedge_to(triangles(s), h),
             o = halfedge_apex(triangles(s), h);
    for (int k = 0; k < 2; k++) {
        const double(*at)[2] = (const double(*)[2])s->p->at[k];
        if (predicate_orient(at[a], at[m], at[o]) <= 0 ||
            predicate_orient(at[m], at[b], at[o]) <= 0)
            return false;
    }
    return true;
}

static void join(struct splitter *s, uint32_t g, uint32_t h) {
    if (g != HALFEDGE_NONE) s->twin[g] = h;
    if (h != HALFEDGE_NONE) s->twin[h] = g;
}

/* Halves the triangle of h = ab: it keeps a and its half edge h, now am; returns that of mb. */
static uint32_t halve(struct splitter *s, uint32_t h, uint32_t m) {
    struct plane_map *p = s->p;
    uint32_t t = h / 3, c = h % 3, more = (uint32_t)p->triangle_count++;
    uint32_t far = s->twin[3 * t + (c + 1) % 3]; /* beyond bo */
    memcpy(p->triangle[more], p->triangle[t], sizeof *p->triangle);
    p->triangle[t][(c + 2) % 3] = m;
    p->triangle[more][(c + 1) % 3] = m;
    join(s, 3 * more + (c + 1) % 3, far);
    join(s, 3 * t + (c + 1) % 3, 3 * more + (c + 2) % 3);
    return 3 * more + c;
}

static bool make_room(struct splitter *s, struct err *err) {
    struct plane_map *p = s->p;
    if (p->triangle_count + 2 > s->max_triangles)
        return err_set(err, ERR_REFUSAL, "more than %zu triangles are needed", s->max_triangles);
    return mem_grow(p->at[0], &s->at_cap[0], p->vertex_count + 1, err) &&
           mem_grow(p->at[1], &s->at_cap[1], p->vertex_count + 1, err) &&
           mem_grow(p->triangle, &s->triangle_cap, p->triangle_count + 2, err) &&
           mem_grow(s->twin, &s->twin_cap, 3 * (p->triangle_count + 2), err);
}

/* Halves side h, if its triangles' halves are sound; *done says so. */
static bool split(struct splitter *s, uint32_t h, bool *done, struct err *err) {
    struct plane_map *p = s->p;
    uint32_t m = (uint32_t)p->vertex_count, g = s->twin[h], h2, g2;
    uint32_t a = halfedge_from(triangles(s), h), b = halfedge_to(triangles(s), h);
    if (!make_room(s, err)) return false;
    for (int k = 0; k < 2; k++)
        for (int c = 0; c < 2; c++)
            p->at[k][m][c] =
                num_rounded(p->at[k][a][c] / 2 + p->at[k][b][c] / 2, k ? s->digits : 0);
    *done = is_sound(s, h, m) && (g == HALFEDGE_NONE || is_sound(s, g, m));
    if (!*done) return true;
    p->vertex_count++;
    h2 = halve(s, h, m); /* h = am, h2 = mb */
    s->twin[h2] = HALFEDGE_NONE;
    if (g == HALFEDGE_NONE) return true;
    g2 = halve(s, g, m); /* g = bm, g2 = ma */
    join(s, h, g2);
    join(s, h2, g);
    return true;
}

bool plane_map_split(struct plane_map *p, double max_area, size_t max_triangles, int digits,
                     struct err *err) {
    struct splitter s = {.p = p,
                         .at_cap = {p->vertex_count, p->vertex_count},
                         .triangle_cap = p->triangle_count,
                         .twin_cap = 3 * p->triangle_count,
                         .max_triangles = max_triangles,
                         .digits = digits};
    bool ok = halfedge_twins(&s.twin, triangles(&s), p->triangle_count, err);
    for (uint32_t t = 0; ok && t < p->triangle_count; t++) {
        bool done = true;
        while (ok && done && area(p, t) > max_area) ok = split(&s, end_of_path(&s, t), &done, err);
    }
    free(s.twin);
    return ok;
}
