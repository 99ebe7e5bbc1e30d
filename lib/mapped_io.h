/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mapped_io - what icc-map moves: a list of points, the vertices of a model, or coordinates. It is
 * read once, and mapped and written for as many targets as there are. */
#ifndef MAPPED_IO_H
#define MAPPED_IO_H

#include "places_io.h"
#include "vertices_io.h"

struct mapped {
    enum icc_use use;
    bool model;  /* the points are the vertices of an OBJ */
    int axes[2]; /* the coordinates of a vertex that are x and y */
    bool keep_outside;
    int digits; /* of what is written, as in num_print */
    /* private */
    struct vertices vertices; /* or only its file, where places are read */
    struct places places;
    double (*given)[3]; /* the points as they were read; NULL: they are mapped once only */
};

/* Reads what is to be mapped, for a source; with `many`, it is mapped more than once. The fields up
 * to `digits` are set. Freed by mapped_close in any case. */
bool mapped_open(struct mapped *m, const char *path, const struct cage *source, bool many,
                 struct err *err) WARN_UNUSED;
void mapped_close(struct mapped *m); /* harmless on a zeroed struct */

/* Maps it. Points outside are refused, with their cage's name, unless they are to be kept. */
bool mapped_map(struct mapped *m, struct icc_map *map, const char *cage_name,
                struct progress *progress, struct err *err) WARN_UNUSED;

/* Writes a copy of the file with the images. */
bool mapped_write(struct out *out, const struct mapped *m, const struct cage *source,
                  struct err *err) WARN_UNUSED;

#endif
