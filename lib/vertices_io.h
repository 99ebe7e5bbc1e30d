/* SPDX-License-Identifier: GPL-3.0-or-later */
/* vertices_io - the vertices of whatever a program may be given as MODEL: an OBJ model, or a list
 * of points of the plane (.xy) or of space (.xyz). */
#ifndef VERTICES_IO_H
#define VERTICES_IO_H

#include "filemap.h"
#include "obj_points.h"
#include "place.h"

enum vertices_format {
    VERTICES_BY_NAME = -1, /* a choice, not a format */
    VERTICES_OBJ,
    VERTICES_XY,  /* x y: coordinates in the grid's own frame; depth does not matter */
    VERTICES_XYZ, /* x y z: the model's axes */
};

/* The names of the formats from OBJ on, for an option; NULL ends them. */
extern const char *const vertices_format_names[];

/* The choice itself, or by the extension of the path: .xy, .xyz, else OBJ. */
enum vertices_format vertices_format(int choice, const char *path);

struct vertices {
    enum vertices_format format;
    struct filemap file;
    struct obj_points points; /* of .xy: x y 0 */
};

/* Reads path (NULL or "-": stdin). */
bool vertices_open(struct vertices *v, const char *path, enum vertices_format format,
                   struct err *err) WARN_UNUSED;
void vertices_close(struct vertices *v); /* harmless on a zeroed struct */

/* Which coordinates of these vertices count on a grid. */
struct projection vertices_projection(const struct vertices *v, const struct grid *g);

/* The number of columns of a list. */
static inline int vertices_columns(const struct vertices *v) {
    return v->format == VERTICES_XY ? 2 : 3;
}

/* CRC-32 (zlib) of all coordinates, three a vertex, as little-endian doubles. */
uint32_t vertices_checksum(const struct vertices *v);

/* The line of vertex i, counted from 0. O(text). */
size_t vertices_line(const struct vertices *v, size_t i);

/* The refusal of `outside` vertices that lie outside `what`, for example "the grid", `first` being
 * the first. Always false. */
bool vertices_refuse(const struct vertices *v, const char *what, size_t outside, size_t first,
                     struct err *err);

/* The refusal of a vertex where `what`, for example "the image", is not finite. Always false. */
bool vertices_refuse_result(const struct vertices *v, const char *what, size_t i, struct err *err);

#endif
