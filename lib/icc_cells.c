/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Row by row of cells: the part of a side in the row spans an interval of columns. A margin far
 * above rounding errors, and far below a cell, keeps lists complete. */
#include "icc_cells.h"

#include "mem.h"

#include <math.h>

#define MARGIN 0x1p-20

/* Columns first..last of a side in row j. */
static void columns(const double a[2], const double b[2], double j, uint32_t *first,
                    uint32_t *last) {
    double low = fmin(a[0], b[0]), high = fmax(a[0], b[0]);
    double bottom = fmax(fmin(a[1], b[1]), j - MARGIN),
           top = fmin(fmax(a[1], b[1]), j + 1 + MARGIN);
    if (top - bottom < fabs(b[1] - a[1])) {
        double slope = (b[0] - a[0]) / (b[1] - a[1]);
        double x = a[0] + (bottom - a[1]) * slope, y = a[0] + (top - a[1]) * slope;
        low = fmax(low, fmin(x, y));
        high = fmin(high, fmax(x, y));
    }
    *first = (uint32_t)(low - MARGIN);
    *last = (uint32_t)(high + MARGIN);
}

/* Counts the cells of a side in start[cell + 2], or lists it there: start[cell + 1] says where. */
static void add_side(struct icc_cells *c, const struct icc_domain *d, uint32_t side, bool list) {
    const double *a = d->cage[side], *b = d->cage[side + 1 < d->count ? side + 1 : 0];
    uint32_t last_row = (uint32_t)(fmax(a[1], b[1]) + MARGIN), first, last;
    for (uint32_t j = (uint32_t)(fmin(a[1], b[1]) - MARGIN); j <= last_row; j++) {
        columns(a, b, j, &first, &last);
        for (uint32_t i = first; i <= last; i++) {
            uint32_t cell = j * d->nx + i;
            if (list)
                c->side[c->start[cell + 1]++] = side;
            else
                c->start[cell + 2]++;
        }
    }
}

bool icc_cells_init(struct icc_cells *c, const struct icc_domain *d, struct err *err) {
    uint32_t n = icc_domain_size(d), count = (uint32_t)d->count;
    *c = (struct icc_cells){0};
    if (!mem_new(c->start, (size_t)n + 2, err)) return false;
    for (uint32_t side = 0; side < count; side++) add_side(c, d, side, false);
    for (uint32_t cell = 0; cell < n; cell++) c->start[cell + 2] += c->start[cell + 1];
    if (!mem_new(c->side, c->start[n + 1], err)) return false;
    for (uint32_t side = 0; side < count; side++) add_side(c, d, side, true);
    return true;
}

void icc_cells_free(struct icc_cells *c) {
    free(c->start);
    free(c->side);
    *c = (struct icc_cells){0};
}
