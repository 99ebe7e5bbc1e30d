/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "image.h"

#include "mem.h"

#include <string.h>

bool image_allocate(struct image *image, struct err *err) {
    size_t n = (size_t)image->width * image->height;
    if (__builtin_mul_overflow(n, (size_t)image->channels, &n)) return err_memory(err);
    image->value = mem_alloc_unset(n, sizeof *image->value, err);
    return image->value != NULL;
}

void image_free(struct image *image) {
    free(image->names);
    free(image->value);
    *image = (struct image){0};
}

/* Bytes of the names, with the last NUL. */
static size_t names_length(const struct image *image) {
    const char *end = image->names;
    for (int c = 0; c < image->channels; c++) end += strlen(end) + 1;
    return (size_t)(end - image->names);
}

bool image_allocate_like(struct image *image, const struct image *like, uint32_t width,
                         uint32_t height, struct err *err) {
    *image = *like;
    image->width = width;
    image->height = height;
    image->names = NULL;
    image->value = NULL;
    if (like->names) {
        size_t length = names_length(like);
        if (!mem_new(image->names, length, err)) return false;
        memcpy(image->names, like->names, length);
    }
    if (image_allocate(image, err)) return true;
    image_free(image);
    return false;
}

float image_full(enum image_sample sample) {
    return sample == IMAGE_U8 ? UINT8_MAX : sample == IMAGE_U16 ? UINT16_MAX : 1;
}

size_t image_sample_size(enum image_sample sample) {
    return sample == IMAGE_U8 ? 1 : sample == IMAGE_FLOAT ? 4 : 2;
}

/* The nearest whole number in 0..full; x - n is exact. */
static inline int nearest(float x, int full) {
    int n;
    if (!(x > 0)) return 0;
    if (x >= (float)full) return full;
    n = (int)x;
    return n + (x - (float)n >= 0.5F);
}

void image_round_u8(const float *value, size_t n, uint8_t *sample) {
    for (size_t i = 0; i < n; i++) sample[i] = (uint8_t)nearest(value[i], UINT8_MAX);
}

void image_round_u16(const float *value, size_t n, uint16_t *sample) {
    for (size_t i = 0; i < n; i++) sample[i] = (uint16_t)nearest(value[i], UINT16_MAX);
}
