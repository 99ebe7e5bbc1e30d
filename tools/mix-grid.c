/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mix-grid - linear combinations of deformations on one domain. */
#include "mem.h"
#include "mix.h"
#include "num.h"
#include "result_options.h"

#include <string.h>

static const struct cli_option options[] = {
    RESULT_OPTIONS,
    {0},
};

static const struct cli_program program = {
    .name = "mix-grid",
    .synopsis = "[-o FILE] W GRID [W GRID]...",
    .options = options,
    .epilogue =
        "Weights may be negative; those of a blend add up to 1. Options come first.\n"
        "examples:\n"
        "  mkgrid --rect 0,0,8,4 --cells 8x4 | mix-grid 0.5 - >half.grid\n"
        "  mkgrid --rect 0,0,8,4 --cells 8x4 >a.grid; mix-grid 2 a.grid -1 a.grid >b.grid\n",
    .numbers_are_operands = true,
};

struct settings {
    size_t count;
    double *weight;
    const char **path;
    struct result_options result;
};

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) != CLI_END)
        if (key == CLI_STOP || !result_option(&set->result, cli, key, err)) return false;
    set->count = (size_t)cli->operand_count / 2;
    if (cli->operand_count < 2 || cli->operand_count % 2 != 0)
        return err_set(err, ERR_USAGE,
                       "expected pairs of a weight and a grid; try mix-grid --help");
    if (!mem_new(set->weight, set->count, err) || !mem_new(set->path, set->count, err))
        return false;
    for (size_t i = 0; i < set->count; i++) {
        const char *w = cli->operands[2 * i], *end = w + strlen(w), *next = w;
        if (num_read(w, end, &set->weight[i], &next) != NUM_OK || next != end)
            return err_set(err, ERR_USAGE, "expected a weight, got '%s'; try mix-grid --help", w);
        set->path[i] = cli->operands[2 * i + 1];
    }
    return cli_check_stdin(cli, (int)set->count, set->path, err);
}

static bool read_all(const struct settings *set, struct grid_file *file, struct spline *spline,
                     struct err *err) {
    for (size_t i = 0; i < set->count; i++) {
        if (!grid_read(&file[i], set->path[i], err)) return false;
        spline[i] = file[i].spline; /* borrowed */
    }
    return true;
}

static bool mix(const struct settings *set, struct grid_file *file, struct spline *result,
                struct err *err) {
    struct spline *spline = NULL;
    size_t culprit = 0;
    bool ok = mem_new(spline, set->count, err) && read_all(set, file, spline, err);
    if (ok && !mix_splines(set->count, set->weight, spline, result, &culprit, err)) {
        if (culprit) err_place(err, set->path[culprit], 0, 0);
        ok = false;
    }
    free(spline);
    return ok;
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct grid_file *file = NULL, result = {0};
    bool ok = mem_new(file, set->count, err) && mix(set, file, &result.spline, err);
    if (ok) {
        result.history = file[0].history;
        file[0].history = NULL;
        ok = result_write(&set->result, cli, &result, err);
    }
    for (size_t i = 0; file && i < set->count; i++) grid_file_free(&file[i]);
    free(file);
    grid_file_free(&result);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {0};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) run(&cli, &set, &err);
    free(set.weight);
    free(set.path);
    return cli_finish(&cli, &err);
}
