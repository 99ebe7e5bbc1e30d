/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tessellate - a deformation sampled: each triangle of the domain cut into steps^2 triangles.
 *
 * The sample points of a triangle are (i u0 + j u1 + k u2) / steps, those on shared edges and
 * corners once: they are numbered as the control points of a spline of degree `steps` on the same
 * domain (grid.h). Their images are one sheet, the plane map at depth 0, or with depth two: psi of
 * the planes z = a (bottom) and z = b (top). Between the sheets psi is linear in z. */
#ifndef TESSELLATE_H
#define TESSELLATE_H

#include "spline.h"

enum { TESSELLATE_STEPS_MAX = 1000 };

struct tessellation {
    struct grid net; /* the domain with degree = steps; its arrays are borrowed from the spline's */
    int sheets;      /* 1, or 2: bottom, top */
    double (*source)[2];   /* net.point_count sample points, rounded correctly; grid's frame */
    double (*sheet[2])[3]; /* their images, in the axes of the model (frame.h) */
};

/* Samples s, which must outlive the tessellation; 1 <= steps <= TESSELLATE_STEPS_MAX. Refuses more
 * points than uint32_t can number and images beyond the range of numbers. O(points degree^2). */
bool tessellate(struct tessellation *t, const struct spline *s, int steps,
                struct err *err) WARN_UNUSED;
void tessellation_free(struct tessellation *t);

/* Face 0 .. 2*row of that row, 0 .. steps-1, of triangle t of the domain: three points,
 * counter-clockwise in the grid's frame. Row 0 has the corner 0 of t. O(1). */
void tessellation_face(const struct tessellation *t, uint32_t triangle, int row, int place,
                       uint32_t face[3]);

/* The ends of step 0 .. steps-1 of edge l of triangle t, counter-clockwise. O(1). */
void tessellation_step(const struct tessellation *t, uint32_t triangle, int l, int step,
                       uint32_t end[2]);

#endif
