/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fans.h"

/* The edge corner next to corner `at` of triangle t, towards corner `to`. */
static const double *edge_corner(const struct spline *s, uint32_t t, int at, int to) {
    int weight[3] = {0};
    weight[at] = s->grid.degree - 1;
    weight[to] += 1;
    return s->phi[grid_point(&s->grid, t, weight[0], weight[1], weight[2])];
}

enum fan_kind fan_of_vertex(const struct spline *s, uint32_t v, uint32_t *turns) {
    const struct grid *g = &s->grid;
    uint32_t begin = g->fan_start[v], end = g->fan_start[v + 1];
    const double *apex = s->phi[v], *first = NULL, *next = NULL;
    bool closes = false;
    *turns = 0;
    for (uint32_t f = begin; f < end; f++) {
        uint32_t t = g->fan[f];
        int l = grid_corner(g, t, v);
        const double *from = edge_corner(s, t, l, (l + 1) % 3);
        next = edge_corner(s, t, l, (l + 2) % 3);
        if (predicate_orient(apex, from, next) <= 0) return FAN_UNKNOWN;
        if (f == begin) {
            first = from;
            continue;
        }
        if (predicate_orient(apex, from, first) > 0) {
            int side = predicate_orient(apex, first, next);
            *turns += side >= 0;
            closes = side == 0;
        } else
            closes = false;
    }
    if (next == first) return *turns == 1 ? FAN_SOUND : FAN_COVERS;
    return *turns == 0 ? FAN_SOUND : *turns == 1 && closes ? FAN_CLOSES : FAN_COVERS;
}

uint32_t fans_worst(const struct spline *s, enum fan_kind *kind, uint32_t *turns) {
    static const int rank[] = {
        [FAN_SOUND] = 0, [FAN_UNKNOWN] = 1, [FAN_CLOSES] = 2, [FAN_COVERS] = 3};
    uint32_t worst = GRID_NONE;
    *kind = FAN_SOUND;
    *turns = 0;
    for (uint32_t v = 0; v < s->grid.vertex_count; v++) {
        uint32_t n;
        enum fan_kind k = fan_of_vertex(s, v, &n);
        if (rank[k] <= rank[*kind]) continue;
        *kind = k;
        *turns = n;
        worst = v;
    }
    return worst;
}
