/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Why that proves it: see embed.h. */
#include "plane_map.h"

#include "halfedge.h"
#include "mem.h"
#include "predicate.h"
#include "sides.h"

#include <string.h>

void plane_map_free(struct plane_map *p) {
    free(p->at[0]);
    free(p->at[1]);
    free(p->triangle);
    *p = (struct plane_map){0};
}

static double length2(const double a[2], const double b[2]) {
    return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

double plane_map_roundness(const double a[2], const double b[2], const double c[2]) {
    double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return area > 0 ? area / (length2(a, b) + length2(b, c) + length2(c, a)) : 0;
}

size_t plane_map_flipped(const struct plane_map *p, int plane, size_t from) {
    const double(*at)[2] = (const double(*)[2])p->at[plane];
    while (from < p->triangle_count) {
        const uint32_t *v = p->triangle[from];
        if (predicate_orient(at[v[0]], at[v[1]], at[v[2]]) <= 0) break;
        from++;
    }
    return from;
}

/* The edges of the boundary, between vertices that are numbered anew. */
struct boundary {
    uint32_t *number;
    uint32_t (*side)[2];
    double (*point[2])[2];
    size_t side_count, point_count;
};

static uint32_t number_of(struct boundary *b, const struct plane_map *p, uint32_t v) {
    if (b->number[v] == HALFEDGE_NONE) {
        b->number[v] = (uint32_t)b->point_count;
        for (int m = 0; m < 2; m++)
            memcpy(b->point[m][b->point_count], p->at[m][v], sizeof *b->point[m]);
        b->point_count++;
    }
    return b->number[v];
}

static bool find_boundary(struct boundary *b, const struct plane_map *p, struct err *err) {
    const uint32_t(*triangle)[3] = (const uint32_t(*)[3])p->triangle;
    uint32_t *twin;
    bool ok = halfedge_twins(&twin, triangle, p->triangle_count, err);
    for (size_t h = 0; ok && h < 3 * p->triangle_count; h++)
        b->side_count += twin[h] == HALFEDGE_NONE;
    ok = ok && mem_new(b->number, p->vertex_count, err) && mem_new(b->side, b->side_count, err);
    for (int m = 0; ok && m < 2; m++) ok = mem_new(b->point[m], b->side_count, err);
    if (ok) memset(b->number, 0xff, p->vertex_count * sizeof *b->number);
    b->side_count = 0;
    for (uint32_t h = 0; ok && h < 3 * p->triangle_count; h++) {
        if (twin[h] != HALFEDGE_NONE) continue;
        b->side[b->side_count][0] = number_of(b, p, halfedge_from(triangle, h));
        b->side[b->side_count++][1] = number_of(b, p, halfedge_to(triangle, h));
    }
    free(twin);
    return ok;
}

static bool prove_boundary(const struct boundary *b, int plane, struct err *err) {
    const struct shim_cgal_sides sides = {(const double(*)[2])b->point[plane], b->point_count,
                                          (const uint32_t(*)[2])b->side, b->side_count};
    struct sides_fault fault;
    char text[SIDES_TEXT_MAX];
    if (!sides_check(&sides, &fault, err)) return false;
    if (fault.trouble == SIDES_SOUND) return true;
    sides_describe(&fault, &sides, sides.point, text);
    return err_set(err, ERR_REFUSAL,
                   "precision: the boundary of the %s, as rounded, meets itself: %s",
                   plane == 0 ? "source" : "target", text);
}

bool plane_map_prove(const struct plane_map *p, struct err *err) {
    struct boundary b = {0};
    bool ok = true;
    for (int m = 0; ok && m < 2; m++) {
        size_t t = plane_map_flipped(p, m, 0);
        if (t == p->triangle_count) continue;
        const double *at = p->at[m][p->triangle[t][0]];
        ok = err_set(err, ERR_REFUSAL,
                     "precision: the triangle at (%.9g, %.9g) of the %s is turned over", at[0],
                     at[1], m == 0 ? "source" : "target");
    }
    ok =
        ok && find_boundary(&b, p, err) && prove_boundary(&b, 0, err) && prove_boundary(&b, 1, err);
    free(b.number);
    free(b.side);
    free(b.point[0]);
    free(b.point[1]);
    return ok;
}
