/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model_options.h"

#include <string.h>

enum { OUTSIDE_ERROR, OUTSIDE_KEEP };
static const char *const outside_names[] = {"error", "keep", NULL};

void model_options_init(struct model_options *o) {
    *o = (struct model_options){.format = VERTICES_BY_NAME};
}

bool model_option_axes(const struct cli *cli, int axes[3], struct err *err) {
    return grid_axes(cli->value, strlen(cli->value), axes) ||
           cli_bad_value(cli, err, "two of the letters x, y, z");
}

bool model_option(struct model_options *o, const struct cli *cli, int key, struct err *err) {
    int choice;
    switch (key) {
    case MODEL_FORMAT:
        if (!cli_choice(cli, vertices_format_names, &choice, err)) return false;
        o->format = (enum vertices_format)choice;
        return true;
    case MODEL_OUTSIDE:
        if (!cli_choice(cli, outside_names, &choice, err)) return false;
        o->keep_outside = choice == OUTSIDE_KEEP;
        return true;
    default: /* MODEL_PLANE */
        o->has_plane = true;
        return model_option_axes(cli, o->axes, err);
    }
}

bool model_options_end(struct model_options *o, const struct cli *cli, const char *further,
                       struct err *err) {
    const char *const files[] = {further, cli_operand(cli, 0), cli_operand(cli, 1)};
    if (!cli_check_operands(cli, 1, 2, err) || !cli_check_stdin(cli, 3, files, err)) return false;
    o->format = vertices_format(o->format, cli_operand(cli, 0));
    return true;
}

bool model_options_open(const struct model_options *o, const struct cli *cli,
                        struct grid_file *grid, struct vertices *vertices, struct err *err) {
    const int *axes;
    if (!grid_read(grid, cli_operand(cli, 1), err)) return false;
    axes = grid->spline.grid.axes;
    if (o->has_plane && (axes[0] != o->axes[0] || axes[1] != o->axes[1]))
        return err_set(err, ERR_INPUT, "the plane of the grid is %c%c, not %c%c", "xyz"[axes[0]],
                       "xyz"[axes[1]], "xyz"[o->axes[0]], "xyz"[o->axes[1]]);
    return vertices_open(vertices, cli_operand(cli, 0), o->format, err);
}

bool model_options_accept(const struct model_options *o, const struct vertices *v, const char *what,
                          size_t outside, size_t first, struct err *err) {
    return outside == 0 || o->keep_outside || vertices_refuse(v, what, outside, first, err);
}
