/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_sample - a deformation of a cage sampled at the vertices of a triangulation.
 *
 * The source is triangulated so that no triangle has more than a given area nor, except where sides
 * of the cage meet at such angles, an angle of less than 20 degrees; sides of the cage are unions
 * of edges. Its vertices are mapped, those on a side to the same place of the target's side, and
 * between them the map is taken to be affine on each triangle.
 *
 * That may turn a triangle over where the deformation itself turns nothing: at corners, say, where
 * it shears strongly within a triangle. There points are added first, in a few rounds. Since the
 * deformation may be as much sheared in the small as in the large, that does not always help; then
 * vertices of the triangle are taken away, if the hole can be filled with triangles that are sound
 * in source and target (joint.h). What then remains is counted, and is the caller's problem. */
#ifndef ICC_SAMPLE_H
#define ICC_SAMPLE_H

#include "cage.h"
#include "joint.h"

enum { ICC_SAMPLE_MAX = 2000000 }; /* triangles */

struct icc_sampled {
    const struct cage *source, *target; /* borrowed */
    /* Replaces points inside the source, x y 0 each, by their images. */
    bool (*map)(void *context, double (*point)[3], size_t count, struct err *err);
    void *context;
};

struct icc_sample_report {
    size_t flipped;     /* triangles that the first sample turned over */
    int rounds;         /* in which points were added */
    size_t added, lost; /* vertices, because of that */
    size_t left;        /* triangles turned over in the end */
    double where[2];    /* a corner of one of them, in the source */
    bool too_many;      /* triangles, of such an area: that is why it was refused */
};

/* Makes the map, with a target of so many significant digits (0: doubles). If report->left > 0,
 * there is none. Refuses (ERR_REFUSAL) an area that takes more than ICC_SAMPLE_MAX triangles, and
 * digits that are too few. About 10 us a triangle, and as many images as vertices. Freed by
 * plane_map_free in any case. */
bool icc_sample(struct plane_map *map, const struct icc_sampled *what, double max_area, int digits,
                struct icc_sample_report *report, struct err *err) WARN_UNUSED;

#endif
