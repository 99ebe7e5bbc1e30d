/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A filter is a product of one for columns and one for rows: up to four taps each, pixel numbers
 * and weights that add up to 1. Taps beyond the edge are those at the edge. Where a position is a
 * pixel's centre in one direction, that direction has a single tap. */
#include "sampler.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

const char *const sampler_filter_names[] = {"nearest", "linear", "cubic", NULL};

#define NEAR 0x1p-24

struct taps {
    int n;
    uint32_t at[4];
    double weight[4];
};

static void cubic_weights(double t, double w[4]) {
    w[0] = t * (-0.5 + t * (1 - 0.5 * t));
    w[1] = 1 + t * t * (1.5 * t - 2.5);
    w[2] = t * (0.5 + t * (2 - 1.5 * t));
    w[3] = t * t * (0.5 * t - 0.5);
}

/* False: outside. */
static inline bool find_taps(struct taps *taps, enum sampler_filter filter, double x,
                             uint32_t size) {
    double t;
    int32_t first;
    int n = filter == SAMPLER_CUBIC ? 4 : 2;
    if (!(x >= -NEAR && x <= size + NEAR)) return false;
    first = (int32_t)(x + 0.5) - 1; /* the last centre at or before x */
    t = x - 0.5 - first;
    if (t > 1 - NEAR) {
        first++;
        t = 0;
    }
    taps->n = 1;
    taps->weight[0] = 1;
    if (filter == SAMPLER_NEAREST)
        first += t >= 0.5 - NEAR;
    else if (t >= NEAR) {
        taps->n = n;
        if (n == 4) {
            first--;
            cubic_weights(t, taps->weight);
        } else {
            taps->weight[0] = 1 - t;
            taps->weight[1] = t;
        }
    }
    for (int i = 0; i < taps->n; i++) {
        int32_t at = first + i;
        taps->at[i] = at < 0 ? 0 : at >= (int32_t)size ? size - 1 : (uint32_t)at;
    }
    return true;
}

/* The sums of weight * pixel. A constant number of channels is what takes time to read. */
static inline __attribute__((always_inline)) void blend(const struct image *image, int channels,
                                                        const struct taps *x, const struct taps *y,
                                                        float *value) {
    double sum[IMAGE_CHANNELS_MAX];
    for (int k = 0; k < channels; k++) sum[k] = 0;
    for (int r = 0; r < y->n; r++)
        for (int c = 0; c < x->n; c++) {
            const float *pixel = image_pixel(image, x->at[c], y->at[r]);
            double weight = x->weight[c] * y->weight[r];
            for (int k = 0; k < channels; k++) sum[k] += weight * pixel[k];
        }
    for (int k = 0; k < channels; k++) value[k] = (float)sum[k];
}

/* The same for colours beside a straight alpha: of weight * alpha * pixel, over that of alpha. */
static void blend_straight(const struct image *image, const struct taps *x, const struct taps *y,
                           float *value) {
    double sum[IMAGE_CHANNELS_MAX] = {0}, covered = 0;
    blend(image, image->channels, x, y, value);
    if (!(value[image->alpha] > 0)) return;
    for (int r = 0; r < y->n; r++)
        for (int c = 0; c < x->n; c++) {
            const float *pixel = image_pixel(image, x->at[c], y->at[r]);
            double weight = x->weight[c] * y->weight[r] * pixel[image->alpha];
            covered += weight;
            for (int k = 0; k < image->channels; k++) sum[k] += weight * pixel[k];
        }
    for (int k = 0; k < image->channels; k++)
        if (k != image->alpha) value[k] = (float)(sum[k] / covered);
}

static void blend_any(const struct image *image, const struct taps *x, const struct taps *y,
                      float *value) {
    if (image->straight)
        blend_straight(image, x, y, value);
    else if (image->channels == 1)
        blend(image, 1, x, y, value);
    else if (image->channels == 3)
        blend(image, 3, x, y, value);
    else
        blend(image, image->channels, x, y, value);
}

void sampler_values(const struct image *image, enum sampler_filter filter, size_t n,
                    const double (*position)[2], const float *outside, float *value) {
    size_t size = (size_t)image->channels * sizeof *value;
    for (size_t i = 0; i < n; i++, value += image->channels) {
        struct taps x, y;
        if (!find_taps(&x, filter, position[i][0], image->width) ||
            !find_taps(&y, filter, position[i][1], image->height))
            memcpy(value, outside, size);
        else if (x.n == 1 && y.n == 1)
            memcpy(value, image_pixel(image, x.at[0], y.at[0]), size);
        else
            blend_any(image, &x, &y, value);
    }
}
