/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles - one edit of a C1 spline by constrained least squares: steps 0-7 of decles.md.
 *
 * Anchors A get new positions; slaves S may move; derived points D (slaves and what the types of
 * A and S demand, [14] figure 13) follow so that the conditions E, those that touch A or D, stay
 * true, and come as near as possible to suggested positions p' ([14] 5.1). Points outside A and D
 * do not change by a bit. phi (k = 2 columns), sigma0 and sigma1 (k = 1) are edited by separate
 * calls. Cost: proportional to |A| + |D| + |E|, never to the size of the grid. */
#ifndef DECLES_H
#define DECLES_H

#include "c1.h"

enum decles_kind { DECLES_TRANSLATE, DECLES_ROTATE, DECLES_SCALE };

/* How a statement moves its anchors (theta = 1) and what it suggests for derived points (theta <
 * 1): p' = p + theta by;  turn by theta*degrees about `centre`;  scale by factor^theta about
 * `centre`. */
struct decles_motion {
    enum decles_kind kind;
    double by[2], centre[2], degrees, factor;
};

struct decles_anchor {
    uint32_t point, motion; /* motion: index into decles_edit.motion */
    double to[2];           /* its new position */
};

struct decles_wish { /* `suggest`: overrides p' of a slave */
    uint32_t point;
    double to[2];
};

struct decles_edit {
    size_t anchor_count, slave_count, motion_count, wish_count;
    const struct decles_anchor *anchor;
    const uint32_t *slave; /* duplicates, anchors and pinned points among them are ignored */
    const struct decles_motion *motion;
    const struct decles_wish *wish; /* their points count as slaves */
    double share; /* 0 < share < 1: p' is held back to this share of its way; 0 stands for 1 */
};

/* What one edit did; the arrays are borrowed until the next call on the same editor. */
struct decles_report {
    size_t anchors, slaves, derived, conditions; /* |A| |S| |D| |E| */
    size_t rank, redundant, added;               /* of A_D; rows dropped; points added by step 3 */
    double residual;     /* largest of E afterwards, relative to its terms */
    double displacement; /* largest of D */
    double gain;         /* the same over the largest displacement asked for: of anchors to their
                            new positions, of D to p' */
    bool by_qr;
    const uint32_t *derived_point; /* D */
    const double *suggested;       /* p' of each, k columns */
    const double *before;          /* where each was, k columns: what an undo needs */
    const uint64_t *condition;     /* E, as numbers e*d + m */
};

struct decles_editor; /* working memory of O(points), allocated once for many edits */

struct decles_options {
    int continuity;  /* 1, or 0: no conditions, D = S */
    double max_gain; /* e.g. 100: refused beyond; what rounding of E (64 u) may move is allowed */
};

/* The grid is borrowed. Refused if degree < 5 with continuity 1. */
struct decles_editor *decles_new(const struct grid *g, const struct decles_options *options,
                                 struct err *err) WARN_UNUSED;
void decles_free(struct decles_editor *editor);

/* Pinned points never move; weights count in the least squares, default 1. Both last. */
void decles_pin(struct decles_editor *editor, uint32_t p, bool pinned);
bool decles_is_pinned(const struct decles_editor *editor, uint32_t p);
void decles_weigh(struct decles_editor *editor, uint32_t p, double weight);

/* Applies the edit to k components q[stride*p + c], c < k. All or nothing: on failure q is
 * unchanged and err (ERR_REFUSAL) names points and conditions. */
bool decles_apply(struct decles_editor *editor, double *q, size_t stride, int k,
                  const struct decles_edit *edit, struct decles_report *report,
                  struct err *err) WARN_UNUSED;

/* Projects k components onto the C1 splines, nearest in (unweighted) least squares. A spline that
 * is C1 already (all conditions within 64 u of their terms) is left as it is. Any degree. */
bool decles_repair(const struct grid *g, double *q, size_t stride, int k,
                   struct err *err) WARN_UNUSED;

#endif
