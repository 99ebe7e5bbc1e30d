/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deform - a spline deformation applied to points and normals of a model, in the model's own axes.
 *
 * Points have numbers, so that their places in the grid may be known beforehand; otherwise they are
 * found here, with the same results bit for bit. Outside nothing moves. */
#ifndef DEFORM_H
#define DEFORM_H

#include "place.h"
#include "progress.h"
#include "spline.h"

struct deform {
    const struct spline *spline; /* borrowed, unchanged while the struct lives */
    struct projection projection;
    /* private */
    const struct place *places;
    struct placer placer;
    struct spline_cursor cursor;
};

/* Of points under this projection. `places` of all points, by their numbers, are borrowed; NULL:
 * find them.
 */
bool deform_init(struct deform *d, const struct spline *s, const struct projection *projection,
                 const struct place *places, struct err *err) WARN_UNUSED;
void deform_free(struct deform *d);

/* The image of point number i and, unless NULL, the derivative there, jacobian[r][c] = d result_r /
 * d point_c. False: the point lies outside; nothing is set. The result may overflow to infinity.
 * With a derivative, the image may be rounded in another way. Fast for points that lie near the one
 * before; the answer does not depend on it. */
bool deform_point(struct deform *d, size_t i, const double point[3], double result[3],
                  double jacobian[3][3]);

/* Many points at once; images are the same bit for bit with gradients and without. Those outside
 * stay where they are, with the derivative of the identity. */
struct deform_batch {
    size_t count;
    double (*points)[3], (*images)[3]; /* may be the same array */
    double (*gradient)[5];     /* NULL, or phi's dx/dx, dx/dy, dy/dx, dy/dy in the grid's axes, and
                                  their determinant */
    struct progress *progress; /* or NULL */
    size_t outside;            /* set: how many, and the first of them */
    size_t first;
};

/* False: what point number `first` is mapped to is not finite. */
bool deform_points(struct deform *d, struct deform_batch *batch);

/* The image of a surface normal: the inverse transpose of the Jacobian times the normal, with the
 * normal's own length. It stays on the side of the surface that it was on, also where the map
 * folds (determinant < 0). False where the Jacobian is singular (or not finite); the result is the
 * normal itself then. */
bool deform_normal(double jacobian[3][3], const double normal[3], double result[3]);

#endif
