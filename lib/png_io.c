/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A chunk is { length 4, type 4, data, CRC 4 }, numbers big endian; a type in lower case is
 * ancillary.
 *
 * libpng tells of errors by longjmp. Each of the two functions that set the place to go to has no
 * variables of its own that change: all is in a struct. */
#include "png_io.h"

#include "mem.h"

#include <png.h>
#include <stdint.h>
#include <string.h>

enum { SIGNATURE = 8, AROUND = 12 }; /* bytes; the latter of a chunk without its data */

/* ---- what is read of a file */

static bool is_pixels(const unsigned char *type) {
    static const char kept[][5] = {"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (memcmp(type, kept[i], 4) == 0) return true;
    return false;
}

/* The length of a chunk as a whole, 0: it goes beyond the end. */
static size_t chunk_length(const unsigned char *chunk, const unsigned char *end) {
    size_t left = (size_t)(end - chunk), n;
    if (left < AROUND) return 0;
    n = (size_t)chunk[0] << 24 | (size_t)chunk[1] << 16 | (size_t)chunk[2] << 8 | chunk[3];
    return n <= left - AROUND ? n + AROUND : 0;
}

/* Appends the chunks at *to; returns what is wrong, or NULL. */
static const char *copy_chunks(unsigned char **to, const unsigned char *chunk,
                               const unsigned char *end) {
    bool begun = false, ended = false; /* the chunks IDAT */
    for (;;) {
        const unsigned char *type = chunk + 4;
        size_t n = chunk_length(chunk, end);
        if (n == 0) return "it ends within a chunk or before IEND";
        if (memcmp(type, "IDAT", 4) != 0)
            ended = begun;
        else if (ended)
            return "other chunks are between those of its pixels (IDAT)";
        else
            begun = true;
        if (is_pixels(type)) {
            memcpy(*to, chunk, n);
            *to += n;
        } else if (type[0] < 'a')
            return "it has an unknown critical chunk";
        if (memcmp(type, "IEND", 4) == 0) return NULL;
        chunk += n;
    }
}

/* A copy of a file, without all that is not pixels. */
static bool pixels_only(const void *bytes, size_t length, unsigned char **copy, size_t *copy_length,
                        struct err *err) {
    const unsigned char *begin = bytes;
    unsigned char *to = *copy = mem_alloc_unset(length, 1, err);
    const char *wrong;
    if (!to) return false;
    memcpy(to, begin, SIGNATURE);
    to += SIGNATURE;
    wrong = copy_chunks(&to, begin + SIGNATURE, begin + length);
    *copy_length = (size_t)(to - *copy);
    return !wrong || err_set(err, ERR_INPUT, "bad PNG image: %s", wrong);
}

/* ---- libpng's way to fail */

struct failure {
    struct err *err;
    const char *what;
};

static PNG_NORETURN void on_error(png_structp png, png_const_charp message) {
    const struct failure *f = png_get_error_ptr(png);
    err_set(f->err, ERR_INPUT, "%s: %s", f->what, message);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message) {
    (void)png;
    (void)message;
}

/* ---- reading */

struct reader {
    png_structp png;
    png_infop info;
    struct image *image;
    const unsigned char *at, *end;
    unsigned char *row; /* one; all of an interlaced image */
    size_t row_bytes;
    int passes;
    bool palette;
    png_colorp colour;
    int colours, opacities; /* of the palette */
    png_bytep opacity;
    struct err *err;
};

static void read_bytes(png_structp png, png_bytep to, size_t n) {
    struct reader *r = png_get_io_ptr(png);
    if ((size_t)(r->end - r->at) < n) png_error(png, "it ends early");
    memcpy(to, r->at, n);
    r->at += n;
}

/* The channels and samples of the image, and how rows come. */
static void read_header(struct reader *r) {
    struct image *image = r->image;
    int depth, type;
    png_uint_32 width, height;
    png_read_info(r->png, r->info);
    png_get_IHDR(r->png, r->info, &width, &height, &depth, &type, NULL, NULL, NULL);
    if (width != image->width || height != image->height) png_error(r->png, "it has two sizes");
    r->palette = type == PNG_COLOR_TYPE_PALETTE;
    if (r->palette) {
        png_set_packing(r->png);
        png_get_PLTE(r->png, r->info, &r->colour, &r->colours);
        png_get_tRNS(r->png, r->info, &r->opacity, &r->opacities, NULL);
    } else {
        png_set_expand(r->png);
    }
    if (depth == 16) png_set_swap(r->png);
    r->passes = png_set_interlace_handling(r->png);
    png_read_update_info(r->png, r->info);
    r->row_bytes = png_get_rowbytes(r->png, r->info);
    image->channels = r->palette ? (r->opacities > 0 ? 4 : 3) : png_get_channels(r->png, r->info);
    image->alpha = image->channels % 2 ? -1 : image->channels - 1;
    image->straight = image->alpha >= 0;
    image->sample = depth == 16 ? IMAGE_U16 : IMAGE_U8;
}

static void set_from_palette(const struct reader *r, const unsigned char *index, float *value) {
    for (uint32_t c = 0; c < r->image->width; c++, index++, value += r->image->channels) {
        if (*index >= r->colours) png_error(r->png, "a pixel's colour is not in the palette");
        value[0] = r->colour[*index].red;
        value[1] = r->colour[*index].green;
        value[2] = r->colour[*index].blue;
        if (r->opacities > 0) value[3] = *index < r->opacities ? r->opacity[*index] : 255;
    }
}

static void set_row(const struct reader *r, const unsigned char *samples, uint32_t row) {
    float *value = image_pixel(r->image, 0, row);
    size_t n = (size_t)r->image->width * (size_t)r->image->channels;
    uint16_t word;
    if (r->palette) {
        set_from_palette(r, samples, value);
    } else if (r->image->sample == IMAGE_U8) {
        for (size_t i = 0; i < n; i++) value[i] = samples[i];
    } else {
        for (size_t i = 0; i < n; i++) {
            memcpy(&word, samples + 2 * i, 2);
            value[i] = word;
        }
    }
}

/* The size of the decoder's work is known to be allowed. */
static bool decode(struct reader *r) {
    const bool whole = r->passes > 1;
    if (!image_allocate(r->image, r->err)) return false;
    r->row = mem_alloc_unset(whole ? r->image->height : 1, r->row_bytes, r->err);
    if (!r->row) return false;
    for (int pass = 0; pass < r->passes; pass++)
        for (uint32_t row = 0; row < r->image->height; row++) {
            unsigned char *samples = r->row + (whole ? row * r->row_bytes : 0);
            png_read_row(r->png, samples, NULL);
            if (pass == r->passes - 1) set_row(r, samples, row);
        }
    png_read_end(r->png, NULL);
    return true;
}

static bool read_all(struct reader *r) {
    if (setjmp(png_jmpbuf(r->png))) return false;
    png_set_user_limits(r->png, IMAGE_SIDE_MAX, IMAGE_SIDE_MAX);
    png_set_crc_action(r->png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_read_fn(r->png, r, read_bytes);
    read_header(r);
    return decode(r);
}

bool png_read(struct image *image, const void *bytes, size_t length, struct err *err) {
    struct failure failure = {err, "bad PNG image"};
    struct reader r = {.image = image, .err = err};
    unsigned char *copy = NULL;
    bool ok = pixels_only(bytes, length, &copy, &length, err);
    if (ok) {
        r.at = copy;
        r.end = copy + length;
        r.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning);
        r.info = r.png ? png_create_info_struct(r.png) : NULL;
        ok = r.info ? read_all(&r) : err_memory(err);
    }
    png_destroy_read_struct(&r.png, &r.info, NULL);
    free(r.row);
    free(copy);
    return ok;
}

/* ---- writing */

struct writer {
    png_structp png;
    png_infop info;
    const struct image *image;
    const unsigned char *samples, *end; /* of rows still to be written */
    struct out *out;
};

static void write_bytes(png_structp png, png_bytep bytes, size_t n) {
    const struct writer *w = png_get_io_ptr(png);
    out_bytes(w->out, (const char *)bytes, n);
}

static void flush(png_structp png) {
    (void)png;
}

static bool write_all(struct writer *w) {
    static const int types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                PNG_COLOR_TYPE_RGB_ALPHA};
    const struct image *image = w->image;
    const size_t bytes = image->width * (size_t)image->channels * image_sample_size(image->sample);
    if (setjmp(png_jmpbuf(w->png))) return false;
    png_set_user_limits(w->png, IMAGE_SIDE_MAX, IMAGE_SIDE_MAX);
    png_set_write_fn(w->png, w, write_bytes, flush);
    png_set_IHDR(w->png, w->info, image->width, image->height,
                 8 * (int)image_sample_size(image->sample), types[image->channels - 1],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    png_write_info(w->png, w->info);
    if (image->sample == IMAGE_U16) png_set_swap(w->png);
    for (; w->samples < w->end; w->samples += bytes) png_write_row(w->png, w->samples);
    png_write_end(w->png, NULL);
    return true;
}

bool png_write(struct out *out, const struct image *image, const void *samples, struct err *err) {
    struct failure failure = {err, "cannot write PNG"};
    struct writer w = {.image = image, .samples = samples, .out = out};
    bool ok;
    w.end = w.samples + (size_t)image->height * image->width * (size_t)image->channels *
                            image_sample_size(image->sample);
    w.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &failure, on_error, on_warning);
    w.info = w.png ? png_create_info_struct(w.png) : NULL;
    ok = w.info ? write_all(&w) : err_memory(err);
    png_destroy_write_struct(&w.png, &w.info);
    return ok;
}
