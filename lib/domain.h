/* SPDX-License-Identifier: GPL-3.0-or-later */
/* domain - grids of polygons with holes: constrained Delaunay triangulation, Delaunay refinement.
 *
 * The first loop is the outline, further ones are holes; orientation does not matter. The polygon's
 * points are snapped to the lattice first and become the grid's first vertices. Points that the
 * refinement adds are snapped afterwards, those on sides too, so a side may bend by half a step.
 * All is verified exactly on the lattice.
 *
 * The area limit holds for the triangles of the grid. The angle limit holds before the added points
 * are snapped, except where the polygon itself has smaller angles (or angles near them, in the
 * wedge between two sides); termination is proved up to 20.7 degrees (Shewchuk, "Delaunay
 * refinement algorithms for triangular mesh generation", 2002), and beyond that max_triangles ends
 * it. */
#ifndef DOMAIN_H
#define DOMAIN_H

#include "grid.h"
#include "lattice.h"
#include "polygon.h"

struct domain {
    struct lattice_choice lattice;
    double max_area;  /* world units squared; INFINITY: any */
    double min_angle; /* degrees, 0..60; 0: any */
    size_t max_triangles;
};

/* Completes and builds *g, whose degree, axes and depth are set, and is the caller's to free in any
 * case. Refusals (ERR_REFUSAL) name points and sides. About 5 us a triangle. */
bool domain_grid(struct grid *g, const struct polygon *outline, const struct domain *d,
                 struct err *err) WARN_UNUSED;

#endif
