/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_resolution - is the grid over a cage fine enough to have the cage's shape?
 *
 * Four tests ([13] leaves this open). If the first three pass, the inside vertices are a ball:
 * connected, without holes, and f has no critical point inside but its maximum. With the fourth,
 * every place of the cage lies in a triangle on which f is known. They secure the topology only. */
#ifndef ICC_RESOLUTION_H
#define ICC_RESOLUTION_H

#include "icc_trace.h"

enum icc_test {
    ICC_TEST_REACHED,  /* inside vertices that the tree does not reach */
    ICC_TEST_DIAGONAL, /* cells of whose corners only two, opposite ones, are inside */
    ICC_TEST_CUT,      /* edges between inside vertices that cross the cage */
    ICC_TEST_BARE,     /* pieces of sides in triangles where f has no value */
    ICC_TESTS,
};

struct icc_failures {
    size_t count;
    double at[2];  /* the first, in world units: a vertex, the lower left corner, an end, a point */
    uint32_t side; /* with ICC_TEST_BARE */
};

/* O(vertices of the grid + cells that sides meet). */
void icc_resolution(const struct icc_field *f, struct icc_failures failures[ICC_TESTS]);

/* Says it in words. */
enum { ICC_FAILURE_TEXT_MAX = 192 };
void icc_failure_describe(enum icc_test test, const struct icc_failures *failures,
                          char text[ICC_FAILURE_TEXT_MAX]);

/* How narrow are the necks of a cage, or the gaps between its arms: the least distance, if that is
 * less than `limit`, from a vertex to a place on a side to which the way along the cage is more
 * than three times as long; else the limit. Of vertices that crowd together, 64 on the length of
 * the limit are looked at. Near O(count) where sides are about as long as that. */
bool icc_width(const double (*vertex)[2], size_t count, double limit, double *width,
               struct err *err) WARN_UNUSED;

#endif
