/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rectangle - a regular grid on a rectangle. */
#ifndef RECTANGLE_H
#define RECTANGLE_H

#include "lattice.h"
#include "pattern.h"

struct rectangle {
    double low[2], high[2]; /* world units, low < high */
    uint32_t
        cells[2]; /* {n, 0}: n along the longer side, as near to regular as whole numbers let */
    enum pattern_kind kind;
    struct lattice_choice lattice;
};

/* Fills lattice, vertices and triangles of *g. The lattice's origin is the low corner, rounded to a
 * multiple of the step; the high corner is rounded to the nearest lattice point. Refuses a lattice
 * too coarse for the cells. */
bool rectangle_grid(struct grid *g, const struct rectangle *r, struct err *err) WARN_UNUSED;

#endif
