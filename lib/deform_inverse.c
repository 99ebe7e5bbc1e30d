/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With D0, D1, D2, D3 the displacements of phi, sigma0 and sigma1 at the preimage, depths a < b,
 *
 *     z = z' + D2 + a1 (D3 - D2),   a1 = (z' - a) / (b - a) = (z - a - D2) / (b - a + D3 - D2)
 *
 * so that z' is z, bit for bit, where D2 = D3 = 0. Quarters keep differences finite. */
#include "deform.h"

#include "injective.h"

#include <float.h>
#include <math.h>

bool deform_prove(const struct spline *s, const struct projection *projection, struct err *err) {
    struct spline seen = *s;
    if (!projection->has_depth) {
        seen.grid.has_depth = false;
        seen.sigma = NULL;
    }
    return injective_prove(&seen, err);
}

/* What 16 ulp of the largest depth are. */
static double face_of(const struct spline *s) {
    double most = fmax(fabs(s->grid.depth[0]), fabs(s->grid.depth[1]));
    int e;
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        most = fmax(most, fmax(fabs(s->sigma[p][0]), fabs(s->sigma[p][1])));
    (void)frexp(most, &e);
    return ldexp(16 * DBL_EPSILON, e - 1);
}

bool deform_init_inverse(struct deform *d, const struct spline *s,
                         const struct projection *projection, const struct place *places,
                         bool one_to_one, struct err *err) {
    *d =
        (struct deform){.spline = s, .projection = *projection, .places = places, .inverted = true};
    if (projection->has_depth) d->face = face_of(s);
    if (spline_cursor_init(&d->cursor, s, err) && inverse_init(&d->inverse, s, one_to_one, err) &&
        inverse_cursor_init(&d->finder, &d->inverse, err))
        return true;
    deform_free(d);
    return false;
}

/* z' from a1. */
static double depth_at(const double depth[2], double a1) {
    double quarter = depth[1] / 4 - depth[0] / 4;
    return a1 < 0.5 ? depth[0] + 4 * (a1 * quarter) : depth[1] - 4 * ((1 - a1) * quarter);
}

/* The depth that goes to z above a place; false: none. */
static bool depth_back(struct deform *d, const struct place *place, double z, double *depth) {
    const double *k = d->projection.depth;
    double shift[4], above, thickness, a1, off;
    spline_cursor_shift(&d->cursor, place->triangle, place->b, shift);
    above = z / 4 - (k[0] / 4 + shift[2] / 4);
    thickness = (k[1] / 4 - k[0] / 4) + (shift[3] / 4 - shift[2] / 4);
    a1 = thickness != 0 ? above / thickness : 0;
    off = a1 > 1 ? fabs(above - thickness) : a1 < 0 || thickness == 0 ? fabs(above) : 0;
    if (!(off <= d->face / 4)) return false;
    *depth = shift[2] == 0 && shift[3] == 0 ? z : depth_at(k, a1);
    *depth = fmin(fmax(*depth, k[0]), k[1]);
    return true;
}

struct level {
    struct deform *deform;
    double z;
};

static bool is_in_prism(void *context, const struct place *place) {
    const struct level *level = context;
    double depth;
    return depth_back(level->deform, place, level->z, &depth);
}

/* The place of a preimage of point number i. */
static bool find_place(struct deform *d, size_t i, const double q[3], struct place *place) {
    struct level level = {d, q[2]};
    inverse_wanted *wanted = d->projection.has_depth ? is_in_prism : NULL;
    uint32_t t = d->places ? d->places[i].triangle : GRID_NONE;
    if (t != GRID_NONE && d->inverse.one_to_one)
        inverse_cursor_hint(&d->finder, t);
    else if (t != GRID_NONE && inverse_find_in(&d->finder, t, q, wanted, &level, place))
        return true;
    return inverse_find(&d->finder, q, wanted, &level, place);
}

/* The same, and the preimage in the grid's axes. */
static bool find_back(struct deform *d, size_t i, const double q[3], struct place *place,
                      double p[3]) {
    if (!find_place(d, i, q, place)) return false;
    inverse_point(&d->inverse, q, place, p);
    p[2] = q[2];
    return !d->projection.has_depth || depth_back(d, place, q[2], &p[2]);
}

bool deform_point_back(struct deform *d, size_t i, const double point[3], double result[3],
                       double jacobian[3][3]) {
    const int *axes = d->projection.axes;
    const double q[3] = {point[axes[0]], point[axes[1]], point[axes[2]]};
    double p[3], image[3], inner[3][3];
    struct place place;
    if (!find_back(d, i, q, &place, p)) return false;
    if (jacobian) spline_cursor_evaluate(&d->cursor, place.triangle, place.b, p, image, inner);
    for (int r = 0; r < 3; r++) {
        result[axes[r]] = p[r];
        for (int c = 0; jacobian && c < 3; c++) jacobian[axes[r]][axes[c]] = inner[r][c];
    }
    return true;
}
