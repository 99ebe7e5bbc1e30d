/* SPDX-License-Identifier: GPL-3.0-or-later */
/* snap - points of the plane moved to the nearest points of a lattice.
 *
 * The lattice's origin is the low corner of the points' box, rounded to a multiple of the step.
 * Whether a figure survives the move is for others to check, exactly, on the lattice coordinates;
 * snap_refuse words what they find. */
#ifndef SNAP_H
#define SNAP_H

#include "err.h"
#include "lattice.h"

struct snap {
    struct lattice_choice choice;
    struct lattice lattice;
    double span; /* longer side of the box */
    size_t count;
    int32_t (*at)[2]; /* lattice coordinates of the points */
};

/* Snaps n >= 1 points, n < 2^32 - 1. Refuses a given step that is too fine for the bits. */
bool snap_init(struct snap *s, const struct lattice_choice *choice, const double (*point)[2],
               size_t n, struct err *err) WARN_UNUSED;
void snap_free(struct snap *s);

/* Refuses points that coincide: as given, or after snapping. */
bool snap_check_distinct(const struct snap *s, const double (*point)[2],
                         struct err *err) WARN_UNUSED;

/* World position of lattice coordinates, rounded. */
void snap_world(const struct snap *s, const int32_t at[2], double world[2]);

/* "lattice too coarse: WHAT; try --lattice .." with a finer one. Always false. */
bool snap_refuse(const struct snap *s, struct err *err, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
