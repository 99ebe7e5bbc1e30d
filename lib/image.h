/* SPDX-License-Identifier: GPL-3.0-or-later */
/* image - a picture as numbers.
 *
 * Rows run downwards, columns to the right; pixel (column c, row r) covers [c,c+1] x [r,r+1], its
 * centre at +1/2. A pixel has one number for each channel. Whatever type of sample a file has, its
 * numbers are held as floats, which hold all of them exactly: 8 and 16-bit samples as 0..255 and
 * 0..65535, not as fractions. So what nobody touches is written back bit for bit.
 *
 * One channel may be `alpha`, how much of the pixel is covered, from 0 to image_full(). The colours
 * beside it are either those of what covers (`straight`: PNG, some TIFF) or multiplied by it
 * (OpenEXR, other TIFF).
 *
 * What the numbers mean as light (sRGB, linear, a wavelength) is not known here: means and
 * interpolations are those of the numbers. */
#ifndef IMAGE_H
#define IMAGE_H

#include "err.h"

#include <stdint.h>

enum image_sample { IMAGE_U8, IMAGE_U16, IMAGE_HALF, IMAGE_FLOAT };

enum {
    IMAGE_SIDE_MAX = 1 << 24, /* pixels; as many as a lattice has steps */
    IMAGE_CHANNELS_MAX = 64,
};

struct image {
    uint32_t width, height;
    int channels;
    int alpha; /* number of that channel; -1: there is none */
    bool straight;
    enum image_sample sample; /* what a file holds */
    char *names;              /* of the channels, each ended by a NUL; NULL: the usual ones */
    float *value;             /* [(row * width + column) * channels + channel] */
};

/* Room for the pixels of an image whose other fields are set; the values are not. O(1) memory until
 * they are. */
bool image_allocate(struct image *image, struct err *err) WARN_UNUSED;
void image_free(struct image *image); /* harmless on a zeroed struct */

/* Room for an image of another size, or the same, with the channels and types of `like`. */
bool image_allocate_like(struct image *image, const struct image *like, uint32_t width,
                         uint32_t height, struct err *err) WARN_UNUSED;

/* The largest value of 8 and 16-bit samples; 1 for the others. */
float image_full(enum image_sample sample);

/* Bytes of a sample in a file. */
size_t image_sample_size(enum image_sample sample);

static inline float *image_pixel(const struct image *image, uint32_t column, uint32_t row) {
    return image->value + ((size_t)row * image->width + column) * (size_t)image->channels;
}

/* n values as 8 or 16-bit samples: the nearest, halves upwards, those beyond the range and NaN its
 * ends (NaN: 0). */
void image_round_u8(const float *value, size_t n, uint8_t *sample);
void image_round_u16(const float *value, size_t n, uint16_t *sample);

#endif
