/* SPDX-License-Identifier: GPL-3.0-or-later */
/* paint - which cells of an even pattern meet a shape dilated by a radius. Shapes are given piece
 * by piece, in lattice coordinates, which need not be whole numbers. */
#ifndef PAINT_H
#define PAINT_H

#include "pattern.h"

struct paint {
    const struct pattern *pattern; /* borrowed; lines of one spacing each */
    uint8_t *keep;                 /* 1: the cell is painted */
    /* private */
    uint32_t *skip; /* how many painted cells follow a painted cell, at least */
    double low[2], width, height, radius, reach;
    struct crossing *crossing;
    size_t crossing_cap;
};

/* The radius is at least 2^-30 of a cell, so that rounding loses no cell; larger ones shrink by as
 * much, so that cells which only touch are not painted. */
bool paint_init(struct paint *b, const struct pattern *pattern, double radius,
                struct err *err) WARN_UNUSED;
void paint_free(struct paint *b);

/* The dilated segment pq; p = q is a disk. Cost: the cells of its strips near it. */
void paint_segment(struct paint *b, const double p[2], const double q[2]);

/* The dilated polygon: its sides and where its winding number is not 0. Cost: also the
 * crossings of its sides with strips. */
bool paint_polygon(struct paint *b, size_t n, const double (*xy)[2], struct err *err) WARN_UNUSED;

/* Paints as many more cells as it takes for one fan around each vertex; returns their number. They
 * stay in the box of what was painted, which must not reach the outermost cells. */
size_t paint_join_fans(struct paint *b);

#endif
