/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "deform.h"

#include <math.h>
#include <string.h>

bool deform_init(struct deform *d, const struct spline *s, struct err *err) {
    *d = (struct deform){.spline = s};
    if (locator_init(&d->locator, &s->grid, err) && spline_cursor_init(&d->cursor, s, err))
        return true;
    deform_free(d);
    return false;
}

void deform_free(struct deform *d) {
    locator_free(&d->locator);
    spline_cursor_free(&d->cursor);
    *d = (struct deform){0};
}

bool deform_point(struct deform *d, const double point[3], double result[3],
                  double jacobian[3][3]) {
    const struct grid *g = &d->spline->grid;
    const int *axes = g->axes;
    double p[3], value[3], inner[3][3], b[3];
    uint32_t t;
    for (int c = 0; c < 3; c++) p[c] = point[axes[c]];
    if (g->has_depth && !(p[2] >= g->depth[0] && p[2] <= g->depth[1])) return false;
    if (!locate(&d->locator, p, &d->hint, &t, b)) return false;
    spline_cursor_evaluate(&d->cursor, t, b, p, value, jacobian ? inner : NULL);
    for (int r = 0; r < 3; r++) {
        result[axes[r]] = value[r];
        for (int c = 0; jacobian && c < 3; c++) jacobian[axes[r]][axes[c]] = inner[r][c];
    }
    return true;
}

bool deform_points(struct deform *d, size_t n, double (*points)[3], double (*results)[3],
                   size_t *outside, size_t *first) {
    *outside = 0;
    for (size_t i = 0; i < n; i++) {
        double image[3];
        if (!deform_point(d, points[i], image, NULL)) {
            if ((*outside)++ == 0) *first = i;
            memcpy(image, points[i], sizeof image);
        }
        if (!isfinite(image[0]) || !isfinite(image[1]) || !isfinite(image[2])) {
            *first = i;
            return false;
        }
        memcpy(results[i], image, sizeof image);
    }
    return true;
}

static void cross(const double a[3], const double b[3], double c[3]) {
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double largest(const double v[3]) {
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* Length over the largest component: no square overflows or vanishes. */
static double relative_length(const double v[3]) {
    double m = largest(v), w[3] = {v[0] / m, v[1] / m, v[2] / m};
    return sqrt(dot(w, w));
}

static bool is_identity(double j[3][3]) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            if (j[r][c] != (r == c)) return false;
    return true;
}

/* J^-T = (r1 x r2, r2 x r0, r0 x r1) / det for the rows r of J; only its direction matters, so
 * the sign of the determinant does and its magnitude does not. */
bool deform_normal(double jacobian[3][3], const double normal[3], double result[3]) {
    double cofactor[3][3], det, turned[3], scale;
    for (int r = 0; r < 3; r++) cross(jacobian[(r + 1) % 3], jacobian[(r + 2) % 3], cofactor[r]);
    det = dot(jacobian[0], cofactor[0]);
    for (int r = 0; r < 3; r++) turned[r] = dot(cofactor[r], normal);
    memcpy(result, normal, 3 * sizeof *result);
    if (is_identity(jacobian) || largest(normal) == 0) return true;
    if (!(det != 0) || !isfinite(det) || !(largest(turned) > 0)) return false;
    scale = largest(normal) / largest(turned) * (relative_length(normal) / relative_length(turned));
    if (!isfinite(scale * largest(turned))) return false;
    for (int r = 0; r < 3; r++) result[r] = turned[r] * (det > 0 ? scale : -scale);
    return true;
}
