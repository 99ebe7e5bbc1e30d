/* SPDX-License-Identifier: GPL-3.0-or-later */
/* source_options - the options that say which grid to make. A tool has SOURCE_OPTIONS in its table,
 * hands their keys to source_option, and calls source_options_end after the last. */
#ifndef SOURCE_OPTIONS_H
#define SOURCE_OPTIONS_H

#include "cli.h"
#include "source_io.h"

enum {
    SOURCE_KEY = 256,
    OPTION_RECT = SOURCE_KEY, /* the sources, in the order of enum source_kind */
    OPTION_MODEL,
    OPTION_AROUND,
    OPTION_POLYGON,
    OPTION_TRIANGULATION,
    OPTION_IMAGE,
    OPTION_PLANE, /* what goes with them, and what goes with all */
    OPTION_FRAME,
    OPTION_MARGIN,
    OPTION_CELLS,
    OPTION_CELL,
    OPTION_PATTERN,
    OPTION_MAX_AREA,
    OPTION_MIN_ANGLE,
    OPTION_MAX_TRIANGLES,
    OPTION_DEGREE,
    OPTION_DEPTH,
    OPTION_FLAT,
    OPTION_LATTICE,
    OPTION_BITS,
    SOURCE_KEY_END
};

/* clang-format off */
#define SOURCE_OPTIONS                                                                             \
    {OPTION_RECT, "rect", "X0,Y0,X1,Y1", "a grid on this rectangle"},                              \
    {OPTION_MODEL, "model", "FILE", "a grid around this OBJ model"},                               \
    {OPTION_AROUND, "around", "FILE", "a grid around this outline (.xy)"},                         \
    {OPTION_POLYGON, "polygon", "FILE", "a grid of this polygon with holes (.xy)"},                \
    {OPTION_TRIANGULATION, "triangulation", "FILE",                                                \
        "of these triangles or points (.obj .ele .poly .node .xy)"},                               \
    {OPTION_IMAGE, "image", "FILE", "a grid on the rectangle of this image"},                      \
    {OPTION_PLANE, "plane", "AXES", "the model axes that are the grid's x and y (default xy)"},    \
    {OPTION_FRAME, "frame", "X0,Y0,X1,Y1", "where the image lies (default: one unit a pixel)"},    \
    {OPTION_MARGIN, "margin", "M", "around the model (default 0.05 of its larger extent)"},        \
    {OPTION_CELLS, "cells", "N|NXxNY", "cells along the longer side (16); both with --rect"},      \
    {OPTION_CELL, "cell", "SIZE", "or the side of a cell, with --model or --around"},              \
    {OPTION_PATTERN, "pattern", "NAME", "diagonal (default), cross or hex"},                       \
    {OPTION_MAX_AREA, "max-area", "A", "of the triangles of --polygon"},                           \
    {OPTION_MIN_ANGLE, "min-angle", "DEG", "of the triangles of --polygon (default 20)"},          \
    {OPTION_MAX_TRIANGLES, "max-triangles", "N", "of --polygon (default 1000000)"},                \
    {OPTION_DEGREE, "degree", "D", "of the spline, 1..15 (default 5)"},                            \
    {OPTION_DEPTH, "depth", "A,B", "the interval that the prisms span (default: the model's)"},    \
    {OPTION_FLAT, "flat", NULL, "no depth, whatever the model"},                                   \
    {OPTION_LATTICE, "lattice", "STEP", "of the vertices (default: the power of two that fits)"},  \
    {OPTION_BITS, "lattice-bits", "N", "vertices take 0..2^N-1 steps, N = 1..24 (default 16)"}
/* clang-format on */

struct source_options {
    bool given[SOURCE_KEY_END - SOURCE_KEY]; /* by key */
    struct source source;
    int axes[3]; /* of the grid, like degree and depth */
    double depth[2];
    int64_t degree;
    int64_t cells[2], bits, triangles; /* as read; cells[1] 0: one number */
};

void source_options_init(struct source_options *o);

/* Takes the current option of cli, whose key this is. */
bool source_option(struct source_options *o, const struct cli *cli, int key,
                   struct err *err) WARN_UNUSED;

/* Checks what goes together and completes o->source. */
bool source_options_end(struct source_options *o, struct err *err) WARN_UNUSED;

/* Makes the grid, to be freed by the caller in any case. */
bool source_options_grid(const struct source_options *o, struct grid *g,
                         struct surround_report *report, struct err *err) WARN_UNUSED;

#endif
