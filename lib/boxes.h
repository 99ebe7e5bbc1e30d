/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boxes - which of many boxes meet each other, or a given one: a binary tree of boxes.
 *
 * Items are put in the order of a space-filling curve (Morton), and the tree halves that sequence;
 * a node's box holds those of its items. Where boxes are no larger than they are far apart, pairs
 * cost O(n log n + pairs), and a query O(sqrt n) and what it finds. The answer and its order depend
 * on the boxes alone. */
#ifndef BOXES_H
#define BOXES_H

#include "err.h"

#include <stdint.h>

/* Closed: lo <= hi, finite. */
struct box {
    double lo[2], hi[2];
};

/* The least box. */
struct box box_of_points(uint32_t n, const double (*point)[2]);

static inline bool box_meets(const struct box *a, const struct box *b) {
    return a->lo[0] <= b->hi[0] && b->lo[0] <= a->hi[0] && a->lo[1] <= b->hi[1] &&
           b->lo[1] <= a->hi[1];
}

/* Makes a hold b. */
static inline void box_enlarge(struct box *a, const struct box *b) {
    for (int c = 0; c < 2; c++) {
        a->lo[c] = b->lo[c] < a->lo[c] ? b->lo[c] : a->lo[c];
        a->hi[c] = b->hi[c] > a->hi[c] ? b->hi[c] : a->hi[c];
    }
}

struct boxes {
    uint32_t count;
    uint32_t *item;   /* leaves, in order */
    struct box *node; /* 2 count - 1: a node, those below its first half, those below its second */
};

bool boxes_init(struct boxes *b, const struct box *box, uint32_t count,
                struct err *err) WARN_UNUSED;
void boxes_free(struct boxes *b); /* harmless on a zeroed struct */

/* Visits each two items whose boxes meet, once. A visitor that returns false ends it; returns
 * whether none did. */
bool boxes_pairs(const struct boxes *b, bool (*visit)(void *context, uint32_t i, uint32_t j),
                 void *context);

/* The same for the items whose boxes meet this one. */
bool boxes_query(const struct boxes *b, const struct box *box,
                 bool (*visit)(void *context, uint32_t i), void *context);

#endif
