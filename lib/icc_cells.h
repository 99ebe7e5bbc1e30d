/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_cells - the sides of a cage listed by the cells of its grid.
 *
 * Cell (i,j) has the number of its vertex (i,j) (icc_domain.h); its list holds every side that
 * meets the closed cell, and perhaps some that pass very near. */
#ifndef ICC_CELLS_H
#define ICC_CELLS_H

#include "icc_domain.h"

struct icc_cells {
    size_t *start;  /* nx ny + 1: cell c has side[start[c]] .. side[start[c + 1] - 1] */
    uint32_t *side; /* in rising order */
};

/* Freed by icc_cells_free in any case. O(vertices of the grid + cells that sides meet). */
bool icc_cells_init(struct icc_cells *c, const struct icc_domain *d, struct err *err) WARN_UNUSED;
void icc_cells_free(struct icc_cells *c);

#endif
