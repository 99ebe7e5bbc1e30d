/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A ray from p to the right meets an edge that has one end above p's height and the other at or
 * below it (so that a vertex at p's height counts once, or not at all where the loop only touches
 * it) exactly if p lies left of the edge taken upwards; predicate_orient says that without error.
 *
 * Only edges whose heights include p's matter. The box is cut into horizontal bands, and each band
 * lists the edges that reach into it:
 *
 *     band 2 ----------/\------------      fl((y - lo) * scale) grows with y also when rounded, so
 *     band 1 ---------/--\-----------      an edge that includes a height is listed in the band of
 *     band 0 --------/____\----------      that height: the bands lose nothing.
 *
 * There are as many bands as edges, or fewer where long edges would make the lists longer than
 * LIST_MAX edges times that. */
#include "polygon.h"

#include "mem.h"
#include "predicate.h"
#include "segment.h"

#include <string.h>

enum { LIST_MAX = 4 };

static void bound(struct polygon *g) {
    memcpy(g->lo, g->point[0], sizeof g->lo);
    memcpy(g->hi, g->point[0], sizeof g->hi);
    for (size_t i = 0; i < g->point_count; i++)
        for (int c = 0; c < 2; c++) {
            if (g->point[i][c] < g->lo[c]) g->lo[c] = g->point[i][c];
            if (g->point[i][c] > g->hi[c]) g->hi[c] = g->point[i][c];
        }
}

static void link_loops(struct polygon *g) {
    for (size_t l = 0; l < g->loop_count; l++) {
        for (size_t i = g->loop_start[l]; i + 1 < g->loop_start[l + 1]; i++) g->next[i] = i + 1;
        g->next[g->loop_start[l + 1] - 1] = g->loop_start[l];
    }
}

static size_t band_of(const struct polygon *g, double y) {
    double b = (y - g->lo[1]) * g->band_scale;
    if (!(b > 0)) return 0;
    return b < (double)(g->band_count - 1) ? (size_t)b : g->band_count - 1;
}

static void edge_bands(const struct polygon *g, size_t i, size_t *first, size_t *last) {
    double ya = g->point[i][1], yb = g->point[g->next[i]][1];
    *first = band_of(g, ya < yb ? ya : yb);
    *last = band_of(g, ya < yb ? yb : ya);
}

static void set_band_count(struct polygon *g, size_t n) {
    double height = g->hi[1] - g->lo[1];
    double scale = (double)n / height; /* inf, or 0 where the height overflows: one band then */
    g->band_scale = scale < 1e300 ? scale : 0;
    g->band_count = n;
}

/* Total length of the lists, or SIZE_MAX where it passes limit. */
static size_t list_length(const struct polygon *g, size_t limit) {
    size_t total = 0, first, last;
    for (size_t i = 0; i < g->point_count; i++) {
        edge_bands(g, i, &first, &last);
        total += last - first + 1;
        if (total > limit) return SIZE_MAX;
    }
    return total;
}

/* Counting sort of the edges by band; band_start serves as the places to fill, shifted by one. */
static void fill_bands(struct polygon *g) {
    size_t first, last;
    for (size_t i = 0; i < g->point_count; i++) {
        edge_bands(g, i, &first, &last);
        for (size_t b = first; b <= last; b++) g->band_start[b + 2]++;
    }
    for (size_t b = 2; b < g->band_count + 2; b++) g->band_start[b] += g->band_start[b - 1];
    for (size_t i = 0; i < g->point_count; i++) {
        edge_bands(g, i, &first, &last);
        for (size_t b = first; b <= last; b++) g->band_edge[g->band_start[b + 1]++] = i;
    }
}

bool polygon_build(struct polygon *g, struct err *err) {
    size_t length = SIZE_MAX, n = g->point_count;
    bound(g);
    if (!mem_new(g->next, n, err)) return false;
    link_loops(g);
    for (size_t bands = n; length == SIZE_MAX; bands = (bands + 1) / 2) {
        set_band_count(g, bands);
        length = list_length(g, LIST_MAX * n);
    }
    if (!mem_new(g->band_start, g->band_count + 2, err)) return false;
    if (!mem_new(g->band_edge, length, err)) return false;
    fill_bands(g);
    return true;
}

void polygon_free(struct polygon *g) {
    free(g->point);
    free(g->loop_start);
    free(g->band_start);
    free(g->band_edge);
    free(g->next);
    *g = (struct polygon){0};
}

static bool between(double x, double a, double b) {
    return a < b ? a <= x && x <= b : b <= x && x <= a;
}

int polygon_find(const struct polygon *g, const double p[2], size_t *edge) {
    bool inside = false;
    size_t band;
    if (!between(p[0], g->lo[0], g->hi[0]) || !between(p[1], g->lo[1], g->hi[1])) return -1;
    band = band_of(g, p[1]);
    for (size_t at = g->band_start[band]; at < g->band_start[band + 1]; at++) {
        size_t i = g->band_edge[at];
        const double *a = g->point[i], *b = g->point[g->next[i]];
        int side;
        if (!between(p[1], a[1], b[1]) || (p[0] > a[0] && p[0] > b[0])) continue;
        side = predicate_orient(a, b, p);
        if (side == 0 && between(p[0], a[0], b[0])) {
            *edge = i;
            return 0;
        }
        if ((a[1] > p[1]) != (b[1] > p[1]) && (side > 0) == (b[1] > a[1])) inside = !inside;
    }
    return inside ? 1 : -1;
}

int polygon_side(const struct polygon *g, const double p[2]) {
    size_t edge;
    return polygon_find(g, p, &edge);
}

/* Edges of several bands are met several times. */
bool polygon_near(const struct polygon *g, const double p[2], double limit, size_t *edge) {
    double best = limit * limit;
    bool found = false;
    if (!between(p[0], g->lo[0] - limit, g->hi[0] + limit) ||
        !between(p[1], g->lo[1] - limit, g->hi[1] + limit))
        return false;
    size_t end = g->band_start[band_of(g, p[1] + limit) + 1];
    for (size_t at = g->band_start[band_of(g, p[1] - limit)]; at < end; at++) {
        size_t i = g->band_edge[at];
        const double *a = g->point[i], *b = g->point[g->next[i]];
        double lambda, d;
        if ((p[0] < a[0] - limit && p[0] < b[0] - limit) ||
            (p[0] > a[0] + limit && p[0] > b[0] + limit))
            continue;
        d = segment_distance2(a, b, p, &lambda);
        if (d > best || (found && d == best && i >= *edge)) continue;
        found = true;
        best = d;
        *edge = i;
    }
    return found;
}

static bool precedes(const double a[2], const double b[2]) {
    return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
}

size_t polygon_lowest(const struct polygon *g, size_t loop) {
    size_t low = g->loop_start[loop];
    for (size_t i = low + 1; i < g->loop_start[loop + 1]; i++)
        if (precedes(g->point[i], g->point[low])) low = i;
    return low;
}

int polygon_sense(const struct polygon *g, size_t loop) {
    size_t low = polygon_lowest(g, loop);
    size_t before = low == g->loop_start[loop] ? g->loop_start[loop + 1] - 1 : low - 1;
    return predicate_orient(g->point[before], g->point[low], g->point[g->next[low]]);
}
