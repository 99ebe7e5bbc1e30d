/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surface_io - a tessellated deformation as a Wavefront OBJ.
 *
 * One sheet is an open surface. Two sheets are the closed surface of the deformed prisms: the
 * groups bottom, top and walls, every edge in two faces. Faces are triangles, counter-clockwise
 * from outside (of one sheet: from the side of growing depth). `v` are images in model axes, the
 * bottom first; `vt` are the source positions in the grid's frame, one for each sample point. */
#ifndef SURFACE_IO_H
#define SURFACE_IO_H

#include "out.h"
#include "tessellate.h"

/* history: comment lines (history.h); digits: of the images, as in num_print. */
void surface_write(struct out *out, const struct tessellation *t, const char *history, int digits);

#endif
