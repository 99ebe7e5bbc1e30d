/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure_options.h"

#include "colour_io.h"

static bool read_colours(struct figure_options *o, const struct cli *cli, struct err *err) {
    o->lines.colour_count = colour_read_list(cli->value, FIGURE_COLOURS_MAX, o->lines.colour);
    return o->lines.colour_count > 0 ||
           cli_bad_value(cli, err, "1 to %d of %s, with commas between", FIGURE_COLOURS_MAX,
                         COLOUR_SYNTAX);
}

bool figure_option(struct figure_options *o, const struct cli *cli, int key, struct err *err) {
    int side = 0;
    switch (key) {
    case FIGURE_SIDE:
        if (!cli_choice(cli, figure_side_names, &side, err)) return false;
        o->side = (enum figure_side)side;
        return true;
    case FIGURE_LAYER_LIST:
        return cli_names(cli, figure_layer_names, &o->layers, err);
    case FIGURE_LINE_WIDTH:
        return cli_double(cli, 0.1, 100, &o->lines.width, err);
    case FIGURE_DOTS:
        return cli_double(cli, 0.1, 100, &o->lines.dot, err);
    case FIGURE_SQUARES:
        return cli_double(cli, 1e-300, 1e300, &o->lines.square, err);
    case FIGURE_DOT_LABELS:
        return o->lines.labels = true;
    case FIGURE_COLORS:
        return read_colours(o, cli, err);
    case FIGURE_WIDTH:
        return cli_double(cli, 64, 32767, &o->width, err);
    case FIGURE_Y_DOWN:
        return o->y_down = true;
    default: /* FIGURE_NO_LEGEND */
        o->legend = false;
        return true;
    }
}
