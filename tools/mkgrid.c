/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mkgrid - makes a regular grid on a rectangle or around a model. */
#include "cli.h"
#include "grid_io.h"
#include "obj_io.h"
#include "rectangle.h"
#include "surround.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum {
    RECT = 256,
    MODEL,
    PLANE,
    MARGIN,
    CELLS,
    CELL,
    PATTERN,
    DEGREE,
    DEPTH,
    FLAT,
    LATTICE,
    BITS,
    DIGITS,
    VERBOSE
};

static const struct cli_option options[] = {
    {RECT, "rect", "X0,Y0,X1,Y1", "a grid on this rectangle"},
    {MODEL, "model", "FILE", "a grid around this OBJ model"},
    {PLANE, "plane", "AXES", "the model axes that are the grid's x and y (default xy)"},
    {MARGIN, "margin", "M", "around the model (default 0.05 of its larger extent)"},
    {CELLS, "cells", "N|NXxNY", "cells along the longer side (16); both with --rect"},
    {CELL, "cell", "SIZE", "or the side of a cell, with --model"},
    {PATTERN, "pattern", "NAME", "diagonal (default), cross or hex"},
    {DEGREE, "degree", "D", "of the spline, 1..15 (default 5)"},
    {DEPTH, "depth", "A,B", "the interval that the prisms span (default: the model's)"},
    {FLAT, "flat", NULL, "no depth, whatever the model"},
    {LATTICE, "lattice", "STEP", "of the vertices (default: the power of two that fits)"},
    {BITS, "lattice-bits", "N", "vertices take 0..2^N-1 steps, N = 1..24 (default 16)"},
    {DIGITS, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},
    {VERBOSE, "verbose", NULL, "report the numbers of cells and points on stderr"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "mkgrid",
    .synopsis = "--rect X0,Y0,X1,Y1 | --model FILE [OPTION]...",
    .options = options,
    .epilogue = "examples:\n"
                "  mkgrid --rect 0,0,8,6 --cells 8x6 | decles-edit -e 'move @4,3 by 1 0 reach 5'\n"
                "  mkgrid --model worm.obj --plane zy | decles-edit bend.edits | deform-mesh "
                "worm.obj >bent.obj\n",
};

struct settings {
    bool has_rect, has_depth, has_margin, verbose;
    double rect[4], depth[2];
    const char *model, *output;
    int axes[3], kind;
    int64_t cells[2]; /* 0: not given */
    int64_t degree, bits, digits;
    struct surround surround;
};

static bool parse_rect(const struct cli *cli, struct settings *set, struct err *err) {
    const double *r = set->rect;
    set->has_rect = true;
    if (!cli_doubles(cli, 4, set->rect, err)) return false;
    return (r[0] < r[2] && r[1] < r[3]) || cli_bad_value(cli, err, "X0 < X1 and Y0 < Y1");
}

static bool parse_depth(const struct cli *cli, struct settings *set, struct err *err) {
    set->has_depth = true;
    if (!cli_doubles(cli, 2, set->depth, err)) return false;
    return set->depth[0] < set->depth[1] || cli_bad_value(cli, err, "A < B");
}

static bool parse_cells(const struct cli *cli, struct settings *set, struct err *err) {
    set->cells[1] = 0;
    if (strchr(cli->value, 'x')) return cli_cells(cli, PATTERN_CELLS_MAX, set->cells, err);
    return cli_int(cli, 1, SURROUND_CELLS_MAX, &set->cells[0], err);
}

/* What is made: the first options of the table. */
static bool parse_shape(const struct cli *cli, int key, struct settings *set, struct err *err) {
    switch (key) {
    case RECT:
        return parse_rect(cli, set, err);
    case MODEL:
        set->model = cli->value;
        return true;
    case PLANE:
        return grid_axes(cli->value, strlen(cli->value), set->axes) ||
               cli_bad_value(cli, err, "two of the letters x, y, z");
    case MARGIN:
        set->has_margin = true;
        return cli_double(cli, 0, DBL_MAX, &set->surround.margin, err);
    case CELLS:
        return parse_cells(cli, set, err);
    case CELL:
        return cli_double(cli, DBL_MIN, DBL_MAX, &set->surround.cell, err);
    default:
        return cli_choice(cli, pattern_names, &set->kind, err);
    }
}

static bool parse_one(const struct cli *cli, int key, struct settings *set, struct err *err) {
    switch (key) {
    case DEGREE:
        return cli_int(cli, 1, GRID_DEGREE_MAX, &set->degree, err);
    case DEPTH:
        return parse_depth(cli, set, err);
    case FLAT:
        return set->surround.flat = true;
    case LATTICE:
        return cli_double(cli, DBL_MIN, DBL_MAX, &set->surround.lattice.step, err);
    case BITS:
        return cli_int(cli, 1, 24, &set->bits, err);
    case DIGITS:
        return cli_int(cli, 1, 17, &set->digits, err);
    case VERBOSE:
        return set->verbose = true;
    case 'o':
        set->output = cli->value;
        return true;
    default:
        return parse_shape(cli, key, set, err);
    }
}

static bool misuse(struct err *err, const char *what) {
    return err_set(err, ERR_USAGE, "%s; try mkgrid --help", what);
}

/* Options that do not go together. */
static bool check(const struct settings *set, struct err *err) {
    const struct surround *s = &set->surround;
    if (set->has_rect == (set->model != NULL))
        return misuse(err, "expected one of --rect and --model");
    if (set->has_depth && s->flat) return misuse(err, "--depth and --flat exclude each other");
    if (set->cells[0] && s->cell > 0) return misuse(err, "--cells and --cell exclude each other");
    if (set->has_rect && (set->has_margin || s->cell > 0))
        return misuse(err, "--margin and --cell go with --model only");
    if (set->has_rect && set->cells[1] == 0)
        return misuse(err, "--rect needs --cells NXxNY, as in 16x12");
    if (set->model && set->cells[1] > 0)
        return misuse(err, "--cells takes one number with --model");
    return true;
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) != CLI_END)
        if (key == CLI_STOP || !parse_one(cli, key, set, err)) return false;
    if (!cli_check_operands(cli, 0, 0, err) || !check(set, err)) return false;
    set->surround.kind = (enum pattern_kind)set->kind;
    set->surround.lattice.bits = (int)set->bits;
    if (set->cells[0]) set->surround.cells = (uint32_t)set->cells[0];
    return true;
}

static bool make_rectangle(const struct settings *set, struct grid *g, struct err *err) {
    const struct rectangle r = {.low = {set->rect[0], set->rect[1]},
                                .high = {set->rect[2], set->rect[3]},
                                .cells = {(uint32_t)set->cells[0], (uint32_t)set->cells[1]},
                                .kind = set->surround.kind,
                                .lattice = set->surround.lattice};
    return rectangle_grid(g, &r, err) && grid_build(g, err);
}

static bool make_around(const struct cli *cli, const struct settings *set, struct grid *g,
                        struct err *err) {
    struct surround_report report;
    struct model model;
    bool ok;
    if (!model_read(&model, set->model, err)) return false;
    ok = surround_grid(g, &model, &set->surround, &report, err);
    model_free(&model);
    if (ok && set->verbose)
        cli_note(cli,
                 "margin %g, cells of %g: %zu meet the model, %zu added to keep one fan around "
                 "each vertex",
                 report.margin, report.cell, report.kept, report.added);
    return ok;
}

static bool print(const struct cli *cli, const struct settings *set, const struct grid_file *file,
                  struct err *err) {
    char *history = cli_history(cli, err);
    struct out out;
    bool ok = history && out_open(&out, set->output, err);
    if (ok) {
        grid_write(&out, file, history, (int)set->digits);
        ok = out_close(&out, err);
    }
    free(history);
    return ok;
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct grid_file file = {0};
    struct grid g = {.degree = (int)set->degree, .has_depth = set->has_depth};
    bool ok;
    memcpy(g.axes, set->axes, sizeof g.axes);
    memcpy(g.depth, set->depth, sizeof g.depth);
    ok = set->model ? make_around(cli, set, &g, err) : make_rectangle(set, &g, err);
    if (ok && set->verbose)
        cli_note(cli, "%u vertices, %u triangles, %u control points", g.vertex_count,
                 g.triangle_count, g.point_count);
    ok = ok && spline_identity(&file.spline, &g, err) && print(cli, set, &file, err);
    grid_file_free(&file);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {
        .axes = {0, 1, 2}, .degree = 5, .bits = 16, .surround = {.margin = -1, .cells = 16}};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
