/* SPDX-License-Identifier: GPL-3.0-or-later */
/* balls - what the tests of integral curve coordinates are made on. */
#ifndef BALLS_H
#define BALLS_H

#include "icc_domain.h"

/* A simple polygon, counter-clockwise, of n vertices around the origin: star-shaped, radii between
 * 1 - roughness and 1. */
void random_cage(double (*vertex)[2], size_t n, double roughness, uint64_t *state);

/* A domain without cage: vertex (i,j) is inside where the bit of row j - 2, column i - 2 is set. */
void planted_domain(struct icc_domain *d, uint32_t columns, uint32_t rows,
                    const unsigned char *bits);

/* Are the inside vertices a ball: connected by edges of the grid, without holes, and no 2x2 block
 * has only a diagonal pair of them? */
bool is_ball(const struct icc_domain *d);

/* A random ball of at most `count` vertices in columns x rows, grown vertex by vertex. */
void random_ball(struct icc_domain *d, uint32_t columns, uint32_t rows, uint32_t count,
                 uint64_t *state);

#endif
