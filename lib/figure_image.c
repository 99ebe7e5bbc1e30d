/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure_image.h"

#include "mem.h"

#include <math.h>
#include <string.h>

/* The numbers that are shown as black and white. */
static void find_range(const struct image *image, float range[2]) {
    const size_t n = (size_t)image->width * image->height * (size_t)image->channels;
    range[0] = INFINITY;
    range[1] = -INFINITY;
    for (size_t i = 0; i < n; i++) {
        float x = image->value[i];
        if ((int)(i % (size_t)image->channels) == image->alpha || !isfinite(x)) continue;
        range[0] = fminf(range[0], x);
        range[1] = fmaxf(range[1], x);
    }
    if (image->sample == IMAGE_U8 || !(range[0] < range[1])) {
        range[0] = 0;
        range[1] = image_full(image->sample);
    }
}

static uint32_t byte_of(float x, float low, float high) {
    float part = (x - low) / (high - low);
    return part > 0 ? (uint32_t)(fminf(part, 1) * 255 + 0.5F) : 0; /* NaN: 0 */
}

static uint32_t colour_of(const struct image *image, const float *value, const float range[2]) {
    const int colours = image->channels - (image->alpha >= 0);
    float cover = image->alpha < 0 ? 1 : value[image->alpha] / image_full(image->sample);
    uint32_t colour = byte_of(cover, 0, 1);
    int channel = 0;
    for (int k = 0; k < 3; k++) {
        float x;
        if (channel == image->alpha) channel++;
        x = value[channel];
        if (!image->straight && cover > 0) x /= cover;
        colour |= byte_of(x, range[0], range[1]) << (24 - 8 * k);
        if (colours >= 3) channel++;
    }
    return colour;
}

bool figure_image(struct figure_image *to, const struct image *image, const double frame[4],
                  struct err *err) {
    const double usual[4] = {0, 0, image->width, image->height};
    float range[2];
    *to = (struct figure_image){.width = image->width, .height = image->height};
    memcpy(to->frame, frame ? frame : usual, sizeof to->frame);
    if (!mem_new(to->pixel, (size_t)image->width * image->height, err)) return false;
    find_range(image, range);
    for (uint32_t r = 0; r < image->height; r++)
        for (uint32_t c = 0; c < image->width; c++)
            to->pixel[(size_t)r * image->width + c] =
                colour_of(image, image_pixel(image, c, r), range);
    return true;
}
