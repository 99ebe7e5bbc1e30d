/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap - triangles of a grid that have more in common than a vertex or an edge.
 *
 * Whether there are any follows from the boundary (embed.h); which they are is sought only then.
 * All is decided exactly on the lattice. */
#ifndef OVERLAP_H
#define OVERLAP_H

#include "sides.h"

#include "grid.h"

enum overlap_kind {
    OVERLAP_NONE,
    OVERLAP_TOUCH, /* a corner of one lies on the other */
    OVERLAP_AREA,  /* they have inner points in common */
};

struct overlap {
    enum overlap_kind kind;
    uint32_t triangle[2];      /* ascending; OVERLAP_AREA if there are such */
    char text[SIDES_TEXT_MAX]; /* the place on the boundary, in words; "" */
};

/* O(n + b log b) for b boundary edges; O(n log n) if there are such triangles. */
bool overlap_find(struct overlap *o, const struct grid *g, struct err *err) WARN_UNUSED;

/* What two triangles have in common. */
enum overlap_kind overlap_of_triangles(const struct grid *g, uint32_t s, uint32_t t);

#endif
