/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The certificate: all triangles of the image are counter-clockwise, so that each point of the
 * plane is covered as often as the image's rim winds round it (embed.h says why); and the rim winds
 * once, since it is seen counter-clockwise from a point inside all along and passes the ray to the
 * right of it once. */
#include "icc_embed.h"

#include "laplace.h"
#include "mem.h"
#include "predicate.h"
#include "segment.h"
#include "trig.h"

#include <math.h>
#include <string.h>

#define SHARE_MIN   1e-3    /* of the disk's circle that a side gets, times the number of sides */
#define QUANTUM     0x1p-34 /* of the corners' coordinates, so that rim vertices are exact; less if */
#define QUANTUM_MIN 0x1p-52 /* rounding would spoil convexity */
#define WEIGHT_MIN  0.05
#define WEIGHT_MAX  20

/* ---- the disk ---- */

/* The share of the perimeter that side k has, before all are scaled to the sum 1. */
static double share(const struct cage *c, uint32_t k) {
    double length = segment_length(c->vertex[k], c->vertex[cage_next(c, k)]);
    return fmax(length / c->perimeter, SHARE_MIN / (double)c->count);
}

/* The corners before they are rounded to multiples of a quantum. */
static void find_corners(const struct cage *source, double (*corner)[2]) {
    double all = 0, before = 0;
    for (uint32_t k = 0; k < source->count; k++) all += share(source, k);
    for (uint32_t k = 0; k < source->count; k++) {
        trig_degrees(360 * (before / all), &corner[k][0], &corner[k][1]);
        before += share(source, k);
    }
}

static void round_corners(struct icc_disk *d, const double (*corner)[2], double quantum) {
    for (size_t k = 0; k < d->count; k++)
        for (int i = 0; i < 2; i++) d->corner[k][i] = floor(corner[k][i] / quantum + 0.5) * quantum;
}

static bool is_convex(const struct icc_disk *d) {
    for (size_t k = 0; k < d->count; k++)
        if (predicate_orient(d->corner[k], d->corner[(k + 1) % d->count],
                             d->corner[(k + 2) % d->count]) <= 0)
            return false;
    return true;
}

bool icc_disk_init(struct icc_disk *d, const struct cage *source, struct err *err) {
    double(*exact)[2] = NULL, quantum = QUANTUM;
    *d = (struct icc_disk){.count = source->count};
    bool ok = mem_new(d->corner, d->count, err) && mem_new(d->length, d->count, err) &&
              mem_new(exact, d->count, err);
    if (ok) {
        find_corners(source, exact);
        round_corners(d, (const double(*)[2])exact, quantum);
        for (; quantum > QUANTUM_MIN && !is_convex(d); quantum *= 0x1p-6)
            round_corners(d, (const double(*)[2])exact, quantum * 0x1p-6);
        for (size_t k = 0; k < d->count; k++)
            d->length[k] = segment_length(d->corner[k], d->corner[(k + 1) % d->count]);
    }
    free(exact);
    if (!ok) icc_disk_free(d);
    return ok;
}

void icc_disk_free(struct icc_disk *d) {
    free(d->corner);
    free(d->length);
    *d = (struct icc_disk){0};
}

void icc_disk_point(const struct icc_disk *d, uint32_t side, double lambda, double u[2]) {
    size_t next = (size_t)side + 1;
    segment_point(d->corner[side], d->corner[next < d->count ? next : 0], lambda, u);
}

/* The mean of the centroids of triangles around corner 0, weighted by their areas. */
void icc_disk_centroid(const struct icc_disk *d, double u[2]) {
    const double *a = d->corner[0];
    double all = 0, sum[2] = {0, 0};
    for (size_t k = 1; k + 1 < d->count; k++) {
        const double *b = d->corner[k], *c = d->corner[k + 1];
        double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        all += area;
        for (int i = 0; i < 2; i++) sum[i] += area * ((b[i] - a[i]) + (c[i] - a[i])) / 3;
    }
    for (int i = 0; i < 2; i++) u[i] = a[i] + sum[i] / all;
}

/* ---- weights ---- */

/* The cotangent at corner e of triangle t; infinite or NaN where rounding leaves no area. */
static double cotangent(const struct mesh *m, size_t t, int e) {
    const uint32_t *v = m->triangle[t];
    const double *o = m->vertex[v[e]], *a = m->vertex[v[(e + 1) % 3]],
                 *b = m->vertex[v[(e + 2) % 3]];
    double ax = a[0] - o[0], ay = a[1] - o[1], bx = b[0] - o[0], by = b[1] - o[1];
    return (ax * bx + ay * by) / fabs(ax * by - ay * bx);
}

static double clamp(double weight) {
    if (!(weight > WEIGHT_MIN)) return WEIGHT_MIN;
    return fmin(weight, WEIGHT_MAX);
}

/* All edges inside, each once. */
static bool list_edges(const struct icc_mesh *m, bool uniform, struct laplace_problem *p,
                       struct err *err) {
    const struct mesh *mesh = &m->mesh;
    size_t room = (3 * mesh->triangle_count - m->rim_count) / 2;
    p->edge_count = 0;
    if (!mem_new(p->edge, room, err)) return false;
    for (uint32_t t = 0; t < mesh->triangle_count; t++)
        for (int e = 0; e < 3; e++) {
            uint32_t other = mesh->across[t][e];
            const uint32_t *v = mesh->triangle[t], a = v[(e + 1) % 3], b = v[(e + 2) % 3];
            if (other == MESH_NONE || other < t) continue;
            int f = (mesh_corner(mesh, other, a) + 1) % 3;
            double both = uniform ? 2 : cotangent(mesh, t, e) + cotangent(mesh, other, f);
            p->edge[p->edge_count++] = (struct laplace_edge){{a, b}, clamp(both / 2)};
        }
    INVARIANT(p->edge_count == room);
    return true;
}

/* ---- the map ---- */

static void place_rim(const struct icc_mesh *m, const struct icc_disk *d, double (*image)[2]) {
    for (uint32_t k = 0; k < m->side_count; k++)
        for (uint32_t v = m->start[k]; v < m->start[k + 1]; v++)
            icc_disk_point(d, k, icc_mesh_lambda(m, k, v), image[v]);
}

static bool is_certified(const struct icc_mesh *m, const struct icc_disk *d,
                         const double (*image)[2]) {
    double inside[2];
    int passages = 0;
    for (size_t t = 0; t < m->mesh.triangle_count; t++) {
        const uint32_t *v = m->mesh.triangle[t];
        if (predicate_orient(image[v[0]], image[v[1]], image[v[2]]) <= 0) return false;
    }
    icc_disk_centroid(d, inside);
    for (uint32_t v = 0; v < m->rim_count; v++) {
        const double *a = image[v], *b = image[v + 1 < m->rim_count ? v + 1 : 0];
        if (predicate_orient(inside, a, b) <= 0) return false;
        passages += a[1] <= inside[1] && b[1] > inside[1];
    }
    return passages == 1;
}

/* With one kind of weights; *certified: is the map one to one? */
static bool attempt(const struct icc_mesh *m, const struct icc_disk *d, double (*image)[2],
                    bool uniform, bool *certified, struct err *err) {
    struct laplace_problem p = {.vertex_count = (uint32_t)m->mesh.vertex_count,
                                .fixed_count = m->rim_count};
    struct err own = {0};
    if (!list_edges(m, uniform, &p, err)) return false;
    *certified = laplace_solve(&p, image, &own) && is_certified(m, d, (const double(*)[2])image);
    if (own.kind == ERR_NONE || own.kind == ERR_REFUSAL) return true;
    *err = own;
    return false;
}

bool icc_embed(const struct icc_mesh *m, const struct icc_disk *d, double (**image)[2],
               bool *uniform, struct err *err) {
    bool certified = false, ok = mem_new(*image, m->mesh.vertex_count, err);
    if (ok) place_rim(m, d, *image);
    for (int i = 0; ok && !certified && i < 2; i++) {
        *uniform = i == 1;
        ok = attempt(m, d, *image, *uniform, &certified, err);
    }
    if (ok && !certified)
        ok = err_set(err, ERR_REFUSAL,
                     "precision: the cage is too intricate for doubles to tell its parts apart");
    if (ok) return true;
    free(*image);
    *image = NULL;
    return false;
}
