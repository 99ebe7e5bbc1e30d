/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure - a deformation as a picture: the domain, its image, or both side by side.
 *
 * The panels have one scale, so that lengths can be compared. Both show the same layers, from
 * below: an image, the growth of areas, a model's silhouette, the quadrilateral conditions,
 * triangles (the exact curves, to 1/20 of a unit of the page), outline, Bezier net, control points,
 * the sets of one edit with its arrows, labels, polylines. A legend explains what needs it. */
#ifndef FIGURE_H
#define FIGURE_H

#include "drawing.h"
#include "edit_trace.h"
#include "figure_image.h"
#include "model.h"
#include "polylines.h"

enum figure_side { FIGURE_DOMAIN, FIGURE_DEFORMED, FIGURE_BOTH };

enum figure_layer {
    FIGURE_TRIANGLES,
    FIGURE_NET,
    FIGURE_POINTS, /* dots */
    FIGURE_TYPES,  /* dots that tell the types, [14] table 1 */
    FIGURE_QUADS,  /* of the quadrilateral conditions; with an edit: of E only */
    FIGURE_LABELS, /* numbers of the control points if these are shown, else of vertices, triangles
                    */
    FIGURE_SETS,   /* A, S, D, F of an edit; arrows from p to p' and p'' */
    FIGURE_JACOBIAN, /* det grad phi as colours */
    FIGURE_OUTLINE,
    FIGURE_LAYERS
};

/* "triangles", "net", ...; NULL ends the table. */
extern const char *const figure_layer_names[];
extern const char *const figure_side_names[];

struct figure_content {          /* all borrowed; NULL: not there */
    const struct spline *spline; /* NULL: only the domain side, and no layers */
    const struct edit_trace *edit;
    const struct model *model[2];  /* before and after the deformation, in the grid's frame */
    const struct polylines *lines; /* on both sides */
    const struct figure_image *image;
};

enum { FIGURE_COLOURS_MAX = 32 };

struct figure_lines_style {
    double width;  /* of paths, page units */
    double dot;    /* radius of dots, page units */
    double square; /* if > 0, dots are squares with sides of this length, world units */
    bool labels;   /* written at each dot */
    uint32_t colour[FIGURE_COLOURS_MAX]; /* of the first words, 0xRRGGBBAA; others: the palette's */
    size_t colour_count;
};

struct figure_options {
    enum figure_side side;
    unsigned layers; /* 1 << layer each */
    double width;    /* of the page */
    bool y_down;     /* the world's y grows downwards */
    bool legend;
    struct figure_lines_style lines;
};

static inline void figure_options_init(struct figure_options *o) {
    *o = (struct figure_options){
        .side = FIGURE_DEFORMED, .width = 800, .legend = true, .lines = {.width = 1, .dot = 1.6}};
}

/* Fills the drawing, which is the caller's to free in any case. ERR_REFUSAL: what it
 * shows is too large for numbers. */
bool figure_draw(struct drawing *d, const struct figure_content *content,
                 const struct figure_options *options, struct err *err) WARN_UNUSED;

#endif
