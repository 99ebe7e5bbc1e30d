/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_trace - integral lines of a function on the grid over a cage ([13] Algorithms 4-7).
 *
 * Uphill a line follows the gradient, downhill its negative; either is a constant vector g on a
 * triangle. Where a line goes from an edge or a vertex is decided by signs and not by stepping:
 *
 *   Edge. A line enters a triangle at p through its counter-clockwise edge (a,b); e = b - a, o is
 *   the opposite corner. Where g does not point into the triangle (gx ey - gy ex >= 0), two
 *   triangles push against each other: a compression edge, along which the line goes to the end
 *   that g.e points to. Else s = cross(g, o - p) says how it leaves: s > 0 through (b,o), s < 0
 *   through (o,a), s = 0 at o.
 *
 *              o
 *      (o,a)  / \  (b,o)         [13] Table 5.1: pass through, or compression
 *            /   \
 *           a--p--b
 *
 *   Vertex. The steepest way on: the slope |g| of a triangle whose g lies strictly between its
 * edges there, the slope df / length of an edge; of equal ones the first, counter-clockwise from
 * +x.
 *
 *   An edge that both triangles point away from is an expansion edge; a line is on one only if it
 *   starts there, or comes from a vertex, and follows it.
 *
 * Uphill a line ends at the maximum, downhill at the cage: each segment is compared with the sides
 * that its cell lists, the first it crosses counts. A point on a side is inside; a side includes
 * one of its ends, so that a vertex counts once. */
#ifndef ICC_TRACE_H
#define ICC_TRACE_H

#include "icc_cells.h"
#include "icc_function.h"

struct icc_field {
    const struct icc_domain *domain;
    const struct icc_function *function;
    const struct icc_cells *cells;
};

enum icc_direction { ICC_UPHILL = 1, ICC_DOWNHILL = -1 };

enum icc_end {
    ICC_END_MAXIMUM,
    ICC_END_CAGE,
    ICC_END_STUCK, /* no way on: f has no value there, or is flat, or has another extremum */
};

struct icc_line {
    double (*point)[2]; /* from the start on, in grid coordinates */
    size_t count, capacity;
    enum icc_end end;
    uint32_t side; /* with ICC_END_CAGE: where */
    double lambda;
    size_t shared; /* from this point on other lines may have merged with it: the first from which
                      it follows an edge, or vertex; or SIZE_MAX */
    bool expanded; /* it follows an expansion edge */
    bool crossed;  /* uphill: it crosses the cage after its start */
};

/* The line from p, in grid coordinates, on the grid. Line may be a zeroed struct, or one used
 * before; freed by icc_line_free. False for want of memory. O(triangles on the way). */
bool icc_trace(const struct icc_field *f, const double p[2], enum icc_direction direction,
               struct icc_line *line, struct err *err) WARN_UNUSED;
void icc_line_free(struct icc_line *line);

/* Its length, in grid units. */
double icc_line_length(const struct icc_line *line);

/* The point at a distance along it; returns the number of the line's point before it. */
size_t icc_line_at(const struct icc_line *line, double distance, double p[2]);

/* The edge rule above. g.e is not 0 on a compression edge, or `tie` decides: true is b. */
enum icc_exit { ICC_TO_A, ICC_TO_B, ICC_TO_O, ICC_THROUGH_BO, ICC_THROUGH_OA };
enum icc_exit icc_exit(const double a[2], const double b[2], const double o[2], const double g[2],
                       const double p[2], bool tie);

/* What f does at an edge of the grid, seen uphill. */
enum icc_edge { ICC_EDGE_PASS, ICC_EDGE_COMPRESSION, ICC_EDGE_EXPANSION, ICC_EDGE_NONE };

/* Of the edge from vertex v to v + 1 (which = 0), v + nx + 1 (1) or v + nx (2). NONE where one of
 * its triangles has no values. v is not on the border of the grid. */
enum icc_edge icc_edge_kind(const struct icc_field *f, uint32_t v, int which);

#endif
