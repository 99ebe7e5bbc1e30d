/* SPDX-License-Identifier: GPL-3.0-or-later */
/* checker - a checkerboard of unit squares, and its mean over parallelograms.
 *
 * The square [i,i+1) x [j,j+1) is even where i + j is. What a pixel shows is the mean over its
 * footprint, the parallelogram that the linearised map from picture to pattern makes of it: by
 * Green's theorem, in closed form, not by samples. */
#ifndef CHECKER_H
#define CHECKER_H

/* Footprints this long in one of the directions hold so many squares that the mean over the whole
 * board is returned: what is left of it then, at most a few hundredths, could only be seen as
 * moire. */
#define CHECKER_LONG 8

/* The share, 0..1, of odd squares in the parallelogram with the given centre that the vectors u and
 * v span. Exact up to rounding where the parallelogram is not longer than that; without area, that
 * of the centre. O(its length). */
double checker_share(const double centre[2], const double u[2], const double v[2]);

#endif
