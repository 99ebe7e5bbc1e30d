/* SPDX-License-Identifier: GPL-3.0-or-later */
/* triangulation - grids of what users bring: triangles, points, or points and segments.
 *
 * Triangles are taken as they are but for their orientation; points are joined by a Delaunay
 * triangulation; segments enclose the regions that a constrained Delaunay triangulation fills, but
 * for those with a seed. Vertices that no triangle has are dropped. All is snapped to the lattice
 * and verified exactly: triangles that overlap or vanish, T-junctions and pinched vertices are
 * refused, and so is a lattice that makes them. */
#ifndef TRIANGULATION_H
#define TRIANGULATION_H

#include "grid.h"
#include "lattice.h"

struct triangulation { /* arrays from mem.h */
    size_t vertex_count, triangle_count, segment_count, seed_count;
    double (*vertex)[2];     /* world units */
    uint32_t (*triangle)[3]; /* none: see segments */
    uint32_t (*segment)[2];  /* none: Delaunay triangulation of the vertices */
    double (*seed)[2];       /* points in holes */
};

void triangulation_free(struct triangulation *t);

/* Completes and builds *g, whose degree, axes and depth are set, and is the caller's to free in any
 * case. Refusals are ERR_REFUSAL and name the place; triangles count from 0. O(n log n). */
bool triangulation_grid(struct grid *g, const struct triangulation *t,
                        const struct lattice_choice *choice, struct err *err) WARN_UNUSED;

#endif
