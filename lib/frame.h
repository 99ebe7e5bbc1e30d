/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frame - from the grid's frame (x, y, depth) to the axes of the model.
 *
 * The planes yx, xz and zy permute the axes oddly: the model's frame is then a mirror image of the
 * grid's, and what is counter-clockwise in one is clockwise in the other. */
#ifndef FRAME_H
#define FRAME_H

#include "grid.h"

/* The point (x, y, depth) of the grid's frame as model coordinates. */
static inline void frame_to_model(const struct grid *g, double x, double y, double depth,
                                  double model[3]) {
    model[g->axes[0]] = x;
    model[g->axes[1]] = y;
    model[g->axes[2]] = depth;
}

/* Is the model's frame a mirror image of the grid's? */
static inline bool frame_is_mirrored(const struct grid *g) {
    return (g->axes[0] + 1) % 3 != g->axes[1];
}

#endif
