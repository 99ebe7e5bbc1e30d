/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "place.h"

#include <math.h>
#include <string.h>

struct frame frame_of_model(const struct grid *g) {
    struct frame f = {.has_depth = g->has_depth};
    memcpy(f.axes, g->axes, sizeof f.axes);
    memcpy(f.depth, g->depth, sizeof f.depth);
    return f;
}

struct frame frame_of_plane(void) {
    return (struct frame){.axes = {0, 1, 2}};
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

bool placer_init(struct placer *p, const struct grid *g, const struct frame *frame,
                 struct err *err) {
    *p = (struct placer){.frame = *frame};
    return locator_init(&p->locator, g, err);
}

void placer_free(struct placer *p) {
    locator_free(&p->locator);
}

bool placer_find(struct placer *p, const double point[3], struct place *place) {
    const struct frame *f = &p->frame;
    const double xy[2] = {point[f->axes[0]], point[f->axes[1]]};
    double z = point[f->axes[2]];
    place->triangle = GRID_NONE;
    if (f->has_depth && !(z >= f->depth[0] && z <= f->depth[1])) return false;
    return locate(&p->locator, xy, &p->hint, &place->triangle, place->b);
}
