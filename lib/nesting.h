/* SPDX-License-Identifier: GPL-3.0-or-later */
/* nesting - does the image of a component of the domain lie in that of another?
 *
 * Let the curves of the boundary be simple and disjoint. The images of two components either have
 * no point in common, or one of them lies inside the other: it is connected and does not meet the
 * other's boundary. So one point of each component is enough, here the image of a vertex v on its
 * boundary: the boundaries of the other components wind round it as often as their images cover it,
 * if det grad phi > 0; and not 0 times only if they do, whatever the determinant. An image that
 * lies in a hole of another is covered 0 times. */
#ifndef NESTING_H
#define NESTING_H

#include "boundary.h"

enum nesting_verdict { NESTING_NONE, NESTING_UNDECIDED, NESTING_INSIDE };

struct nesting {
    enum nesting_verdict verdict;
    uint32_t vertex;   /* NESTING_INSIDE: its image is also that of a point of ... */
    uint32_t triangle; /* ... this triangle, of another component */
};

/* O(n + c log c) for c components and n arcs; for components within the box of another one, that
 * lie evenly, another O(sqrt n) each. */
bool nesting_survey(struct nesting *n, const struct boundary *b, struct err *err) WARN_UNUSED;

#endif
