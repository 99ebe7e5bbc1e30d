/* SPDX-License-Identifier: GPL-3.0-or-later */
/* viewport - where the pixels of a picture lie in the world.
 *
 * Pixel coordinates are those of image.h: (0,0) is the outer corner of the first pixel, (width,
 * height) that of the last, rows run downwards. The world's y grows downwards, too, or upwards:
 * then step[1] < 0. One unit a pixel with the corner at 0,0, which is the default for images that
 * are read, is exact in both directions. */
#ifndef VIEWPORT_H
#define VIEWPORT_H

#include <stdbool.h>
#include <stdint.h>

struct viewport {
    uint32_t width, height;
    double corner[2]; /* the world position of (0,0) */
    double step[2];   /* world units a pixel; not 0 */
};

/* frame: X0,Y0,X1,Y1, the world positions of (0,0) and (width, height); NULL: 0,0,width,height. */
static inline struct viewport viewport_of_frame(uint32_t width, uint32_t height,
                                                const double frame[4]) {
    struct viewport v = {width, height, {0, 0}, {1, 1}};
    if (!frame) return v;
    v.corner[0] = frame[0];
    v.corner[1] = frame[1];
    v.step[0] = (frame[2] - frame[0]) / width;
    v.step[1] = (frame[3] - frame[1]) / height;
    return v;
}

static inline double viewport_world(const struct viewport *v, int axis, double pixel) {
    return v->corner[axis] + v->step[axis] * pixel;
}

static inline double viewport_pixel(const struct viewport *v, int axis, double world) {
    return (world - v->corner[axis]) / v->step[axis];
}

/* The whole box in a picture of so many pixels, which are squares, in its middle. */
struct viewport viewport_fit(const double lo[2], const double hi[2], const uint32_t size[2],
                             bool y_down);

/* The box with `scale` pixels a unit, rounded up to whole pixels at its right and at its bottom.
 * False: a side would have more than `most` pixels. */
bool viewport_scale(struct viewport *v, const double lo[2], const double hi[2], double scale,
                    uint32_t most, bool y_down);

#endif
