/* SPDX-License-Identifier: GPL-3.0-or-later */
/* select - the ways in which an edit names control points (supple-edits(5), POINTS), and the
 * neighbourhoods of anchors: `reach N`, `within R`.
 *
 * Nominal positions never change; current positions are those of phi and do. Each kind has its
 * index of nearest points, built when it is first needed, so that a script that names points by
 * number pays for none. */
#ifndef SELECT_H
#define SELECT_H

#include "blocks.h"
#include "grid.h"
#include "nearest.h"
#include "polygon.h"

enum selector_kind {
    SELECT_ALL,     /* all */
    SELECT_RANGE,   /* 17, 17-45 */
    SELECT_PLACE,   /* t:i,j,k */
    SELECT_VERTEX,  /* v:7 */
    SELECT_NEAREST, /* @x,y ^x,y v@x,y v^x,y */
    SELECT_BOX,     /* box:X0,Y0,X1,Y1, by nominal positions, closed */
    SELECT_INSIDE,  /* inside:FILE.xy, by nominal positions, closed */
};

struct selector { /* one word of POINTS */
    enum selector_kind kind;
    uint32_t col; /* where it stands in its line, for messages */
    union {
        struct {
            uint32_t first, last;
        } range;
        struct {
            uint32_t triangle;
            int64_t weight[3];
        } place;
        uint32_t vertex;
        struct {
            bool nominal, corner; /* else current position, any point */
            double xy[2];
        } nearest;
        struct {
            double lo[2], hi[2];
        } box;
        struct {
            const struct polygon *polygon; /* both borrowed */
            const char *file;
        } inside;
    };
};

struct point_set {
    uint32_t *point; /* released with free() */
    size_t count, cap;
};

bool point_set_add(struct point_set *set, uint32_t p, struct err *err) WARN_UNUSED;

/* Brings a set to its canonical form: ascending, each point once. */
void point_set_sort(struct point_set *set);

/* For a sorted set. O(log count). */
bool point_set_has(const struct point_set *set, uint32_t p);

struct select_space {
    const struct grid *grid; /* borrowed */
    const double (*phi)[2];  /* current positions, borrowed */
    double (*nominal)[2];    /* NULL until needed */
    struct nearest index[4]; /* nominal + 2 corner; count = 0 until needed */
    struct blocks blocks;    /* of points seen by a search; private */
    bool *mark;
};

void select_init(struct select_space *space, const struct grid *grid, const double (*phi)[2]);
void select_free(struct select_space *space);

/* The current position of p has changed. O(1) amortised. */
void select_moved(struct select_space *space, uint32_t p);

/* Appends the points that the word names. Fails (ERR_INPUT, no place) if a number is out of range
 * or no point is named. Cost: points named, for box and inside those of the bounding box; O(log
 * points) for a single point; the first use of a kind O(points of the grid). */
bool select_points(struct select_space *space, const struct selector *s, struct point_set *set,
                   struct err *err) WARN_UNUSED;

/* Appends the points at graph distance 1..steps from the anchors in the global Bezier net, each
 * once, nearest first. O(points found). */
bool select_reach(struct select_space *space, const struct point_set *anchors, uint32_t steps,
                  struct point_set *set, struct err *err) WARN_UNUSED;

/* Appends the points, anchors among them, whose nominal position lies within the distance of the
 * nominal position of an anchor; perhaps some of them more than once. */
bool select_within(struct select_space *space, const struct point_set *anchors, double distance,
                   struct point_set *set, struct err *err) WARN_UNUSED;

#endif
