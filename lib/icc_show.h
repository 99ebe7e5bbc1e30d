/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_show - what the methods of icc-map work with, as polylines for drawing, in world units.
 *
 *   grid       a dot at each vertex: inside, maximum, or outside; of a grid those that have a
 * value, of a mesh, outside is the rim values     the same, labelled by f: for cousin 10 *
 * 0.95^depth, else what icc_function.h says; of a mesh -|u - u0| triangles  of the grid those that
 * have values lines      integral lines from places on the cage, at equal distances along it from
 * vertex 0
 *
 * Method grid only:
 *   tree       a line from each of the vertices to its parent, labelled by the child's depth
 *   grassfire  a dot at each vertex inside, labelled by the step in which it burns, from 1
 *   edges      compression and expansion edges, as seen uphill, of the vertices inside; and a dot,
 *              unreached, near the middle of each triangle from where the line downhill merges with
 *              others: no line uphill from the cage comes there
 *
 * Method ray only:
 *   image      in the disk, the images of the triangles; the disk; the maximum's place */
#ifndef ICC_SHOW_H
#define ICC_SHOW_H

#include "icc_map.h"
#include "polylines.h"

enum icc_show {
    ICC_SHOW_GRID,
    ICC_SHOW_VALUES,
    ICC_SHOW_TREE,
    ICC_SHOW_GRASSFIRE,
    ICC_SHOW_TRIANGLES,
    ICC_SHOW_EDGES,
    ICC_SHOW_IMAGE,
    ICC_SHOW_KINDS,
};
extern const char *const icc_show_names[ICC_SHOW_KINDS + 1]; /* for cli_choice */

/* Does it belong to a method? */
bool icc_show_has(enum icc_show what, bool method_grid);

/* What belongs to the method. Freed by polylines_free in any case. */
bool icc_show_grid(const struct icc_grid *g, enum icc_show what, struct polylines *p,
                   struct err *err) WARN_UNUSED;
bool icc_show_ray(const struct icc_ray *r, enum icc_show what, struct polylines *p,
                  struct err *err) WARN_UNUSED;

/* The same of the source of a map, whatever its method; lines > 0: so many integral lines instead.
 */
bool icc_show(const struct icc_map *m, enum icc_show what, size_t lines, struct polylines *p,
              struct err *err) WARN_UNUSED;

/* `count` lines, labelled 0 to count - 1. */
bool icc_show_grid_lines(const struct icc_grid *g, size_t count, struct polylines *p,
                         struct err *err) WARN_UNUSED;
bool icc_show_ray_lines(const struct icc_ray *r, size_t count, struct polylines *p,
                        struct err *err) WARN_UNUSED;

/* The i-th of `count` places at equal distances along a cage, from vertex 0. */
struct icc_place icc_show_place(const struct cage *cage, size_t i, size_t count);

#endif
