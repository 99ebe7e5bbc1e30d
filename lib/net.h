/* SPDX-License-Identifier: GPL-3.0-or-later */
/* net - neighbours in the global Bezier net, in which graph distances are measured (grid.h). */
#ifndef NET_H
#define NET_H

#include "grid.h"

/* Neighbours of point p in the net of triangle t, which must have it: 2 to 6 points, in a fixed
 * order; returns how many. All neighbours of p are those in all its triangles (grid_triangles_of);
 * what lies on a shared edge then comes twice. O(1). */
int net_neighbours(const struct grid *g, uint32_t p, uint32_t t, uint32_t neighbour[6]);

/* Point k = 0..degree-fixed of the straight line of the net of triangle t on which corner l has the
 * weight `fixed`, 0..degree-1; counter-clockwise in the domain. O(1). */
uint32_t net_line_point(const struct grid *g, uint32_t t, int l, int fixed, int k);

#endif
