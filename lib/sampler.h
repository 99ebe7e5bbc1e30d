/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sampler - an image as a function on the plane, between its pixels.
 *
 * Positions are pixel coordinates (image.h): at the centre of a pixel the function has the pixel's
 * value, bit for bit, with every filter. As far as positions carry rounding errors, a pixel's
 * centre is meant when it is nearer than 2^-24 of a pixel. The outermost pixels go on to the
 * image's edge; beyond it there is nothing.
 *
 * Colours beside a straight alpha are weighted by it, so that what is transparent does not shine
 * through at edges. */
#ifndef SAMPLER_H
#define SAMPLER_H

#include "image.h"

enum sampler_filter {
    SAMPLER_NEAREST,
    SAMPLER_LINEAR, /* of 2 x 2 pixels */
    SAMPLER_CUBIC,  /* of 4 x 4: Catmull and Rom's spline, Keys's with a = -1/2; it may overshoot */
};

/* "nearest", "linear", "cubic"; NULL ends them. */
extern const char *const sampler_filter_names[];

/* Values at n positions, one pixel after the other; where a position lies outside, or is NaN,
 * those of `outside`. */
void sampler_values(const struct image *image, enum sampler_filter filter, size_t n,
                    const double (*position)[2], const float *outside, float *value);

#endif
