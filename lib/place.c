/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "place.h"

#include <math.h>
#include <string.h>

struct projection projection_of_model(const struct grid *g) {
    struct projection by = {.has_depth = g->has_depth};
    memcpy(by.axes, g->axes, sizeof by.axes);
    memcpy(by.depth, g->depth, sizeof by.depth);
    return by;
}

struct projection projection_of_plane(void) {
    return (struct projection){.axes = {0, 1, 2}};
}

void depth_weights(const double depth[2], double z, double a[2]) {
    double length = depth[1] - depth[0];
    if (isfinite(length)) {
        a[0] = (depth[1] - z) / length;
        a[1] = (z - depth[0]) / length;
    } else { /* halves of numbers this large are exact */
        length = depth[1] / 2 - depth[0] / 2;
        a[0] = (depth[1] / 2 - z / 2) / length;
        a[1] = (z / 2 - depth[0] / 2) / length;
    }
}

bool placer_init(struct placer *p, const struct grid *g, const struct projection *projection,
                 struct err *err) {
    *p = (struct placer){.projection = *projection};
    return locator_init(&p->locator, g, err);
}

void placer_free(struct placer *p) {
    locator_free(&p->locator);
}

bool placer_find(struct placer *p, const double point[3], struct place *place) {
    const struct projection *by = &p->projection;
    const double xy[2] = {point[by->axes[0]], point[by->axes[1]]};
    double z = point[by->axes[2]];
    place->triangle = GRID_NONE;
    if (by->has_depth && !(z >= by->depth[0] && z <= by->depth[1])) return false;
    return locate(&p->locator, xy, &p->hint, &place->triangle, place->b);
}
