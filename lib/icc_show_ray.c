/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line is a segment in the disk, from its rim to u0. It is followed from triangle to triangle of
 * the mesh's image, as icc_trace.c does on a grid: of the corner opposite to where it came in, the
 * side of the segment it lies on tells where it goes out. What it crosses an edge at, in the disk,
 * is taken to the world along that edge. */
#include "icc_show.h"

#include "mem.h"

#include <math.h>
#include <string.h>

struct show {
    const struct icc_ray *r;
    struct polylines_maker maker;
    uint32_t (*rim)[2]; /* of the rim edge that begins at a vertex: its triangle, and its number */
    struct err *err;
};

static bool begin(struct show *s, const char *word) {
    return polylines_word(&s->maker, word, strlen(word), s->err);
}

static bool add(struct show *s, const double p[2]) {
    return polylines_point(&s->maker, p, s->err);
}

/* The triangles, with their vertices at these places. */
static bool show_triangles(struct show *s, const double (*at)[2]) {
    const struct mesh *m = &s->r->mesh.mesh;
    for (size_t t = 0; t < m->triangle_count; t++) {
        if (!begin(s, "triangle")) return false;
        for (int c = 0; c < 4; c++)
            if (!add(s, at[m->triangle[t][c % 3]])) return false;
    }
    return true;
}

static bool show_image(struct show *s) {
    const struct icc_disk *disk = &s->r->disk;
    if (!show_triangles(s, (const double(*)[2])s->r->image) || !begin(s, "disk")) return false;
    for (size_t k = 0; k <= disk->count; k++)
        if (!add(s, disk->corner[k % disk->count])) return false;
    return begin(s, "maximum") && add(s, s->r->centre);
}

static bool show_vertices(struct show *s, bool values) {
    const struct mesh *m = &s->r->mesh.mesh;
    for (size_t v = 0; v < m->vertex_count; v++) {
        const double *u = s->r->image[v], *o = s->r->centre;
        double f = -sqrt((u[0] - o[0]) * (u[0] - o[0]) + (u[1] - o[1]) * (u[1] - o[1]));
        const char *word = f == 0 ? "maximum" : v < s->r->mesh.rim_count ? "outside" : "inside";
        if (!(values ? polylines_number(&s->maker, f, s->err) : begin(s, word)) ||
            !add(s, m->vertex[v]))
            return false;
    }
    return true;
}

bool icc_show_ray(const struct icc_ray *r, enum icc_show what, struct polylines *p,
                  struct err *err) {
    struct show s = {.r = r, .maker = {.p = p}, .err = err};
    bool ok;
    INVARIANT(icc_show_has(what, false));
    *p = (struct polylines){0};
    if (what == ICC_SHOW_TRIANGLES)
        ok = show_triangles(&s, (const double(*)[2])r->mesh.mesh.vertex);
    else
        ok = what == ICC_SHOW_IMAGE ? show_image(&s) : show_vertices(&s, what == ICC_SHOW_VALUES);
    if (ok) polylines_end(&s.maker);
    return ok;
}

/* ---- lines ------------------------------------------------------------------------------------
 */

static bool find_rim(struct show *s) {
    const struct mesh *m = &s->r->mesh.mesh;
    if (!mem_new(s->rim, s->r->mesh.rim_count, s->err)) return false;
    for (uint32_t t = 0; t < m->triangle_count; t++)
        for (uint32_t e = 0; e < 3; e++)
            if (m->across[t][e] == MESH_NONE) {
                uint32_t *rim = s->rim[m->triangle[t][(e + 1) % 3]];
                rim[0] = t;
                rim[1] = e;
            }
    return true;
}

static double cross(const double a[2], const double b[2]) {
    return a[0] * b[1] - a[1] * b[0];
}

/* A segment in the disk, from b along d to u0. */
struct ray {
    double b[2], d[2];
};

/* Left of the segment is positive. */
static double side_of(const struct show *s, const struct ray *ray, uint32_t v) {
    double q[2] = {s->r->image[v][0] - ray->b[0], s->r->image[v][1] - ray->b[1]};
    return cross(ray->d, q);
}

/* Where edge (v,w) crosses the segment, v right of it and w left: in the world, and how far along
 * the segment that is. */
static double crossing(const struct show *s, const struct ray *ray, uint32_t v, uint32_t w,
                       double p[2]) {
    const double(*at)[2] = (const double(*)[2])s->r->mesh.mesh.vertex;
    double right = -side_of(s, ray, v), left = side_of(s, ray, w);
    double mu = right > 0 ? fmin(right / (right + left), 1) : 0, along = 0;
    for (int c = 0; c < 2; c++) {
        double u = s->r->image[v][c] + mu * (s->r->image[w][c] - s->r->image[v][c]);
        along += (u - ray->b[c]) * ray->d[c];
        p[c] = at[v][c] + mu * (at[w][c] - at[v][c]);
    }
    return along / (ray->d[0] * ray->d[0] + ray->d[1] * ray->d[1]);
}

/* What a point of the image of triangle t comes from. */
static void come_from(const struct show *s, uint32_t t, const double u[2], double p[2]) {
    const uint32_t *v = s->r->mesh.mesh.triangle[t];
    const double(*at)[2] = (const double(*)[2])s->r->mesh.mesh.vertex;
    const double *a = s->r->image[v[0]], *b = s->r->image[v[1]], *c = s->r->image[v[2]];
    double ab[2] = {b[0] - a[0], b[1] - a[1]}, ac[2] = {c[0] - a[0], c[1] - a[1]};
    double au[2] = {u[0] - a[0], u[1] - a[1]}, area = cross(ab, ac);
    double x = cross(au, ac) / area, y = cross(ab, au) / area;
    for (int k = 0; k < 2; k++)
        p[k] = at[v[0]][k] + x * (at[v[1]][k] - at[v[0]][k]) + y * (at[v[2]][k] - at[v[0]][k]);
}

/* Follows the segment from edge e of triangle t on. */
static bool follow(struct show *s, const struct ray *ray, uint32_t t, uint32_t e) {
    const struct mesh *m = &s->r->mesh.mesh;
    double p[2];
    for (size_t steps = 0; steps < m->triangle_count; steps++) {
        const uint32_t *v = m->triangle[t];
        uint32_t out = side_of(s, ray, v[e]) > 0 ? (e + 1) % 3 : (e + 2) % 3, next;
        double along = out == (e + 1) % 3 ? crossing(s, ray, v[(e + 2) % 3], v[e], p)
                                          : crossing(s, ray, v[e], v[(e + 1) % 3], p);
        next = m->across[t][out];
        if (along >= 1 || next == MESH_NONE) break;
        if (!add(s, p)) return false;
        for (e = 0; m->across[next][e] != t; e++) continue;
        t = next;
    }
    come_from(s, t, s->r->centre, p);
    return add(s, p);
}

static bool show_line(struct show *s, size_t i, size_t count) {
    const struct icc_ray *r = s->r;
    struct icc_place place = icc_show_place(r->cage, i, count);
    const uint32_t *start = r->mesh.start + place.side;
    uint32_t parts = start[1] - start[0], part = (uint32_t)(place.lambda * parts);
    const uint32_t *rim = s->rim[start[0] + (part < parts ? part : parts - 1)];
    struct ray ray;
    double p[2];
    icc_disk_point(&r->disk, place.side, place.lambda, ray.b);
    cage_point(r->cage, place.side, place.lambda, p);
    for (int c = 0; c < 2; c++) ray.d[c] = r->centre[c] - ray.b[c];
    return polylines_number(&s->maker, (double)i, s->err) && add(s, p) &&
           follow(s, &ray, rim[0], rim[1]);
}

bool icc_show_ray_lines(const struct icc_ray *r, size_t count, struct polylines *p,
                        struct err *err) {
    struct show s = {.r = r, .maker = {.p = p}, .err = err};
    bool ok;
    *p = (struct polylines){0};
    ok = find_rim(&s);
    for (size_t i = 0; ok && i < count; i++) ok = show_line(&s, i, count);
    if (ok) polylines_end(&s.maker);
    free(s.rim);
    return ok;
}
