/* SPDX-License-Identifier: GPL-3.0-or-later */
/* triangulation_io - what mkgrid takes for a triangulation: Triangle's files (triangle_io), by the
 * end of the name; a list of points (.xy); else an OBJ that is flat and made of triangles. */
#ifndef TRIANGULATION_IO_H
#define TRIANGULATION_IO_H

#include "triangulation.h"

/* Reads path ("-": an OBJ from stdin); the plane's axes are axes[0] and axes[1] of an OBJ. */
bool triangulation_read(struct triangulation *t, const char *path, const int axes[3],
                        struct err *err) WARN_UNUSED;

#endif
