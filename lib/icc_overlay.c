/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An edge of the rim is cut at p into ap, pb, and so is its triangle abo:
 *
 *            o                      The edge bo may be on the rim as well: it is the new triangle's
 *           /|\                     then.
 *          / | \
 *         a--p--b */
#include "icc_overlay.h"

#include "mem.h"
#include "overlay_map.h"
#include "predicate.h"

#include <string.h>

#define SLACK_MAX  1e6 /* tries with ever more thinning, see joint_settle */
#define SLACK_MORE 30

/* A mesh cut at the other's rim vertices. */
struct cut {
    const struct icc_ray *own, *other;
    size_t vertex_count, triangle_count;
    double (*x)[2], (*u)[2]; /* of the vertices, in the cage and in the disk */
    uint32_t (*triangle)[3];
    uint32_t *rim; /* of the rim edge that begins at a rim vertex: its triangle */
};

static uint32_t parts(const struct icc_mesh *m, uint32_t side) {
    return m->start[side + 1] - m->start[side];
}

static uint32_t next_on_rim(const struct icc_mesh *m, uint32_t v) {
    return v + 1 < m->rim_count ? v + 1 : 0;
}

static bool copy_mesh(struct cut *c, struct err *err) {
    const struct icc_mesh *m = &c->own->mesh;
    const struct mesh *mesh = &m->mesh;
    size_t more = c->other->mesh.rim_count; /* vertices and triangles, at most */
    if (!mem_new(c->x, mesh->vertex_count + more, err) ||
        !mem_new(c->u, mesh->vertex_count + more, err) ||
        !mem_new(c->triangle, mesh->triangle_count + more, err) ||
        !mem_new(c->rim, m->rim_count, err))
        return false;
    c->vertex_count = mesh->vertex_count;
    c->triangle_count = mesh->triangle_count;
    memcpy(c->x, mesh->vertex, mesh->vertex_count * sizeof *c->x);
    memcpy(c->u, c->own->image, mesh->vertex_count * sizeof *c->u);
    memcpy(c->triangle, mesh->triangle, mesh->triangle_count * sizeof *c->triangle);
    for (uint32_t t = 0; t < mesh->triangle_count; t++)
        for (int e = 0; e < 3; e++)
            if (mesh->across[t][e] == MESH_NONE) c->rim[mesh->triangle[t][(e + 1) % 3]] = t;
    return true;
}

/* Cuts edge ab of triangle t at the new vertex p; returns the triangle of pb. */
static uint32_t cut_triangle(struct cut *c, uint32_t t, uint32_t a, uint32_t b, uint32_t p) {
    uint32_t *corner = c->triangle[t], *more = c->triangle[c->triangle_count];
    int at = corner[0] == a ? 0 : corner[1] == a ? 1 : 2;
    uint32_t o = corner[(at + 2) % 3];
    INVARIANT(corner[at] == a && corner[(at + 1) % 3] == b);
    more[0] = p;
    more[1] = b;
    more[2] = o;
    corner[(at + 1) % 3] = p;
    if (b < c->own->mesh.rim_count && o == next_on_rim(&c->own->mesh, b))
        c->rim[b] = (uint32_t)c->triangle_count;
    return (uint32_t)c->triangle_count++;
}

/* Cuts side k where the other has a vertex: at j / n between i / m and (i + 1) / m. */
static void cut_side(struct cut *c, uint32_t k) {
    const struct icc_mesh *own = &c->own->mesh, *other = &c->other->mesh;
    uint64_t m = parts(own, k), n = parts(other, k), j = 1;
    for (uint64_t i = 0; i < m; i++) {
        uint32_t a = own->start[k] + (uint32_t)i, b = next_on_rim(own, a), t = c->rim[a];
        for (; j < n && j * m <= (i + 1) * n; j++) {
            uint32_t p = (uint32_t)c->vertex_count;
            double lambda = icc_mesh_lambda(other, k, other->start[k] + (uint32_t)j);
            if (j * m == (i + 1) * n) continue;
            cage_point(c->own->cage, k, lambda, c->x[p]);
            icc_disk_point(&c->own->disk, k, lambda, c->u[p]);
            t = cut_triangle(c, t, a, b, p);
            a = p;
            c->vertex_count++;
        }
    }
}

static bool check_triangles(const struct cut *c, struct err *err) {
    for (size_t t = 0; t < c->triangle_count; t++) {
        const uint32_t *v = c->triangle[t];
        if (predicate_orient(c->x[v[0]], c->x[v[1]], c->x[v[2]]) > 0 &&
            predicate_orient(c->u[v[0]], c->u[v[1]], c->u[v[2]]) > 0)
            continue;
        return err_set(err, ERR_REFUSAL,
                       "precision: the cage is too narrow near (%.9g, %.9g) for doubles",
                       c->x[v[0]][0], c->x[v[0]][1]);
    }
    return true;
}

static bool cut_mesh(struct cut *c, struct err *err) {
    if (!copy_mesh(c, err)) return false;
    for (uint32_t k = 0; k < c->own->mesh.side_count; k++) cut_side(c, k);
    return check_triangles(c, err);
}

static void cut_free(struct cut *c) {
    free(c->x);
    free(c->u);
    free(c->triangle);
    free(c->rim);
}

/* The vertices of the cages. */
static bool fix_corners(struct joint *j, const struct overlay *o, const struct icc_mesh *m,
                        struct err *err) {
    bool *corner;
    if (!mem_new(corner, m->rim_count, err)) return false;
    for (size_t k = 0; k < m->side_count; k++) corner[m->start[k]] = true;
    for (size_t v = 0; v < o->vertex_count; v++)
        j->fixed[v] = o->vertex[v].kind == OVERLAY_BOTH && o->vertex[v].in[0] < m->rim_count &&
                      corner[o->vertex[v].in[0]];
    free(corner);
    return true;
}

/* What is wanted of the map. */
struct wish {
    double max_area;
    int digits;
};

static bool try_to_round(struct overlay_map *m, const struct icc_mesh *source,
                         const struct wish *wish, double slack, struct plane_map *map,
                         struct err *err) {
    struct joint j = {0};
    *map = (struct plane_map){0};
    bool ok = overlay_map(m, map, err) && joint_init(&j, map, &m->meaning, err) &&
              fix_corners(&j, m->overlay, source, err) &&
              joint_settle(&j, (int[2]){0, wish->digits}, slack, err) &&
              (wish->max_area == 0 || joint_thin(&j, wish->max_area, err)) &&
              joint_finish(&j, map, err);
    joint_free(&j);
    if (!ok) plane_map_free(map);
    return ok;
}

static bool round_map(const struct overlay *o, const struct overlay_mesh mesh[2],
                      const struct cut cut[2], const struct wish *wish, struct plane_map *map,
                      struct err *err) {
    struct overlay_map m = {.overlay = o,
                            .mesh = mesh,
                            .x = {(const double(*)[2])cut[0].x, (const double(*)[2])cut[1].x}};
    bool ok = false;
    for (double slack = JOINT_SLACK; !ok && slack < SLACK_MAX; slack *= SLACK_MORE) {
        struct err why = {0};
        ok = try_to_round(&m, &cut[0].own->mesh, wish, slack, map, &why);
        if (!ok) *err = why;
        if (!ok && why.kind != ERR_REFUSAL) return false;
    }
    return ok;
}

bool icc_overlay(struct plane_map *map, const struct icc_ray *source, const struct icc_ray *target,
                 double max_area, int digits, struct err *err) {
    struct cut cut[2] = {{.own = source, .other = target}, {.own = target, .other = source}};
    const struct wish wish = {max_area, digits};
    struct overlay_mesh mesh[2];
    struct overlay o = {0};
    *map = (struct plane_map){0};
    bool ok = cut_mesh(&cut[0], err) && cut_mesh(&cut[1], err);
    for (int m = 0; ok && m < 2; m++)
        mesh[m] = (struct overlay_mesh){cut[m].vertex_count, cut[m].triangle_count,
                                        (const double(*)[2])cut[m].u,
                                        (const uint32_t(*)[3])cut[m].triangle};
    ok = ok && overlay_build(&o, mesh, err) && round_map(&o, mesh, cut, &wish, map, err);
    ok = ok && (max_area == 0 || plane_map_split(map, max_area, ICC_OVERLAY_MAX, digits, err));
    if (!ok) plane_map_free(map);
    overlay_free(&o);
    for (int m = 0; m < 2; m++) cut_free(&cut[m]);
    return ok;
}
