/* SPDX-License-Identifier: GPL-3.0-or-later */
/* triangulations - grids for tests: regular, crossed, jittered, flipped, with holes, of several
 * components, with shuffled numbers. Checked by brute force, not by lib/. */
#ifndef TRIANGULATIONS_H
#define TRIANGULATIONS_H

#include "grid.h"

struct recipe {
    int nx, ny;     /* squares; n triangles = 2 nx ny, or 4 nx ny when crossed */
    int spacing;    /* side of a square in lattice steps, even */
    bool crossed;   /* both diagonals: every centre is a singular vertex, while nothing jitters */
    bool jitter;    /* each vertex moves by up to 2/5 of a square where triangles stay ccw */
    int flips;      /* random edge flips tried, for each triangle */
    int removals;   /* random triangles taken away, as long as vertices keep one fan */
    int components; /* 1 or 2: the whole again beside itself */
    bool shuffled;  /* vertex numbers, triangle order, first corners */
};

/* Fills the fields of *g up to `triangle` (degree as given, lattice 1 0 0, no depth), to be
 * followed by grid_build. Up to some thousand triangles; cost O(n^2). */
void triangulate(struct grid *g, const struct recipe *recipe, int degree, uint64_t seed);

/* A built grid by a random recipe of at most about 2 * size^2 * 4 triangles. */
void random_grid(struct grid *g, int size, int degree, uint64_t seed);

#endif
