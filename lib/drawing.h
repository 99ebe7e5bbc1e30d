/* SPDX-License-Identifier: GPL-3.0-or-later */
/* drawing - a picture as data: shapes in the order in which they are painted.
 *
 * Coordinates are those of the page: x to the right, y down, one unit a pixel of a raster image and
 * 1/96 inch of a vector one. A path is begun by drawing_move, goes on with lines and cubic Bezier
 * curves, may have several parts, and becomes a shape when it is inked; shapes hide those before
 * them. Rendering is drawing_io's business. Memory is the only thing that can fail; the error
 * sticks and is asked for once, by drawing_ok. */
#ifndef DRAWING_H
#define DRAWING_H

#include "err.h"

#include <stdint.h>

#define DRAWING_NO_COLOUR 0u /* colours are 0xRRGGBBAA */

struct drawing_ink {
    uint32_t fill, stroke;
    double width, dash; /* of the stroke; dash and gap have this length, 0: none */
};

enum drawing_op { DRAWING_MOVE, DRAWING_LINE, DRAWING_CURVE, DRAWING_CLOSE };

struct drawing_shape {
    struct drawing_ink ink;
    size_t op, op_count, point; /* its first op; how many; its first point */
    size_t picture;             /* an image instead of a path, or SIZE_MAX */
};

/* An image painted into the rectangle with the corners `at`: the outer corners of its first and its
 * last pixel. */
struct drawing_picture {
    uint32_t width, height;
    uint32_t *pixel; /* rows downwards, 0xRRGGBBAA; owned by the drawing */
    double at[2][2];
};

struct drawing {
    double width, height;
    size_t shape_count, op_count, point_count, picture_count;
    struct drawing_shape *shape;
    unsigned char *op; /* enum drawing_op: takes 1, 1, 3 and 0 points */
    double (*point)[2];
    struct drawing_picture *picture;
    /* private */
    size_t shape_cap, op_cap, point_cap, picture_cap;
    size_t op_inked, point_inked; /* what belongs to shapes */
    struct err err;
};

void drawing_init(struct drawing *d);
void drawing_free(struct drawing *d);

/* False if memory was short anywhere since drawing_init. */
bool drawing_ok(const struct drawing *d, struct err *err) WARN_UNUSED;

void drawing_move(struct drawing *d, double x, double y);
void drawing_line(struct drawing *d, double x, double y);
void drawing_curve(struct drawing *d, const double a[2], const double b[2], const double end[2]);
void drawing_close(struct drawing *d);

/* Makes the path since the last call a shape. Fills by the non-zero rule. */
void drawing_paint(struct drawing *d, const struct drawing_ink *ink);

/* Paints an image; `pixel` moves into the drawing, also on failure. */
void drawing_place(struct drawing *d, uint32_t width, uint32_t height, uint32_t *pixel,
                   const double first[2], const double last[2]);

/* Parts of paths, closed. */
void drawing_disc(struct drawing *d, double x, double y, double radius);
void drawing_polygon(struct drawing *d, size_t n, const double (*point)[2]);

/* A line with a head at its end, inked with `ink`'s stroke; the head's length is `head`, or half of
 * the arrow if that is shorter. */
void drawing_arrow(struct drawing *d, const double from[2], const double to[2], double head,
                   const struct drawing_ink *ink);

#endif
