/* SPDX-License-Identifier: GPL-3.0-or-later */
/* model - a model as geometry: vertices, and the polygons, polylines and points on them.
 *
 * Element e is the vertices index[start[e] .. start[e+1]), a polygon (f, >= 3), a polyline (l, >=
 * 2) or a point (p). Indices count from 0. */
#ifndef MODEL_H
#define MODEL_H

#include <stddef.h>
#include <stdint.h>

struct model {
    size_t vertex_count, element_count;
    double (*vertex)[3];
    size_t *start;
    uint32_t *index;
    char *kind; /* 'f', 'l' or 'p' */
};

#endif
