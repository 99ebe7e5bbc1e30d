/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bary - locates the vertices of a model in a grid, once for all deformations of its domain. */
#include "bary_io.h"
#include "model_options.h"

#include <stdlib.h>

static const struct cli_option options[] = {
    MODEL_OPTIONS,
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
    struct model_options model;
    const char *output;
};

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) >= 0) {
        if (key == 'o') set->output = cli->value;
        if (model_option_is(key) && !model_option(&set->model, cli, key, err)) return false;
    }
    return key == CLI_END && model_options_end(&set->model, cli, NULL, err);
}

/* What a run holds; released by close_job. */
struct job {
    const struct cli *cli;
    const struct settings *set;
    struct grid_file grid;
    struct vertices vertices;
    struct bary bary;
};

static bool find_places(struct job *job, struct err *err) {
    const struct grid *g = &job->grid.spline.grid;
    struct projection projection = vertices_projection(&job->vertices, g);
    struct bary *bary = &job->bary;
    struct bary_key key;
    return bary_key(&key, g, &job->vertices, err) &&
           bary_locate(bary, &key, g, &projection, job->vertices.points.vertex, err) &&
           model_options_accept(&job->set->model, &job->vertices, "the grid", bary->outside,
                                bary->first, err);
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
    bool ok = model_options_open(&set->model, cli, &job.grid, &job.vertices, err) &&
              find_places(&job, err) && print(&job, err);
    close_job(&job);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {0};
    model_options_init(&set.model);
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
