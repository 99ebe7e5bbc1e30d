/* SPDX-License-Identifier: GPL-3.0-or-later */
/* foldfree - keeps edits from folding a deformation.
 *
 * An edit that is accepted leaves, on each triangle that it touched (one that has a point which
 * moved, in whichever component),
 *
 *     det grad phi > margin,   and with depth   (sigma1 - sigma0) / (b - a) > margin,
 *
 * proved, exactly about the doubles as they are. The identity has 1 in both places. Triangles that
 * were not touched stay as they were, so a deformation that begins above the margin remains so.
 * That makes phi one-to-one near every point, not as a whole: parts that do not share a triangle
 * may come to lie upon each other.
 *
 * The first exit of an edit is the largest share s of the straight way of all control points, from
 * where they were before to where it puts them, such that the above holds at all shares up to s:
 * later the margin may be lost and won again. (jacobian_path.h) */
#ifndef FOLDFREE_H
#define FOLDFREE_H

#include "spline.h"

struct foldfree;

enum { FOLDFREE_TEXT_MAX = 500 };

/* s is borrowed, and is to be edited. margin >= 0. The memory has room for all points, of which
 * only what is touched is used. Everything below costs in proportion to the triangles touched. */
struct foldfree *foldfree_new(const struct spline *s, double margin, struct err *err) WARN_UNUSED;
void foldfree_free(struct foldfree *f); /* NULL is harmless */

/* An edit begins: nothing is touched. */
void foldfree_begin(struct foldfree *f);

/* These points may have moved. */
bool foldfree_touch(struct foldfree *f, const uint32_t *points, size_t n,
                    struct err *err) WARN_UNUSED;

/* Where a touched point was before the edit, after all were touched: x and y, or the one number of
 * sigma0 or sigma1. Points that are not told of are where they were. */
enum foldfree_component { FOLDFREE_PHI, FOLDFREE_BOTTOM, FOLDFREE_TOP };
void foldfree_was(struct foldfree *f, enum foldfree_component c, uint32_t point,
                  const double *from);

/* Certifies the touched triangles as they are now. ERR_REFUSAL with one that is not above the
 * margin, or undecided: its number, a place and the value there, and whether it was so before.
 * About 1 us a triangle of degree 5. */
bool foldfree_check(const struct foldfree *f, struct err *err) WARN_UNUSED;

/* How far the edit may go. */
struct foldfree_exit {
    double share; /* proved up to this; 1: the whole way */
    double lost;  /* if share < 1: the margin is lost here, or undecided from `share` on;
                     share < lost <= (1 + 2^-9) share */
    char text[FOLDFREE_TEXT_MAX]; /* how, as in the refusals of foldfree_check */
};

/* ERR_REFUSAL if there is no such share above 2^-21. About 3 us a triangle of degree 5. */
bool foldfree_find_exit(const struct foldfree *f, struct foldfree_exit *exit,
                        struct err *err) WARN_UNUSED;

#endif
