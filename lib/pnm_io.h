/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pnm_io - the pixels of PNM files, plain and raw: P1 to P6.
 *
 * Not through OpenImageIO, whose release 2.4 is off by one in many 16-bit samples it reads, and
 * writes 8 bits only. A bitmap's 1 is black: 0 here, its 0 is 255. Where white is not 255 or 65535,
 * values are scaled to that, to the nearest whole number. */
#ifndef PNM_IO_H
#define PNM_IO_H

#include "image_header_io.h"
#include "out.h"

/* Completes an image whose width and height are set, from the file whose header *h is; freed by
 * image_free. Errors have no place. */
bool pnm_read(struct image *image, const struct image_header *h, const void *bytes, size_t length,
              struct err *err) WARN_UNUSED;

/* Writes P5 or P6, of 8 or 16 bits: samples as image_round_u8 or _u16 make them. The latter are
 * turned to big endian in place. */
void pnm_write(struct out *out, const struct image *image, void *samples);

#endif
