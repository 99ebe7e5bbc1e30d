/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bary - locates the vertices of a model in a grid, once for all deformations of its domain. */
#include "bary_io.h"
#include "cli.h"
#include "grid_io.h"

#include <stdlib.h>

static const struct cli_option options[] = {
    {256, "format", "WHAT", "MODEL is obj, xy or xyz (default: by its name, else obj)"},
    {257, "outside", "WHAT", "vertices outside the grid: error (default) or keep"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "bary",
    .synopsis = "[OPTION]... MODEL [GRID]",
    .options = options,
    .epilogue = "\n"
                "examples:\n"
                "  mkgrid --model worm.obj --plane zy | bary worm.obj >worm.bary\n"
                "  mkgrid --model worm.obj >r.grid && bary worm.obj r.grid | deform-mesh --bary - "
                "worm.obj r.grid\n",
};

struct settings {
    int format, outside;
    const char *output;
};

enum { OUTSIDE_ERROR, OUTSIDE_KEEP };
static const char *const outside_names[] = {"error", "keep", NULL};

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    bool ok = true;
    while (ok && (key = cli_next(cli, err)) != CLI_END) {
        switch (key) {
        case 256:
            ok = cli_choice(cli, vertices_format_names, &set->format, err);
            break;
        case 257:
            ok = cli_choice(cli, outside_names, &set->outside, err);
            break;
        case 'o':
            set->output = cli->value;
            break;
        default:
            return false;
        }
    }
    return ok && cli_check_operands(cli, 1, 2, err);
}

/* What a run holds; released by close_job. */
struct job {
    const struct cli *cli;
    const struct settings *set;
    struct grid_file grid;
    struct vertices vertices;
    struct bary bary;
};

static bool read_inputs(struct job *job, struct err *err) {
    const char *path = cli_operand(job->cli, 0);
    return grid_read(&job->grid, cli_operand(job->cli, 1), err) &&
           vertices_open(&job->vertices, path, vertices_format(job->set->format, path), err);
}

static bool find_places(struct job *job, struct err *err) {
    const struct grid *g = &job->grid.spline.grid;
    struct projection projection = vertices_projection(&job->vertices, g);
    struct bary *bary = &job->bary;
    struct bary_key key;
    if (!bary_key(&key, g, &job->vertices, err) ||
        !bary_locate(bary, &key, g, &projection, job->vertices.points.vertex, err))
        return false;
    if (bary->outside > 0 && job->set->outside == OUTSIDE_ERROR)
        return vertices_refuse(&job->vertices, bary->outside, bary->first, err);
    return true;
}

/* The history of the places is that of the grid, which made them what they are. */
static bool print(struct job *job, struct err *err) {
    char *line = cli_history(job->cli, err);
    struct out out;
    bool ok = line && out_open(&out, job->set->output, err);
    if (ok) {
        job->bary.history = job->grid.history;
        job->grid.history = NULL;
        bary_write(&out, &job->bary, line);
        ok = out_close(&out, err);
    }
    free(line);
    return ok;
}

static void close_job(struct job *job) {
    bary_free(&job->bary);
    vertices_close(&job->vertices);
    grid_file_free(&job->grid);
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct job job = {.cli = cli, .set = set};
    bool ok = read_inputs(&job, err) && find_places(&job, err) && print(&job, err);
    close_job(&job);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.format = VERTICES_BY_NAME};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
