/* SPDX-License-Identifier: GPL-3.0-or-later */
/* match - two cages given the same number of vertices, so that one can be the other's deformed
 * version: vertices are inserted on the sides of both, at corresponding arc lengths.
 *
 *      source  0-----------1-----2--------3     anchors 0:0 and 3:2
 *      target  0---------------1----------2
 *      both    0-----------1---2-3--------4     1 is inserted on the target, 2 on the source
 *
 * An anchor I:J says that vertex I of the source goes to vertex J of the target. Between two
 * anchors that follow each other, points correspond that divide the lengths of the two paths, from
 * anchor to anchor, in the same proportion. All given vertices are kept, bit for bit; those that
 * correspond but for rounding become one pair, and any other gets a partner, which is inserted.
 * Vertices are numbered in the order of the source, from its vertex 0.
 *
 * Lengths and inserted vertices are rounded, so these may lie beside their side, by an ulp. */
#ifndef MATCH_H
#define MATCH_H

#include "cage.h"

struct match_anchor {
    size_t vertex[2]; /* as given: of the source, of the target */
};

struct match {
    size_t count;
    double (*vertex[2])[2];
    uint32_t (*given)[2]; /* number of the given vertex, MATCH_INSERTED */
};

#define MATCH_INSERTED UINT32_MAX

/* Matches two lists of vertices, without sides of length 0; without an anchor, vertices 0 are one.
 * Anchors that name a vertex that does not exist are ERR_INPUT, those that contradict each other
 * ERR_REFUSAL. O(n + a log a). Freed by match_free in any case. */
bool match_init(struct match *m, const double (*const vertex[2])[2], const size_t count[2],
                const struct match_anchor *anchor, size_t anchor_count,
                struct err *err) WARN_UNUSED;
void match_free(struct match *m); /* harmless on a zeroed struct */

/* The same for cages, replacing both; the target becomes a deformed version of the source. */
bool match_cages(struct cage *source, struct cage *target, const struct match_anchor *anchor,
                 size_t anchor_count, struct err *err) WARN_UNUSED;

#endif
