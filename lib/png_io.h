/* SPDX-License-Identifier: GPL-3.0-or-later */
/* png_io - a PNG file without all that is not pixels.
 *
 * Texts and profiles of a few bytes may unfold to gigabytes, and what ends early makes OpenImageIO
 * 2.4 leak; so a decoder gets a copy with the chunks IHDR, PLTE, tRNS, IDAT and IEND alone. */
#ifndef PNG_IO_H
#define PNG_IO_H

#include "err.h"

/* Sets *copy, to be freed, and its length. Errors, which have no place: a chunk's length goes
 * beyond the end, a critical chunk is unknown, chunks IDAT do not follow each other, there is no
 * IEND. The bytes are those of a sound
 * header (image_header_io.h). O(length). */
bool png_pixels_only(const void *bytes, size_t length, void **copy, size_t *copy_length,
                     struct err *err) WARN_UNUSED;

#endif
