/* SPDX-License-Identifier: GPL-3.0-or-later */
/* obj_normals - the normals of an OBJ whose vertices each turn them in their own way.
 *
 * The first vertex that uses a normal keeps its line. Where another vertex turns the same normal
 * to a different result (by more than 2^-44 of it, which rounding may explain), a copy with a line
 * of its own is needed: one for each such pair (normal, vertex). Its line follows the last vn line
 * before the face that first needs it (or the normal's own line, if that comes later still), so the
 * numbers of all later normals change:
 *
 *     vn (0)                    vn (0)   for its first vertex
 *     vn (1)                    vn (1)
 *     f  uses 0 at v, w         vn (2)   copy of 0 for w
 *     vn (2)                    f
 *                               vn (3)   was 2
 *
 * Memory is O(vertices + normals + copies), whatever the number of faces. */
#ifndef OBJ_NORMALS_H
#define OBJ_NORMALS_H

#include "filemap.h"
#include "obj_points.h"
#include "obj_scan.h"

#include <stdint.h>

/* Turns a normal at a vertex; false: it cannot, *result is the normal itself then. */
typedef bool obj_turn(void *context, size_t vertex, const double normal[3], double result[3]);

struct obj_normal_copy {
    uint32_t normal, vertex; /* the pair */
    uint32_t after;          /* the normal whose line its own line follows */
    double value[3];
};

struct obj_normals {
    size_t normal_count, copy_count;
    uint32_t *owner;              /* the normal's first vertex; OBJ_UNUSED */
    double (*value)[3];           /* the result there */
    struct obj_normal_copy *copy; /* in the order of their lines */
    uint32_t *before;             /* [n]: copies before the line of normal n, n <= normal_count */
    size_t stuck_count, stuck_first; /* vertices where turn said false */
    /* private */
    size_t copy_cap, slot_count;
    uint32_t *slot;
};
#define OBJ_UNUSED UINT32_MAX

/* Plans them from the faces of the text. Indices that do not exist are errors. O(text + turns). */
bool obj_normals_plan(struct obj_normals *n, const struct filemap *f, const struct obj_points *p,
                      obj_turn *turn, void *context, struct err *err) WARN_UNUSED;
void obj_normals_free(struct obj_normals *n); /* harmless on a zeroed struct */

/* The number in the output, from 0, of normal n as used at a vertex. */
size_t obj_normals_number(const struct obj_normals *n, size_t normal, size_t vertex);

/* How many normals the output has where the input has `count`. */
size_t obj_normals_defined(const struct obj_normals *n, size_t count);

/* Checks the syntax of all corners, nothing else. */
bool obj_normals_check(const struct filemap *f, struct err *err) WARN_UNUSED;

#endif
