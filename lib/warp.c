/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Row by row of samples: their points in the world, the points that these come from, what the image
 * has there; rows of one pixel row add up. */
#include "warp.h"

#include "injective.h"
#include "inverse_row.h"
#include "locate.h"
#include "mem.h"

#include <math.h>
#include <string.h>

#define TOLERANCE 0x1p-30 /* pixels of the image */

struct run {
    const struct warp *warp;
    /* backward */
    struct inverse inverse;
    struct inverse_row rows;
    struct inverse_spot *spot;
    /* forward */
    struct locator locator;
    struct spline_cursor cursor;
    uint32_t hint;
    /* a row of samples, and with several samples a pixel the sums of a row of pixels */
    double (*point)[2];
    float *value;
    double *sum;
};

static bool begin_backward(struct run *r, size_t n, struct err *err) {
    const struct warp *w = r->warp;
    double pixel = fmin(fabs(w->from.step[0]), fabs(w->from.step[1]));
    struct err unproved;
    bool one_to_one = injective_prove(w->spline, &unproved);
    return inverse_init(&r->inverse, w->spline, one_to_one, err) &&
           inverse_row_init(&r->rows, &r->inverse, TOLERANCE * pixel, err) &&
           mem_new(r->spot, n, err);
}

static bool begin(struct run *r, struct err *err) {
    const struct warp *w = r->warp;
    size_t n = (size_t)w->to.width * (size_t)w->antialias, channels = (size_t)w->image->channels;
    if (!mem_new(r->point, n, err) || !mem_new(r->value, n * channels, err) ||
        !mem_new(r->sum, w->to.width * channels, err))
        return false;
    if (!w->inverse) return begin_backward(r, n, err);
    return locator_init(&r->locator, &w->spline->grid, err) &&
           spline_cursor_init(&r->cursor, w->spline, err);
}

static void end(struct run *r) {
    inverse_row_free(&r->rows);
    inverse_free(&r->inverse);
    free(r->spot);
    locator_free(&r->locator);
    spline_cursor_free(&r->cursor);
    free(r->point);
    free(r->value);
    free(r->sum);
}

/* Replaces points of the picture by what they show, or by NaN. */
static void look_backward(struct run *r, size_t n) {
    inverse_row_find(&r->rows, n, (const double(*)[2])r->point, r->spot);
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            r->point[i][k] = r->spot[i].triangle == GRID_NONE ? NAN : r->spot[i].p[k];
}

static void look_forward(struct run *r, size_t n) {
    for (size_t i = 0; i < n; i++) {
        double p[3] = {r->point[i][0], r->point[i][1], 0}, b[3], value[3] = {NAN, NAN, 0};
        uint32_t t;
        if (locate(&r->locator, p, &r->hint, &t, b))
            spline_cursor_evaluate(&r->cursor, t, b, p, value, NULL);
        memcpy(r->point[i], value, sizeof r->point[i]);
    }
}

/* Sets r->value to what the samples of row y, in pixels of the picture, show. */
static void sample_row(struct run *r, double y) {
    const struct warp *w = r->warp;
    size_t n = (size_t)w->to.width * (size_t)w->antialias;
    double world_y = viewport_world(&w->to, 1, y);
    for (size_t i = 0; i < n; i++) {
        r->point[i][0] = viewport_world(&w->to, 0, ((double)i + 0.5) / w->antialias);
        r->point[i][1] = world_y;
    }
    if (w->inverse)
        look_forward(r, n);
    else
        look_backward(r, n);
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++) r->point[i][k] = viewport_pixel(&w->from, k, r->point[i][k]);
    sampler_values(w->image, w->filter, n, (const double(*)[2])r->point, w->outside, r->value);
}

/* Adds a row of samples to the sums of its pixels. Colours with straight alpha count by it. */
static void add_row(struct run *r) {
    const struct image *image = r->warp->image;
    size_t n = (size_t)r->warp->to.width * (size_t)r->warp->antialias;
    size_t channels = (size_t)image->channels;
    for (size_t i = 0; i < n; i++) {
        const float *value = r->value + i * channels;
        double *sum = r->sum + i / (size_t)r->warp->antialias * channels;
        for (size_t k = 0; k < channels; k++)
            sum[k] += image->straight && (int)k != image->alpha
                          ? (double)value[k] * value[image->alpha]
                          : value[k];
    }
}

/* Sets a row of pixels to the means of their samples, and the sums to 0. */
static void end_row(struct run *r, float *pixel) {
    const struct image *image = r->warp->image;
    double samples = r->warp->antialias * r->warp->antialias;
    size_t channels = (size_t)image->channels;
    for (uint32_t i = 0; i < r->warp->to.width; i++) {
        double *sum = r->sum + i * channels, alpha = image->straight ? sum[image->alpha] : 0;
        for (size_t k = 0; k < channels; k++, pixel++) {
            double total = image->straight && (int)k != image->alpha ? alpha : samples;
            *pixel = total != 0 ? (float)(sum[k] / total) : 0;
        }
        memset(sum, 0, channels * sizeof *sum);
    }
}

bool warp(const struct warp *w, struct image *picture, struct err *err) {
    struct run r = {.warp = w};
    bool ok = begin(&r, err);
    for (uint32_t row = 0; ok && row < picture->height; row++) {
        float *pixel = image_pixel(picture, 0, row);
        size_t bytes = picture->width * (size_t)picture->channels * sizeof *pixel;
        for (int i = 0; i < w->antialias; i++) {
            sample_row(&r, row + (i + 0.5) / w->antialias);
            if (w->antialias > 1)
                add_row(&r);
            else
                memcpy(pixel, r.value, bytes);
        }
        if (w->antialias > 1) end_row(&r, pixel);
        progress_step(w->progress, row, picture->height);
    }
    end(&r);
    return ok;
}
