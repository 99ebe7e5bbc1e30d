/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the cage crosses the lines of the grid is listed for each line and sorted; along a row,
 * inside and outside alternate at the crossings. The same lists, along rows and columns, tell which
 * edges of the grid the cage crosses. */
#include "icc_domain.h"

#include "mem.h"

#include <math.h>
#include <string.h>

#define PADDING  2
#define CELL_MIN 0x1p-36 /* of the largest coordinate: grid coordinates err by 2^-16 there */

static const double shift[2] = {0.0137, 0.0071};

/* Crossings of the lines of one direction: line l has at[start[l]] .. at[start[l + 1] - 1]. */
struct crossings {
    size_t *start;
    double *at;
};

static void bound(const double (*vertex)[2], size_t count, double low[2], double high[2]) {
    memcpy(low, vertex[0], 2 * sizeof *low);
    memcpy(high, vertex[0], 2 * sizeof *high);
    for (size_t i = 1; i < count; i++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], vertex[i][c]);
            high[c] = fmax(high[c], vertex[i][c]);
        }
}

static bool lay_out(struct icc_domain *d, const double low[2], const double high[2],
                    struct err *err) {
    double size[2], largest = 0;
    for (int c = 0; c < 2; c++) {
        size[c] = ceil((high[c] - low[c]) / d->h) + 2 * PADDING + 1;
        largest = fmax(largest, fmax(fabs(low[c]), fabs(high[c])));
    }
    if (d->h < CELL_MIN * largest)
        return err_set(err, ERR_REFUSAL,
                       "precision: cells of %.9g are too small for coordinates up to %.9g", d->h,
                       largest);
    if (!(size[0] * size[1] <= ICC_GRID_MAX))
        return err_set(err, ERR_REFUSAL,
                       "resolution: with cells of %.9g the grid has %.0f x %.0f vertices, more "
                       "than %d",
                       d->h, size[0], size[1], ICC_GRID_MAX);
    d->nx = (uint32_t)size[0];
    d->ny = (uint32_t)size[1];
    for (int c = 0; c < 2; c++) {
        d->centre[c] = low[c] + (high[c] - low[c]) / 2;
        d->middle[c] = (size[c] - 1) / 2 - shift[c];
    }
    return true;
}

/* Lines first..last - 1 are crossed by a side from coordinate a to b. */
static void crossed(double a, double b, size_t *first, size_t *last) {
    *first = (size_t)ceil(fmin(a, b));
    *last = (size_t)ceil(fmax(a, b));
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* axis 0: along rows (y is constant); axis 1: along columns. */
static bool cross_lines(const struct icc_domain *d, int axis, struct crossings *x,
                        struct err *err) {
    size_t lines = axis == 0 ? d->ny : d->nx, first, last;
    *x = (struct crossings){0};
    if (!mem_new(x->start, lines + 2, err)) return false;
    for (size_t i = 0; i < d->count; i++) {
        crossed(d->cage[i][!axis], d->cage[i + 1 < d->count ? i + 1 : 0][!axis], &first, &last);
        for (size_t l = first; l < last; l++) x->start[l + 2]++;
    }
    for (size_t l = 2; l < lines + 2; l++) x->start[l] += x->start[l - 1];
    if (!mem_new(x->at, x->start[lines + 1], err)) return false;
    for (size_t i = 0; i < d->count; i++) {
        const double *a = d->cage[i], *b = d->cage[i + 1 < d->count ? i + 1 : 0];
        double slope = (b[axis] - a[axis]) / (b[!axis] - a[!axis]);
        crossed(a[!axis], b[!axis], &first, &last);
        for (size_t l = first; l < last; l++)
            x->at[x->start[l + 1]++] = a[axis] + ((double)l - a[!axis]) * slope;
    }
    for (size_t l = 0; l < lines; l++)
        qsort(x->at + x->start[l], x->start[l + 1] - x->start[l], sizeof *x->at, compare);
    return true;
}

static void crossings_free(struct crossings *x) {
    free(x->start);
    free(x->at);
}

static void mark_inside(struct icc_domain *d, const struct crossings *rows) {
    for (uint32_t j = 0; j < d->ny; j++) {
        size_t at = rows->start[j], end = rows->start[j + 1];
        bool inside = false;
        for (uint32_t i = 0; i < d->nx; i++) {
            for (; at < end && rows->at[at] <= i; at++) inside = !inside;
            d->inside[j * d->nx + i] = inside;
            d->inside_count += inside;
        }
    }
}

/* Edges along one axis with both ends inside and a crossing between. */
static void find_cuts(struct icc_domain *d, int axis, const struct crossings *x) {
    uint32_t lines = axis == 0 ? d->ny : d->nx;
    uint32_t along = axis == 0 ? 1 : d->nx, across = axis == 0 ? d->nx : 1;
    for (uint32_t l = 0; l < lines; l++) {
        uint32_t before = UINT32_MAX;
        for (size_t at = x->start[l]; at < x->start[l + 1]; at++) {
            uint32_t i = (uint32_t)(ceil(x->at[at]) - 1), v = l * across + i * along;
            if (i != before && d->inside[v] && d->inside[v + along] && d->cut_count++ == 0) {
                d->cut[0] = v;
                d->cut[1] = v + along;
            }
            before = i;
        }
    }
}

static bool scan(struct icc_domain *d, struct err *err) {
    struct crossings rows = {0}, columns = {0};
    bool ok = cross_lines(d, 0, &rows, err) && cross_lines(d, 1, &columns, err);
    if (ok) {
        mark_inside(d, &rows);
        find_cuts(d, 0, &rows);
        find_cuts(d, 1, &columns);
    }
    crossings_free(&rows);
    crossings_free(&columns);
    return ok;
}

bool icc_domain_init(struct icc_domain *d, const double (*vertex)[2], size_t count, double h,
                     struct err *err) {
    double low[2], high[2];
    *d = (struct icc_domain){.h = h, .count = count};
    INVARIANT(h > 0 && count >= 3);
    bound(vertex, count, low, high);
    if (!lay_out(d, low, high, err) || !mem_new(d->cage, count, err) ||
        !mem_new(d->inside, icc_domain_size(d), err))
        return false;
    for (size_t i = 0; i < count; i++) icc_domain_to_grid(d, vertex[i], d->cage[i]);
    return scan(d, err);
}

void icc_domain_free(struct icc_domain *d) {
    free(d->cage);
    free(d->inside);
    *d = (struct icc_domain){0};
}

/* Steps to the nearest vertex outside, over edges of the grid: a pass upwards takes the best way
 * from the left and from below, a pass downwards the others (Rosenfeld and Pfaltz 1966). */
uint32_t icc_domain_burn(const struct icc_domain *d, uint32_t *layer) {
    uint32_t nx = d->nx, n = icc_domain_size(d), layers = 0;
    for (uint32_t v = 0; v < n; v++) {
        if (!d->inside[v]) {
            layer[v] = 0;
            continue;
        }
        layer[v] = 1 + (layer[v - 1] < layer[v - nx] ? layer[v - 1] : layer[v - nx]);
    }
    for (uint32_t v = n; v-- > 0;) {
        if (!d->inside[v]) continue;
        if (layer[v + 1] < layer[v]) layer[v] = layer[v + 1] + 1;
        if (layer[v + nx] < layer[v]) layer[v] = layer[v + nx] + 1;
        if (layer[v] > layers) layers = layer[v];
    }
    return layers;
}

/* Sums of coordinates, and the distances below times the count, are integers, exact in double as
 * long as they are below 2^53: for grids that are not a single file of millions of vertices. */
uint32_t icc_domain_last(const struct icc_domain *d, const uint32_t *layer, uint32_t layers) {
    uint32_t nx = d->nx, n = icc_domain_size(d), best = UINT32_MAX;
    double count = 0, sum[2] = {0, 0}, least = INFINITY;
    for (uint32_t v = 0; v < n; v++) {
        if (layer[v] != layers) continue;
        uint32_t i = v % nx, j = v / nx;
        count++;
        sum[0] += i;
        sum[1] += j;
    }
    for (uint32_t v = 0; v < n; v++) {
        if (layer[v] != layers) continue;
        uint32_t i = v % nx, j = v / nx;
        double x = count * i - sum[0], y = count * j - sum[1];
        if (x * x + y * y < least) {
            least = x * x + y * y;
            best = v;
        }
    }
    return best;
}

uint32_t icc_domain_nearest(const struct icc_domain *d, const double world[2]) {
    uint32_t n = icc_domain_size(d), best = UINT32_MAX;
    double p[2], least = INFINITY;
    icc_domain_to_grid(d, world, p);
    for (uint32_t v = 0; v < n; v++) {
        if (!d->inside[v]) continue;
        double q[2];
        icc_domain_vertex_grid(d, v, q);
        double x = q[0] - p[0], y = q[1] - p[1];
        if (x * x + y * y < least) {
            least = x * x + y * y;
            best = v;
        }
    }
    return best;
}
