/* SPDX-License-Identifier: GPL-3.0-or-later */
/* vtu_io - a deformation as an unstructured grid of VTK, XML in ASCII: exact, in Bezier form.
 *
 * Points are the control points in model axes; cells are Bezier triangles (VTK type 76) or, with
 * depth, Bezier wedges (80) of degrees (d,d,1) from the bottom control points to the top ones. The
 * point data `source` are the nominal positions: as Bezier coefficients they give each place of a
 * cell the place it comes from. */
#ifndef VTU_IO_H
#define VTU_IO_H

#include "out.h"
#include "spline.h"

/* history: comment lines (history.h), written as processing instructions; digits: of the control
 * points, as in num_print. */
void vtu_write(struct out *out, const struct spline *s, const char *history, int digits);

#endif
