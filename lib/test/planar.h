/* SPDX-License-Identifier: GPL-3.0-or-later */
/* planar - random triangulations of a square for tests, in doubles: with points on a coarse
 * lattice, so that those of two meshes coincide and lie on each other's edges all the time, or
 * anywhere; Delaunay or not. Checked with rationals, not by lib/. */
#ifndef PLANAR_H
#define PLANAR_H

#include "shim_cgal.h"

#include <gmp.h>

struct planar {
    int size;    /* the square [0, size * step]^2, with `size` edges on each side, up to 8 */
    double step; /* 0.1: points of a side are not on a line exactly */
    int inner;   /* points inside, up to 200 */
    int flips;   /* random edge flips tried */
};

/* The first 4 * size vertices are those of the boundary. Arrays are released with free(). */
void planar_make(struct shim_cgal_mesh *m, const struct planar *p, uint64_t *state);

/* Moves the inner vertices at random, `rounds` times each, as far as triangles stay
 * counter-clockwise. */
void planar_shake(struct shim_cgal_mesh *m, const struct planar *p, int rounds, uint64_t *state);

/* Sets area to twice the area of a, b, c, exactly. */
void planar_area2(mpq_t area, mpq_t a[2], mpq_t b[2], mpq_t c[2]);

/* Adds up twice the areas of triangles; false if one is not counter-clockwise. */
bool planar_total(mpq_t area, const double (*at)[2], const uint32_t (*triangle)[3], size_t count);

#endif
