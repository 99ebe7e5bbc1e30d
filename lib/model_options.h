/* SPDX-License-Identifier: GPL-3.0-or-later */
/* model_options - what the programs share that take a MODEL through a GRID: the operands MODEL
 * [GRID], and the options that say how to read the one and what of it may lie outside the other. A
 * tool has MODEL_OPTIONS in its table, hands their keys to model_option, calls model_options_end
 * after the last, and reads both with model_options_open. */
#ifndef MODEL_OPTIONS_H
#define MODEL_OPTIONS_H

#include "cli.h"
#include "grid_io.h"
#include "vertices_io.h"

enum { MODEL_KEY = 300, MODEL_FORMAT = MODEL_KEY, MODEL_OUTSIDE, MODEL_PLANE, MODEL_KEY_END };

/* clang-format off */
#define MODEL_OPTIONS                                                                              \
    {MODEL_FORMAT, "format", "WHAT", "MODEL is obj, xy or xyz (default: by its name, else obj)"}, \
    {MODEL_OUTSIDE, "outside", "WHAT", "vertices outside the grid: error (default) or keep"},  \
    {MODEL_PLANE, "plane", "AXES", "insist that this is the grid's plane, e.g. zy"}
/* clang-format on */

struct model_options {
    enum vertices_format format; /* of MODEL, by its name unless given */
    bool keep_outside;
    bool has_plane;
    int axes[3];
};

void model_options_init(struct model_options *o);

/* Is this key one of them? */
static inline bool model_option_is(int key) {
    return key >= MODEL_KEY && key < MODEL_KEY_END;
}

/* Takes the current option of cli, whose key this is. */
bool model_option(struct model_options *o, const struct cli *cli, int key,
                  struct err *err) WARN_UNUSED;

/* Checks the operands; `further` is one more file that is read, or NULL: one input may be stdin. */
bool model_options_end(struct model_options *o, const struct cli *cli, const char *further,
                       struct err *err) WARN_UNUSED;

/* Reads grid and model, which are zeroed before and are to be freed in any case. */
bool model_options_open(const struct model_options *o, const struct cli *cli,
                        struct grid_file *grid, struct vertices *vertices,
                        struct err *err) WARN_UNUSED;

/* Refuses `outside` vertices outside `what`, for example "the grid", `first` being the first,
 * unless there are none or they are to be kept. */
bool model_options_accept(const struct model_options *o, const struct vertices *v, const char *what,
                          size_t outside, size_t first, struct err *err) WARN_UNUSED;

/* The value of an option that is a plane, for example zy. */
bool model_option_axes(const struct cli *cli, int axes[3], struct err *err) WARN_UNUSED;

#endif
