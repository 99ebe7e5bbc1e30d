/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cells - a raster of square cells over a bounding box, and which of many items meet each cell.
 *
 * The cell of a point is a monotone function of its coordinates, also as rounded. So an item that
 * holds a point is always in the list of the point's cell, and lists are in ascending order. */
#ifndef CELLS_H
#define CELLS_H

#include "err.h"

#include <stdint.h>

struct cells_raster {
    double lo[2], hi[2]; /* the bounding box */
    double scale[2];     /* cells a unit */
    uint32_t size[2];
};

struct cells {
    struct cells_raster raster;
    uint32_t *start; /* item[start[c] .. start[c+1]) meet cell c = row * size[0] + column */
    uint32_t *item;
};

/* What is put into cells: the bounding box of an item, and whether it certainly misses a rectangle
 * x[0]..x[1], y[0]..y[1] (infinite where the raster has one column or row). */
struct cells_items {
    uint32_t count;
    const void *context;
    void (*box)(const void *context, uint32_t i, double lo[2], double hi[2]);
    bool (*misses)(const void *context, uint32_t i, const double x[2], const double y[2]);
};

/* About `density` cells an item, fewer where long items would be in too many. O(items), unless
 * their boxes overlap much. `name` is what the items are, for the one refusal: too many. */
bool cells_init(struct cells *c, const double lo[2], const double hi[2],
                const struct cells_items *items, double density, const char *name,
                struct err *err) WARN_UNUSED;
void cells_free(struct cells *c); /* harmless on a zeroed struct */

/* The column (axis 0) or row (1) of a coordinate, the nearest one if it lies outside. */
static inline uint32_t cells_column(const struct cells_raster *r, int axis, double x) {
    double c = (x - r->lo[axis]) * r->scale[axis];
    if (!(c > 0)) return 0;
    return c >= r->size[axis] ? r->size[axis] - 1 : (uint32_t)c;
}

static inline size_t cells_of(const struct cells_raster *r, const double p[2]) {
    return (size_t)cells_column(r, 1, p[1]) * r->size[0] + cells_column(r, 0, p[0]);
}

/* The rectangle of cell number c, wider than it can be by any rounding. */
void cells_rectangle(const struct cells_raster *r, size_t c, double x[2], double y[2]);

static inline bool cells_holds(const struct cells_raster *r, const double p[2]) {
    return p[0] >= r->lo[0] && p[0] <= r->hi[0] && p[1] >= r->lo[1] && p[1] <= r->hi[1];
}

#endif
