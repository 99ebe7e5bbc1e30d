/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lattice - world coordinates of rational lattice points, rounded correctly. */
#ifndef LATTICE_H
#define LATTICE_H

#include <stdbool.h>
#include <stdint.h>

/* The double nearest to the real number origin + step*n/d, ties to even; an exact zero is +0.
 * |n| < 2^53, 1 <= d < 2^53, origin and step finite. About 15 ns where double-double arithmetic
 * decides the rounding, else a microsecond. */
double lattice_coordinate(double origin, double step, int64_t n, int d);

#endif
