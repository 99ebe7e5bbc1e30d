/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_options - the options that say how cages are mapped, and what of it is to be drawn. A tool
 * has ICC_OPTIONS in its table and hands their keys to icc_option. */
#ifndef ICC_OPTIONS_H
#define ICC_OPTIONS_H

#include "cli.h"
#include "icc_map.h"
#include "icc_show.h"

enum {
    ICC_KEY = 340,
    ICC_METHOD = ICC_KEY,
    ICC_POINTS,
    ICC_CELL,
    ICC_LINES,
    ICC_SHOW,
    ICC_RESOLUTION, /* from here on: method grid */
    ICC_FUNCTION,
    ICC_MAXIMUM,
    ICC_AXES,
    ICC_OUTSIDE_VALUES,
    ICC_RESOLUTION_CHECK,
    ICC_KEY_END
};

/* clang-format off */
#define ICC_OPTIONS                                                                                \
    {ICC_METHOD, "method", "WHAT", "ray (default), or grid, which is not one to one"},             \
    {ICC_POINTS, "points", "N", "points inside each cage (default: 20 a side, 600..20000)"},       \
    {ICC_CELL, "cell", "SIZE", "instead: their distance from each other in the source"},           \
    {ICC_LINES, "lines", "N", NULL},                                                               \
    {ICC_SHOW, "show", "WHAT", "print N lines, the grid, values and so on, as polylines"},         \
    {ICC_RESOLUTION, "resolution", "K", "grid: cells K times finer"},                              \
    {ICC_FUNCTION, "function", "NAME", "grid: cousin (default), manhattan, harmonic, biharmonic"}, \
    {ICC_MAXIMUM, "maximum", "X,Y[,U,V]", "grid: its place in the source [and the target]"},       \
    {ICC_AXES, "axes", "ORDER", NULL},                                                             \
    {ICC_OUTSIDE_VALUES, "outside-values", "HOW", "grid: xy (default) or yx; inward or literal"},  \
    {ICC_RESOLUTION_CHECK, "resolution-check", "HOW", "grid: refuse (default) or warn"}
/* clang-format on */

struct icc_options {
    bool given[ICC_KEY_END - ICC_KEY]; /* by key */
    struct icc_rule rule;
    int64_t lines; /* 0: none */
    int show;      /* enum icc_show, if it is given */
};

/* Is this key one of them? */
static inline bool icc_option_is(int key) {
    return key >= ICC_KEY && key < ICC_KEY_END;
}

/* Takes the current option of cli, whose key this is. o is zeroed before the first. */
bool icc_option(struct icc_options *o, const struct cli *cli, int key, struct err *err) WARN_UNUSED;

/* What no single option can know. */
bool icc_options_end(struct icc_options *o, const struct cli *cli, struct err *err) WARN_UNUSED;

/* Is something to be drawn, and nothing mapped? */
bool icc_options_show(const struct icc_options *o);

#endif
