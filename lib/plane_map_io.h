/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plane_map_io - a map of the plane as a Wavefront OBJ: `v` are the places in the target, z = 0,
 * `vt` those in the source, one for each vertex; faces are triangles, counter-clockwise. */
#ifndef PLANE_MAP_IO_H
#define PLANE_MAP_IO_H

#include "out.h"
#include "plane_map.h"

/* history: comment lines (history.h); digits: of the target, as in num_print. */
void plane_map_write(struct out *out, const struct plane_map *map, const char *history, int digits);

#endif
