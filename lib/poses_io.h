/* SPDX-License-Identifier: GPL-3.0-or-later */
/* poses_io - a list of files, one a line, and an output for each, named after it, in a folder.
 *
 * Blanks around a name do not belong to it, '#' begins a comment. Names are as on a command line:
 * relative to where the program runs. The outputs appear together, when all are written: until then
 * they are temporaries. */
#ifndef POSES_IO_H
#define POSES_IO_H

#include "out.h"

struct pose {
    char *path, *output;
    size_t line;
    struct out_pending pending; /* written, but not there yet */
};

struct poses {
    size_t count;
    struct pose *pose;
};

/* Reads a list; NULL or "-" is stdin. Outputs have the names of the files, with this extension
 * (".obj") in the place of their own, unless it is NULL. Two outputs of one name, and outputs that
 * are a file of the list, are ERR_USAGE. Freed by poses_free in any case. */
bool poses_read(struct poses *p, const char *list, const char *folder, const char *extension,
                struct err *err) WARN_UNUSED;

/* Ends with ERR_USAGE if an output is this file, which is to be read; NULL and "-" are none. */
bool poses_spare(const struct poses *p, const char *path, struct err *err) WARN_UNUSED;

/* Gives all outputs their names. */
bool poses_commit(struct poses *p, struct err *err) WARN_UNUSED;
void poses_free(struct poses *p); /* takes back what has no name yet; harmless on a zeroed struct */

#endif
