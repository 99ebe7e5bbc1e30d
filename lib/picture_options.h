/* SPDX-License-Identifier: GPL-3.0-or-later */
/* picture_options - what the programs share that make pictures of pixels: their size, colours and
 * file. A tool has PICTURE_OPTIONS last in its table, hands their keys to picture_option, calls
 * picture_options_end after the last, and picture_begin when it knows what is to be seen. */
#ifndef PICTURE_OPTIONS_H
#define PICTURE_OPTIONS_H

#include "cli.h"
#include "frames_io.h"
#include "viewport.h"

enum {
    PICTURE_KEY = 340,
    PICTURE_SIZE = PICTURE_KEY,
    PICTURE_SCALE,
    PICTURE_Y_DOWN,
    PICTURE_ANTIALIAS,
    PICTURE_BACKGROUND,
    PICTURE_MAX_PIXELS,
    PICTURE_PROGRESS,
    PICTURE_FRAMES,
    PICTURE_TO,
};

/* clang-format off */
#define PICTURE_OPTIONS                                                                            \
    {PICTURE_SIZE, "size", "WxH", "of the picture (default: 800 pixels along the longer side)"},   \
    {PICTURE_SCALE, "scale", "S", "or pixels a unit"},                                             \
    {PICTURE_Y_DOWN, "y-down", NULL, "the world's y grows downwards"},                             \
    {PICTURE_ANTIALIAS, "antialias", "N", "N x N samples a pixel, 1..16 (default 4)"},             \
    {PICTURE_BACKGROUND, "background", "C", "colour around (default white; none: transparent)"},   \
    {PICTURE_MAX_PIXELS, "max-pixels", "N", "refuse larger pictures and images (100000000)"},      \
    {PICTURE_PROGRESS, "progress", NULL, "show progress on stderr also if that is no terminal"},   \
    {PICTURE_FRAMES, "frames", "LIST", "many pictures: lines INPUT PICTURE, in file LIST"},        \
    {PICTURE_TO, "to", "FORMAT", "png, tiff, exr or pnm (default: by the name of -o, else png)"},  \
    {'o', "output", "FILE", "write to FILE instead of stdout"}
/* clang-format on */

struct picture_options {
    const char *output, *frames; /* of the latter there is only one */
    const char *input;           /* the operand, "-" without it; NULL: there is none */
    bool has_size, has_scale, y_down, progress;
    uint32_t size[2];
    double scale;
    int64_t antialias, max_pixels;
    uint32_t background; /* 0xRRGGBBAA */
    int to;
    enum image_format format; /* of `output` */
};

void picture_options_init(struct picture_options *o);

/* Is this key one of them? */
static inline bool picture_option_is(int key) {
    return key == 'o' || (key >= PICTURE_KEY && key <= PICTURE_TO);
}

/* Takes the current option of cli, whose key this is. */
bool picture_option(struct picture_options *o, const struct cli *cli, int key,
                    struct err *err) WARN_UNUSED;

/* Takes the operand, one or none as `operands` says, and checks what goes together, and the file:
 * before long work. */
bool picture_options_end(struct picture_options *o, const struct cli *cli, int operands,
                         struct err *err) WARN_UNUSED;

/* Makes the one picture, or all of the list. */
bool picture_make(const struct picture_options *o, frames_maker *make, void *context,
                  struct err *err) WARN_UNUSED;

/* Where the pixels of a picture of this box lie, and an image for them: RGB, or RGBA unless the
 * background is opaque; of 8 bits, or of halves for OpenEXR. ERR_USAGE or ERR_REFUSAL: it
 * would have more pixels than are allowed. */
bool picture_begin(const struct picture_options *o, enum image_format format, const double lo[2],
                   const double hi[2], struct viewport *view, struct image *image,
                   struct err *err) WARN_UNUSED;

/* The current option's value as the frame of an image: X0,Y0,X1,Y1, neither width nor height 0. */
bool picture_frame(const struct cli *cli, double frame[4], struct err *err) WARN_UNUSED;

/* The current option's value as a colour. */
bool picture_colour(const struct cli *cli, uint32_t *colour, struct err *err) WARN_UNUSED;

#endif
