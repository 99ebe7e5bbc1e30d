/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_ray - integral curve coordinates by rays, a homeomorphism.
 *
 * The source cage is mapped one to one onto the disk (icc_embed.h), u = u_S(p). The function
 * f = -|u - u0| has one critical point, a maximum; u0 is the image of the vertex of the mesh that
 * burns last when fire starts on the whole cage, the grassfire maximum. The integral lines of f are
 * what the rays from u0 come from, so
 *
 *      (side, lambda)   the ray from u0 through u ends at lambda of side k of the disk
 *      t                |u - u0| over the length of that ray
 *
 * and since side k of any deformed cage T goes linearly onto the same side of the disk, the point
 * of T with these coordinates is u_T^-1(u): the deformation is piecewise linear and one to one,
 * with an inverse of the same kind. It does not depend on u0. On the cage it is exact: a point on
 * side k at lambda goes to side k at lambda.
 *
 * What is exact: the meshes, the proof that no image of a triangle is turned over, and in which
 * triangle a point lies. The positions of vertices in the disk are rounded once, and so are the
 * means of corners. */
#ifndef ICC_RAY_H
#define ICC_RAY_H

#include "icc.h"
#include "icc_embed.h"
#include "mesh_locate.h"

/* A cage with its map to the disk. Read-only once it has what it is used for. */
struct icc_ray {
    const struct cage *cage; /* borrowed */
    struct icc_disk disk;    /* of the source; owned by it */
    double centre[2];        /* u0, of the source */
    bool is_source;
    struct icc_mesh mesh;
    double (*image)[2]; /* of its vertices in the disk */
    bool uniform;       /* see icc_embed */
    /* private */
    struct mesh_locator world, inner;
};

/* Of the source (source = NULL), or of a deformed version: made by cage_init_like of the source's
 * cage. `points`: see icc_mesh. The source outlives its deformed versions. Refusals are
 * ERR_REFUSAL, "precision". About 4 us a point. */
bool icc_ray_init(struct icc_ray *r, const struct cage *cage, const struct icc_ray *source,
                  size_t points, struct err *err) WARN_UNUSED;
void icc_ray_free(struct icc_ray *r); /* harmless on a zeroed struct */

/* What a cage is used for: points of it are looked up, or asked for. To be said once, before. About
 * 1 us a point for each. */
enum { ICC_RAY_LOOK_UP = 1, ICC_RAY_ASK = 2 };
bool icc_ray_prepare(struct icc_ray *r, unsigned use, struct err *err) WARN_UNUSED;

/* Where the last points were found: makes the next ones fast if they lie near, and has no effect on
 * the answers. Starts zeroed. */
struct icc_ray_cursor {
    uint32_t from, to;
};

/* The coordinates of p, with sides of the prepared cage (ICC_RAY_LOOK_UP). False: p lies outside.
 */
bool icc_ray_coordinates(const struct icc_ray *r, struct icc_ray_cursor *cursor, const double p[2],
                         struct icc_place *place);

/* The point with these coordinates (ICC_RAY_ASK). */
void icc_ray_point(const struct icc_ray *r, struct icc_ray_cursor *cursor,
                   const struct icc_place *place, double p[2]);

/* Both at once, without the detour over u0: the image q in `to` (ICC_RAY_ASK) of a point p of
 * `from` (ICC_RAY_LOOK_UP). False: p lies outside. One of the two is the source of the other, or
 * both have the same. */
bool icc_ray_map(const struct icc_ray *from, const struct icc_ray *to,
                 struct icc_ray_cursor *cursor, const double p[2], double q[2]);

#endif
