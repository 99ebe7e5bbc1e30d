/* SPDX-License-Identifier: GPL-3.0-or-later */
/* locate - which triangle of a grid holds a point, exactly.
 *
 * The hinted triangle first, then buckets; every step is decided by exact signs, so a point on a
 * shared edge or corner is found, and belongs to the lowest triangle number. Near O(1): about 20 ns
 * where points lie near the one before, 40 ns where they do not (10,000 triangles); 250 bytes a
 * triangle. Read-only after locator_init: threads may share it. */
#ifndef LOCATE_H
#define LOCATE_H

#include "cells.h"
#include "grid.h"

/* Buckets are cells (cells.h). Each knows the triangles that meet it: one to be tried first, which
 * holds the cell's centre if any does, and the others. */
struct locator_cell {
    uint32_t first; /* GRID_NONE: no triangle meets the cell */
    uint32_t start; /* item[start .. start of the next cell) are the others */
};

/* Edge e runs from corner e+1 to corner e+2, counter-clockwise. What predicate_side_filter computes
 * anew for each point is kept, in the same roundings, times locator.unit: a power of two, 1 but for
 * grids so large that areas would overflow. `bound` is that of all edges, for any point in the
 * bounding box of the grid, since |p| does not exceed the largest coordinate there. */
struct locator_triangle {
    double corner[3][2];
    double edge[3][2]; /* in steps of the lattice, exact */
    double bound;
    double area;   /* twice, over step: as in struct view */
    double radius; /* of a square on its tip around corner 0 that holds the triangle */
};

struct locator {
    const struct grid *grid; /* borrowed */
    /* private */
    struct cells_raster raster; /* over the bounding box, rounded monotonely */
    double unit;
    struct locator_cell *cell;
    uint32_t *item;
    struct locator_triangle *triangle;
};

bool locator_init(struct locator *l, const struct grid *g, struct err *err) WARN_UNUSED;
void locator_free(struct locator *l);

/* Finds the triangle of p and barycentric coordinates with fl(fl(b0+b1)+b2) = 1, all in [0,1];
 * false if p lies outside the triangulation. *hint is the triangle to start from (any valid number)
 * and becomes the one found. */
bool locate(const struct locator *l, const double p[2], uint32_t *hint, uint32_t *t, double b[3]);

/* Private: a corner of a triangle, modulo 3. */
static inline const int32_t *locator_corner(const struct locator *l, uint32_t t, int corner) {
    return l->grid->vertex[l->grid->triangle[t][corner % 3]];
}

#endif
