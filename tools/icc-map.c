/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc-map - moves points from a cage to a deformed version of it. */
#include "cage_io.h"
#include "icc_notes.h"
#include "icc_options.h"
#include "list_io.h"
#include "mem.h"
#include "model_options.h"
#include "obj_copy.h"
#include "places_io.h"
#include "polylines_io.h"

#include <string.h>

enum { INVERSE = 256, COORDS, FROM_COORDS, MODEL, PLANE, OUTSIDE, DIGITS, VERBOSE, PROGRESS };

static const struct cli_option options[] = {
    ICC_OPTIONS,
    {INVERSE, "inverse", NULL, "from the target to the source"},
    {COORDS, "coords", NULL, "print coordinates k lambda t; without a target"},
    {FROM_COORDS, "from-coords", NULL, "POINTS are such coordinates"},
    {MODEL, "model", "FILE.obj", "map the vertices of an OBJ model instead of POINTS"},
    {PLANE, "plane", "AXES", "axes of the model that are x and y (default xy)"},
    {OUTSIDE, "outside", "WHAT", "points outside the cage: error (default) or keep"},
    {DIGITS, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},
    {VERBOSE, "verbose", NULL, "tell on stderr what the map is made of"},
    {PROGRESS, "progress", NULL, "show progress on stderr also if that is no terminal"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "icc-map",
    .synopsis = "[OPTION]... SOURCE.xy TARGET.xy [POINTS]",
    .options = options,
    .epilogue =
        "\n"
        "examples:\n"
        "  icc-map square.xy quad.xy points.xy >moved.xy\n"
        "  icc-map --coords square.xy points.xy | icc-map --from-coords square.xy quad.xy\n",
};

struct settings {
    struct icc_options icc;
    bool inverse, coords, from_coords, has_plane, verbose, progress;
    int outside;
    int axes[3];
    int64_t digits;
    const char *model, *output;
};

enum { OUTSIDE_ERROR, OUTSIDE_KEEP };
static const char *const outside_names[] = {"error", "keep", NULL};

static bool misuse(struct err *err, const char *what) {
    return err_set(err, ERR_USAGE, "%s; try %s --help", what, program.name);
}

/* What no single option can know. */
static bool check(const struct cli *cli, struct settings *set, struct err *err) {
    bool show = icc_options_show(&set->icc);
    int cages = set->coords || show ? 1 : 2, operands = cages + (set->model || show ? 0 : 1);
    if (set->inverse + set->coords + set->from_coords > 1)
        return misuse(err, "--inverse, --coords and --from-coords exclude each other");
    if (show && (set->inverse || set->coords || set->from_coords || set->model))
        return misuse(err, "--lines and --show map nothing");
    if (set->model && (set->coords || set->from_coords))
        return misuse(err, "--model is not for coordinates");
    if (set->has_plane && !set->model) return misuse(err, "--plane needs --model");
    if (!icc_options_end(&set->icc, cli, err) || !cli_check_operands(cli, cages, operands, err))
        return false;
    for (int i = 0; set->model && strcmp(set->model, "-") == 0 && i < cages; i++)
        if (strcmp(cli_operand(cli, i), "-") == 0) return misuse(err, "two inputs from stdin");
    return true;
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    bool ok = true;
    while (ok && (key = cli_next(cli, err)) != CLI_END) {
        if (key == CLI_STOP) return false;
        if (icc_option_is(key)) ok = icc_option(&set->icc, cli, key, err);
        if (key == INVERSE) set->inverse = true;
        if (key == COORDS) set->coords = true;
        if (key == FROM_COORDS) set->from_coords = true;
        if (key == MODEL) set->model = cli->value;
        if (key == PLANE) ok = set->has_plane = model_option_axes(cli, set->axes, err);
        if (key == OUTSIDE) ok = cli_choice(cli, outside_names, &set->outside, err);
        if (key == DIGITS) ok = cli_int(cli, 1, 17, &set->digits, err);
        if (key == VERBOSE) set->verbose = true;
        if (key == PROGRESS) set->progress = true;
        if (key == 'o') set->output = cli->value;
    }
    return ok && check(cli, set, err);
}

/* What a run holds; released by close_job. */
struct job {
    const struct cli *cli;
    const struct settings *set;
    struct cage source, target;
    struct vertices vertices; /* or only its file, where places are read */
    struct places places;
    struct icc_map map;
};

static bool read_inputs(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    const char *source = cli_operand(job->cli, 0), *target = cli_operand(job->cli, 1);
    const char *points = set->model ? set->model : cli_operand(job->cli, set->coords ? 1 : 2);
    if (!cage_read(&job->source, source, err)) return false;
    if (icc_options_show(&set->icc)) return true;
    if (!set->coords && !cage_read_like(&job->target, target, &job->source, source, err))
        return false;
    if (set->from_coords)
        return filemap_open(&job->vertices.file, points, err) &&
               places_read(&job->places, &job->vertices.file, &job->source, err);
    if (!vertices_open(&job->vertices, points, set->model ? VERTICES_OBJ : VERTICES_XY, err))
        return false;
    job->places.count = job->vertices.points.vertex_count;
    return !set->coords || mem_new(job->places.place, job->places.count, err);
}

static bool bind(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    const char *const name[2] = {cli_operand(job->cli, 0), cli_operand(job->cli, 1)};
    bool alone = set->coords || icc_options_show(&set->icc);
    enum icc_use use = alone              ? ICC_NAME
                       : set->from_coords ? ICC_ASK
                       : set->inverse     ? ICC_INVERSE
                                          : ICC_FORWARD;
    if (!icc_map_init(&job->map, &job->source, &set->icc.rule, use, err))
        return err_place(err, name[0], 0, 0);
    if (!alone && !icc_map_target(&job->map, &job->target, err))
        return err_place(err, name[1], 0, 0);
    icc_notes_bound(job->cli, &job->map, name, set->verbose);
    return true;
}

static bool map(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    struct cli_progress progress;
    struct icc_batch batch = {.count = job->places.count,
                              .points = set->from_coords ? job->places.point
                                                         : job->vertices.points.vertex,
                              .axes = {set->axes[0], set->axes[1]},
                              .places = job->places.place,
                              .progress = cli_progress_begin(&progress, job->cli, set->progress)};
    bool ok = icc_map_batch(&job->map, &batch, err);
    cli_progress_end(&progress);
    if (ok && set->verbose)
        icc_notes_mapped(job->cli, &job->map,
                         (const char *const[]){cli_operand(job->cli, 0), cli_operand(job->cli, 1)});
    if (!ok || batch.outside == 0 || set->from_coords || set->outside == OUTSIDE_KEEP) return ok;
    return vertices_refuse(&job->vertices, cli_operand(job->cli, set->inverse), batch.outside,
                           batch.first, err);
}

static bool show(const struct job *job, struct out *out, struct err *err) {
    const struct icc_options *icc = &job->set->icc;
    struct polylines lines;
    bool ok = icc_show(&job->map, (enum icc_show)icc->show, (size_t)icc->lines, &lines, err);
    if (ok) polylines_write(out, &lines, (int)job->set->digits);
    polylines_free(&lines);
    return ok;
}

static bool copy(const struct job *job, struct out *out, struct err *err) {
    const struct settings *set = job->set;
    const struct vertices *v = &job->vertices;
    const struct obj_change model = {
        .vertex = v->points.vertex, .normals = OBJ_NORMALS_KEEP, .digits = (int)set->digits};
    const struct list_change list = {
        .columns = 2, .point = v->points.vertex, .digits = (int)set->digits};
    if (icc_options_show(&set->icc)) return show(job, out, err);
    if (set->coords)
        return places_name(out, &v->file, &job->places, &job->source, (int)set->digits, err);
    if (set->from_coords) return places_ask(out, &v->file, &job->places, (int)set->digits, err);
    return set->model ? obj_copy(out, &v->file, &v->points, &model, err)
                      : list_copy(out, &v->file, v->points.vertex_count, &list, err);
}

static bool print(const struct job *job, struct err *err) {
    struct out out;
    if (!out_open(&out, job->set->output, err)) return false;
    if (copy(job, &out, err)) return out_close(&out, err);
    out_discard(&out);
    return false;
}

static void close_job(struct job *job) {
    icc_map_free(&job->map);
    places_free(&job->places);
    vertices_close(&job->vertices);
    cage_free(&job->target);
    cage_free(&job->source);
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct job job = {.cli = cli, .set = set};
    bool ok = read_inputs(&job, err) && bind(&job, err) && map(&job, err) && print(&job, err);
    close_job(&job);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.axes = {0, 1, 2}};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
