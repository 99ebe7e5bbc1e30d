/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frames_io - a list of pictures to be made: the file of what each shows, and the picture's, two
 * words a line. One program makes them all, which reads but once what they share. */
#ifndef FRAMES_IO_H
#define FRAMES_IO_H

#include "image_io.h"

struct frames {
    size_t count;
    struct frame {
        char *input, *picture;
        enum image_format format;
    } * frame;
};

/* Reads path ("-": stdin); `to` is the choice of a format, as in image_output_format. Errors:
 * file:LINE:COL; there must be a frame, and neither word is "-". */
bool frames_read(struct frames *f, const char *path, int to, struct err *err) WARN_UNUSED;
void frames_free(struct frames *f); /* harmless on a zeroed struct */

/* Makes the picture of an input. */
typedef bool frames_maker(void *context, const char *input, const char *picture,
                          enum image_format format, struct err *err);

/* Reads the list, and makes all of its pictures; those before an error remain. */
bool frames_make(const char *path, int to, frames_maker *make, void *context,
                 struct err *err) WARN_UNUSED;

#endif
