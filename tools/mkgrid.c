/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mkgrid - makes a grid: on a rectangle, a polygon or an image, around a model or an outline, of
 * triangles. */
#include "cli.h"
#include "grid_io.h"
#include "source_options.h"

#include <stdlib.h>

enum { DIGITS = SOURCE_KEY_END, VERBOSE };

static const struct cli_option options[] = {
    SOURCE_OPTIONS,
    {DIGITS, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},
    {VERBOSE, "verbose", NULL, "report the numbers of cells and points on stderr"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
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
    int64_t digits;
    bool verbose;
    const char *output;
};

static bool parse_one(const struct cli *cli, int key, struct settings *set, struct err *err) {
    switch (key) {
    case DIGITS:
        return cli_int(cli, 1, 17, &set->digits, err);
    case VERBOSE:
        return set->verbose = true;
    case 'o':
        set->output = cli->value;
        return true;
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
    struct surround_report cells = {0};
    struct grid_file file = {0};
    struct grid g;
    bool ok = source_options_grid(&set->source, &g, &cells, err);
    if (ok && set->verbose) report(cli, &g, &cells);
    if (!ok) grid_free(&g);
    ok = ok && spline_identity(&file.spline, &g, err) && print(cli, set, &file, err);
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
