/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_show - what method grid works with, as polylines for drawing, in world units.
 *
 *   grid       a dot at each grid vertex that has a value: inside, outside or maximum
 *   values     the same, labelled by f: for cousin 10 * 0.95^depth, else what icc_function.h says
 *   tree       a line from each of these vertices to its parent, labelled by the child's depth
 *   grassfire  a dot at each vertex inside, labelled by the step in which it burns, from 1
 *   triangles  the triangles that have values
 *   edges      compression and expansion edges, as seen uphill, and a dot, unreached, at the middle
 * of each triangle from where the line downhill merges with others: no line uphill from the cage
 * comes there lines      integral lines from places on the cage, at equal distances along it from
 * vertex 0 */
#ifndef ICC_SHOW_H
#define ICC_SHOW_H

#include "icc_grid.h"
#include "polylines.h"

enum icc_show {
    ICC_SHOW_GRID,
    ICC_SHOW_VALUES,
    ICC_SHOW_TREE,
    ICC_SHOW_GRASSFIRE,
    ICC_SHOW_TRIANGLES,
    ICC_SHOW_EDGES,
    ICC_SHOW_IMAGE, /* method ray */
    ICC_SHOW_KINDS,
};
extern const char *const icc_show_names[ICC_SHOW_KINDS + 1]; /* for cli_choice */

/* Freed by polylines_free in any case. */
bool icc_show_grid(const struct icc_grid *g, enum icc_show what, struct polylines *p,
                   struct err *err) WARN_UNUSED;

/* `count` lines, labelled 0 to count - 1. */
bool icc_show_lines(const struct icc_grid *g, size_t count, struct polylines *p,
                    struct err *err) WARN_UNUSED;

/* The i-th of `count` places at equal distances along a cage, from vertex 0. */
struct icc_place icc_show_place(const struct cage *cage, size_t i, size_t count);

#endif
