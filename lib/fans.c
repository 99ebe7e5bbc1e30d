/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Let a direction be high if its angle a is in [0,180), else low. Since a sector is less than 180
 * degrees wide, it holds the direction of the x axis, which is the first high one, exactly if e_i
 * is low and e_i+1 is high. With n such sectors the angles add up to 360 n + a_m - a_0, which is
 * 360 (n - 1) and something if a_m < a_0, else 360 n and something. */
#include "fans.h"

/* The edge corner next to corner `at` of triangle t, towards corner `to`. */
static const double *edge_corner(const struct spline *s, uint32_t t, int at, int to) {
    int weight[3] = {0};
    weight[at] = s->grid.degree - 1;
    weight[to] += 1;
    return s->phi[grid_point(&s->grid, t, weight[0], weight[1], weight[2])];
}

static bool is_high(const double apex[2], const double q[2]) {
    return q[1] > apex[1] || (q[1] == apex[1] && q[0] > apex[0]);
}

/* The sign of a_m - a_0. */
static int compare_angles(const double apex[2], const double e0[2], const double em[2]) {
    if (is_high(apex, e0) != is_high(apex, em)) return is_high(apex, e0) ? 1 : -1;
    return predicate_orient(apex, e0, em);
}

enum fan_kind fan_of_vertex(const struct spline *s, uint32_t v, uint32_t *turns) {
    const struct grid *g = &s->grid;
    const double *apex = s->phi[v], *first = NULL, *to = NULL;
    int side;
    *turns = 0;
    for (uint32_t f = g->fan_start[v]; f < g->fan_start[v + 1]; f++) {
        uint32_t t = g->fan[f];
        int l = grid_corner(g, t, v);
        const double *from = edge_corner(s, t, l, (l + 1) % 3);
        to = edge_corner(s, t, l, (l + 2) % 3);
        if (predicate_orient(apex, from, to) <= 0) return FAN_UNKNOWN;
        if (!first) first = from;
        *turns += !is_high(apex, from) && is_high(apex, to);
    }
    if (to == first) return *turns == 1 ? FAN_SOUND : FAN_COVERS;
    side = compare_angles(apex, first, to);
    *turns -= side < 0;
    return *turns == 0 ? FAN_SOUND : *turns == 1 && side == 0 ? FAN_CLOSES : FAN_COVERS;
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
