/* SPDX-License-Identifier: GPL-3.0-or-later */
/* c1 - the quadrilateral conditions that make a spline C1 across the inner edges of its grid.
 *
 * For an inner edge {a,b}, a < b, with opposite vertices u0 (in the lower triangle u) and v0 (in
 * v), and m = k = 0..d-1 from a to b, j = d-1-m:
 *
 *     q^v_1jk = B0 q^u_1jk + B1 q_0,j+1,k + B2 q_0,j,k+1                          [14] (4)(6)
 *
 * multiplied by twice the area of u: integer coefficients. Condition m of edge e has the number e*d
 * + m (numbers of boundary edges mean nothing).
 *
 *          u0                     m = 0, d-1   ring 1 of an end vertex (extremes: two edge corners)
 *         / 1jk                   m = 1, d-2   ring 2 (extremes: two inner corners)
 *   a ---+---+--- b               others       middle conditions (extremes: two inner edge points)
 *         \ 1jk
 *          v0
 */
#ifndef C1_H
#define C1_H

#include "grid.h"

enum point_type { /* [14] table 1 */
                  TYPE_CORNER,
                  TYPE_EDGE_CORNER,
                  TYPE_EDGE,
                  TYPE_INNER_CORNER,
                  TYPE_INNER_EDGE,
                  TYPE_INTERIOR,
};

/* "corner", "edge-corner", "edge", "inner-corner", "inner-edge", "interior"; NULL ends the table.
 */
extern const char *const c1_type_names[];

/* O(1). The name follows the larger of the point's two or three weights: in degree 2 an edge's only
 * point is an edge corner, in degree 3 a triangle's only inner point an inner corner. */
enum point_type c1_type(const struct grid *g, uint32_t p);

/* sum over i of coefficient[i] * q[point[i]] = 0. point[0] and [1] are the extremes, in v and in u;
 * [2] and [3] lie on the edge, nearer to a and to b. The extremes' coefficients are never 0; others
 * that are 0 are kept. All are below 2^53, and their sum is 0. */
struct c1_condition {
    uint32_t point[4];
    int64_t coefficient[4];
};

/* Condition m of the inner edge e. O(1). */
struct c1_condition c1_condition(const struct grid *g, uint32_t e, int m);

/* Calls visit for every condition that contains point p with a non-zero coefficient, once each, in
 * an order that depends on the grid alone. O(degree of the vertex) for corners, else O(1). */
void c1_conditions_of(const struct grid *g, uint32_t p,
                      void (*visit)(void *context, uint32_t e, int m), void *context);

/* k components that belong together (the x and y of phi, or one sigma): q[stride * p + c], c < k.
 */
struct c1_field {
    double *q;
    size_t stride;
    int k;
    double extent; /* c1_extent of the grid */
};

/* The largest coordinate of the grid, with its depth, in world units. O(vertices). */
double c1_extent(const struct grid *g);

/* What a condition comes to in component c. Its terms are those of points as far away as the domain
 * reaches, or farther where its own points are, in whichever component: a turn carries the rounding
 * of y into an x that may be 0, so an error must be held against the size of the map, not of the
 * numbers that happen to stand in one condition. */
struct c1_value {
    double sum;   /* of a q, in double-double, rounded once */
    double terms; /* sum |a| (extent + largest |q| of its points and all components) */
};
#define C1_RANGE 0x1p960 /* of |q| and extent: beyond, the products may overflow */
struct c1_value c1_evaluate(const struct c1_condition *condition, const struct c1_field *field,
                            int c);

/* A condition counts as true when |sum| is within 64 u of its terms, u = 2^-53: a solution that is
 * rounded once leaves 1 u where the condition was solved for or follows from such, and some u where
 * it hangs on older roundings. nan is not true. */
bool c1_holds(struct c1_value value);

/* |sum| / terms; 0/0 = 0. */
double c1_relative(struct c1_value value);

/* Number of inner vertices, and of those that are singular: all their edges on exactly two lines.
 */
void c1_vertices(const struct grid *g, uint32_t *inner, uint32_t *singular);

/* The rank of all conditions: d*E_I - 2*V_I - s for d >= 5 (decles.md; [LS]). It is a sum over
 * vertices and edges, since for d >= 5 rings 1 and 2 of different vertices share no point and each
 * middle condition has extremes of its own: so holes, components and even triangles that overlap do
 * not matter. */
size_t c1_rank_formula(const struct grid *g);

/* Over all conditions and components: the largest |sum a q| / max |a|, in the unit of q; the
 * largest |sum a q| over its terms; *edge is where that is attained (the lowest such), GRID_NONE
 * without inner edges. nan counts as larger than any number. */
void c1_residual(const struct grid *g, const struct c1_field *field, double *absolute,
                 double *relative, uint32_t *edge);

/* Adds what the inner edge e has to these, which begin as 0, 0, GRID_NONE; returns whether all its
 * conditions hold. */
bool c1_edge(const struct grid *g, uint32_t e, const struct c1_field *field, double *absolute,
             double *relative, uint32_t *edge);

#endif
