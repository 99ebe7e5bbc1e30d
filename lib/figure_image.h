/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_image - an image as figures show it: 8 bits a colour, and where it lies in the world. */
#ifndef FIGURE_IMAGE_H
#define FIGURE_IMAGE_H

#include "image.h"

struct figure_image {
    uint32_t width, height;
    uint32_t *pixel; /* rows downwards, 0xRRGGBBAA; from mem.h, owned */
    double frame[4]; /* world position of the first pixel's outer corner, and of the last one's */
};

/* Frame NULL: one unit a pixel, y down, the first corner at 0,0. Grey or RGB, the first channels,
 * with alpha if there is one. 8-bit images are shown as they are; others from their least to their
 * greatest number, since cameras seldom use all 16 bits. O(pixels). */
bool figure_image(struct figure_image *to, const struct image *image, const double frame[4],
                  struct err *err) WARN_UNUSED;

#endif
