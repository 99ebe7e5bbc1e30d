/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surround - a regular grid around a model ([11] 4.1).
 *
 * Kept are the cells of a pattern that meet the projection of the model's faces, lines and vertices
 * dilated by the margin, and as many more as it takes to leave one fan around each vertex of the
 * grid. Insides of polygons are those of non-zero winding. Every vertex of the model lies inside
 * the grid, which is checked exactly. */
#ifndef SURROUND_H
#define SURROUND_H

#include "lattice.h"
#include "model.h"
#include "pattern.h"

struct surround {
    enum pattern_kind kind;
    double margin;  /* world units, or negative: 0.05 of the larger extent */
    uint32_t cells; /* along the longer side of what is dilated */
    double cell;    /* side of a cell in world units; 0: by `cells` */
    bool flat;      /* no depth; else, unless *g has one, the model's extent plus margin */
    struct lattice_choice lattice;
};

enum { SURROUND_CELLS_MAX = 8000 };

struct surround_report {
    double margin, cell; /* as used, in world units */
    size_t kept, added;  /* cells that meet the model; cells added for the fans */
};

/* Completes *g, whose degree, axes and possibly depth are set, and builds it. Refuses a lattice too
 * coarse, a model without extent where that leaves no cell or no depth, and one that a given depth
 * does not hold. Near-linear in the size of the model and the number of cells. */
bool surround_grid(struct grid *g, const struct model *m, const struct surround *how,
                   struct surround_report *report, struct err *err) WARN_UNUSED;

#endif
