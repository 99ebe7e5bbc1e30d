/* SPDX-License-Identifier: GPL-3.0-or-later */
/* check-grid - proves that a deformation is smooth and one-to-one, or shows where it is not. */
#include "check_io.h"
#include "cli.h"
#include "grid_io.h"

enum { JSON = 256, BOUND, UNDECIDED, PER_TRIANGLE };

static const struct cli_option options[] = {
    {JSON, "json", NULL, "write JSON instead of lines"},
    {BOUND, "bound", "TOL", "relative gap of the bounds, 1e-12..0.5 (default 0.01)"},
    {UNDECIDED, "undecided", "B", "|least det| and distances, relative, that may stay undecided"},
    {PER_TRIANGLE, "per-triangle", NULL, "also the verdict and bounds of each triangle"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "check-grid",
    .synopsis = "[OPTION]... [GRID]",
    .options = options,
    .epilogue = "exit status: 0 when all holds, 3 when not; the report is on stdout either way\n"
                "\n"
                "examples:\n"
                "  decles-edit bend.edits worm.grid | check-grid\n"
                "  mkgrid --rect 0,0,8,6 --cells 8x6 | check-grid --json --per-triangle\n",
};

struct settings {
    bool json, per_triangle;
    struct least_rule rule;
    const char *output;
};

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) >= 0) {
        if (key == 'o') set->output = cli->value;
        if (key == JSON) set->json = true;
        if (key == PER_TRIANGLE) set->per_triangle = true;
        if (key == BOUND && !cli_double(cli, 1e-12, 0.5, &set->rule.tolerance, err)) return false;
        if (key == UNDECIDED && !cli_double(cli, 0, 0.5, &set->rule.undecided, err)) return false;
    }
    return key == CLI_END && cli_check_operands(cli, 0, 1, err);
}

/* The verdict is printed whatever it is. */
static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct grid_file file;
    struct check check;
    struct out out;
    bool ok;
    if (!grid_read(&file, cli_operand(cli, 0), err)) return false;
    ok = check_init(&check, &file.spline, &set->rule, set->per_triangle, err);
    if (ok) {
        ok = out_open(&out, set->output, err);
        if (ok) {
            check_write(&out, &check, &file.spline, set->json, set->per_triangle);
            ok = out_close(&out, err) && check_holds(&check, &file.spline, err);
        }
        check_free(&check);
    }
    grid_file_free(&file);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.rule = jacobian_default_rule};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
