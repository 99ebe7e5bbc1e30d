/* SPDX-License-Identifier: GPL-3.0-or-later */
/* texture - what is painted on the plane of a pattern: a checkerboard of two colours, or an image.
 *
 * Colours are red, green, blue, alpha from 0 to 1; in results the first three are multiplied by
 * alpha. */
#ifndef TEXTURE_H
#define TEXTURE_H

#include "image.h"
#include "viewport.h"

struct texture {
    double origin[2], square;  /* the checkerboard: the corner of a square, and its side */
    double colour[2][4];       /* of even and odd squares, see checker.h */
    const struct image *image; /* instead of it, unless NULL; borrowed; in the first channels grey
                                  or RGB */
    struct viewport view;      /* where the image lies; around it everything is transparent */
};

/* The mean over the parallelogram around `at` that u and v span: of the checkerboard in closed form
 * (checker.h); of an image over points of its bilinear interpolation, closer than its pixels, as
 * long as that takes no more than 32 x 32 of them. */
void texture_mean(const struct texture *t, const double at[2], const double u[2], const double v[2],
                  double rgba[4]);

/* Makes it a checkerboard of n squares along the longer side of a box, from its low corner on. */
void texture_squares(struct texture *t, const double lo[2], const double hi[2], double n);

/* A colour 0xRRGGBBAA as four numbers. */
void texture_colour(uint32_t colour, double rgba[4]);

#endif
