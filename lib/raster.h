/* SPDX-License-Identifier: GPL-3.0-or-later */
/* raster - faces on a lattice of samples, none twice and none forgotten.
 *
 * The sample in column c of row r stands at (c + 1/2, r + 1/2); rows run downwards. Corners are
 * doubles and are meant as they stand: nothing is snapped, and which samples a triangle covers is
 * decided by exact signs. A sample on an edge counts as lying a hair to the right and, by much
 * less than that hair, down. So each sample near an edge or corner that triangles share belongs to
 * exactly one of them, and triangles without area have none.
 *
 * Whoever wants N x N samples a pixel multiplies coordinates by N. Pictures too large for that are
 * rendered in bands of rows. */
#ifndef RASTER_H
#define RASTER_H

#include "err.h"

#include <stdint.h>

/* The samples of one triangle, row by row:
 *
 *     raster_scan_begin(&s, corner, width, first_row, end_row);
 *     while (raster_scan_next(&s)) ... samples [s.begin, s.end) of s.row, never empty
 */
struct raster_scan {
    int turn; /* +1: corners go from x towards y (on the screen: clockwise); -1; 0: no area */
    uint32_t row, begin, end;
    /* private */
    const double *corner[3]; /* by falling height on the screen */
    uint32_t width, next_row, end_row;
};

/* Only samples in columns [0, width) and rows [first_row, end_row) are looked at; all at most 2^30.
 * The corners are borrowed while it goes on. Those that are not finite give no samples. O(rows). */
void raster_scan_begin(struct raster_scan *s, const double corner[3][2], uint32_t width,
                       uint32_t first_row, uint32_t end_row);
bool raster_scan_next(struct raster_scan *s);

/* A quantity given at the corners of a triangle with area, and linear between them. */
struct raster_plane {
    double origin[2], value, slope[2]; /* value + slope . (p - origin) */
    double least, most;                /* at the corners: thin triangles do not overshoot */
};
void raster_plane_set(struct raster_plane *plane, const double corner[3][2], const double value[3]);

static inline double raster_plane_at(const struct raster_plane *plane, double x, double y) {
    double value = plane->value + plane->slope[0] * (x - plane->origin[0]) +
                   plane->slope[1] * (y - plane->origin[1]);
    return value < plane->least ? plane->least : value > plane->most ? plane->most : value;
}

/* Who is seen: for each sample of a band of rows, the face nearest to the eye. */
struct raster {
    uint32_t width, height;   /* samples of the whole picture */
    uint32_t first_row, rows; /* of the band */
    uint32_t *face;           /* [(row - first_row) * width + column]; RASTER_NONE */
    double *nearness;         /* of that face; where there is none, -infinity */
    uint32_t room;            /* private: rows that there is room for */
};
#define RASTER_NONE UINT32_MAX

/* Room for bands of about as many rows as take `samples` in all: whole groups of `unit` rows, at
 * least one group, at most the picture, whose height is a multiple of `unit`. */
bool raster_init(struct raster *r, uint32_t width, uint32_t height, uint32_t unit, size_t samples,
                 struct err *err) WARN_UNUSED;
void raster_free(struct raster *r); /* harmless on a zeroed struct */

/* Goes to the next band and empties it; the first one at first. False: there is no more.
 *
 *     while (raster_next_band(&r)) { raster_draw all faces; look at r.face; }
 */
bool raster_next_band(struct raster *r);

/* Draws a face; `near` grows towards the eye, and of the same nearness the last one drawn is seen.
 * NULL: 0 everywhere. Returns its turn, as in raster_scan. */
int raster_draw(struct raster *r, uint32_t face, const double corner[3][2], const double near[3]);

#endif
