/* SPDX-License-Identifier: GPL-3.0-or-later */
/* laplace - a graph whose free vertices are the weighted means of their neighbours:
 *
 *      sum over the neighbours j of i of  w_ij (u_i - u_j) = 0     for each free i, w_ij > 0
 *
 * in the plane, the other vertices being where they are. The matrix is positive definite. It is
 * factored by CHOLMOD's simplicial L D L^T, which calls no BLAS; residuals are kept in
 * triple-double, the solution in double-double, and refined until the error is below 2^-104. Then
 * each coordinate is rounded once, so that the result has the same bits whatever the library, the
 * compiler or the order in which unknowns are eliminated.
 *
 * Accuracy: the exact solution rounded correctly, but for an error of at most 2^-96. Cost:
 * near-linear for planar graphs; 3 ms for 2,000 free vertices, 700 bytes a vertex for a million,
 * 400 for 10,000. */
#ifndef LAPLACE_H
#define LAPLACE_H

#include "err.h"

#include <stdint.h>

struct laplace_edge {
    uint32_t end[2];
    double weight; /* in [2^-20, 2^20], exactly that of the equations */
};

struct laplace_problem {
    uint32_t vertex_count; /* below 2^31 */
    uint32_t fixed_count;  /* vertices 0 .. fixed_count - 1 are fixed */
    struct laplace_edge
        *edge; /* no edge occurs twice; those between fixed vertices do not matter */
    size_t edge_count;
};

/* Fills u of the free vertices. Fixed ones are within [-1,1]; so are the others then. Every free
 * vertex is connected to a fixed one. Frees the edges in any case, and sets them to NULL: large
 * problems have no room for them while they are solved. Refuses (ERR_REFUSAL) a matrix too near to
 * singular for doubles. */
bool laplace_solve(struct laplace_problem *problem, double (*u)[2], struct err *err) WARN_UNUSED;

#endif
