/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cage_fill - points of a regular lattice well inside a cage.
 *
 * The lattice is triangular:
 *
 *       .   .   .   .       spacing h in a row, sqrt(3)/2 h between rows
 *     .   .   .   .
 *       .   .   .   .
 *
 * It moves with the cage, so that a similarity of the cage is one of the points, up to rounding:
 * the area centroid is a point of it, and its rows make a fixed angle with an axis, that of the
 * cage's inertia, or where all axes are as good, of that of its sides, each with a weight given for
 * it (the longer principal axis; any, where that is not unique either). That angle is none at which
 * a symmetric cage has points that are as near to four points of the lattice as to each other.
 */
#ifndef CAGE_FILL_H
#define CAGE_FILL_H

#include "cage.h"

/* The points inside that have no side nearer than `clearance`, row by row; rounded. weight: of each
 * side, > 0; NULL: all are the same. The caller frees *point on success. O(points + (perimeter /
 * spacing + sides) log sides) and room for a row; so a spacing far below the perimeter is for the
 * caller to avoid. Points beyond `limit` are refused. */
bool cage_fill(const struct cage *c, const double *weight, double spacing, double clearance,
               size_t limit, double (**point)[2], size_t *count, struct err *err) WARN_UNUSED;

#endif
