/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cages - pairs of cages for tests: a source and its deformed version, with as many vertices. */
#ifndef CAGES_H
#define CAGES_H

#include <stddef.h>
#include <stdint.h>

struct cage_pair {
    const char *name;
    size_t count;
    double (*source)[2], (*target)[2];
    double stretch; /* that parts may suffer on the way: rounding counts as often more */
    double back;    /* that a point may be off, there and back, over the diameter: 1e-12, but where
                       the target is so narrow that its doubles are further apart in the source */
};

enum { CAGE_PAIRS_QUICK = 16, CAGE_PAIRS = 18 }; /* the last two have many vertices */

/* Pair 0 .. CAGE_PAIRS - 1 of the shapes that a bijective map finds hard: a sharp quadrilateral, a
 * star, a blob with three legs, a spiral, combs, a dumbbell, necks of 1e-5, strips of 1:500,
 * collinear vertices, triangles. Counter-clockwise. */
void cage_pair_make(struct cage_pair *p, int i);

/* Two random simple polygons that have nothing in common but the number of vertices, low..high. */
void cage_pair_random(struct cage_pair *p, int low, int high, uint64_t seed);

/* The same vertices, beginning with number `shift`, and backwards if reversed. */
void cage_pair_turn(struct cage_pair *p, const struct cage_pair *from, size_t shift, int reversed);

void cage_pair_free(struct cage_pair *p);

#endif
