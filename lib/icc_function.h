/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_function - a function on the grid over a cage, with one critical point, a maximum.
 *
 * The cousin tree ([13] Algorithm 3) grows breadth first from the maximum over the edges of the
 * grid between inside vertices. depth is the number of edges to the maximum, and
 *
 *     cousin       f(maximum) = 10, f(child) = 0.95 f(parent):  10 * 0.95^depth
 *     manhattan    f = -depth                                   (section 6.5)
 *     harmonic     f = 0 on the first ring outside, the mean of its four neighbours inside
 *     biharmonic   the same of the mean's deviation: least sum of (4 f - neighbours)^2 inside
 *                  (both scaled to any height at the maximum; integral lines do not depend on it)
 *
 * f is linear on each triangle of the grid. Three rings of vertices around those inside have values
 * too, so that lines reach the cage:
 *
 *     inward    the vertices beside one inside, along an edge, are 0.95 times the least of their 8
 *               neighbours inside; then twice all those around what has values (of a ring, first
 *               those beside it along an edge, then those at its corners), 0.95 times the least of
 *               their 8 neighbours with values. So f falls outwards everywhere. Where three corners
 *               of a triangle would be equal, one is lowered.
 *     literal   ([13] Algorithm 2) the tree goes on for three rings, 0.95 times the parent.
 *
 * What stands for 0.95 with the others: depth + 1 for manhattan as well; less the least value
 * inside nearby for harmonic and biharmonic.
 *
 * Heights order the vertices: the higher has the greater height, or the same and a lower number.
 * 0.95^depth vanishes in double from depth 14,512 on and loses bits from 13,856; so depths are
 * kept, and where differences of f are wanted (in a triangle, around a vertex) they are taken in
 * units of the greatest value there: nothing vanishes, however deep the tree. */
#ifndef ICC_FUNCTION_H
#define ICC_FUNCTION_H

#include "icc_domain.h"

#include <math.h>

enum icc_kind { ICC_COUSIN, ICC_MANHATTAN, ICC_HARMONIC, ICC_BIHARMONIC };
enum icc_outside { ICC_INWARD, ICC_LITERAL };
enum icc_axes { ICC_XY, ICC_YX };
enum { ICC_RINGS = 3, ICC_POWERS = 1024 };
#define ICC_NO_VERTEX UINT32_MAX

struct icc_function_rule {
    enum icc_kind kind;
    enum icc_outside outside; /* ICC_LITERAL: cousin and manhattan only */
    enum icc_axes axes;       /* which neighbours are found first; without effect on f */
};

struct icc_function {
    enum icc_kind kind;
    uint32_t maximum;
    uint32_t reached; /* inside vertices that have a value: those connected with the maximum */
    uint32_t valued;  /* with the rings outside */
    double *height;   /* nx ny: -depth for cousin and manhattan, f for the others; NAN: no value */
    uint32_t *parent; /* nx ny: in the tree, and outside the neighbour whose value decided */
    double power[ICC_POWERS]; /* 0.95^k */
};

/* The maximum is a vertex inside. Freed by icc_function_free in any case. Linear in the size of the
 * grid, but for harmonic and biharmonic: a sparse factorisation. */
bool icc_function_init(struct icc_function *f, const struct icc_domain *d, uint32_t maximum,
                       const struct icc_function_rule *rule, struct err *err) WARN_UNUSED;
void icc_function_free(struct icc_function *f);

static inline bool icc_function_has(const struct icc_function *f, uint32_t v) {
    return !isnan(f->height[v]);
}

/* Is vertex a, with value, higher than b, with value? */
static inline bool icc_function_higher(const struct icc_function *f, uint32_t a, uint32_t b) {
    return f->height[a] > f->height[b] || (f->height[a] == f->height[b] && a < b);
}

/* f in units of its value at height `top`, for a vertex of that height or less. */
static inline double icc_function_at(const struct icc_function *f, double top, double height) {
    if (f->kind != ICC_COUSIN) return height;
    return top - height < ICC_POWERS ? f->power[(int)(top - height)] : 0;
}

/* f itself, for drawing; rounded. */
double icc_function_value(const struct icc_function *f, uint32_t v);

#endif
