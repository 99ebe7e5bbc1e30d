/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rectangle.h"

#include <math.h>

static double larger(double a, double b) {
    return a > b ? a : b;
}

/* Cells as regular as whole numbers let, n along the longer side. Rows of hex are 13/15 as high as
 * wide, like those of surround. (Both extents infinite: 1 cell; the span is refused elsewhere.) */
static void regular_cells(const double extent[2], uint32_t n, enum pattern_kind kind,
                          uint32_t cells[2]) {
    double longer = larger(extent[0], extent[1]);
    double rows = kind == PATTERN_HEX ? n * 15.0 / 13 : n;
    cells[0] = (uint32_t)larger(rint(extent[0] / longer * n), 1);
    cells[1] = (uint32_t)larger(rint(extent[1] / longer * rows), 1);
}

bool rectangle_grid(struct grid *g, const struct rectangle *r, struct err *err) {
    const double extent[2] = {r->high[0] - r->low[0], r->high[1] - r->low[1]};
    double span = larger(extent[0], extent[1]), far = 0, origin[2], step;
    uint32_t cells[2] = {r->cells[0], r->cells[1]};
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
    if (cells[1] == 0) regular_cells(extent, cells[0], r->kind, cells);
    if (!pattern_init(&pattern, r->kind, cells, zero, size, err)) return false;
    g->lattice = (struct lattice){step, origin[0], origin[1]};
    ok = pattern_triangulate(&pattern, NULL, g, err);
    pattern_free(&pattern);
    return ok;
}
