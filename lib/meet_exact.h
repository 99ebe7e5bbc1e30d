/* SPDX-License-Identifier: GPL-3.0-or-later */
/* meet_exact - meet.h's search in integers. */
#ifndef MEET_EXACT_H
#define MEET_EXACT_H

#include "meet.h"

struct meet_exact {
    int d;
    enum meet_pair pair;
    const struct meet_rule *rule;
    struct meet *m;
    struct arc_integers whole[2];
    int exponent;    /* coordinates are integers times 2^exponent */
    mpz_t near;      /* extent of the arcs times what is undecided ... */
    mp_bitcnt_t cut; /* ... times 2^cut */
    size_t parts;
};

void meet_exact_init(struct meet_exact *x, int d, const double (*a)[2], const double (*b)[2],
                     enum meet_pair pair, const struct meet_rule *rule, struct meet *m);
void meet_exact_free(struct meet_exact *x);

/* Pieces index .. index + 1 over 2^level of both arcs. */
struct meet_pieces {
    int level[2];
    uint64_t index[2];
};

/* Do these pieces meet, as a `question` of that kind? m->verdict goes up at most. */
void meet_exact_ask(struct meet_exact *x, enum meet_pair question,
                    const struct meet_pieces *pieces);

/* They cross: shortens the intervals. */
void meet_exact_refine(struct meet_exact *x, const struct meet_pieces *pieces);

#endif
