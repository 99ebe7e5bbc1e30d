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

/* Reads NAME.node, NAME.ele with NAME.node, or NAME.poly, as the name of the file ends. */
bool triangle_read(struct triangulation *t, const char *path, struct err *err) WARN_UNUSED;

/* Does the name end so? */
bool triangle_is_name(const char *path);

#endif
