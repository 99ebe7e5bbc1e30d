/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parts of sides are about as long as inside points are apart, h / sqrt(2) to h sqrt(2),
 *
 *     h = sqrt(area / (sqrt(3)/2 n)),      but at least perimeter / (4 (n + sides)),
 *
 * so that long thin cages do not get more points on the rim than they are worth. Inside points keep
 * a distance of 0.45 h from the cage. */
#include "icc_mesh.h"

#include "cage_fill.h"
#include "mem.h"
#include "segment.h"
#include "shim_cgal.h"

#include <math.h>
#include <string.h>

#define CLEARANCE 0.45

enum { PARTS_MAX = 1 << 26, TRIM_FROM = 100000 };
enum { POINTS_PER_SIDE = 20, POINTS_LOW = 600, POINTS_HIGH = 20000, RIM_PER_POINT = 4 };

size_t icc_mesh_points(size_t sides) {
    if (sides <= POINTS_LOW / POINTS_PER_SIDE) return POINTS_LOW;
    return sides < POINTS_HIGH / POINTS_PER_SIDE ? sides * POINTS_PER_SIDE : POINTS_HIGH;
}

/* The points that are to be triangulated. */
struct work {
    const struct cage *cage;
    double h;
    double (*inside)[2];
    size_t inside_count;
    double (*point)[2]; /* rim, then inside */
    size_t point_count;
    uint32_t (*side)[2]; /* between rim points */
};

/* How many parts a side of this length gets. */
static uint32_t parts(double length, double h) {
    uint32_t n = 1;
    while (length * length > 2 * h * h * ((double)n * n) && n < PARTS_MAX) n *= 2;
    return n;
}

static bool cut_sides(struct icc_mesh *m, const struct cage *c, double h, struct err *err) {
    m->start[0] = 0;
    for (uint32_t k = 0; k < c->count; k++)
        m->start[k + 1] =
            m->start[k] + parts(segment_length(c->vertex[k], c->vertex[cage_next(c, k)]), h);
    m->rim_count = m->start[c->count];
    free(m->side);
    if (!mem_new(m->side, m->rim_count, err)) return false;
    for (uint32_t k = 0; k < c->count; k++)
        for (uint32_t v = m->start[k]; v < m->start[k + 1]; v++) m->side[v] = k;
    return true;
}

static bool choose_points(struct work *w, const double *weight, size_t n, struct err *err) {
    const struct cage *c = w->cage;
    if (n > ICC_POINTS_MAX)
        return err_set(err, ERR_REFUSAL, "more than %d points inside are too many", ICC_POINTS_MAX);
    w->h = INFINITY;
    if (n == 0) return true;
    w->h = fmax(sqrt(c->area / (sqrt(3) / 2 * (double)n)),
                c->perimeter / (RIM_PER_POINT * (double)(n + c->count)));
    return cage_fill(c, weight, w->h, CLEARANCE * w->h, 2 * (size_t)ICC_POINTS_MAX, &w->inside,
                     &w->inside_count, err);
}

/* Removes inside points that are not inside, or twice there, because of rounding. */
static void keep_sound(struct work *w) {
    size_t n = 0;
    for (size_t i = 0; i < w->inside_count; i++) {
        const double *p = w->inside[i];
        if (polygon_side(&w->cage->polygon, p) <= 0) continue;
        if (n > 0 && w->inside[n - 1][0] == p[0] && w->inside[n - 1][1] == p[1]) continue;
        memcpy(w->inside[n++], p, sizeof *w->inside);
    }
    w->inside_count = n;
}

static bool gather(struct work *w, const struct icc_mesh *m, struct err *err) {
    free(w->point);
    free(w->side);
    w->side = NULL;
    w->point_count = m->rim_count + w->inside_count;
    if (!mem_new(w->point, w->point_count, err) || !mem_new(w->side, m->rim_count, err))
        return false;
    for (uint32_t k = 0; k < w->cage->count; k++)
        for (uint32_t v = m->start[k]; v < m->start[k + 1]; v++) {
            cage_point(w->cage, k, icc_mesh_lambda(m, k, v), w->point[v]);
            w->side[v][0] = v;
            w->side[v][1] = v + 1 < m->rim_count ? v + 1 : 0;
        }
    if (w->inside_count > 0)
        memcpy(w->point[m->rim_count], w->inside, w->inside_count * sizeof *w->inside);
    return true;
}

/* Does a rim vertex lie on side k, ends included? */
static bool is_on(const struct icc_mesh *m, uint32_t v, uint32_t k) {
    return (v >= m->start[k] && v <= m->start[k + 1]) || (v == 0 && k + 1 == m->side_count);
}

/* Has a triangle three corners on one side? If an edge inside joins two points of a side, then one
 * has. */
static bool has_flat_triangle(const struct icc_mesh *m) {
    for (size_t t = 0; t < m->mesh.triangle_count; t++) {
        const uint32_t *v = m->mesh.triangle[t];
        if (v[0] >= m->rim_count || v[1] >= m->rim_count || v[2] >= m->rim_count) continue;
        for (int c = 0; c < 3; c++) {
            uint32_t k = m->side[v[c]];
            if (is_on(m, v[0], k) && is_on(m, v[1], k) && is_on(m, v[2], k)) return true;
        }
    }
    return false;
}

/* *sound: are the triangles what they should be? */
static bool triangulate(struct icc_mesh *m, const struct work *w, bool *sound, struct err *err) {
    struct shim_cgal_sides sides = {(const double(*)[2])w->point, w->point_count,
                                    (const uint32_t(*)[2])w->side, m->rim_count};
    struct shim_cgal_mesh mesh;
    struct shim_cgal_report report;
    *sound = shim_cgal_domain(&sides, NULL, &mesh, &report);
    if (!*sound && report.status == SHIM_CGAL_MEMORY) return err_memory(err);
    if (!*sound) return true;
    m->mesh = (struct mesh){.vertex_count = mesh.vertex_count,
                            .triangle_count = mesh.triangle_count,
                            .vertex = mesh.vertex,
                            .triangle = mesh.triangle};
    *sound = !has_flat_triangle(m);
    if (!*sound) mesh_free(&m->mesh);
    return true;
}

/* With sides cut; else uncut, with those inside points that are inside; else without any. Nothing
 * is rounded then. */
static bool build(struct icc_mesh *m, struct work *w, struct err *err) {
    bool sound = false;
    for (int attempt = 0; attempt < 3 && !sound; attempt++) {
        if (attempt == 1) keep_sound(w);
        if (attempt == 2) w->inside_count = 0;
        if (!cut_sides(m, w->cage, attempt ? INFINITY : w->h, err) || !gather(w, m, err) ||
            !triangulate(m, w, &sound, err))
            return false;
    }
    return sound || err_set(err, ERR_REFUSAL, "precision: the cage cannot be triangulated");
}

bool icc_mesh_init(struct icc_mesh *m, const struct cage *cage, const double *weight, size_t points,
                   struct err *err) {
    struct work w = {.cage = cage};
    *m = (struct icc_mesh){.side_count = cage->count};
    bool ok = mem_new(m->start, cage->count + 1, err) && choose_points(&w, weight, points, err) &&
              build(m, &w, err) && mesh_link(&m->mesh, err);
    free(w.inside);
    free(w.point);
    free(w.side);
    if (m->mesh.vertex_count > TRIM_FROM) mem_trim();
    if (!ok) icc_mesh_free(m);
    return ok;
}

void icc_mesh_free(struct icc_mesh *m) {
    mesh_free(&m->mesh);
    free(m->start);
    free(m->side);
    *m = (struct icc_mesh){0};
}
