/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deform - a spline deformation, or its inverse, applied to points and normals of a model, in the
 * model's own axes.
 *
 * Points have numbers, so that their places in the grid may be known beforehand; otherwise they are
 * found here, with the same results bit for bit. Outside nothing moves.
 *
 * The inverse of psi takes (x,y,z) to the preimage (x',y') of (x,y) under phi (inverse.h), and to
 * the z' of which psi makes z there, which is linear in z'. Outside of it is what has no preimage
 * in the domain, or lies below sigma0 or above sigma1; up to 16 ulp (of the largest of their
 * coefficients and the depths) off these faces, z counts as on them, as images carry errors of that
 * size. */
#ifndef DEFORM_H
#define DEFORM_H

#include "inverse.h"
#include "progress.h"
#include "spline.h"

struct deform {
    const struct spline *spline; /* borrowed, unchanged while the struct lives */
    struct projection projection;
    /* private */
    const struct place *places;
    struct placer placer;
    struct spline_cursor cursor;
    bool inverted;
    struct inverse inverse; /* where inverted */
    struct inverse_cursor finder;
    double face; /* the 16 ulp of depths */
};

/* Of points under this projection. `places` of all points, by their numbers, are borrowed; NULL:
 * find them.
 */
bool deform_init(struct deform *d, const struct spline *s, const struct projection *projection,
                 const struct place *places, struct err *err) WARN_UNUSED;

/* The inverse. `one_to_one`: the spline is proved to be that (deform_prove). If not, the result is
 * one preimage of several, the same whatever was asked before; with depth one in the prisms if
 * there is one. The triangles of `places`, if any, are those of the points before they were moved:
 * where to look first, which changes nothing for a one-to-one map, and which preimage to prefer for
 * another. */
bool deform_init_inverse(struct deform *d, const struct spline *s,
                         const struct projection *projection, const struct place *places,
                         bool one_to_one, struct err *err) WARN_UNUSED;

/* Is the spline proved to be one-to-one, as far as points under this projection see it? If not,
 * ERR_REFUSAL as from injective_prove. */
bool deform_prove(const struct spline *s, const struct projection *projection,
                  struct err *err) WARN_UNUSED;
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
    double (*gradient)[5];     /* NULL, or the plane map's dx/dx, dx/dy, dy/dx, dy/dy in the grid's
                                  axes, and their determinant */
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

/* The same under the inverse of a map with this Jacobian: the transpose times the normal. */
bool deform_normal_back(double jacobian[3][3], const double normal[3], double result[3]);

/* The image of a normal at point number i: of either, as inverted. Outside it stays as it is. */
bool deform_turn(struct deform *d, size_t i, const double point[3], const double normal[3],
                 double result[3]);

/* Private: deform_point of an inverse; the derivative that of psi at the result. */
bool deform_point_back(struct deform *d, size_t i, const double point[3], double result[3],
                       double jacobian[3][3]);

#endif
