/* SPDX-License-Identifier: GPL-3.0-or-later */
/* shim_oiio - the C face of OpenImageIO: images in memory to pixels and back.
 *
 * The shim is a module of its own, which oiio_load.h loads when it is needed: it takes 0.2 s. All
 * that it exports is one table of functions.
 *
 * Only the decoder that is named is tried. Pixels come as floats that hold the samples exactly, see
 * image.h. One thread does all the work. No exception, message or state leaves the shim; since
 * libpng writes its errors to stderr, that is turned to /dev/null while the library works, which
 * other threads would notice. */
#ifndef SHIM_OIIO_H
#define SHIM_OIIO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum shim_oiio_status {
    SHIM_OIIO_OK,
    SHIM_OIIO_MEMORY,
    SHIM_OIIO_NO_PAGE,
    SHIM_OIIO_SAMPLES, /* of another type: message names it */
    SHIM_OIIO_VOLUME,  /* not one number for each pixel and channel: more planes, or lists */
    SHIM_OIIO_FAILED,  /* in the words of the library: message, one line */
};

struct shim_oiio_report {
    enum shim_oiio_status status;
    char message[256];
};

enum shim_oiio_sample { SHIM_OIIO_U8, SHIM_OIIO_U16, SHIM_OIIO_HALF, SHIM_OIIO_FLOAT };

/* Fields as in struct image. */
struct shim_oiio_spec {
    uint32_t width, height;
    int channels, alpha;
    bool straight;
    enum shim_oiio_sample sample;
    char *names;          /* reading: to be freed; writing: borrowed, may be NULL */
    uint64_t tile_pixels; /* reading: of a tile, which a decoder needs at once; 0: rows */
};

struct shim_oiio_reader;

struct shim_oiio {
    /* Reads the header of the image in these bytes, which are borrowed until `close`. `format` is
     * tiff, openexr or jpeg; pages count from 0. NULL: see *report. */
    struct shim_oiio_reader *(*open)(const void *bytes, size_t length, const char *format, int page,
                                     struct shim_oiio_spec *spec, struct shim_oiio_report *report);

    /* Decodes all of it, once. What is cut or damaged is an error. */
    bool (*pixels)(struct shim_oiio_reader *reader, float *value, struct shim_oiio_report *report);
    void (*close)(struct shim_oiio_reader *reader); /* NULL: nothing */

    /* Encodes an image whose samples are uint8_t, uint16_t or, for both others, float; `sink` gets
     * the bytes. The same image gives the same bytes: no clock, host or version is in them. TIFF is
     * not compressed. */
    bool (*write)(const char *format, const struct shim_oiio_spec *spec, const void *samples,
                  void (*sink)(void *context, const char *bytes, size_t length), void *context,
                  struct shim_oiio_report *report);
};

extern const struct shim_oiio shim_oiio;

#ifdef __cplusplus
}
#endif

#endif
