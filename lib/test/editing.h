/* SPDX-License-Identifier: GPL-3.0-or-later */
/* editing - a spline under edit in a test, with the checks that every edit must pass. */
#ifndef EDITING_H
#define EDITING_H

#include "decles.h"

#include "testing.h"

struct editing {
    struct grid g;
    double *q, *old; /* point_count x 2: now, and before the last edit */
    double magnitude;
    struct decles_editor *editor;
    struct decles_report report;
    struct err err;
    uint64_t seed;
};

/* The identity on g, whose ownership moves here. */
void editing_begin(struct editing *s, struct grid *g, int continuity, double max_gain,
                   uint64_t seed);
void editing_end(struct editing *s);

/* Applies an edit to k components, keeping the old positions. On success: nothing but A and D has
 * changed, by a single bit; anchors are where they should be; E is what touches A or D. On failure:
 * nothing has changed at all. */
bool editing_apply(struct editing *s, const struct decles_edit *edit, int k);

/* One anchor displaced by (dx, dy). */
bool editing_move(struct editing *s, uint32_t p, double dx, double dy);

/* Puts the old positions back. */
void editing_undo(struct editing *s);

/* All conditions hold: within 1e-13 of the magnitude of the coordinates, and as step 0 wants them.
 */
void editing_check_c1(const struct editing *s);

/* Compares the solution with dense long double least squares, to 1e-12 of the magnitude. */
void editing_check_solution(const struct editing *s, const double *weight, int k);

/* n points, no two the same, with equal chances. */
void random_points(const struct grid *g, uint64_t *seed, uint32_t *points, size_t n);

#endif
