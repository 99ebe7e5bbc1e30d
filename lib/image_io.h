/* SPDX-License-Identifier: GPL-3.0-or-later */
/* image_io - image files: PNG, TIFF, OpenEXR and PNM to read and write, JPEG to read.
 *
 * What a file is, its first bytes say, never its name; nothing else reaches a decoder
 * (image_header_io.h), and no pixels are decoded of an image that is larger than allowed. Samples
 * have 8 or 16 bits, are halves or floats; fewer bits are spread over 8. Palettes, CMYK and YCbCr
 * become RGB. An OpenEXR image is its data window.
 *
 * PNG and PNM take no time to begin with; for the others, OpenImageIO is loaded (oiio_load.h). */
#ifndef IMAGE_IO_H
#define IMAGE_IO_H

#include "image_header_io.h"

#define IMAGE_PIXELS_DEFAULT 100000000 /* of an image that is read, unless asked for more */

struct image_request {
    const char *path; /* NULL or "-": stdin */
    int64_t page;     /* of TIFF and OpenEXR with several images, from 1 */
    int64_t max_pixels;
};

/* Reads an image, to be freed by image_free. */
bool image_read(struct image *image, const struct image_request *request,
                struct err *err) WARN_UNUSED;

/* The names of the formats that can be written, in the order of enum image_format; NULL ends them.
 */
extern const char *const image_format_names[];

/* The format of an image to be written: the choice, an index into these names, unless that is -1;
 * else by the extension of the path (.png .tif .tiff .exr .pgm .ppm .pnm); else PNG. ERR_USAGE: the
 * extension is another one, or pixels would go to a terminal. Before long work. */
bool image_output_format(int choice, const char *path, enum image_format *format,
                         struct err *err) WARN_UNUSED;

/* Can the format hold such samples and channels? Never converts. ERR_INPUT. */
bool image_fits(const struct image *image, enum image_format format, struct err *err) WARN_UNUSED;

/* Writes an image that fits to path (NULL or "-": stdout). The same image gives the same bytes. */
bool image_write(const struct image *image, enum image_format format, const char *path,
                 struct err *err) WARN_UNUSED;

#endif
