/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_render - a lit picture of a scene, seen from afar (orthographically).
 *
 * The eye is in the direction (azimuth, elevation), degrees: 0, 90 looks straight down on the
 * plane, x to the right and y up; elevation 0 looks along the plane; a growing azimuth carries the
 * eye counter-clockwise around the depth axis, from the side of -y. The light comes from above the
 * eye's left shoulder. Each pixel is the mean of N x N samples. The world of the viewport is the
 * plane of the picture: x along axis[0] of the camera, y along axis[1]. */
#ifndef SCENE_RENDER_H
#define SCENE_RENDER_H

#include "image.h"
#include "progress.h"
#include "scene.h"
#include "viewport.h"

struct scene_camera {
    double axis[3][3]; /* right, up, towards the eye: unit vectors in the scene */
};
struct scene_camera scene_camera(double azimuth, double elevation);

/* The box of what is to be seen, on the picture. ERR_REFUSAL: there is nothing. */
bool scene_bounds(const struct scene *s, const struct scene_camera *camera, double lo[2],
                  double hi[2], struct err *err) WARN_UNUSED;

struct scene_style {
    int antialias;             /* N, 1..16 */
    uint32_t background;       /* 0xRRGGBBAA; AA < 255 only with an alpha channel */
    struct progress *progress; /* or NULL */
};

/* Renders into the image, RGB or RGBA, allocated, of the viewport's size. Memory: 36 bytes a sample
 * of a band of 2^22 samples, 16 a pixel, and the scene again in screen coordinates. O(faces bands +
 * samples). */
bool scene_render(const struct scene *s, const struct scene_camera *camera,
                  const struct viewport *view, const struct scene_style *style, struct image *image,
                  struct err *err) WARN_UNUSED;

#endif
