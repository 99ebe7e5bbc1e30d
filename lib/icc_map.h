/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc_map - deformations of a cage by integral curve coordinates, whatever the method.
 *
 * A source cage is bound once; then each target, a deformed version of it, makes a map. Points go
 * from the source to the target or back, or stop half-way at their coordinates. Only what the use
 * needs is made. */
#ifndef ICC_MAP_H
#define ICC_MAP_H

#include "icc_grid.h"
#include "icc_ray.h"
#include "progress.h"

enum icc_method { ICC_RAY, ICC_GRID, ICC_METHODS };
extern const char *const icc_method_names[ICC_METHODS + 1]; /* ends with NULL */

struct icc_rule {
    enum icc_method method;
    bool has_points; /* else as many as icc_mesh_points says */
    size_t points;   /* wanted inside each cage */
    double cell;     /* > 0: as many as lie inside the source at this distance from each other */
    struct icc_grid_rule grid[2]; /* method grid: of the source, of the target; the above goes for
                                     both, and need not be repeated here */
};

enum icc_use {
    ICC_FORWARD, /* from points of the source to points of the target */
    ICC_INVERSE, /* the other way */
    ICC_NAME,    /* from points of the source to coordinates; no target */
    ICC_ASK,     /* from coordinates to points of the target */
};

struct icc_map {
    enum icc_use use;
    struct icc_rule rule;               /* with the number of points that was found */
    const struct cage *source, *target; /* borrowed */
    struct icc_ray ray[2];              /* of the source, of the target */
    struct icc_grid grid[2];            /* or these */
    struct icc_tally tally[2]; /* method grid: of the last batch, where points came from the source
                                  or the target, and where they went to */
    /* private */
    bool ready; /* the source is prepared */
    struct icc_lines lines;
};

/* Binds the source. Freed by icc_map_free on success. Refusals are ERR_REFUSAL. */
bool icc_map_init(struct icc_map *m, const struct cage *source, const struct icc_rule *rule,
                  enum icc_use use, struct err *err) WARN_UNUSED;
void icc_map_free(struct icc_map *m); /* harmless on a zeroed struct */

/* Binds a target, made by cage_init_like of the source, in place of the one before. */
bool icc_map_target(struct icc_map *m, const struct cage *target, struct err *err) WARN_UNUSED;

/* Many points at once. Those outside stay where they are. */
struct icc_batch {
    size_t count;
    double (*points)[3]; /* before and after; NULL for none */
    int axes[2];         /* which of the three coordinates are x and y */
    struct icc_place
        *places; /* coordinates, of the prepared cage: before or after; NULL for none */
    struct progress *progress; /* or NULL */
    size_t outside;            /* set: how many, and the first of them */
    size_t first;
};

/* For ICC_FORWARD and ICC_INVERSE points are replaced, for ICC_NAME places are found, for ICC_ASK
 * points are set where the place is not outside. */
bool icc_map_batch(struct icc_map *m, struct icc_batch *b, struct err *err) WARN_UNUSED;

#endif
