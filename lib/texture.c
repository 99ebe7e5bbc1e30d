/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "texture.h"

#include "checker.h"
#include "sampler.h"

#include <math.h>

enum { POINTS_MAX = 32 }; /* in each direction */

void texture_colour(uint32_t colour, double rgba[4]) {
    for (int k = 0; k < 4; k++) rgba[k] = (colour >> (24 - 8 * k) & 255) / 255.0;
}

void texture_squares(struct texture *t, const double lo[2], const double hi[2], double n) {
    double side = fmax(hi[0] - lo[0], hi[1] - lo[1]);
    for (int k = 0; k < 2; k++) t->origin[k] = lo[k];
    t->square = side > 0 ? side / n : 1;
}

/* A pixel's colour, times alpha; rgb may already be so. */
static void pixel_colour(const struct image *image, const float *pixel, double rgba[4]) {
    double full = image_full(image->sample);
    bool grey = image->channels - (image->alpha >= 0) < 3;
    rgba[3] = image->alpha >= 0 ? pixel[image->alpha] / full : 1;
    for (int k = 0; k < 3; k++) {
        rgba[k] = pixel[grey ? 0 : k] / full;
        if (image->straight) rgba[k] *= rgba[3];
    }
}

/* How many points it takes along a vector so that they are closer than pixels. */
static int points_along(const struct viewport *view, const double u[2]) {
    double length = fmax(fabs(u[0] / view->step[0]), fabs(u[1] / view->step[1]));
    return length > POINTS_MAX ? POINTS_MAX : length > 1 ? (int)ceil(length) : 1;
}

static void image_mean(const struct texture *t, const double at[2], const double u[2],
                       const double v[2], double rgba[4]) {
    static const float nothing[IMAGE_CHANNELS_MAX] = {0};
    int nu = points_along(&t->view, u), nv = points_along(&t->view, v);
    for (int k = 0; k < 4; k++) rgba[k] = 0;
    for (int i = 0; i < nu * nv; i++) {
        const int column = i % nu, row = i / nu;
        double a = (column + 0.5) / nu - 0.5, b = (row + 0.5) / nv - 0.5; /* -1/2..1/2 */
        double position[1][2], colour[4];
        float pixel[IMAGE_CHANNELS_MAX];
        for (int k = 0; k < 2; k++)
            position[0][k] = viewport_pixel(&t->view, k, at[k] + a * u[k] + b * v[k]);
        if (!(position[0][0] >= 0 && position[0][0] <= t->view.width && position[0][1] >= 0 &&
              position[0][1] <= t->view.height))
            continue;
        sampler_values(t->image, SAMPLER_LINEAR, 1, (const double(*)[2])position, nothing, pixel);
        pixel_colour(t->image, pixel, colour);
        for (int k = 0; k < 4; k++) rgba[k] += colour[k] / (nu * nv);
    }
}

static void checker_mean(const struct texture *t, const double at[2], const double u[2],
                         const double v[2], double rgba[4]) {
    double c[2], su[2], sv[2], odd;
    for (int k = 0; k < 2; k++) {
        c[k] = (at[k] - t->origin[k]) / t->square;
        su[k] = u[k] / t->square;
        sv[k] = v[k] / t->square;
    }
    odd = checker_share(c, su, sv);
    rgba[3] = (1 - odd) * t->colour[0][3] + odd * t->colour[1][3];
    for (int k = 0; k < 3; k++)
        rgba[k] =
            (1 - odd) * t->colour[0][k] * t->colour[0][3] + odd * t->colour[1][k] * t->colour[1][3];
}

void texture_mean(const struct texture *t, const double at[2], const double u[2], const double v[2],
                  double rgba[4]) {
    if (t->image)
        image_mean(t, at, u, v, rgba);
    else
        checker_mean(t, at, u, v, rgba);
}
