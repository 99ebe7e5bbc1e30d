/* SPDX-License-Identifier: GPL-3.0-or-later */
/* obj_io - Wavefront OBJ: the vertices and elements of a model, and copies with other vertices.
 *
 * Only `v`, `vn`, `f`, `l` and `p` lines are understood; everything else is somebody else's and
 * passes through byte for byte. Lines may be continued by a final backslash. */
#ifndef OBJ_IO_H
#define OBJ_IO_H

#include "err.h"
#include "model.h"

/* Reads path (NULL or "-": stdin). Errors: file:LINE:COL, indices out of range at either end. */
bool model_read(struct model *m, const char *path, struct err *err) WARN_UNUSED;
void model_free(struct model *m);

#endif
