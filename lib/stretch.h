/* SPDX-License-Identifier: GPL-3.0-or-later */
/* stretch - how much a deformation stretches, by samples: no proof. */
#ifndef STRETCH_H
#define STRETCH_H

#include "spline.h"

/* Least and largest singular value of grad phi at the corners, the middles of the edges and one
 * inner point of each triangle. O(triangles). */
bool stretch_sample(const struct spline *s, double *least, double *largest,
                    struct err *err) WARN_UNUSED;

#endif
