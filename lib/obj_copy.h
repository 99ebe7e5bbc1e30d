/* SPDX-License-Identifier: GPL-3.0-or-later */
/* obj_copy - a copy of an OBJ text in which vertices and normals are replaced.
 *
 * Of a v line only the three numbers change; weights, colours, blanks and comments stay. What is
 * not understood, and faces unless the numbers of their normals change, pass byte for byte. */
#ifndef OBJ_COPY_H
#define OBJ_COPY_H

#include "obj_normals.h"
#include "out.h"

enum obj_normal_mode {
    OBJ_NORMALS_TRANSFORM, /* by a plan */
    OBJ_NORMALS_DROP,      /* neither vn lines nor references to them */
    OBJ_NORMALS_KEEP,
};

struct obj_change {
    double (*vertex)[3]; /* the new vertices */
    enum obj_normal_mode normals;
    const struct obj_normals *plan; /* for OBJ_NORMALS_TRANSFORM */
    int digits;                     /* as in num_print */
};

/* Writes the copy. The text has been read before, so the only errors are those of `out`, which
 * stick there, and that the file changed meanwhile. */
bool obj_copy(struct out *out, const struct filemap *f, const struct obj_points *p,
              const struct obj_change *change, struct err *err) WARN_UNUSED;

#endif
