/* SPDX-License-Identifier: GPL-3.0-or-later */
/* meet - do two Bezier arcs meet, or one itself? With proof.
 *
 * Pieces of the arcs are halved until each is monotone, each two that follow one another are so
 * together, and all others lie apart (arc.h); or until two are seen to cross, or to have a point in
 * common. In doubles as long as that decides, then in integers, so that it is exact about the
 * control points as they are.
 *
 * Arcs that touch without crossing, at parameters that are no simple fractions, cannot be decided
 * in this way, nor can arcs that leave their common end in the same direction. Then it is to be
 * shown that they come close: two points, not of the same place, within a stated distance. If the
 * arcs have no common end, and their distance is larger than the rule's bound, or if they have one
 * and leave it in different directions, or if a single arc has a derivative that nowhere vanishes,
 * then the verdict is reached, unless the work is limited. */
#ifndef MEET_H
#define MEET_H

#include "arc.h"
#include "err.h"

enum meet_pair {
    MEET_SELF,   /* a = b: one arc */
    MEET_JOINED, /* a ends where b begins; do they meet elsewhere? */
    MEET_APART,  /* no end of a is meant to be one of b */
};

enum meet_verdict {
    MEET_NOT,       /* proved */
    MEET_UNDECIDED, /* two points come within `distance` */
    MEET_CROSS,     /* A(s) = B(t) for some s, t within the intervals */
    MEET_POINT,     /* A(s) = B(t) where the intervals are single numbers */
};

struct meet_rule {
    double undecided; /* how near is undecided, relative to the extent of the two arcs; < 1 */
    size_t parts;     /* pairs of pieces in integers, afterwards it is undecided; 0: doubles only */
};

struct meet {
    enum meet_verdict verdict;
    mpq_t lo[2], hi[2]; /* unless MEET_NOT: intervals of s and t */
    double distance;    /* proved, rounded up; infinite if nothing is known */
};
void meet_init(struct meet *m);
void meet_free(struct meet *m);

/* Two arcs of degree d with these control points. Some 100 ns where they are mild and not close. */
void meet_arcs(int d, const double (*a)[2], const double (*b)[2], enum meet_pair pair,
               const struct meet_rule *rule, struct meet *m);

#endif
