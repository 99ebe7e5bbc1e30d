/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The neighbours of a vertex v, counter-clockwise, are the polygon 0 .. n-1 that remains when v is
 * gone; for a vertex on the boundary, the edge from n-1 to 0 is the new boundary.
 *
 *          3_______2                   Triangulations of the chain i..j, closed by the edge ji, are
 *          / \   / \                   a triangle i k j and triangulations of the chains i..k,
 * k..j. 4/___\v/___\1                 Of those with sound triangles only, the best one has the
 *         \   / \   /                  roundest worst triangle (dynamic programming; Klincsek
 * 1980). \ /   \ /                   A polygon that is simple and filled with counter-clockwise
 *          5-------0                   triangles is covered once, so nothing else need be tested.
 */
#include "joint.h"

#include "halfedge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NEAR                                                                                       \
    0x1p-10 /* of the furthest neighbour's distance: so close that another may stand in            \
             */

#define ROUND 0.02 /* round enough; an equilateral triangle has 0.29 */

enum { POLYGON_MAX = JOINT_STAR_MAX + 1 };

struct hole {
    struct joint *j;
    double max_area, floor; /* of new triangles: their area in the source, their roundness */
    int n;
    uint32_t vertex[POLYGON_MAX];
    uint32_t outer[POLYGON_MAX];   /* half edge beyond the edge from i to i+1, or NONE */
    uint32_t free[JOINT_STAR_MAX]; /* triangles that may be used */
    int free_count;
    double worst[POLYGON_MAX][POLYGON_MAX]; /* roundness of the worst triangle of i..j */
    uint8_t apex[POLYGON_MAX][POLYGON_MAX];
};

static double length2(const double a[2], const double b[2]) {
    return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

static double area(const struct joint *j, uint32_t a, uint32_t b, uint32_t c) {
    const double *p = joint_place(j, 0, a), *q = joint_place(j, 0, b), *r = joint_place(j, 0, c);
    return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
}

/* The lesser roundness of both planes; -1: the triangle is not sound, or not rounder than that. */
static double judge(struct hole *h, int i, int k, int j, double floor) {
    uint32_t a = h->vertex[i], b = h->vertex[k], c = h->vertex[j];
    double least = INFINITY;
    if (area(h->j, a, b, c) > h->max_area) return -1;
    for (int m = 0; m < 2; m++)
        least = fmin(least, plane_map_roundness(joint_place(h->j, m, a), joint_place(h->j, m, b),
                                                joint_place(h->j, m, c)));
    if (least <= floor || least < h->floor) return -1;
    for (int m = 0; m < 2; m++)
        if (joint_orient(h->j, m, a, b, c) <= 0) return -1;
    return least;
}

static void choose_apex(struct hole *h, int i, int j) {
    double best = -1;
    for (int k = i + 1; k < j; k++) {
        double chains = fmin(h->worst[i][k], h->worst[k][j]), worst;
        if (chains <= best) continue;
        worst = fmin(chains, judge(h, i, k, j, best));
        if (worst <= best) continue;
        best = worst;
        h->apex[i][j] = (uint8_t)k;
    }
    h->worst[i][j] = best;
}

static bool can_be_filled(struct hole *h) {
    for (int i = 0; i + 1 < h->n; i++) h->worst[i][i + 1] = INFINITY;
    for (int span = 2; span < h->n; span++)
        for (int i = 0; i + span < h->n; i++) choose_apex(h, i, i + span);
    return h->worst[0][h->n - 1] >= 0;
}

/* How far neighbour i is from v, compared to the neighbour that is furthest; in the worse plane. */
static double distance(const struct hole *h, uint32_t v, int i) {
    double most = 0;
    for (int m = 0; m < 2; m++) {
        double own = 0, furthest = 0;
        for (int k = 0; k < h->n; k++) {
            double d = length2(joint_place(h->j, m, v), joint_place(h->j, m, h->vertex[k]));
            furthest = fmax(furthest, d);
            if (k == i) own = d;
        }
        most = fmax(most, own > 0 ? own / furthest : 0);
    }
    return sqrt(most);
}

/* Can all triangles be given to neighbour w? */
static bool can_be_fanned(struct hole *h, int w) {
    for (int i = 0; i + 1 < w; i++) {
        if (judge(h, i, i + 1, w, -1) < 0) return false;
        h->apex[i][w] = (uint8_t)(i + 1);
    }
    for (int i = w + 2; i < h->n; i++) {
        if (judge(h, w, i - 1, i, -1) < 0) return false;
        h->apex[w][i] = (uint8_t)(i - 1);
    }
    if (w == 0 || w == h->n - 1) return true;
    h->apex[0][h->n - 1] = (uint8_t)w;
    return judge(h, 0, w, h->n - 1, -1) >= 0;
}

static bool can_be_collapsed(struct hole *h, uint32_t v) {
    double least = NEAR;
    int nearest = -1;
    for (int i = 0; i < h->n; i++) {
        double d = distance(h, v, i);
        if (d >= least) continue;
        least = d;
        nearest = i;
    }
    return nearest >= 0 && can_be_fanned(h, nearest);
}

static void join(struct hole *h, uint32_t a, uint32_t b) {
    if (a != HALFEDGE_NONE) h->j->twin[a] = b;
    if (b != HALFEDGE_NONE) h->j->twin[b] = a;
}

/* Fills the chain i..j; returns the half edge that runs from j to i. For a chain of one edge that
 * is the half edge beyond it. */
static uint32_t fill(struct hole *h, int i, int j) {
    int k = h->apex[i][j];
    uint32_t t, *corner;
    if (j == i + 1) return h->outer[i];
    t = h->free[--h->free_count];
    corner = h->j->map.triangle[t];
    corner[0] = h->vertex[i];
    corner[1] = h->vertex[k];
    corner[2] = h->vertex[j];
    for (uint32_t c = 0; c < 3; c++) h->j->corner[corner[c]] = 3 * t + c;
    join(h, 3 * t + 2, fill(h, i, k));
    join(h, 3 * t, fill(h, k, j));
    return 3 * t + 1;
}

static void open_star(struct hole *h, const struct joint_star *star) {
    const uint32_t(*triangle)[3] = (const uint32_t(*)[3])h->j->map.triangle;
    for (size_t i = 0; i < star->count; i++) {
        uint32_t at = star->corner[i];
        h->vertex[i] = halfedge_from(triangle, at);
        h->outer[i] = h->j->twin[at];
        h->free[i] = at / 3;
    }
    h->n = h->free_count = (int)star->count;
    if (!star->boundary) return;
    h->vertex[h->n] = halfedge_to(triangle, star->corner[star->count - 1]);
    h->outer[h->n++] = HALFEDGE_NONE;
}

/* Takes v away, whose star is given; false if that cannot be. */
static bool try_to_remove(struct hole *h, uint32_t v, const struct joint_star *star) {
    struct joint *j = h->j;
    if (star->count > JOINT_STAR_MAX) return false;
    open_star(h, star);
    if (h->n < 3 || !(can_be_collapsed(h, v) || can_be_filled(h))) return false;
    join(h, fill(h, 0, h->n - 1), h->outer[h->n - 1]);
    while (h->free_count > 0)
        memset(j->map.triangle[h->free[--h->free_count]], 0xff, sizeof *j->map.triangle);
    j->corner[v] = JOINT_NONE;
    return true;
}

bool joint_remove(struct joint *j, uint32_t v, struct joint_star *star, bool *done,
                  struct err *err) {
    struct hole h; /* large: not to be zeroed each time */
    h.j = j;
    h.max_area = INFINITY;
    h.floor = 0;
    if (!joint_star(j, v, star, err)) return false;
    *done = try_to_remove(&h, v, star);
    return true;
}

/* The largest area in the source and the least roundness of the triangles around v. */
static void measure(const struct joint *j, const struct joint_star *star, double *most,
                    double *least) {
    *most = 0;
    *least = INFINITY;
    for (size_t i = 0; i < star->count; i++) {
        const uint32_t *t = j->map.triangle[star->corner[i] / 3];
        *most = fmax(*most, area(j, t[0], t[1], t[2]));
        for (int m = 0; m < 2; m++)
            *least =
                fmin(*least, plane_map_roundness(joint_place(j, m, t[0]), joint_place(j, m, t[1]),
                                                 joint_place(j, m, t[2])));
    }
}

bool joint_thin(struct joint *j, double max_area, struct err *err) {
    struct joint_star star = {0};
    struct hole h;
    bool ok = true, progress = true;
    h.j = j;
    h.max_area = max_area;
    while (ok && progress) {
        progress = false;
        for (uint32_t v = (uint32_t)j->map.vertex_count; ok && v-- > 0;) {
            double most;
            if (j->fixed[v] || j->corner[v] == JOINT_NONE) continue;
            ok = joint_star(j, v, &star, err);
            if (!ok) break;
            measure(j, &star, &most, &h.floor);
            h.floor = fmin(h.floor, ROUND);
            if (most <= max_area && try_to_remove(&h, v, &star)) progress = true;
        }
    }
    free(star.corner);
    return ok;
}

bool joint_mend(struct joint *j, size_t *left, struct err *err) {
    struct joint_star star = {0};
    bool ok = true, progress = true;
    while (ok && progress) {
        progress = false;
        *left = 0;
        for (uint32_t t = 0; ok && t < j->map.triangle_count; t++) {
            uint32_t corner[3];
            bool done = false;
            memcpy(corner, j->map.triangle[t], sizeof corner);
            if (corner[0] == JOINT_NONE || joint_is_sound(j, t)) continue;
            for (int c = 0; ok && c < 3 && !done; c++)
                if (!j->fixed[corner[c]]) ok = joint_remove(j, corner[c], &star, &done, err);
            progress = progress || done;
            *left += !done;
        }
    }
    free(star.corner);
    return ok;
}
