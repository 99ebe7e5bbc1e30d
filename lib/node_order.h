/* SPDX-License-Identifier: GPL-3.0-or-later */
/* node_order - in which order mesh files list the nodes of a triangle of high degree.
 *
 * First the corners 0, 1, 2; then the edges 01, 12, 20, the degree-1 nodes of each in its
 * direction; then the interior, in one of two ways:
 *
 *     nested  as a triangle of degree-3, corners, edges, interior (Gmsh; triangles of VTK)
 *     rows    parallel to edge 01, from it towards corner 2, each from edge 20 to 12 (wedges of
 * VTK)
 */
#ifndef NODE_ORDER_H
#define NODE_ORDER_H

enum node_interior { NODE_NESTED, NODE_ROWS };

/* weight[q] = (i,j,k) of the node in place q, (degree+1)(degree+2)/2 of them; i + j + k = degree.
 * O(nodes). degree >= 1. */
void node_order(int degree, enum node_interior interior, int weight[][3]);

#endif
