/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rectangle.h"

#include <math.h>

static double larger(double a, double b) {
    return a > b ? a : b;
}

bool rectangle_grid(struct grid *g, const struct rectangle *r, struct err *err) {
    double span = larger(r->high[0] - r->low[0], r->high[1] - r->low[1]), far = 0, origin[2], step;
    int32_t zero[2] = {0, 0}, size[2];
    struct pattern pattern;
    bool ok;
    for (int c = 0; c < 2; c++) far = larger(far, larger(fabs(r->low[c]), fabs(r->high[c])));
    if (!isfinite(span)) return err_set(err, ERR_REFUSAL, "the rectangle is too large");
    if (!lattice_step(&r->lattice, span, far, &step, err)) return false;
    for (int c = 0; c < 2; c++) {
        origin[c] = lattice_nearest(r->low[c], step);
        size[c] = (int32_t)rint((r->high[c] - origin[c]) / step);
    }
    if (!pattern_init(&pattern, r->kind, r->cells, zero, size, err)) return false;
    g->lattice = (struct lattice){step, origin[0], origin[1]};
    ok = pattern_triangulate(&pattern, NULL, g, err);
    pattern_free(&pattern);
    return ok;
}
