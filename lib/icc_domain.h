/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_domain - the grid over a cage, and which of its vertices lie inside ([13] Algorithm 1).
 *
 * Grid coordinates: cells are unit squares, and vertex (i,j), 0 <= i < nx, 0 <= j < ny, has the
 * number j nx + i. Each cell is cut by the diagonal from (i,j) to (i+1,j+1):
 *
 *      j+1  *------*       world = centre + h (grid - middle)
 *           | up /  |
 *           |  /    |      h      side of a cell in world units
 *           |/  low |      centre of the cage's bounding box
 *       j   *------*       middle its place on the grid: half the grid, less (0.0137, 0.0071), so
 *           i     i+1             that sides of the cage do not lie on grid lines
 *
 * Around the bounding box are two cells of padding, so no vertex inside, and none that it is next
 * to, is on the border of the grid. Cage vertices are rounded to grid coordinates; what is inside
 * is inside of that polygon: even-odd, where a crossing at a vertex's height counts for the side
 * that goes up from there. */
#ifndef ICC_DOMAIN_H
#define ICC_DOMAIN_H

#include "err.h"

#include <stdint.h>

enum { ICC_GRID_MAX = 1 << 25 }; /* vertices of a grid */

struct icc_domain {
    double h, centre[2], middle[2];
    uint32_t nx, ny;
    size_t count;          /* of cage vertices */
    double (*cage)[2];     /* in grid coordinates */
    unsigned char *inside; /* nx ny flags */
    uint32_t inside_count;

    /* Grid edges with both ends inside that cross the cage: how many, and the first, from vertex
     * cut[0] to vertex cut[1]. If there is one, the grid is too coarse to have the cage's shape. */
    size_t cut_count;
    uint32_t cut[2];
};

/* A grid with cells of side h > 0 over a simple polygon. Refuses (ERR_REFUSAL) more than
 * ICC_GRID_MAX vertices, and cells so small that coordinates do not tell them apart. Freed by
 * icc_domain_free in any case. O(vertices of the grid + crossings of the cage with grid lines). */
bool icc_domain_init(struct icc_domain *d, const double (*vertex)[2], size_t count, double h,
                     struct err *err) WARN_UNUSED;
void icc_domain_free(struct icc_domain *d);

static inline uint32_t icc_domain_size(const struct icc_domain *d) {
    return d->nx * d->ny;
}

static inline void icc_domain_to_grid(const struct icc_domain *d, const double world[2],
                                      double grid[2]) {
    for (int c = 0; c < 2; c++) grid[c] = (world[c] - d->centre[c]) / d->h + d->middle[c];
}

static inline void icc_domain_to_world(const struct icc_domain *d, const double grid[2],
                                       double world[2]) {
    for (int c = 0; c < 2; c++) world[c] = d->centre[c] + d->h * (grid[c] - d->middle[c]);
}

static inline void icc_domain_vertex_grid(const struct icc_domain *d, uint32_t v, double grid[2]) {
    uint32_t i = v % d->nx, j = v / d->nx;
    grid[0] = i;
    grid[1] = j;
}

static inline void icc_domain_vertex(const struct icc_domain *d, uint32_t v, double world[2]) {
    double grid[2];
    icc_domain_vertex_grid(d, v, grid);
    icc_domain_to_world(d, grid, world);
}

/* The grassfire ([13] Algorithm 2): all that is outside burns, and each step burns the inside
 * vertices that have a burning neighbour to the left, right, below or above. layer[v] is the step,
 * from 1, and 0 outside; what it has room for is nx ny. Returns the number of steps. */
uint32_t icc_domain_burn(const struct icc_domain *d, uint32_t *layer);

/* Where the fire ends: of the last layer's vertices the one nearest to their centroid, of several
 * the lowest number. There is a vertex inside. */
uint32_t icc_domain_last(const struct icc_domain *d, const uint32_t *layer, uint32_t layers);

/* The vertex inside that is nearest to a point of the world, of several the lowest number. There is
 * one. */
uint32_t icc_domain_nearest(const struct icc_domain *d, const double world[2]);

#endif
