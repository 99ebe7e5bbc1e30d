/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pnm_io.h"

#include <inttypes.h>
#include <string.h>

struct pixels {
    const unsigned char *at, *end;
    uint32_t largest; /* what stands for white */
    bool bitmap, plain;
    uint32_t width, column; /* rows of raw bitmaps end with a byte */
};

static bool is_blank(int c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

static void skip_blanks(struct pixels *p) {
    while (p->at < p->end && (is_blank(*p->at) || *p->at == '#'))
        if (*p->at++ == '#')
            while (p->at < p->end && *p->at != '\n') p->at++;
}

/* Digits of plain bitmaps need no blanks between them. -1: there is no number. */
static int64_t plain_value(struct pixels *p) {
    int64_t value = 0;
    const unsigned char *begin;
    skip_blanks(p);
    begin = p->at;
    while (p->at < p->end && *p->at >= '0' && *p->at <= '9' && value <= UINT16_MAX) {
        value = 10 * value + (*p->at++ - '0');
        if (p->bitmap) break;
    }
    return p->at > begin ? value : -1;
}

/* A sample of a bitmap; the first of a row begins a byte. */
static int64_t raw_bit(struct pixels *p) {
    int bit = 7 - (int)(p->column % 8);
    if (p->at == p->end) return -1;
    if (++p->column == p->width) p->column = 0;
    return *(bit == 0 || p->column == 0 ? p->at++ : p->at) >> bit & 1;
}

static int64_t raw_value(struct pixels *p) {
    int n = p->largest > UINT8_MAX ? 2 : 1;
    int64_t value;
    if (p->end - p->at < n) return -1;
    value = p->at[0];
    if (n == 2) value = value << 8 | p->at[1];
    p->at += n;
    return value;
}

static const char *read_values(struct pixels *p, float *value, size_t n, uint32_t full) {
    for (size_t i = 0; i < n; i++) {
        int64_t x = p->plain ? plain_value(p) : p->bitmap ? raw_bit(p) : raw_value(p);
        if (x < 0) return "the pixels end early or are damaged";
        if (x > p->largest) return "a value is larger than the largest";
        if (p->bitmap) x = 1 - x;
        if (p->largest != full) x = (2 * x * full + p->largest) / (2 * p->largest);
        value[i] = (float)x;
    }
    return NULL;
}

bool pnm_read(struct image *image, const struct image_header *h, const void *bytes, size_t length,
              struct err *err) {
    const unsigned char *begin = bytes;
    int kind = begin[1] - '0';
    struct pixels p = {.at = begin + h->pixels,
                       .end = begin + length,
                       .largest = h->largest,
                       .bitmap = kind == 1 || kind == 4,
                       .plain = kind <= 3,
                       .width = h->width};
    const char *wrong;
    size_t n;
    image->channels = kind == 3 || kind == 6 ? 3 : 1;
    image->alpha = -1;
    image->sample = h->largest > UINT8_MAX ? IMAGE_U16 : IMAGE_U8;
    n = (size_t)h->width * h->height * (size_t)image->channels;
    if (!image_allocate(image, err)) return false;
    wrong = read_values(&p, image->value, n, (uint32_t)image_full(image->sample));
    return !wrong || err_set(err, ERR_INPUT, "bad PNM image: %s", wrong);
}

void pnm_write(struct out *out, const struct image *image, void *samples) {
    size_t n = (size_t)image->width * image->height * (size_t)image->channels;
    unsigned char *byte = samples;
    out_format(out, "P%c\n%" PRIu32 " %" PRIu32 "\n%d\n", image->channels == 1 ? '5' : '6',
               image->width, image->height, (int)image_full(image->sample));
    for (size_t i = 0; image->sample == IMAGE_U16 && i < n; i++) {
        uint16_t sample;
        memcpy(&sample, byte + 2 * i, 2);
        byte[2 * i] = (unsigned char)(sample >> 8);
        byte[2 * i + 1] = (unsigned char)sample;
    }
    out_bytes(out, samples, n * image_sample_size(image->sample));
}
