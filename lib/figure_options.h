/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_options - the options that say how a figure is drawn. A tool has FIGURE_OPTIONS in its
 * table and hands their keys to figure_option. */
#ifndef FIGURE_OPTIONS_H
#define FIGURE_OPTIONS_H

#include "cli.h"
#include "figure.h"

enum {
    FIGURE_KEY = 340,
    FIGURE_SIDE = FIGURE_KEY,
    FIGURE_LAYER_LIST,
    FIGURE_LINE_WIDTH,
    FIGURE_DOTS,
    FIGURE_SQUARES,
    FIGURE_DOT_LABELS,
    FIGURE_COLORS,
    FIGURE_WIDTH,
    FIGURE_Y_DOWN,
    FIGURE_NO_LEGEND,
    FIGURE_KEY_END
};

/* clang-format off */
#define FIGURE_OPTIONS                                                                             \
    {FIGURE_SIDE, "side", "WHICH", "domain, deformed (default) or both"},                          \
    {FIGURE_LAYER_LIST, "layers", "LIST",                                                          \
     "of triangles,net,points,types,quads,labels,sets,jacobian,outline"},                          \
    {FIGURE_LINE_WIDTH, "line-width", "W", "of the polylines (1)"},                                \
    {FIGURE_DOTS, "dots", "R", "their dots' radius (1.6)"},                                        \
    {FIGURE_SQUARES, "squares", "SIDE", "or dots as squares of this side, in units of the world"}, \
    {FIGURE_DOT_LABELS, "dot-labels", NULL, "write the labels of dots"},                                \
    {FIGURE_COLORS, "colors", "A,B,...", "of the words among their labels, as they appear"}, \
    {FIGURE_WIDTH, "width", "W", "of the picture, in pixels or 1/96 inch (800)"},                  \
    {FIGURE_Y_DOWN, "y-down", NULL, "the world's y grows downwards"},                              \
    {FIGURE_NO_LEGEND, "no-legend", NULL, "without the legend"}
/* clang-format on */

/* Is this key one of them? */
static inline bool figure_option_is(int key) {
    return key >= FIGURE_KEY && key < FIGURE_KEY_END;
}

/* One that needs polylines? */
static inline bool figure_option_of_lines(int key) {
    return key >= FIGURE_LINE_WIDTH && key <= FIGURE_COLORS;
}

/* Takes the current option of cli, whose key this is. */
bool figure_option(struct figure_options *o, const struct cli *cli, int key,
                   struct err *err) WARN_UNUSED;

#endif
