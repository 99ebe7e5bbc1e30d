/* SPDX-License-Identifier: GPL-3.0-or-later */
/* msh_io - a deformation as a mesh of Gmsh: MSH 4.1, ASCII, triangles of the grid's own degree.
 *
 * Node p + 1 is sample point p of a tessellation with steps = degree (on the second sheet p + 1 +
 * point_count), element t + 1 is triangle t (on the second sheet t + 1 + triangle_count). So a
 * triangle's nodes are the images of its nominal positions, and interpolate the map exactly. Each
 * sheet is a surface and a physical group: "sheet", or "bottom" and "top". */
#ifndef MSH_IO_H
#define MSH_IO_H

#include "out.h"
#include "tessellate.h"

enum { MSH_DEGREE_MAX = 10 }; /* Gmsh has no triangles beyond */

/* history: comment lines (history.h); digits: of the coordinates, as in num_print. The degree, t's
 * steps, is at most MSH_DEGREE_MAX. */
void msh_write(struct out *out, const struct tessellation *t, const char *history, int digits);

#endif
