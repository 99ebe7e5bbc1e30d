/* SPDX-License-Identifier: GPL-3.0-or-later */
/* embed - does a triangulation cover its domain once?
 *
 * Let all triangles be counter-clockwise. Then a point that lies on no edge is in as many triangles
 * as the boundary winds round it: map the triangulation, as an abstract surface, into the plane;
 * the degree of that map at a point is the winding number of the boundary's image, and each
 * triangle counts as +1. So nothing overlaps exactly if the boundary is simple and winds once round
 * what it encloses, which sides_check decides. */
#ifndef EMBED_H
#define EMBED_H

#include "grid.h"
#include "sides.h"
#include "snap.h"

/* Checks the built grid with its vertices at these places, where all its triangles are
 * counter-clockwise. *text is "" if nothing overlaps, else names the place, in `world` coordinates.
 * O(n + b log b) for b boundary edges. */
bool embed_check(const struct grid *g, const double (*at)[2], const double (*world)[2],
                 char text[SIDES_TEXT_MAX], struct err *err) WARN_UNUSED;

/* The same for a grid as it is. */
bool embed_check_grid(const struct grid *g, char text[SIDES_TEXT_MAX], struct err *err) WARN_UNUSED;

/* Checks and builds *g, whose vertices were snapped and whose fields up to `triangle` are set. What
 * is refused (ERR_REFUSAL, with the place) is the lattice's fault, on which triangles turn over,
 * vanish or overlap, or that of the triangulation: its topology, or overlaps of the triangles as
 * `given`, before snapping (NULL: those are known to be sound). */
bool embed_build(struct grid *g, const struct snap *s, const struct shim_cgal_mesh *given,
                 struct err *err) WARN_UNUSED;

#endif
