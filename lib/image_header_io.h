/* SPDX-License-Identifier: GPL-3.0-or-later */
/* image_header_io - what kind of image a file is, and how many pixels it has.
 *
 * PNG, TIFF, OpenEXR, PNM (P1 to P6) and JPEG, told by the first bytes, whatever the file is
 * called; anything else is refused. These few lines stand before every decoder: they take
 * microseconds where an image library takes 0.2 s to load, allocate nothing, and cannot be made to
 * work longer than it takes to walk over the header.
 *
 * Sizes are those of the pixels as stored: a note in the file that a camera was turned is not
 * obeyed, of OpenEXR's two windows the data window counts, and of several pages the first.
 *
 * What is checked is the header's structure, up to the pixels or to the end of the record that
 * holds the size: every length in it fits the file. The pixels themselves may still be damaged. */
#ifndef IMAGE_HEADER_IO_H
#define IMAGE_HEADER_IO_H

#include "image.h"

enum image_format { IMAGE_PNG, IMAGE_TIFF, IMAGE_OPENEXR, IMAGE_PNM, IMAGE_JPEG };

struct image_header {
    enum image_format format;
    uint32_t width, height; /* 1..IMAGE_SIDE_MAX */
    uint32_t largest;       /* PNM: the value of white, 1..65535 */
    size_t pixels;          /* PNM: where they begin */
};

/* Reads the header at the beginning of these bytes, which are the whole file. O(its length). */
bool image_header(struct image_header *h, const void *bytes, size_t length,
                  struct err *err) WARN_UNUSED;

/* The same of a file; "-" is stdin. */
bool image_header_read(struct image_header *h, const char *path, struct err *err) WARN_UNUSED;

#endif
