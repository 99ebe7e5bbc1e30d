/* SPDX-License-Identifier: GPL-3.0-or-later */
/* triangle_io - the files of Shewchuk's Triangle: .node, .ele and .poly.
 *
 *   .node   VERTICES 2 ATTRIBUTES MARKERS   then   NUMBER X Y [attributes] [marker]
 *   .ele    TRIANGLES CORNERS ATTRIBUTES    then   NUMBER A B C [more corners] [attributes]
 *   .poly   the lines of .node (or VERTICES 0: they are in the .node file beside it), then
 *           SEGMENTS MARKERS, NUMBER A B [marker], HOLES, NUMBER X Y, [regions: ignored]
 *
 * Numbers count from 0 or from 1, as the first vertex says. Attributes and markers are read and
 * forgotten; of six corners the first three count. */
#ifndef TRIANGLE_IO_H
#define TRIANGLE_IO_H

#include "triangulation.h"

/* Vertices; triangles, of the vertices in the file `node`; vertices, there or in the file itself,
 * segments and holes. Errors: file:LINE:COL. */
bool triangle_read_node(struct triangulation *t, const char *path, struct err *err) WARN_UNUSED;
bool triangle_read_ele(struct triangulation *t, const char *path, const char *node,
                       struct err *err) WARN_UNUSED;
bool triangle_read_poly(struct triangulation *t, const char *path, const char *node,
                        struct err *err) WARN_UNUSED;

/* Does the name end in .node, .ele or .poly? */
bool triangle_is_name(const char *path);

/* Reads the file as its name ends, with NAME.node beside it. */
bool triangle_read(struct triangulation *t, const char *path, struct err *err) WARN_UNUSED;

#endif
