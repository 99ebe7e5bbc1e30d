/* SPDX-License-Identifier: GPL-3.0-or-later */
/* nearest - a dynamic index of points of the plane: nearest point, points in a box.
 *
 * It borrows an array of positions. Whoever changes a position says so afterwards, at a cost of
 * O(1), so that a mouse pick after an edit costs nothing that grows with the grid. A search costs
 * O(1) where the points are spread as evenly as control points are, O(points) at worst. */
#ifndef NEAREST_H
#define NEAREST_H

#include "err.h"

#include <stdint.h>

#define NEAREST_NONE UINT32_MAX

struct nearest {
    const double (*at)[2]; /* borrowed */
    uint32_t count;
    /* private */
    double origin[2], scale[2]; /* cell = (x - origin) * scale */
    double unit;                /* a power of two that brings distances near 1 */
    uint32_t cells[2];
    uint32_t *head;        /* first point of each cell */
    uint32_t *cell;        /* of each point */
    uint32_t *next, *prev; /* the points of a cell, in no order that matters */
    uint64_t moved;        /* points moved since the cells were laid out */
};

/* Indexes at[0..count), all finite. O(count). */
bool nearest_init(struct nearest *n, const double (*at)[2], uint32_t count,
                  struct err *err) WARN_UNUSED;
void nearest_free(struct nearest *n); /* harmless on a zeroed struct */

/* Position at[p] has changed. O(1) amortised. */
void nearest_moved(struct nearest *n, uint32_t p);

/* The point nearest to (x, y), of several the lowest number; NEAREST_NONE if there is none.
 * Squared distances are compared as doubles, scaled by a power of two so that they neither
 * overflow nor vanish. */
uint32_t nearest_find(const struct nearest *n, const double xy[2]);

/* Calls visit for each point in the closed box, in no particular order. */
void nearest_box(const struct nearest *n, const double lo[2], const double hi[2],
                 void (*visit)(void *context, uint32_t p), void *context);

#endif
