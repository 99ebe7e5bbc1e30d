/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boundary - the images of the boundary edges: do they meet, and what do they wind round?
 *
 * The image of a boundary edge is a Bezier arc, whose control points are those of the edge. Arcs
 * run with the domain on their left, and each ends where another one begins, so that together they
 * are closed curves. */
#ifndef BOUNDARY_H
#define BOUNDARY_H

#include "boxes.h"
#include "meet.h"
#include "spline.h"

struct boundary {
    const struct spline *spline; /* borrowed */
    uint32_t count;
    uint32_t *edge;     /* of the grid, by arc, ascending */
    uint32_t (*end)[2]; /* the vertices where it begins and ends */
    uint32_t *next;     /* the arc that begins where this one ends */
    struct boxes boxes; /* of control points */
};

bool boundary_init(struct boundary *b, const struct spline *s, struct err *err) WARN_UNUSED;
void boundary_free(struct boundary *b); /* harmless on a zeroed struct */

/* The degree + 1 control points of an arc; of edge l of triangle t, counter-clockwise. */
void boundary_arc(const struct boundary *b, uint32_t arc, double (*q)[2]);
void boundary_arc_of_edge(const struct spline *s, uint32_t t, int l, double (*q)[2]);

/* Two edges whose images meet elsewhere than at a common vertex, or one whose image meets itself.
 * An edge's parameter runs from `from` to `to`, with the domain on the left. */
struct boundary_place {
    uint32_t triangle, from, to;
    double position[2]; /* in the undeformed grid, at the middle of the interval, rounded once */
};
struct boundary_meeting {
    struct meet meet;
    struct boundary_place place[2]; /* unless MEET_NOT, like the rest */
    double image[2];                /* of the middle of the first interval, rounded once */
};
void boundary_meeting_init(struct boundary_meeting *m);
void boundary_meeting_free(struct boundary_meeting *m);

/* MEET_NOT: all curves are simple, and no two meet. Else MEET_CROSS or MEET_POINT if two places of
 * the boundary are found that have one image, and MEET_UNDECIDED if neither is proved. 1 us an arc
 * where the curves are mild and not close. */
bool boundary_meets(const struct boundary *b, const struct meet_rule *rule,
                    struct boundary_meeting *m, struct err *err) WARN_UNUSED;

#endif
