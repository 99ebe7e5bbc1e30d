/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_plane - a deformation of a cage as a map on triangles, none of which is turned over.
 *
 * A sample (icc_sample.h) where that will do. Else, for method ray, all of the deformation
 * (icc_overlay.h), its triangles halved until they are small enough. */
#ifndef ICC_PLANE_H
#define ICC_PLANE_H

#include "icc_map.h"
#include "icc_overlay.h"
#include "icc_sample.h"

struct icc_plane {
    struct icc_map *map; /* ICC_FORWARD, or ICC_INVERSE: then what is said of the source holds for
                            the target, and the other way */
    double max_area;     /* of the triangles in the source, about */
    int digits;          /* of the target, 0: doubles */
};

struct icc_plane_report {
    struct icc_sample_report sample;
    bool overlay; /* the sample would not do */
};

/* Makes the map and proves that it has no folds. Refuses (ERR_REFUSAL): areas that are too small,
 * precision, and, for other methods than ray, what is still turned over after all attempts. Freed
 * by plane_map_free on success. */
bool icc_plane(struct plane_map *map, const struct icc_plane *p, struct icc_plane_report *report,
               struct err *err) WARN_UNUSED;

#endif
