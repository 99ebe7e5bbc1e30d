/* SPDX-License-Identifier: GPL-3.0-or-later */
/* filemap - a whole input as one piece of read-only memory, so that it can be read twice.
 *
 * A regular file is mapped; anything else (a pipe, a terminal) is first copied to a temporary file
 * in $TMPDIR or /tmp that has no name any more. Private memory is O(1) in either case. Copies have
 * no limit but the room there. Whoever truncates a mapped file makes its readers die of SIGBUS. */
#ifndef FILEMAP_H
#define FILEMAP_H

#include "err.h"

struct filemap {
    const char *name; /* as in messages; borrowed */
    const char *data; /* never NULL; no terminating NUL */
    size_t length;
    void *map; /* private */
};

/* Opens a file; NULL or "-" is stdin, called "<stdin>", from where it stands. */
bool filemap_open(struct filemap *f, const char *path, struct err *err) WARN_UNUSED;
void filemap_close(struct filemap *f); /* harmless on a zeroed struct */

#endif
