/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "render.h"

#include "palette.h"

#include <math.h>

/* How much of what lies below a mark of a fold hides. */
#define FOLD_OPACITY 0.6

/* An opaque colour over a sum, as far as `opacity` goes. */
static void cover(double rgba[4], uint32_t colour, double opacity) {
    double over[4];
    texture_colour(colour, over);
    for (int k = 0; k < 4; k++) rgba[k] += opacity * (over[k] - rgba[k]);
}

void render_add(const struct render_style *style, const struct render_sight *sight, double sum[4]) {
    double rgba[4];
    if (style->lines && sight->line < 0.5) {
        texture_colour(PALETTE_INK, rgba);
    } else {
        texture_mean(&style->texture, sight->at, sight->u, sight->v, rgba);
        if (style->folds && sight->fold) cover(rgba, PALETTE_FOLD, FOLD_OPACITY);
    }
    for (int k = 0; k < 4; k++) sum[k] += rgba[k];
}

bool render_add_plain(const struct render_style *style, const struct render_sight *sight,
                      double sum[4]) {
    const struct texture *t = &style->texture;
    struct render_sight centre = *sight;
    int samples = style->antialias * style->antialias;
    double once[4] = {0};
    if (t->image || (style->lines && sight->line < 1.5)) return false;
    for (int k = 0; k < 2; k++) { /* all samples and their footprints: a pixel to all sides */
        double x = (sight->at[k] - t->origin[k]) / t->square;
        double reach = (fabs(sight->u[k]) + fabs(sight->v[k])) / t->square;
        if (floor(x - reach) != floor(x + reach)) return false;
        centre.u[k] = centre.v[k] = 0;
    }
    render_add(style, &centre, once);
    for (int k = 0; k < 4; k++) sum[k] += samples * once[k];
    return true;
}

void render_set(const struct render_style *style, const double sum[4], const struct image *image,
                uint32_t column, uint32_t row) {
    float *pixel = image_pixel(image, column, row);
    const double *background = style->background;
    double full = image_full(image->sample), rgba[4], samples = style->antialias * style->antialias;
    for (int k = 0; k < 4; k++) rgba[k] = sum[k] / samples;
    for (int k = 0; k < 3; k++) rgba[k] += (1 - rgba[3]) * background[k] * background[3];
    rgba[3] += (1 - rgba[3]) * background[3];
    for (int k = 0; k < image->channels; k++) {
        bool straight = k < 3 && image->straight && rgba[3] > 0;
        pixel[k] = (float)(full * (straight ? rgba[k] / rgba[3] : rgba[k]));
    }
}
