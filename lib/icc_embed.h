/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_embed - a triangulated cage mapped one to one onto a convex polygon, the disk.
 *
 * The corners c_k of the disk lie on the unit circle, one for each side of the source cage, with
 * angles in proportion to the lengths of the sides (at least 1/1000 of the mean each). Side k of
 * any deformed cage goes linearly onto the disk's side from c_k to c_k+1: exactly so, since corners
 * are rounded to multiples of 2^-34 and rim vertices are at multiples of a power of two, unless
 * there are thousands of very short sides. Each inside vertex is the mean of its neighbours with
 * positive weights. Such a map is a homeomorphism (Tutte 1963, Floater 2003), and so is the map
 * that is affine on each triangle, if the images of all triangles are counter-clockwise: that is
 * checked exactly. The weights are (cot alpha + cot beta) / 2, those of harmonic maps, clamped to
 * [0.05, 20]; where rounding turns a triangle over, they are all 1. */
#ifndef ICC_EMBED_H
#define ICC_EMBED_H

#include "icc_mesh.h"

struct icc_disk {
    size_t count;
    double (*corner)[2]; /* counter-clockwise */
    double *length;      /* of the sides */
};

/* The disk of a source cage. */
bool icc_disk_init(struct icc_disk *d, const struct cage *source, struct err *err) WARN_UNUSED;
void icc_disk_free(struct icc_disk *d); /* harmless on a zeroed struct */

/* The point at lambda of side k of the disk. */
void icc_disk_point(const struct icc_disk *d, uint32_t side, double lambda, double u[2]);

/* The area centroid, which lies inside. */
void icc_disk_centroid(const struct icc_disk *d, double u[2]);

/* The images of all vertices of a mesh, rounded once; the caller frees *image. *uniform: the
 * weights had to be 1. Refuses (ERR_REFUSAL, "precision") where doubles cannot tell the images of
 * vertices apart. Cost: see laplace.h. */
bool icc_embed(const struct icc_mesh *m, const struct icc_disk *d, double (**image)[2],
               bool *uniform, struct err *err) WARN_UNUSED;

#endif
