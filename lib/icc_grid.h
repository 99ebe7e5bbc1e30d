/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_grid - integral curve coordinates of the function on a grid ([13] Algorithm 8): method grid.
 *
 * The coordinates of a point are the place where its line reaches the cage downhill, and
 *
 *     t = up / (up + down),     up, down: lengths of its lines to the maximum and to the cage,
 *
 * so t = 1 on the cage and 0 at the maximum. Coordinates name the point on the line uphill from
 * their place, at (1 - t) of its length.
 *
 * This is not bijective: lines merge where they run together at compression edges, differently in
 * each cage. A tally counts it. */
#ifndef ICC_GRID_H
#define ICC_GRID_H

#include "cage.h"
#include "icc.h"
#include "icc_resolution.h"

struct icc_grid_rule {
    double cell;       /* side of a cell, or 0: */
    double points;     /* wanted number of vertices inside, or 0 */
    double resolution; /* cells are so much finer; with neither, than with 365 points; or 0 */
    struct icc_function_rule function;
    bool has_maximum; /* else it is where the grassfire ends */
    double maximum[2];
    bool warn; /* a failed test of the resolution is no refusal */
};

enum { ICC_POINTS_AUTO = 600, ICC_POINTS_AUTO_MAX = 60000, ICC_POINTS_THESIS = 365 };

struct icc_grid {
    const struct cage *cage; /* borrowed */
    struct icc_domain domain;
    struct icc_function function;
    struct icc_cells cells;
    struct icc_failures failures[ICC_TESTS]; /* side as the cage was given */
};

/* What happened to points, each counted once under each heading. */
struct icc_tally {
    size_t points;
    size_t merged;   /* lines of other points have merged with its line before it reaches the cage,
                        and so they have the same place; or before it comes to the point's image */
    size_t lost;     /* a line got stuck, and went on straight to the cage or the maximum */
    size_t leaving;  /* the line up crosses the cage */
    size_t expanded; /* the line down follows an expansion edge */
};

/* Lines in use, to be kept from point to point. */
struct icc_lines {
    struct icc_line up, down;
};

/* Without cell, points and resolution, cells are as large as 600 inside, or as half the width of
 * the cage, then halved until all tests of the resolution pass, up to 60,000 inside. Refuses
 * (ERR_REFUSAL) what icc_domain_init refuses, grids without a vertex inside or that fail a test,
 * and a maximum that is not inside. Freed by icc_grid_free in any case. */
bool icc_grid_init(struct icc_grid *g, const struct cage *cage, const struct icc_grid_rule *rule,
                   struct err *err) WARN_UNUSED;
void icc_grid_free(struct icc_grid *g);

static inline struct icc_field icc_grid_field(const struct icc_grid *g) {
    return (struct icc_field){&g->domain, &g->function, &g->cells};
}

/* The coordinates of a point; outside the cage, of which the side is ICC_OUTSIDE. False for want of
 * memory. O(cells on the way). */
bool icc_grid_locate(const struct icc_grid *g, const double p[2], struct icc_lines *lines,
                     struct icc_place *place, struct icc_tally *tally, struct err *err) WARN_UNUSED;

/* The point of coordinates. */
bool icc_grid_place(const struct icc_grid *g, const struct icc_place *place,
                    struct icc_lines *lines, double p[2], struct icc_tally *tally,
                    struct err *err) WARN_UNUSED;
void icc_lines_free(struct icc_lines *lines);

#endif
