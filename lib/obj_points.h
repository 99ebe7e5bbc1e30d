/* SPDX-License-Identifier: GPL-3.0-or-later */
/* obj_points - the vertices and normals of an OBJ text, without its faces. */
#ifndef OBJ_POINTS_H
#define OBJ_POINTS_H

#include "filemap.h"

struct obj_points {
    size_t vertex_count, normal_count;
    double (*vertex)[3], (*normal)[3];
};

/* Reads all v and vn lines; there must be a vertex. Errors: file:LINE:COL. */
bool obj_points_read(struct obj_points *p, const struct filemap *f, struct err *err) WARN_UNUSED;
void obj_points_free(struct obj_points *p);

/* The line of vertex i, counted from 0, for messages. O(text). */
size_t obj_points_line(const struct filemap *f, size_t i);

#endif
