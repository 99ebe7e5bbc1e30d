/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks are made on the vertices as given, so that faults have the user's numbers: side i joins
 * the vertices i and i + 1 and is turned, for the triangulator, where the list is clockwise. */
#include "cage.h"

#include "dd.h"
#include "mem.h"
#include "segment.h"
#include "sides.h"

#include <math.h>
#include <string.h>

#define AREA_MIN   1e-14 /* of diameter^2 */
#define SIZE_LEAST 1e-100
#define SIZE_MOST  1e100
#define ROUNDING   0x1p-48 /* of the largest coordinate: how far rounding may move a point */

static bool check_list(const double (*vertex)[2], size_t n, struct err *err) {
    if (n < 3) return err_set(err, ERR_REFUSAL, "a cage has three vertices or more, got %zu", n);
    if (n >= UINT32_MAX) return err_set(err, ERR_REFUSAL, "more than 2^32 - 2 vertices");
    for (size_t i = 0; i < n; i++) {
        const double *a = vertex[i], *b = vertex[i + 1 < n ? i + 1 : 0];
        if (!isfinite(a[0]) || !isfinite(a[1]))
            return err_set(err, ERR_REFUSAL, "vertex %zu is not finite", i);
        if (a[0] == b[0] && a[1] == b[1])
            return err_set(err, ERR_REFUSAL,
                           "side %zu has no length: its ends are both at (%.9g, %.9g)", i, a[0],
                           a[1]);
    }
    return true;
}

/* Twice the signed area, to about 2^-100 of the products: differences and sums are double-double.
 */
static double area2(const double (*v)[2], size_t n) {
    struct dd sum = {0, 0};
    for (size_t i = 1; i + 1 < n; i++) {
        struct dd ax = dd_two_sum(v[i][0], -v[0][0]), ay = dd_two_sum(v[i][1], -v[0][1]);
        struct dd bx = dd_two_sum(v[i + 1][0], -v[0][0]), by = dd_two_sum(v[i + 1][1], -v[0][1]);
        sum = dd_add(sum, dd_add(dd_mul(ax, by), dd_negate(dd_mul(ay, bx))));
    }
    return sum.hi;
}

static double perimeter(const double (*v)[2], size_t n) {
    double sum = 0;
    for (size_t i = 0; i < n; i++) sum += segment_length(v[i], v[i + 1 < n ? i + 1 : 0]);
    return sum;
}

static const double *end_of(const struct shim_cgal_sides *s, size_t side, int which) {
    return s->point[s->side[side][which]];
}

/* Where two sides cross, rounded. */
static void crossing(const struct shim_cgal_sides *s, size_t i, size_t j, double p[2]) {
    const double *a = end_of(s, i, 0), *b = end_of(s, i, 1);
    const double *c = end_of(s, j, 0), *d = end_of(s, j, 1);
    double x = d[0] - c[0], y = d[1] - c[1];
    double at_a = x * (a[1] - c[1]) - y * (a[0] - c[0]);
    double at_b = x * (b[1] - c[1]) - y * (b[0] - c[0]);
    double lambda = at_a / (at_a - at_b);
    for (int k = 0; k < 2; k++) p[k] = a[k] + lambda * (b[k] - a[k]);
}

/* A loop that does not meet itself covers its inside once, so no other fault is possible. */
static bool refuse(const struct shim_cgal_sides *s, const struct sides_fault *f, struct err *err) {
    const double *at = s->point[f->a];
    double p[2];
    INVARIANT(f->trouble != SIDES_COVERED);
    if (f->trouble == SIDES_SAME_POINT)
        return err_set(err, ERR_REFUSAL,
                       "the cage is not simple: vertices %zu and %zu are both at (%.9g, %.9g)",
                       f->a, f->b, at[0], at[1]);
    if (f->trouble == SIDES_ON_SIDE)
        return err_set(err, ERR_REFUSAL,
                       "the cage is not simple: vertex %zu, at (%.9g, %.9g), lies on side %zu",
                       f->a, at[0], at[1], f->b);
    crossing(s, f->a, f->b, p);
    return err_set(err, ERR_REFUSAL,
                   "the cage is not simple: sides %zu and %zu cross at (%.9g, %.9g)",
                   f->a < f->b ? f->a : f->b, f->a < f->b ? f->b : f->a, p[0], p[1]);
}

static bool check_simple(const double (*vertex)[2], size_t n, bool reversed, struct err *err) {
    struct sides_fault fault;
    uint32_t(*side)[2];
    bool ok;
    if (!mem_new(side, n, err)) return false;
    for (size_t i = 0; i < n; i++) {
        side[i][reversed] = (uint32_t)i;
        side[i][!reversed] = (uint32_t)(i + 1 < n ? i + 1 : 0);
    }
    struct shim_cgal_sides sides = {vertex, n, (const uint32_t(*)[2])side, n};
    ok = sides_check(&sides, &fault, err) &&
         (fault.trouble == SIDES_SOUND || refuse(&sides, &fault, err));
    free(side);
    return ok;
}

static size_t given_vertex(const struct cage *c, size_t i) {
    return c->reversed ? (c->shift + c->count - i) % c->count : (c->shift + i) % c->count;
}

/* Makes the polygon of the vertices in the order of the prepared cage. */
static bool fill(struct cage *c, const double (*vertex)[2], struct err *err) {
    struct polygon *g = &c->polygon;
    *g = (struct polygon){.point_count = c->count, .loop_count = 1};
    if (!mem_new(g->point, c->count, err) || !mem_new(g->loop_start, 2, err)) return false;
    for (size_t i = 0; i < c->count; i++)
        memcpy(g->point[i], vertex[given_vertex(c, i)], sizeof *g->point);
    g->loop_start[1] = c->count;
    c->vertex = g->point;
    return polygon_build(g, err);
}

static bool measure(struct cage *c, struct err *err) {
    const struct polygon *g = &c->polygon;
    double width = g->hi[0] - g->lo[0], height = g->hi[1] - g->lo[1];
    if (!(fmax(width, height) >= SIZE_LEAST && fmax(width, height) <= SIZE_MOST))
        return err_set(err, ERR_REFUSAL, "the cage is %g x %g large, not in %g..%g", width, height,
                       SIZE_LEAST, SIZE_MOST);
    c->diameter = segment_length(g->lo, g->hi);
    c->area = fabs(area2((const double(*)[2])c->vertex, c->count)) / 2;
    c->perimeter = perimeter((const double(*)[2])c->vertex, c->count);
    return true;
}

/* Prepares the cage; with a source, in its numbering. */
static bool prepare(struct cage *c, const double (*vertex)[2], const struct cage *source,
                    struct err *err) {
    if (!fill(c, vertex, err) || !measure(c, err)) return false;
    c->shift = polygon_lowest(&c->polygon, 0);
    c->reversed = polygon_sense(&c->polygon, 0) < 0;
    if (!check_simple(vertex, c->count, c->reversed, err)) return false;
    if (!(c->area > AREA_MIN * c->diameter * c->diameter))
        return err_set(err, ERR_REFUSAL, "the cage has no area: %.9g, at a diameter of %.9g",
                       c->area, c->diameter);
    if (source && source->reversed != c->reversed)
        return err_set(err, ERR_REFUSAL, "the cage is %s, but the source is not",
                       c->reversed ? "clockwise" : "counter-clockwise");
    if (source) c->shift = source->shift;
    polygon_free(&c->polygon);
    return fill(c, vertex, err) && measure(c, err);
}

static bool init(struct cage *c, const double (*vertex)[2], size_t n, const struct cage *source,
                 struct err *err) {
    *c = (struct cage){.count = n};
    if (check_list(vertex, n, err) && prepare(c, vertex, source, err)) return true;
    cage_free(c);
    return false;
}

bool cage_init(struct cage *c, const double (*vertex)[2], size_t n, struct err *err) {
    return init(c, vertex, n, NULL, err);
}

bool cage_init_like(struct cage *c, const double (*vertex)[2], size_t n, const struct cage *source,
                    struct err *err) {
    if (n != source->count)
        return err_set(err, ERR_REFUSAL, "the cage has %zu vertices, but the source has %zu", n,
                       source->count);
    return init(c, vertex, n, source, err);
}

void cage_free(struct cage *c) {
    polygon_free(&c->polygon);
    *c = (struct cage){0};
}

void cage_point(const struct cage *c, uint32_t side, double lambda, double p[2]) {
    segment_point(c->vertex[side], c->vertex[cage_next(c, side)], lambda, p);
}

double cage_rounding(const struct cage *c) {
    const struct polygon *g = &c->polygon;
    double largest =
        fmax(fmax(fabs(g->lo[0]), fabs(g->hi[0])), fmax(fabs(g->lo[1]), fabs(g->hi[1])));
    return ROUNDING * largest;
}

/* The end of a side is the beginning of the next. */
static void begin_at_vertex(const struct cage *c, uint32_t *side, double *lambda) {
    if (*lambda < 1) return;
    *side = cage_next(c, *side);
    *lambda = 0;
}

double cage_foot(const struct cage *c, uint32_t *side, const double p[2]) {
    double lambda;
    (void)segment_distance2(c->vertex[*side], c->vertex[cage_next(c, *side)], p, &lambda);
    begin_at_vertex(c, side, &lambda);
    return lambda;
}

enum cage_where cage_find(const struct cage *c, const double p[2], uint32_t *side, double *lambda) {
    size_t edge = 0;
    int inside = polygon_find(&c->polygon, p, &edge);
    if (inside > 0) return CAGE_INSIDE;
    if (inside < 0 && !polygon_near(&c->polygon, p, cage_rounding(c), &edge)) return CAGE_OUTSIDE;
    *side = (uint32_t)edge;
    *lambda = cage_foot(c, side, p);
    return CAGE_ON;
}

static void turn(const struct cage *c, uint32_t *side, double *lambda) {
    *lambda = 1 - *lambda;
    begin_at_vertex(c, side, lambda);
}

/* Reversed, side i from vertex i to i + 1 is given as the side from shift - i - 1 to shift - i. */
void cage_to_given(const struct cage *c, uint32_t *side, double *lambda) {
    *side = (uint32_t)given_vertex(c, c->reversed ? (size_t)*side + 1 : *side);
    if (c->reversed) turn(c, side, lambda);
}

void cage_from_given(const struct cage *c, uint32_t *side, double *lambda) {
    size_t k = *side, n = c->count;
    *side = (uint32_t)(c->reversed ? (c->shift + 2 * n - k - 1) % n : (k + n - c->shift) % n);
    if (c->reversed) turn(c, side, lambda);
}
