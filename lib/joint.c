/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signs come from the rounded places where these, and their distance to what is meant, decide;
 * else from rationals, which are kept for each vertex that is loose. */
#include "joint.h"

#include "halfedge.h"
#include "mem.h"
#include "predicate.h"

#include <math.h>
#include <string.h>

struct joint_places {
    bool known;
    mpq_t p[2];
};

static uint32_t apex_corner(uint32_t halfedge) { /* of the vertex that it begins at */
    return halfedge_next(halfedge);
}

static bool build(struct joint *j, struct err *err) {
    size_t n = j->map.vertex_count;
    if (!mem_new(j->corner, n, err) || !mem_new(j->fixed, n, err) || !mem_new(j->settled, n, err) ||
        !mem_new(j->exact[0], n, err) || !mem_new(j->exact[1], n, err) ||
        !halfedge_twins(&j->twin, (const uint32_t(*)[3])j->map.triangle, j->map.triangle_count,
                        err))
        return false;
    for (size_t v = 0; v < n; v++) j->corner[v] = JOINT_NONE;
    for (size_t t = 0; t < j->map.triangle_count; t++)
        for (uint32_t c = 0; c < 3; c++) j->corner[j->map.triangle[t][c]] = 3 * (uint32_t)t + c;
    return true;
}

bool joint_init(struct joint *j, struct plane_map *map, const struct joint_meaning *meaning,
                struct err *err) {
    *j = (struct joint){.map = *map, .meaning = meaning};
    *map = (struct plane_map){0};
    return build(j, err);
}

void joint_forget(struct joint *j) {
    for (int m = 0; m < 2; m++)
        for (size_t v = 0; j->exact[m] && v < j->map.vertex_count; v++) {
            struct joint_places *e = &j->exact[m][v];
            if (e->known) mpq_clears(e->p[0], e->p[1], NULL);
            e->known = false;
        }
}

void joint_free(struct joint *j) {
    joint_forget(j);
    for (int m = 0; m < 2; m++) {
        free(j->exact[m]);
        free(j->wish[m]);
    }
    free(j->twin);
    free(j->corner);
    free(j->fixed);
    free(j->settled);
    plane_map_free(&j->map);
    *j = (struct joint){0};
}

/* ---- signs ---- */

static bool is_rounded(const struct joint *j, uint32_t v) {
    return j->meaning && !j->settled[v];
}

/* Sets p to the place of v as it is now. */
static void exact_place(struct joint *j, int plane, uint32_t v, mpq_t p[2]) {
    struct joint_places *e = &j->exact[plane][v];
    const double *at = joint_place(j, plane, v);
    if (!is_rounded(j, v)) {
        for (int c = 0; c < 2; c++) mpq_set_d(p[c], at[c]);
        return;
    }
    if (!e->known) {
        mpq_inits(e->p[0], e->p[1], NULL);
        e->known = true;
        j->meaning->exact(j->meaning->context, v, plane, e->p);
    }
    for (int c = 0; c < 2; c++) mpq_set(p[c], e->p[c]);
}

static int exact_orient(struct joint *j, int plane, uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t vertex[3] = {a, b, c};
    mpq_t p[3][2];
    int sign;
    for (int i = 0; i < 3; i++) {
        mpq_inits(p[i][0], p[i][1], NULL);
        exact_place(j, plane, vertex[i], p[i]);
    }
    for (int i = 1; i < 3; i++)
        for (int k = 0; k < 2; k++) mpq_sub(p[i][k], p[i][k], p[0][k]);
    mpq_mul(p[1][0], p[1][0], p[2][1]);
    mpq_mul(p[1][1], p[1][1], p[2][0]);
    sign = mpq_cmp(p[1][0], p[1][1]);
    for (int i = 0; i < 3; i++) mpq_clears(p[i][0], p[i][1], NULL);
    return (sign > 0) - (sign < 0);
}

/* Each coordinate may be off by e, so each difference by 2e. */
int joint_orient(struct joint *j, int plane, uint32_t a, uint32_t b, uint32_t c) {
    const double *p = joint_place(j, plane, a), *q = joint_place(j, plane, b),
                 *r = joint_place(j, plane, c);
    double qx = q[0] - p[0], qy = q[1] - p[1], rx = r[0] - p[0], ry = r[1] - p[1];
    double e, det, bound;
    if (!is_rounded(j, a) && !is_rounded(j, b) && !is_rounded(j, c))
        return predicate_orient(p, q, r);
    e = j->meaning->error[plane];
    det = qx * ry - qy * rx;
    bound = 0x1p-50 * (fabs(qx * ry) + fabs(qy * rx)) +
            2.1 * e * (fabs(qx) + fabs(qy) + fabs(rx) + fabs(ry) + 4 * e) + 0x1p-1000;
    if (det > bound) return 1;
    if (det < -bound) return -1;
    return exact_orient(j, plane, a, b, c);
}

bool joint_is_sound(struct joint *j, uint32_t t) {
    const uint32_t *v = j->map.triangle[t];
    return joint_orient(j, 0, v[0], v[1], v[2]) > 0 && joint_orient(j, 1, v[0], v[1], v[2]) > 0;
}

/* ---- stars ---- */

/* The same vertex's corner in the next triangle counter-clockwise (clockwise), or NONE. */
static uint32_t turn(const struct joint *j, uint32_t corner, bool clockwise) {
    uint32_t twin = j->twin[clockwise ? halfedge_prev(corner) : halfedge_next(corner)];
    if (twin == HALFEDGE_NONE) return JOINT_NONE;
    return clockwise ? halfedge_prev(twin) : apex_corner(twin);
}

bool joint_star(const struct joint *j, uint32_t v, struct joint_star *star, struct err *err) {
    uint32_t first = j->corner[v], back = first;
    star->count = 0;
    do {
        first = back;
        back = turn(j, first, true);
    } while (back != JOINT_NONE && back != j->corner[v]);
    star->boundary = back == JOINT_NONE;
    if (!star->boundary) first = j->corner[v];
    for (uint32_t at = first; at != JOINT_NONE; at = turn(j, at, false)) {
        if (at == first && star->count > 0) break;
        if (!mem_grow(star->corner, &star->cap, star->count + 1, err)) return false;
        star->corner[star->count++] = at;
    }
    return true;
}

/* ---- the end ---- */

bool joint_finish(struct joint *j, struct plane_map *map, struct err *err) {
    size_t vertices = 0, triangles = 0;
    uint32_t *number;
    if (!mem_new(number, j->map.vertex_count, err)) return false;
    joint_forget(j);
    *map = j->map;
    j->map = (struct plane_map){0};
    for (size_t v = 0; v < map->vertex_count; v++) {
        if (j->corner[v] == JOINT_NONE) continue;
        number[v] = (uint32_t)vertices;
        for (int m = 0; m < 2; m++)
            memmove(map->at[m][vertices], map->at[m][v], sizeof *map->at[m]);
        vertices++;
    }
    for (size_t t = 0; t < map->triangle_count; t++) {
        if (map->triangle[t][0] == JOINT_NONE) continue;
        for (int c = 0; c < 3; c++) map->triangle[triangles][c] = number[map->triangle[t][c]];
        triangles++;
    }
    map->vertex_count = vertices;
    map->triangle_count = triangles;
    free(number);
    return true;
}
