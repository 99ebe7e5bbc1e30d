/* SPDX-License-Identifier: GPL-3.0-or-later */
/* frames_io - a list of pictures to be made: a grid's file and a picture's, two words a line. */
#ifndef FRAMES_IO_H
#define FRAMES_IO_H

#include "err.h"

struct frames {
    size_t count;
    struct frame {
        char *grid, *picture;
        size_t line; /* of the list, for messages */
    } * frame;
};

/* Reads path ("-": stdin). Errors: file:LINE:COL; there must be a frame, and neither word is "-".
 */
bool frames_read(struct frames *f, const char *path, struct err *err) WARN_UNUSED;
void frames_free(struct frames *f); /* harmless on a zeroed struct */

#endif
