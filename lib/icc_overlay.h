/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_overlay - the deformation of method ray as a triangulation: all of it, not a sample.
 *
 * Source and target are the cages' meshes, mapped to the same disk. The deformation is affine where
 * a triangle of the one meets a triangle of the other, in the cells of their overlay; so the cells,
 * triangulated, are the deformation itself, and none of them is turned over. Their number is about
 * ten times that of the meshes' vertices together; it grows where the meshes are dense in different
 * places of the disk.
 *
 * The meshes cut the sides of their cages differently. First each is cut where the other has a
 * vertex on its rim, the point of the same lambda: then both have the same boundary in the disk. */
#ifndef ICC_OVERLAY_H
#define ICC_OVERLAY_H

#include "icc_ray.h"
#include "joint.h"

/* The map without folds: the overlay's cells, rounded to so many significant digits in the target
 * (0: doubles); vertices of the cages are kept. Where that turns triangles over, vertices are taken
 * away or moved (joint.h). With max_area > 0, triangles are joined and halved until they have about
 * that area in the source: then it is the deformation no more, but a sample of it that has no folds
 * either. Refuses (precision) what even then has folds, and areas that take more than
 * ICC_OVERLAY_MAX triangles. About 2 us a triangle, 20 us for each vertex that is taken away. Freed
 * by plane_map_free on success. */
enum { ICC_OVERLAY_MAX = 2000000 };
bool icc_overlay(struct plane_map *map, const struct icc_ray *source, const struct icc_ray *target,
                 double max_area, int digits, struct err *err) WARN_UNUSED;

#endif
