/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bary_io - the bary format, supple-bary(5): the places of a model's vertices in a grid. */
#ifndef BARY_IO_H
#define BARY_IO_H

#include "bary.h"
#include "out.h"
#include "vertices_io.h"

/* The key of places of these vertices in a grid. */
bool bary_key(struct bary_key *key, const struct grid *g, const struct vertices *v,
              struct err *err) WARN_UNUSED;

/* Reads path (NULL or "-": stdin). Everything is checked against the key: other checksums, counts
 * or triangles are errors with their place; NULL: read whatever there is, with depth if the first
 * vertex that is inside has it. */
bool bary_read(struct bary *bary, const char *path, const struct bary_key *key,
               struct err *err) WARN_UNUSED;

/* Writes the canonical form; reading and writing a canonical file gives the same bytes. `added` is
 * a line for the history without "# " and newline, or NULL. */
void bary_write(struct out *out, const struct bary *bary, const char *added);

#endif
