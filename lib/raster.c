/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of samples crosses two edges of a triangle, or none: an edge from a down to b is crossed by
 * the rows with ay <= y < by. For each of them there is a first sample, the leftmost that lies on
 * the edge or to the right of it:
 *
 *            a
 *     .  .  /#  #  #  #            # the samples from `first` on
 *     .  . / #  #  #  #
 *     .  ./  #  #  #  #
 *        b
 *
 * What is covered lies between the first samples of the two edges: [first(left), first(right)). As
 * the first sample of an edge and a row depends on nothing else, triangles on both sides of an edge
 * fit together. It is guessed in doubles and settled by the exact predicate. */
#include "raster.h"

#include "mem.h"
#include "predicate.h"

#include <math.h>

static void swap(const double **a, const double **b) {
    const double *c = *a;
    *a = *b;
    *b = c;
}

/* The first row, of [low, high], whose samples have y >= this. */
static uint32_t row_from(double y, uint32_t low, uint32_t high) {
    double row = ceil(y - 0.5);
    return row > low ? (row < high ? (uint32_t)row : high) : low;
}

void raster_scan_begin(struct raster_scan *s, const double corner[3][2], uint32_t width,
                       uint32_t first_row, uint32_t end_row) {
    *s = (struct raster_scan){.corner = {corner[0], corner[1], corner[2]}, .width = width};
    for (int c = 0; c < 3; c++)
        if (!isfinite(corner[c][0]) || !isfinite(corner[c][1])) return;
    s->turn = predicate_orient(corner[0], corner[1], corner[2]);
    if (s->turn == 0) return;
    if (s->corner[0][1] > s->corner[1][1]) swap(&s->corner[0], &s->corner[1]);
    if (s->corner[1][1] > s->corner[2][1]) swap(&s->corner[1], &s->corner[2]);
    if (s->corner[0][1] > s->corner[1][1]) swap(&s->corner[0], &s->corner[1]);
    s->next_row = row_from(s->corner[0][1], first_row, end_row);
    s->end_row = row_from(s->corner[2][1], s->next_row, end_row);
}

/* Does the sample lie on the edge from a down to b, or right of it? */
static bool is_right(const double *a, const double *b, uint32_t column, double y) {
    const double sample[2] = {column + 0.5, y};
    return predicate_orient(a, b, sample) <= 0;
}

/* The first sample of an edge, by bisection: where the guess is far off. */
static uint32_t search(const double *a, const double *b, uint32_t width, double y) {
    uint32_t low = 0, high = width; /* not right: before low; right: from high on */
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (is_right(a, b, middle, y))
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

static uint32_t first_sample(const double *a, const double *b, uint32_t width, double y) {
    double x = ceil(a[0] + (y - a[1]) * ((b[0] - a[0]) / (b[1] - a[1])) - 0.5);
    uint32_t guess = !(x > 0) ? 0 : x < width ? (uint32_t)x : width;
    if (guess < width && !is_right(a, b, guess, y)) return search(a, b, width, y);
    if (guess > 0 && is_right(a, b, guess - 1, y)) return search(a, b, width, y);
    return guess;
}

bool raster_scan_next(struct raster_scan *s) {
    const double *const *c = s->corner;
    while (s->next_row < s->end_row) {
        double y = s->next_row + 0.5;
        bool upper = y < c[1][1];
        uint32_t one = first_sample(c[0], c[2], s->width, y);
        uint32_t other = first_sample(c[upper ? 0 : 1], c[upper ? 1 : 2], s->width, y);
        s->row = s->next_row++;
        s->begin = one < other ? one : other;
        s->end = one < other ? other : one;
        if (s->begin < s->end) return true;
    }
    return false;
}

void raster_plane_set(struct raster_plane *plane, const double corner[3][2],
                      const double value[3]) {
    double x1 = corner[1][0] - corner[0][0], y1 = corner[1][1] - corner[0][1];
    double x2 = corner[2][0] - corner[0][0], y2 = corner[2][1] - corner[0][1];
    double v1 = value[1] - value[0], v2 = value[2] - value[0], area = x1 * y2 - x2 * y1;
    *plane = (struct raster_plane){.origin = {corner[0][0], corner[0][1]},
                                   .value = value[0],
                                   .least = fmin(value[0], fmin(value[1], value[2])),
                                   .most = fmax(value[0], fmax(value[1], value[2]))};
    if (area == 0) return; /* underflow */
    plane->slope[0] = (v1 * y2 - v2 * y1) / area;
    plane->slope[1] = (v2 * x1 - v1 * x2) / area;
}

bool raster_init(struct raster *r, uint32_t width, uint32_t height, uint32_t unit, size_t samples,
                 struct err *err) {
    size_t groups = samples / width / unit, n;
    *r = (struct raster){.width = width, .height = height};
    r->room = unit * (groups < 1 ? 1 : groups < height / unit ? (uint32_t)groups : height / unit);
    n = (size_t)r->room * width;
    r->face = mem_alloc_unset(n, sizeof *r->face, err);
    r->nearness = mem_alloc_unset(n, sizeof *r->nearness, err);
    if (r->face && r->nearness) return true;
    raster_free(r);
    return false;
}

void raster_free(struct raster *r) {
    free(r->face);
    free(r->nearness);
    *r = (struct raster){0};
}

bool raster_next_band(struct raster *r) {
    size_t n;
    r->first_row += r->rows;
    if (r->first_row >= r->height) return false;
    r->rows = r->height - r->first_row < r->room ? r->height - r->first_row : r->room;
    n = (size_t)r->rows * r->width;
    for (size_t i = 0; i < n; i++) {
        r->face[i] = RASTER_NONE;
        r->nearness[i] = -INFINITY;
    }
    return true;
}

int raster_draw(struct raster *r, uint32_t face, const double corner[3][2], const double near[3]) {
    struct raster_plane plane = {.value = 0};
    struct raster_scan s;
    raster_scan_begin(&s, corner, r->width, r->first_row, r->first_row + r->rows);
    if (s.turn != 0 && near) raster_plane_set(&plane, corner, near);
    while (raster_scan_next(&s)) {
        size_t row = (size_t)(s.row - r->first_row) * r->width;
        for (uint32_t c = s.begin; c < s.end; c++) {
            double z = raster_plane_at(&plane, c + 0.5, s.row + 0.5);
            if (!(z >= r->nearness[row + c])) continue;
            r->face[row + c] = face;
            r->nearness[row + c] = z;
        }
    }
    return s.turn;
}
