/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles_suggest - where derived points would like to go ([14] 5.1, decles.md step 5).
 *
 *      p' = p + theta v,   theta = far/(near+far)
 *
 * near: graph distance in the global net to the nearest anchor; far: to the nearest point outside A
 * and D. theta = 1 if no such point can be reached, 0 if no anchor can. Several anchors at the same
 * distance: the mean of what the motion of each suggests. A wish overrides. */
#ifndef DECLES_SUGGEST_H
#define DECLES_SUGGEST_H

#include "decles_sets.h"

/* A breadth-first search: what was reached, in the order of distance. */
struct decles_search {
    struct decles_visit *visit;
    size_t count, cap;
};

/* Working memory, all private. */
struct decles_suggester {
    struct decles_search near, far;
    uint32_t *nearest; /* the nearest anchors of all visits, as indices into edit.anchor */
    size_t nearest_count, nearest_cap;
    struct decles_known_turn *turn; /* a cache */
};

bool decles_suggester_init(struct decles_suggester *s, struct err *err) WARN_UNUSED;
void decles_suggester_free(struct decles_suggester *s); /* harmless on a zeroed struct */

/* Fills suggested (derived_count x k, row-major); of `sets` it changes marks, and puts them back.
 * Cost: O(|A| + |D|) and the points that are nearer to an anchor than the last of D is; times the
 * number of nearest anchors where there are several motions. */
bool decles_suggest(struct decles_suggester *s, struct decles_sets *sets,
                    const struct decles_edit *edit, const struct c1_field *values,
                    double *suggested, struct err *err) WARN_UNUSED;

#endif
