/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlay_place - where the vertices of an overlay lie, in the domain of either mesh.
 *
 * The meshes of an overlay lie in one domain C, but each is the image of another domain: its vertex
 * v is there at x[v], and in between the map is affine on each triangle. Cells of the overlay are
 * polygons in both of these domains too, and their vertices are affine combinations of those of a
 * triangle, whose weights are areas in C. */
#ifndef OVERLAY_PLACE_H
#define OVERLAY_PLACE_H

#include "overlay.h"

#include <gmp.h>

/* Sets p to the place of vertex v in the domain of mesh m, whose vertices are at x. */
void overlay_place_exact(const struct overlay_mesh mesh[2], const struct overlay_vertex *v, int m,
                         const double (*x)[2], mpq_t p[2]);

/* The same to within OVERLAY_ERROR times the largest coordinate of the triangle. Exact for vertices
 * of mesh m. About 100 ns. */
#define OVERLAY_ERROR 0x1p-50
void overlay_place(const struct overlay_mesh mesh[2], const struct overlay_vertex *v, int m,
                   const double (*x)[2], double p[2]);

#endif
