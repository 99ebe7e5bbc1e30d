/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lists are made as in a counting sort: two passes over the items, lengths of the lists, then
 * the lists. */
#include "cells.h"

#include "mem.h"

#include <math.h>

enum { PAIRS_PER_ITEM = 64 }; /* with more, larger cells are taken: needles cross many */

/* The cells of an item's bounding box: columns first[0]..last[0], rows first[1]..last[1]. */
static void range_of(const struct cells_raster *r, const struct cells_items *items, uint32_t i,
                     uint32_t first[2], uint32_t last[2]) {
    double lo[2], hi[2];
    items->box(items->context, i, lo, hi);
    for (int axis = 0; axis < 2; axis++) {
        first[axis] = cells_column(r, axis, lo[axis]);
        last[axis] = cells_column(r, axis, hi[axis]);
    }
}

/* The number of pairs of an item and a cell of its bounding box. */
static uint64_t count_pairs(const struct cells_raster *r, const struct cells_items *items) {
    uint64_t n = 0;
    for (uint32_t i = 0; i < items->count; i++) {
        uint32_t first[2], last[2];
        range_of(r, items, i, first, last);
        n += (uint64_t)(last[0] - first[0] + 1) * (last[1] - first[1] + 1);
    }
    return n;
}

/* Chooses square cells, in all about `cells`, over the bounding box. */
static void choose(struct cells_raster *r, double cells) {
    const double extent[2] = {r->hi[0] - r->lo[0], r->hi[1] - r->lo[1]};
    for (int axis = 0; axis < 2; axis++) {
        double n = ceil(sqrt(cells * (extent[axis] / extent[1 - axis])));
        r->size[axis] = n >= 1 && cells >= 1 ? (uint32_t)fmin(n, fmin(cells, INT32_MAX)) : 1;
        r->scale[axis] = r->size[axis] / extent[axis];
        if (r->scale[axis] > 0 && isfinite(r->scale[axis])) continue;
        r->size[axis] = 1; /* too large or too small for a scale */
        r->scale[axis] = 0;
    }
}

/* The ends of column (row) number i: a column is off by less than 2^-19 of a cell, an end as
 * computed here by some ulps of its own magnitude. Infinite, so that nothing misses it, where there
 * is one column without a scale. */
static void ends(const struct cells_raster *r, int axis, uint32_t i, double end[2]) {
    for (int k = 0; k < 2; k++) {
        double from_lo = (i + (k ? 1 + 0x1p-16 : -0x1p-16)) / r->scale[axis];
        double slack = 0x1p-50 * (fabs(r->lo[axis]) + fabs(from_lo));
        end[k] = r->lo[axis] + from_lo + (k ? slack : -slack);
    }
}

void cells_rectangle(const struct cells_raster *r, size_t c, double x[2], double y[2]) {
    ends(r, 0, (uint32_t)(c % r->size[0]), x);
    ends(r, 1, (uint32_t)(c / r->size[0]), y);
}

/* Counts item i in the lists of its cells, or with `put` puts it there. */
static void visit(struct cells *c, const struct cells_items *items, uint32_t i, bool put) {
    const struct cells_raster *r = &c->raster;
    uint32_t first[2], last[2];
    range_of(r, items, i, first, last);
    for (uint32_t row = first[1]; row <= last[1]; row++) {
        double x[2], y[2];
        ends(r, 1, row, y);
        for (uint32_t column = first[0]; column <= last[0]; column++) {
            uint32_t *at = &c->start[(size_t)row * r->size[0] + column + 1];
            ends(r, 0, column, x);
            if (items->misses(items->context, i, x, y)) continue;
            if (put) c->item[*at] = i;
            ++*at;
        }
    }
}

static void fill(struct cells *c, const struct cells_items *items, size_t cells) {
    uint32_t sum = 0;
    for (uint32_t i = 0; i < items->count; i++) visit(c, items, i, false);
    for (size_t k = 0; k < cells; k++) { /* where list k begins */
        uint32_t n = c->start[k + 1];
        c->start[k + 1] = sum;
        sum += n;
    }
    for (uint32_t i = 0; i < items->count; i++) visit(c, items, i, true);
}

bool cells_init(struct cells *c, const double lo[2], const double hi[2],
                const struct cells_items *items, double density, const char *name,
                struct err *err) {
    double wanted = (double)items->count * density;
    uint64_t pairs;
    size_t n;
    *c = (struct cells){.raster = {.lo = {lo[0], lo[1]}, .hi = {hi[0], hi[1]}}};
    for (;; wanted /= 4) {
        choose(&c->raster, wanted);
        pairs = count_pairs(&c->raster, items);
        if (pairs <= (uint64_t)items->count * PAIRS_PER_ITEM || wanted < 1) break;
    }
    if (pairs > UINT32_MAX) return err_set(err, ERR_INPUT, "too many %s to locate points", name);
    n = (size_t)c->raster.size[0] * c->raster.size[1];
    if (mem_new(c->start, n + 1, err) && mem_new(c->item, (size_t)pairs, err)) {
        fill(c, items, n);
        return true;
    }
    cells_free(c);
    return false;
}

void cells_free(struct cells *c) {
    free(c->start);
    free(c->item);
    *c = (struct cells){0};
}
