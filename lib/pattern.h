/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pattern - regular triangulations of a rectangle of the lattice, whole or in part.
 *
 *   diagonal  +---+---+     cross  +---+---+      hex  0---1---2---3    row 1, shifted
 *             | / | / |            |\ /|\ /|           |\ / \ / \ /|
 *             |/  |/  |            | X | X |           | \   |   / |    strip 0
 *             +---+---+            |/ \|/ \|           |/ \ / \ / \|
 *                                  +---+---+           0----1---2--3    row 0
 *
 * The nx + 1 vertical lines x[i] and ny + 1 horizontal lines y[j] are lattice coordinates. Rows of
 * vertices are the horizontal lines; in hex, odd rows begin and end at the sides of the rectangle
 * and have the midpoints of the lines between, so the triangles at both sides are halves.
 *
 * A cell is a square of diagonal and cross (2 and 4 triangles), a triangle of hex. Cells are
 * numbered by rows, from left to right: cell = row * columns + column. In a strip of hex, columns
 * alternate: in even strips those with even numbers stand on their tips, in odd strips the others.
 */
#ifndef PATTERN_H
#define PATTERN_H

#include "grid.h"

enum pattern_kind { PATTERN_DIAGONAL, PATTERN_CROSS, PATTERN_HEX };

extern const char *const pattern_names[]; /* of the kinds; NULL ends them */

struct pattern {
    enum pattern_kind kind;
    uint32_t nx, ny, columns; /* columns: cells in a row */
    int32_t *x, *y;
};

enum { PATTERN_CELLS_MAX = 1 << 26 };

/* nx x ny squares (hex: nx edges in a row, ny strips) on the rectangle x0..x1, y0..y1, the lines
 * spread evenly and rounded to the nearest lattice coordinates. Refuses a lattice too coarse for
 * that and more than PATTERN_CELLS_MAX cells. */
bool pattern_init(struct pattern *p, enum pattern_kind kind, const uint32_t cells[2],
                  const int32_t low[2], const int32_t high[2], struct err *err) WARN_UNUSED;
void pattern_free(struct pattern *p);

/* Corners of a cell, counter-clockwise; returns their number, 3 or 4. */
int pattern_cell(const struct pattern *p, uint32_t column, uint32_t row, int32_t corner[4][2]);

/* Vertices of row 0..ny. */
uint32_t pattern_row_vertices(const struct pattern *p, uint32_t row);

/* The columns of the cells around vertex i of row j, counter-clockwise: the first half lies in
 * strip j, the second in strip j - 1. Returns their number, 4 or 6. -1 stands for cells beyond a
 * side; strips beyond the rectangle are the caller's to exclude. */
int pattern_around(const struct pattern *p, uint32_t i, uint32_t j, int64_t column[6]);

/* Sets vertices and triangles of *g to those of the cells with keep[cell] != 0 (NULL: all), in the
 * order of their rows. At least one cell must be kept. */
bool pattern_triangulate(const struct pattern *p, const uint8_t *keep, struct grid *g,
                         struct err *err) WARN_UNUSED;

#endif
