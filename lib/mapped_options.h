/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mapped_options - the options and operands of icc-map that say what is mapped from where to where.
 * The tool has MAPPED_OPTIONS in its table, hands their keys to mapped_option, and calls
 * mapped_options_end after the last. */
#ifndef MAPPED_OPTIONS_H
#define MAPPED_OPTIONS_H

#include "mapped_io.h"
#include "match_options.h"

enum {
    MAPPED_KEY = 400,
    MAPPED_INVERSE = MAPPED_KEY,
    MAPPED_COORDS,
    MAPPED_FROM_COORDS,
    MAPPED_MODEL,
    MAPPED_PLANE,
    MAPPED_OUTSIDE,
    MAPPED_MESH,
    MAPPED_POSES,
    MAPPED_OUT_DIR,
    MAPPED_KEY_END
};

/* clang-format off */
#define MAPPED_OPTIONS                                                                             \
    {MAPPED_INVERSE, "inverse", NULL, "from the target to the source"},                            \
    {MAPPED_COORDS, "coords", NULL, "print coordinates k lambda t; without a target"},             \
    {MAPPED_FROM_COORDS, "from-coords", NULL, "POINTS are such coordinates"},                      \
    {MAPPED_MODEL, "model", "FILE.obj", "map the vertices of an OBJ model instead of POINTS"},     \
    {MAPPED_PLANE, "plane", "AXES", "axes of the model that are x and y (default xy)"},            \
    {MAPPED_OUTSIDE, "outside", "WHAT", "points outside the cage: error (default) or keep"},       \
    {MAPPED_MESH, "mesh", "AREA", "an OBJ of the map on such triangles: vt source, v target"},     \
    {MAPPED_POSES, "poses", "LIST", "map to each of the targets that this file lists,"},           \
    {MAPPED_OUT_DIR, "out-dir", "DIR", "into files of the same names in this folder"},             \
    MATCH_OPTIONS
/* clang-format on */

struct mapped_options { /* the axes are set, the rest is zeroed at first */
    struct match_options match;
    bool inverse, coords, from_coords; /* one at most */
    bool has_plane;
    int axes[3];
    int outside;                 /* 1: keep */
    const char *model;           /* or NULL */
    double mesh;                 /* area of triangles; 0: points are mapped */
    const char *poses, *out_dir; /* or NULL */
    enum icc_use use;            /* from here on: set by mapped_options_end */
    const char *source, *target; /* paths; no target: NULL */
    const char *points;          /* what is mapped; NULL: nothing */
};

/* Is this key one of them? */
static inline bool mapped_option_is(int key) {
    return (key >= MAPPED_KEY && key < MAPPED_KEY_END) || match_option_is(key);
}

/* Takes the current option of cli, whose key this is. */
bool mapped_option(struct mapped_options *o, const struct cli *cli, int key,
                   struct err *err) WARN_UNUSED;

/* Checks what no single option can know, and takes the operands. `show`: the source is to be drawn,
 * and nothing mapped; `output`: where the output is to go, or NULL. */
bool mapped_options_end(struct mapped_options *o, const struct cli *cli, bool show,
                        const char *output, struct err *err) WARN_UNUSED;
void mapped_options_free(struct mapped_options *o);

/* Reads what the operands name; all is zeroed before, and to be freed in any case. */
bool mapped_options_read(const struct mapped_options *o, int digits, struct cage *source,
                         struct cage *target, struct mapped *mapped, struct err *err) WARN_UNUSED;

#endif
