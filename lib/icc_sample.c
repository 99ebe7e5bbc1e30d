/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points are added at the centroids of triangles that are turned over, and the constrained Delaunay
 * triangulation of all is made anew. Vertices keep their numbers, so only new ones are mapped:
 *
 *     corners of the cage, Steiner points of the refinement, points added in round 1, 2, ... */
#include "icc_sample.h"

#include "halfedge.h"
#include "mem.h"
#include "segment.h"
#include "shim_cgal.h"

#include <string.h>

#define SINE2_MIN 0.11697777844051098 /* of 20 degrees, squared */

enum { ROUNDS = 3 };
#define PATIENCE 10 /* how many times more triangles than they deserve narrow parts may take */

struct sampler {
    const struct icc_sampled *what;
    struct icc_sample_report *report;
    struct plane_map map;
    size_t mapped;       /* vertices */
    uint32_t (*side)[2]; /* the edges of the boundary */
    size_t side_count;
};

static bool refuse(struct sampler *s, enum shim_cgal_status status, double max_area, size_t most,
                   struct err *err) {
    if (status == SHIM_CGAL_MEMORY) return err_memory(err);
    s->report->too_many =
        status == SHIM_CGAL_LIMIT && s->what->source->area > ICC_SAMPLE_MAX / 4.0 * max_area;
    if (status == SHIM_CGAL_LIMIT)
        return err_set(err, ERR_REFUSAL,
                       "an area of %.9g takes more than %zu triangles, which is the most", max_area,
                       most);
    return err_set(err, ERR_REFUSAL,
                   "precision: the cage cannot be triangulated to an area of %.9g", max_area);
}

/* Triangulates points between sides and takes the result. */
static bool triangulate(struct sampler *s, const double (*point)[2], size_t count, double max_area,
                        struct err *err) {
    const struct shim_cgal_sides sides = {point, count, (const uint32_t(*)[2])s->side,
                                          s->side_count};
    const struct cage *source = s->what->source;
    struct shim_cgal_criteria criteria = {false, max_area, SINE2_MIN, 0};
    struct shim_cgal_mesh mesh;
    struct shim_cgal_report report;
    double limit = 8 * source->area / max_area + 100 * (double)source->count + 1000;
    criteria.max_triangles = limit < ICC_SAMPLE_MAX ? (size_t)limit : ICC_SAMPLE_MAX;
    bool ok = shim_cgal_domain(&sides, s->mapped == 0 ? &criteria : NULL, &mesh, &report);
    if (!ok && report.status == SHIM_CGAL_LIMIT && limit < ICC_SAMPLE_MAX) {
        criteria.sine2 = 0;
        criteria.max_triangles =
            PATIENCE * limit < ICC_SAMPLE_MAX ? (size_t)(PATIENCE * limit) : ICC_SAMPLE_MAX;
        ok = shim_cgal_domain(&sides, &criteria, &mesh, &report);
    }
    if (!ok) return refuse(s, report.status, max_area, criteria.max_triangles, err);
    free(s->map.at[0]);
    free(s->map.triangle);
    s->map.at[0] = mesh.vertex;
    s->map.triangle = mesh.triangle;
    s->map.triangle_count = mesh.triangle_count;
    s->map.vertex_count = mesh.vertex_count;
    return true;
}

static bool cage_sides(struct sampler *s, struct err *err) {
    s->side_count = s->what->source->count;
    if (!mem_new(s->side, s->side_count, err)) return false;
    for (uint32_t k = 0; k < s->side_count; k++) {
        s->side[k][0] = k;
        s->side[k][1] = cage_next(s->what->source, k);
    }
    return true;
}

/* The boundary's edges, as sides; next[v]: the vertex after v on it. */
static bool find_boundary(struct sampler *s, uint32_t *next, struct err *err) {
    const uint32_t(*triangle)[3] = (const uint32_t(*)[3])s->map.triangle;
    size_t n = s->map.triangle_count;
    uint32_t *twin;
    if (!halfedge_twins(&twin, triangle, n, err)) return false;
    s->side_count = 0;
    for (uint32_t h = 0; h < 3 * n; h++) s->side_count += twin[h] == HALFEDGE_NONE;
    free(s->side);
    bool ok = mem_new(s->side, s->side_count, err);
    s->side_count = 0;
    for (uint32_t h = 0; ok && h < 3 * n; h++) {
        uint32_t from = halfedge_from(triangle, h), to = halfedge_to(triangle, h);
        if (twin[h] != HALFEDGE_NONE) continue;
        s->side[s->side_count][0] = from;
        s->side[s->side_count++][1] = to;
        next[from] = to;
    }
    free(twin);
    return ok;
}

/* Vertices on the boundary, side by side, from corner to corner of the cage. */
static bool map_boundary(struct sampler *s, bool *on_boundary, struct err *err) {
    const struct cage *source = s->what->source, *target = s->what->target;
    uint32_t *next;
    bool ok = mem_new(next, s->map.vertex_count, err) && find_boundary(s, next, err);
    for (uint32_t k = 0; ok && k < source->count; k++) {
        uint32_t v = k, end = cage_next(source, k);
        double lambda = 0;
        do {
            cage_point(target, k, lambda, s->map.at[1][v]);
            on_boundary[v] = true;
            v = next[v];
            segment_distance2(source->vertex[k], source->vertex[end], s->map.at[0][v], &lambda);
        } while (v != end);
    }
    free(next);
    return ok;
}

/* The new vertices that are not on the boundary. */
static bool map_inside(struct sampler *s, const bool *on_boundary, struct err *err) {
    size_t first = s->mapped, n = 0;
    double(*point)[3];
    if (!mem_new(point, s->map.vertex_count - first, err)) return false;
    for (size_t v = first; v < s->map.vertex_count; v++)
        if (!on_boundary || !on_boundary[v])
            memcpy(point[n++], s->map.at[0][v], 2 * sizeof(double));
    bool ok = s->what->map(s->what->context, point, n, err);
    n = 0;
    for (size_t v = first; v < s->map.vertex_count; v++)
        if (!on_boundary || !on_boundary[v])
            memcpy(s->map.at[1][v], point[n++], 2 * sizeof(double));
    free(point);
    return ok;
}

/* Vertices that are new. */
static bool map_vertices(struct sampler *s, struct err *err) {
    size_t cap = s->mapped;
    bool *on_boundary = NULL, ok = mem_grow(s->map.at[1], &cap, s->map.vertex_count, err);
    if (ok && s->mapped == 0)
        ok = mem_new(on_boundary, s->map.vertex_count, err) && map_boundary(s, on_boundary, err);
    ok = ok && map_inside(s, on_boundary, err);
    s->mapped = s->map.vertex_count;
    free(on_boundary);
    return ok;
}

static size_t count_flipped(const struct plane_map *map) {
    size_t n = 0, t = plane_map_flipped(map, 1, 0);
    for (; t < map->triangle_count; t = plane_map_flipped(map, 1, t + 1)) n++;
    return n;
}

/* Adds the centroids of the triangles that are turned over. */
static bool add_points(struct sampler *s, struct err *err) {
    const struct plane_map *map = &s->map;
    size_t n = map->vertex_count, t = plane_map_flipped(map, 1, 0);
    double(*point)[2];
    if (!mem_new(point, n + count_flipped(map), err)) return false;
    memcpy(point, map->at[0], n * sizeof *point);
    for (; t < map->triangle_count; t = plane_map_flipped(map, 1, t + 1), n++)
        for (int c = 0; c < 2; c++)
            for (int i = 0; i < 3; i++) point[n][c] += map->at[0][map->triangle[t][i]][c] / 3;
    bool ok = triangulate(s, (const double(*)[2])point, n, 0, err) && map_vertices(s, err);
    free(point);
    return ok;
}

/* What is still turned over is mended; the rest is settled at its digits. */
static bool finish(struct sampler *s, int digits, struct err *err) {
    struct icc_sample_report *report = s->report;
    struct joint j;
    bool ok = joint_init(&j, &s->map, NULL, err);
    if (ok) memset(j.fixed, true, s->what->source->count * sizeof *j.fixed);
    ok = ok && joint_mend(&j, &report->left, err);
    for (uint32_t t = 0; ok && report->left > 0 && t < j.map.triangle_count; t++)
        if (j.map.triangle[t][0] != JOINT_NONE && !joint_is_sound(&j, t))
            memcpy(report->where, j.map.at[0][j.map.triangle[t][0]], sizeof report->where);
    if (ok && report->left == 0) {
        ok = (digits == 0 || joint_settle(&j, (int[2]){0, digits}, JOINT_SLACK, err)) &&
             joint_finish(&j, &s->map, err);
        report->lost = s->mapped - s->map.vertex_count;
    }
    joint_free(&j);
    return ok;
}

bool icc_sample(struct plane_map *map, const struct icc_sampled *what, double max_area, int digits,
                struct icc_sample_report *report, struct err *err) {
    struct sampler s = {.what = what, .report = report};
    *report = (struct icc_sample_report){0};
    if (what->source->area / max_area > ICC_SAMPLE_MAX)
        return refuse(&s, SHIM_CGAL_LIMIT, max_area, ICC_SAMPLE_MAX, err);
    bool ok = cage_sides(&s, err) &&
              triangulate(&s, (const double(*)[2])what->source->vertex, what->source->count,
                          max_area, err) &&
              map_vertices(&s, err);
    size_t given = s.mapped;
    report->left = report->flipped = ok ? count_flipped(&s.map) : 0;
    while (ok && report->left > 0 && report->rounds < ROUNDS &&
           s.map.triangle_count + 2 * report->left <= ICC_SAMPLE_MAX) {
        report->rounds++;
        ok = add_points(&s, err);
        if (ok) report->left = count_flipped(&s.map);
    }
    report->added = s.mapped - given;
    ok = ok && finish(&s, digits, err);
    free(s.side);
    *map = s.map;
    return ok;
}
