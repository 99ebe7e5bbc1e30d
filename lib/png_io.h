/* SPDX-License-Identifier: GPL-3.0-or-later */
/* png_io - the pixels of PNG files, by libpng.
 *
 * Of a file that is read, all that is not pixels is left out before: texts and profiles of a few
 * bytes may unfold to gigabytes. So the decoder gets a copy with the chunks IHDR, PLTE, tRNS, IDAT
 * and IEND alone. Palettes become RGB, a transparent colour becomes an alpha channel, fewer than 8
 * bits become 8. What is cut or damaged is an error, also an index that the palette does not have.
 */
#ifndef PNG_IO_H
#define PNG_IO_H

#include "image.h"
#include "out.h"

/* Completes an image whose width and height are set, from a file with a sound header
 * (image_header_io.h); freed by image_free. Errors have no place. */
bool png_read(struct image *image, const void *bytes, size_t length, struct err *err) WARN_UNUSED;

/* Writes an image of 8 or 16 bits: samples as image_round_u8 or _u16 make them. The same image
 * gives the same bytes, with the same versions of libpng and zlib. */
bool png_write(struct out *out, const struct image *image, const void *samples,
               struct err *err) WARN_UNUSED;

#endif
