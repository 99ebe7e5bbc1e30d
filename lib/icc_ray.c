/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points within rounding of the cage. A point in a triangle without a corner on the rim is inside.
 * In any other it is first held against the sides that the triangle touches, exactly, and a point
 * in no triangle against the whole cage. What then lies inside the cage, but outside the mesh,
 * whose rim vertices are rounded, or outside the image of the other mesh, whose rim is rounded in
 * another way, belongs to the nearest edge of the rim. */
#include "icc_ray.h"

#include "mem.h"
#include "predicate.h"
#include "segment.h"

#include <math.h>
#include <string.h>

/* ---- the grassfire ---- */

/* For each vertex, the vertices that follow it round its triangles: its neighbours, but for one of
 * each rim vertex. */
struct fan {
    uint32_t *start, *next;
};

static bool fan_init(struct fan *f, const struct mesh *m, struct err *err) {
    if (!mem_new(f->start, m->vertex_count + 2, err) ||
        !mem_new(f->next, 3 * m->triangle_count, err))
        return false;
    for (size_t t = 0; t < m->triangle_count; t++)
        for (int c = 0; c < 3; c++) f->start[m->triangle[t][c] + 2]++;
    for (size_t v = 2; v < m->vertex_count + 2; v++) f->start[v] += f->start[v - 1];
    for (size_t t = 0; t < m->triangle_count; t++)
        for (int c = 0; c < 3; c++)
            f->next[f->start[m->triangle[t][c] + 1]++] = m->triangle[t][(c + 1) % 3];
    return true;
}

/* The vertices in the order in which they burn; *last: where the last layer begins. */
static void burn(const struct fan *f, const struct icc_mesh *m, bool *burnt, uint32_t *order,
                 size_t *last) {
    size_t count = m->rim_count, end = 0;
    for (uint32_t v = 0; v < m->rim_count; v++) order[v] = v, burnt[v] = true;
    for (size_t i = 0; i < count; i++) {
        if (i == end) *last = i, end = count;
        for (uint32_t n = f->start[order[i]]; n < f->start[order[i] + 1]; n++) {
            uint32_t v = f->next[n];
            if (burnt[v]) continue;
            burnt[v] = true;
            order[count++] = v;
        }
    }
}

/* Of some vertices, the one nearest to their mean; the lowest of several. */
static uint32_t middle(const double (*at)[2], const uint32_t *vertex, size_t n) {
    const double *o = at[vertex[0]];
    double mean[2] = {0, 0}, best = INFINITY;
    uint32_t found = vertex[0];
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) mean[k] += (at[vertex[i]][k] - o[k]) / (double)n;
    for (size_t i = 0; i < n; i++) {
        double x = at[vertex[i]][0] - o[0] - mean[0], y = at[vertex[i]][1] - o[1] - mean[1];
        double d = x * x + y * y;
        if (d > best || (d == best && vertex[i] > found)) continue;
        best = d;
        found = vertex[i];
    }
    return found;
}

/* The image of the grassfire maximum, or of nothing in particular where no vertex is inside. */
static bool find_centre(struct icc_ray *r, struct err *err) {
    const struct icc_mesh *m = &r->mesh;
    size_t n = m->mesh.vertex_count, last = 0;
    struct fan fan = {0};
    uint32_t *order = NULL;
    bool *burnt = NULL;
    if (n == m->rim_count) {
        icc_disk_centroid(&r->disk, r->centre);
        return true;
    }
    bool ok = fan_init(&fan, &m->mesh, err) && mem_new(order, n, err) && mem_new(burnt, n, err);
    if (ok) {
        burn(&fan, m, burnt, order, &last);
        memcpy(r->centre,
               r->image[middle((const double(*)[2])m->mesh.vertex, order + last, n - last)],
               sizeof r->centre);
    }
    free(fan.start);
    free(fan.next);
    free(order);
    free(burnt);
    return ok;
}

/* ---- binding ---- */

static bool begin(struct icc_ray *r, const struct icc_ray *source, struct err *err) {
    r->is_source = !source;
    if (!source) return icc_disk_init(&r->disk, r->cage, err);
    INVARIANT(source->cage->count == r->cage->count);
    r->disk = source->disk;
    memcpy(r->centre, source->centre, sizeof r->centre);
    return true;
}

bool icc_ray_init(struct icc_ray *r, const struct cage *cage, const struct icc_ray *source,
                  size_t points, struct err *err) {
    *r = (struct icc_ray){.cage = cage};
    bool ok = begin(r, source, err) && icc_mesh_init(&r->mesh, cage, r->disk.length, points, err) &&
              icc_embed(&r->mesh, &r->disk, &r->image, &r->uniform, err) &&
              (source || find_centre(r, err));
    if (!ok) icc_ray_free(r);
    return ok;
}

bool icc_ray_prepare(struct icc_ray *r, unsigned use, struct err *err) {
    const struct mesh *m = &r->mesh.mesh;
    if (use & ICC_RAY_LOOK_UP &&
        !mesh_locator_init(&r->world, m, (const double(*)[2])m->vertex, err))
        return false;
    return !(use & ICC_RAY_ASK) ||
           mesh_locator_init(&r->inner, m, (const double(*)[2])r->image, err);
}

void icc_ray_free(struct icc_ray *r) {
    if (r->is_source) icc_disk_free(&r->disk);
    icc_mesh_free(&r->mesh);
    free(r->image);
    mesh_locator_free(&r->world);
    mesh_locator_free(&r->inner);
    *r = (struct icc_ray){0};
}

/* ---- points ---- */

/* Is p, which is in triangle t, on a side that t touches, or outside it by no more than rounding?
 * The nearest such side. */
static bool is_on_rim(const struct icc_ray *r, uint32_t t, const double p[2], uint32_t *side) {
    const struct cage *c = r->cage;
    double best = cage_rounding(c) * cage_rounding(c), lambda;
    bool found = false;
    for (int i = 0; i < 3; i++) {
        uint32_t v = r->mesh.mesh.triangle[t][i];
        if (v >= r->mesh.rim_count) continue;
        uint32_t k = r->mesh.side[v];
        for (int both = 0; both < 2; both++) { /* a corner of the cage is on two sides */
            const double *a = c->vertex[k], *b = c->vertex[cage_next(c, k)];
            double d = segment_distance2(a, b, p, &lambda);
            if (d <= best && predicate_orient(a, b, p) <= 0) best = d, *side = k, found = true;
            k = k > 0 ? k - 1 : (uint32_t)c->count - 1;
            if (r->mesh.start[r->mesh.side[v]] != v) break;
        }
    }
    return found;
}

/* Where p lies: *at in the mesh if inside, *side and *lambda if on the cage. */
static enum cage_where find(const struct icc_ray *r, uint32_t *hint, const double p[2],
                            struct mesh_place *at, uint32_t *side, double *lambda) {
    struct mesh_point point = {{p[0], p[1]}, {0, 0}};
    if (!mesh_locate(&r->world, &point, hint, at)) {
        enum cage_where where = cage_find(r->cage, p, side, lambda);
        if (where == CAGE_INSIDE) mesh_locate_rim(&r->world, &point, at);
        return where;
    }
    /* a triangle's first corner has its lowest number */
    if (r->mesh.mesh.triangle[at->triangle][0] >= r->mesh.rim_count) return CAGE_INSIDE;
    if (!is_on_rim(r, at->triangle, p, side)) return CAGE_INSIDE;
    *lambda = cage_foot(r->cage, side, p);
    return CAGE_ON;
}

/* The point in the disk of a place in the mesh. */
static struct mesh_point image_of(const struct icc_ray *r, const struct mesh_place *at) {
    return mesh_mean(&r->mesh.mesh, (const double(*)[2])r->image, at);
}

/* The point of the cage that u in the disk comes from. */
static void pull_back(const struct icc_ray *r, uint32_t *hint, const struct mesh_point *u,
                      double p[2]) {
    struct mesh_place at = {0, {0, 0, 0}};
    if (!mesh_locate(&r->inner, u, hint, &at)) mesh_locate_rim(&r->inner, u, &at);
    struct mesh_point mean = mesh_mean(&r->mesh.mesh, (const double(*)[2])r->mesh.mesh.vertex, &at);
    memcpy(p, mean.at, sizeof mean.at);
}

bool icc_ray_map(const struct icc_ray *from, const struct icc_ray *to,
                 struct icc_ray_cursor *cursor, const double p[2], double q[2]) {
    struct mesh_place at = {0, {0, 0, 0}};
    struct mesh_point u;
    uint32_t side;
    double lambda;
    switch (find(from, &cursor->from, p, &at, &side, &lambda)) {
    case CAGE_OUTSIDE:
        return false;
    case CAGE_ON:
        cage_point(to->cage, side, lambda, q);
        return true;
    default:
        u = image_of(from, &at);
        pull_back(to, &cursor->to, &u, q);
        return true;
    }
}

/* Is p seen from `o` within half a turn counter-clockwise of a? */
static bool is_left(const double o[2], const double a[2], const double p[2]) {
    return predicate_orient(o, a, p) >= 0;
}

/* The side of the disk that the ray from the centre through u ends at. The corners are in the order
 * of their angles from the centre, taken from corner 0; two angles are compared by their halves of
 * the full turn, and within one half by an orientation. */
static uint32_t side_of_ray(const struct icc_ray *r, const double u[2]) {
    const double(*c)[2] = (const double(*)[2])r->disk.corner, *o = r->centre;
    bool half = is_left(o, c[0], u);
    size_t low = 0, high = r->disk.count; /* the angle is not below that of low, but of high */
    double ahead = (u[0] - o[0]) * (c[0][0] - o[0]) + (u[1] - o[1]) * (c[0][1] - o[1]);
    if (half && ahead > 0 && predicate_orient(o, c[0], u) == 0) return 0;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        bool same = is_left(o, c[0], c[middle]) == half;
        *((same ? is_left(o, c[middle], u) : !half) ? &low : &high) = middle;
    }
    return (uint32_t)low;
}

static double limit(double x) {
    return fmin(fmax(x, 0), 1);
}

/* With d = u - u0, e = c_k+1 - c_k, f = c_k - u0, the ray u0 + s d meets the side where s d = f +
 * lambda e: lambda = f x d / d x e, and t = 1 / s = d x e / f x e. */
static void name_image(const struct icc_ray *r, const struct mesh_point *u,
                       struct icc_place *place) {
    uint32_t k = side_of_ray(r, u->at), next = cage_next(r->cage, k);
    const double *c = r->disk.corner[k], *b = r->disk.corner[next], *o = r->centre;
    double d[2], e[2], f[2];
    for (int i = 0; i < 2; i++) {
        d[i] = u->at[i] - o[i] + u->rest[i];
        e[i] = b[i] - c[i];
        f[i] = c[i] - o[i];
    }
    double de = d[0] * e[1] - d[1] * e[0], fd = f[0] * d[1] - f[1] * d[0];
    place->t = limit(de / (f[0] * e[1] - f[1] * e[0]));
    place->lambda = limit(fd / de);
    place->side = place->lambda < 1 ? k : next;
    if (place->lambda == 1) place->lambda = 0;
    if (place->t == 0) *place = (struct icc_place){0, 0, 0};
}

bool icc_ray_coordinates(const struct icc_ray *r, struct icc_ray_cursor *cursor, const double p[2],
                         struct icc_place *place) {
    struct mesh_place at = {0, {0, 0, 0}};
    struct mesh_point u;
    enum cage_where where = find(r, &cursor->from, p, &at, &place->side, &place->lambda);
    place->t = 1;
    if (where != CAGE_INSIDE) return where == CAGE_ON;
    u = image_of(r, &at);
    name_image(r, &u, place);
    return true;
}

void icc_ray_point(const struct icc_ray *r, struct icc_ray_cursor *cursor,
                   const struct icc_place *place, double p[2]) {
    double d[2];
    if (place->t == 1) {
        cage_point(r->cage, place->side, place->lambda, p);
        return;
    }
    icc_disk_point(&r->disk, place->side, place->lambda, d);
    for (int i = 0; i < 2; i++) d[i] = place->t * (d[i] - r->centre[i]);
    struct mesh_point u = mesh_point(r->centre, d);
    pull_back(r, &cursor->to, &u, p);
}
