/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deform - a spline deformation applied to points and normals of a model, in the model's own axes.
 *
 * The grid's `axes` say which model coordinates are its x, y and depth; results come back in the
 * model's order. Outside are points outside the triangulation or, with depth, outside [a,b]. */
#ifndef DEFORM_H
#define DEFORM_H

#include "locate.h"
#include "spline.h"

struct deform {
    const struct spline *spline; /* borrowed, unchanged while the struct lives */
    /* private */
    struct locator locator;
    struct spline_cursor cursor;
    uint32_t hint;
};

bool deform_init(struct deform *d, const struct spline *s, struct err *err) WARN_UNUSED;
void deform_free(struct deform *d);

/* The image of a point and, unless NULL, the derivative there, jacobian[r][c] = d result_r / d
 * point_c. False: the point lies outside; nothing is set. The result may overflow to infinity. Fast
 * for points that lie near the one before; the answer does not depend on it. */
bool deform_point(struct deform *d, const double point[3], double result[3], double jacobian[3][3]);

/* The images of n points; those outside stay where they are and are counted in *outside, *first is
 * the first of them. False: the image of point *first is not finite. points and results may be the
 * same array. */
bool deform_points(struct deform *d, size_t n, double (*points)[3], double (*results)[3],
                   size_t *outside, size_t *first);

/* The image of a surface normal: the inverse transpose of the Jacobian times the normal, with the
 * normal's own length. It stays on the side of the surface that it was on, also where the map
 * folds (determinant < 0). False where the Jacobian is singular (or not finite); the result is the
 * normal itself then. */
bool deform_normal(double jacobian[3][3], const double normal[3], double result[3]);

#endif
