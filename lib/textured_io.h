/* SPDX-License-Identifier: GPL-3.0-or-later */
/* textured_io - OBJ models with texture coordinates: `v`, `vt` and the `f` that use both.
 *
 * Faces of more than three corners are cut into triangles from their first corner. Everything else
 * is ignored. */
#ifndef TEXTURED_IO_H
#define TEXTURED_IO_H

#include "err.h"
#include "filemap.h"
#include "textured.h"

/* Reads an OBJ text. Errors: file:LINE:COL; there must be a face, and no corner without vt. */
bool textured_read(struct textured *t, const struct filemap *f, struct err *err) WARN_UNUSED;
void textured_free(struct textured *t); /* harmless on a zeroed struct */

#endif
