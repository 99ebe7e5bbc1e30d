/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mkgrid - makes a grid: on a rectangle, a polygon or an image, around a model or an outline, of
 * triangles. */
#include "cli.h"
#include "result_options.h"
#include "source_options.h"

enum { VERBOSE = SOURCE_KEY_END };

static const struct cli_option options[] = {
    SOURCE_OPTIONS,
    {VERBOSE, "verbose", NULL, "report the numbers of cells and points on stderr"},
    RESULT_OPTIONS,
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "mkgrid",
    .synopsis = "--rect BOX | --model FILE | --polygon FILE | ... [OPTION]...",
    .options = options,
    .epilogue = "examples:\n"
                "  mkgrid --rect 0,0,8,6 --cells 8x6 | decles-edit -e 'move @4,3 by 1 0 reach 5'\n"
                "  mkgrid --model worm.obj --plane zy | decles-edit bend.edits | deform-mesh "
                "worm.obj >bent.obj\n",
};

struct settings {
    struct source_options source;
    struct result_options result;
    bool verbose;
};

static bool parse_one(const struct cli *cli, int key, struct settings *set, struct err *err) {
    switch (key) {
    case VERBOSE:
        return set->verbose = true;
    case RESULT_DIGITS:
    case 'o':
        return result_option(&set->result, cli, key, err);
    default:
        return source_option(&set->source, cli, key, err);
    }
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    source_options_init(&set->source);
    while ((key = cli_next(cli, err)) != CLI_END)
        if (key == CLI_STOP || !parse_one(cli, key, set, err)) return false;
    return cli_check_operands(cli, 0, 0, err) && source_options_end(&set->source, err);
}

static void report(const struct cli *cli, const struct grid *g, const struct surround_report *r) {
    if (r->cell > 0)
        cli_note(cli,
                 "margin %g, cells of %g: %zu meet the model, %zu added to keep one fan around "
                 "each vertex",
                 r->margin, r->cell, r->kept, r->added);
    cli_note(cli, "%u vertices, %u triangles, %u control points", g->vertex_count,
             g->triangle_count, g->point_count);
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct surround_report cells = {0};
    struct grid_file file = {0};
    struct grid g;
    bool ok = source_options_grid(&set->source, &g, &cells, err);
    if (ok && set->verbose) report(cli, &g, &cells);
    if (!ok) grid_free(&g);
    ok =
        ok && spline_identity(&file.spline, &g, err) && result_write(&set->result, cli, &file, err);
    grid_file_free(&file);
    return ok;
}

int main(int argc, char **argv) {
    struct settings set = {0};
    struct err err = {0};
    struct cli cli;
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
