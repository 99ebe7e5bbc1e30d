/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warp - an image moved by a deformation, or by its inverse.
 *
 * Image and picture lie in the world by their viewports, in the grid's frame. What the picture
 * shows at a point q is the image at the p with phi(p) = q, or of the inverse map at p = phi(q):
 * for each sample of each pixel the p itself is found, not approximated, to within 2^-30 of a pixel
 * of the image. Where there is no such p, or p lies outside the image, the picture shows `outside`.
 *
 * A picture that nothing moves and that has the image's viewport is the image, bit for bit; so are
 * parts that are moved by whole pixels, or turned by quarters, as far as phi itself is exact. */
#ifndef WARP_H
#define WARP_H

#include "progress.h"
#include "sampler.h"
#include "spline.h"
#include "viewport.h"

struct warp {
    const struct image *image; /* borrowed, like all others */
    struct viewport from, to;  /* of the image; of the picture */
    const struct spline *spline;
    bool inverse;
    enum sampler_filter filter;
    int antialias;             /* N: the mean of N x N samples a pixel */
    const float *outside;      /* a number for each channel */
    struct progress *progress; /* or NULL */
};

/* Fills the picture, which has the size of warp->to and the image's channels. 100 ns a sample of a
 * map that is one-to-one (inverse_row.h), else up to 1 us. */
bool warp(const struct warp *w, struct image *picture, struct err *err) WARN_UNUSED;

#endif
