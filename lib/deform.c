/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "deform.h"

#include <math.h>
#include <string.h>

bool deform_init(struct deform *d, const struct spline *s, const struct projection *projection,
                 const struct place *places, struct err *err) {
    *d = (struct deform){.spline = s, .projection = *projection, .places = places};
    if (spline_cursor_init(&d->cursor, s, err) &&
        (places || placer_init(&d->placer, &s->grid, projection, err)))
        return true;
    deform_free(d);
    return false;
}

void deform_free(struct deform *d) {
    placer_free(&d->placer);
    spline_cursor_free(&d->cursor);
    inverse_cursor_free(&d->finder);
    inverse_free(&d->inverse);
    *d = (struct deform){0};
}

/* deform_point of psi itself. */
static bool map_point(struct deform *d, size_t i, const double point[3], double result[3],
                      double jacobian[3][3]) {
    const int *axes = d->projection.axes;
    double p[3], value[3], inner[3][3];
    struct place found;
    const struct place *place = d->places ? &d->places[i] : &found;
    if (d->places ? place->triangle == GRID_NONE : !placer_find(&d->placer, point, &found))
        return false;
    for (int c = 0; c < 3; c++) p[c] = point[axes[c]];
    spline_cursor_evaluate(&d->cursor, place->triangle, place->b, p, value,
                           jacobian ? inner : NULL);
    if (!d->projection.has_depth) value[2] = p[2];
    for (int r = 0; r < 3; r++) {
        result[axes[r]] = value[r];
        for (int c = 0; jacobian && c < 3; c++) jacobian[axes[r]][axes[c]] = inner[r][c];
    }
    return true;
}

/* From the derivative of psi to that of its inverse, in the model's axes: in the grid's, psi has
 * the form (A 0; g h), and its inverse (B 0; -gB/h 1/h), B = 1/A. */
static void invert(const int axes[3], double j[3][3]) {
    const int x = axes[0], y = axes[1], z = axes[2];
    double a = j[x][x], b = j[x][y], c = j[y][x], d = j[y][y], det = a * d - b * c;
    double g[2] = {j[z][x], j[z][y]}, h = j[z][z];
    j[x][x] = d / det;
    j[x][y] = (0 - b) / det; /* no -0 */
    j[y][x] = (0 - c) / det;
    j[y][y] = a / det;
    j[z][x] = (0 - (g[0] * j[x][x] + g[1] * j[y][x])) / h;
    j[z][y] = (0 - (g[0] * j[x][y] + g[1] * j[y][y])) / h;
    j[z][z] = 1 / h;
}

bool deform_point(struct deform *d, size_t i, const double point[3], double result[3],
                  double jacobian[3][3]) {
    if (!d->inverted) return map_point(d, i, point, result, jacobian);
    if (!deform_point_back(d, i, point, result, jacobian)) return false;
    if (jacobian) invert(d->projection.axes, jacobian);
    return true;
}

/* The derivative of the plane map at point number i, row by row, and its determinant. */
static void plane_gradient(struct deform *d, size_t i, const double point[3], double gradient[5]) {
    const int *axes = d->projection.axes;
    double ignored[3], jacobian[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    (void)deform_point(d, i, point, ignored, jacobian); /* outside: the identity */
    for (int r = 0; r < 2; r++)
        for (int c = 0; c < 2; c++) gradient[2 * r + c] = jacobian[axes[r]][axes[c]];
    gradient[4] = gradient[0] * gradient[3] - gradient[1] * gradient[2];
}

static bool all_finite(const double *x, int n) {
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i])) return false;
    return true;
}

bool deform_points(struct deform *d, struct deform_batch *batch) {
    batch->outside = 0;
    for (size_t i = 0; i < batch->count; i++) {
        const double *point = batch->points[i];
        double image[3];
        progress_tell(batch->progress, i, batch->count);
        if (!deform_point(d, i, point, image, NULL)) {
            if (batch->outside++ == 0) batch->first = i;
            memcpy(image, point, sizeof image);
        }
        if (batch->gradient) plane_gradient(d, i, point, batch->gradient[i]);
        if (!all_finite(image, 3) || (batch->gradient && !all_finite(batch->gradient[i], 5))) {
            batch->first = i;
            return false;
        }
        memcpy(batch->images[i], image, sizeof image);
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

/* Gives a turned normal the length that it had, and the sign. */
static bool set_length(const double turned[3], double sign, const double normal[3],
                       double result[3]) {
    double scale;
    if (!(largest(turned) > 0)) return false;
    scale = largest(normal) / largest(turned) * (relative_length(normal) / relative_length(turned));
    if (!isfinite(scale * largest(turned))) return false;
    for (int r = 0; r < 3; r++) result[r] = turned[r] * (sign > 0 ? scale : -scale);
    return true;
}

/* The rows of the cofactor matrix; returns the determinant. */
static double cofactors(double jacobian[3][3], double cofactor[3][3]) {
    for (int r = 0; r < 3; r++) cross(jacobian[(r + 1) % 3], jacobian[(r + 2) % 3], cofactor[r]);
    return dot(jacobian[0], cofactor[0]);
}

/* J^-T = (r1 x r2, r2 x r0, r0 x r1) / det for the rows r of J; only its direction matters, so
 * the sign of the determinant does and its magnitude does not. */
bool deform_normal(double jacobian[3][3], const double normal[3], double result[3]) {
    double cofactor[3][3], det = cofactors(jacobian, cofactor), turned[3];
    memcpy(result, normal, 3 * sizeof *result);
    if (is_identity(jacobian) || largest(normal) == 0) return true;
    if (!(det != 0) || !isfinite(det)) return false;
    for (int r = 0; r < 3; r++) turned[r] = dot(cofactor[r], normal);
    return set_length(turned, det, normal, result);
}

bool deform_normal_back(double jacobian[3][3], const double normal[3], double result[3]) {
    double cofactor[3][3], det = cofactors(jacobian, cofactor), turned[3] = {0, 0, 0};
    memcpy(result, normal, 3 * sizeof *result);
    if (is_identity(jacobian) || largest(normal) == 0) return true;
    if (!(det != 0) || !isfinite(det)) return false;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) turned[c] += jacobian[r][c] * normal[r];
    return set_length(turned, det, normal, result);
}

bool deform_turn(struct deform *d, size_t i, const double point[3], const double normal[3],
                 double result[3]) {
    double image[3], jacobian[3][3];
    memcpy(result, normal, 3 * sizeof *result);
    if (d->inverted)
        return !deform_point_back(d, i, point, image, jacobian) ||
               deform_normal_back(jacobian, normal, result);
    return !map_point(d, i, point, image, jacobian) || deform_normal(jacobian, normal, result);
}
