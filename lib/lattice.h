/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lattice - world coordinates of rational lattice points, rounded correctly; the choice of a
 * lattice. */
#ifndef LATTICE_H
#define LATTICE_H

#include "err.h"
#include "predicate.h"

/* The double nearest to the real number origin + step*n/d, ties to even; an exact zero is +0.
 * |n| < 2^53, 1 <= d < 2^53, origin and step finite. About 15 ns where double-double arithmetic
 * decides the rounding, else a microsecond. */
double lattice_coordinate(double origin, double step, int64_t n, int d);

/* How to choose a step: 0 is the smallest power of two by which coordinates take fewer than
 * 2^bits steps, and by which they are doubles; else the step itself. */
struct lattice_choice {
    double step;
    int bits; /* 1..24 */
};

/* The step for a rectangle of this span (its longer side) whose coordinates are at most `far` in
 * magnitude. Refuses a given step that needs more bits. */
bool lattice_step(const struct lattice_choice *choice, double span, double far, double *step,
                  struct err *err) WARN_UNUSED;

/* The multiple of a power of two that is nearest to x. (Of other steps, a product rounded.) */
double lattice_nearest(double x, double step);

#endif
