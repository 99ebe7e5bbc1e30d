/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "spline.h"

#include "mem.h"

bool spline_allocate(struct spline *s, struct grid *g, struct err *err) {
    uint32_t n = g->point_count;
    *s = (struct spline){.grid = *g};
    *g = (struct grid){0};
    if (mem_new(s->phi, n, err) && (!s->grid.has_depth || mem_new(s->sigma, n, err))) return true;
    spline_free(s);
    return false;
}

bool spline_identity(struct spline *s, struct grid *g, struct err *err) {
    uint32_t n = g->point_count;
    if (!spline_allocate(s, g, err)) return false;
    grid_nominals(&s->grid, s->phi);
    for (uint32_t p = 0; p < n && s->sigma; p++) {
        s->sigma[p][0] = s->grid.depth[0];
        s->sigma[p][1] = s->grid.depth[1];
    }
    return true;
}

void spline_free(struct spline *s) {
    grid_free(&s->grid);
    free(s->phi);
    free(s->sigma);
    *s = (struct spline){0};
}
