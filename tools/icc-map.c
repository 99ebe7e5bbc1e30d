/* SPDX-License-Identifier: GPL-3.0-or-later */
/* icc-map - moves points from a cage to a deformed version of it. */
#include "cage_io.h"
#include "history.h"
#include "icc_notes.h"
#include "icc_options.h"
#include "icc_plane.h"
#include "mapped_options.h"
#include "plane_map_io.h"
#include "polylines_io.h"
#include "poses_io.h"

#include <stdlib.h>

enum { DIGITS = 256, VERBOSE, PROGRESS };

static const struct cli_option options[] = {
    ICC_OPTIONS,
    MAPPED_OPTIONS,
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
        "examples:\n"
        "  icc-map --match arclength --mesh 0.01 L.xy square.xy | render-checker -o L.png\n"
        "  icc-map --coords square.xy points.xy | icc-map --from-coords square.xy quad.xy\n",
};

struct settings {
    struct icc_options icc;
    struct mapped_options mapped;
    bool verbose, progress;
    int64_t digits;
    const char *output;
};

static bool parse_one(const struct cli *cli, int key, struct settings *set, struct err *err) {
    switch (key) {
    case DIGITS:
        return cli_int(cli, 1, 17, &set->digits, err);
    case VERBOSE:
        return set->verbose = true;
    case PROGRESS:
        return set->progress = true;
    case 'o':
        set->output = cli->value;
        return true;
    default:
        return mapped_option_is(key) ? mapped_option(&set->mapped, cli, key, err)
                                     : icc_option(&set->icc, cli, key, err);
    }
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) != CLI_END)
        if (key == CLI_STOP || !parse_one(cli, key, set, err)) return false;
    return icc_options_end(&set->icc, cli, err) &&
           mapped_options_end(&set->mapped, cli, icc_options_show(&set->icc), set->output, err);
}

/* What a run holds; released by close_job. */
struct job {
    const struct cli *cli;
    const struct settings *set;
    struct cage source, target;
    struct mapped mapped;
    struct icc_map map;
};

static bool bind_source(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    return icc_map_init(&job->map, &job->source, &set->icc.rule, set->mapped.use, err) ||
           err_place(err, set->mapped.source, 0, 0);
}

/* Binds the target, if the path is not NULL, and tells what there is. */
static bool bind_target(struct job *job, const char *path, struct err *err) {
    const char *const name[2] = {job->set->mapped.source, path};
    if (path && job->set->mapped.use != ICC_NAME && !icc_map_target(&job->map, &job->target, err))
        return err_place(err, path, 0, 0);
    icc_notes_bound(job->cli, &job->map, name, job->set->verbose);
    return true;
}

static bool map(struct job *job, const char *target, struct err *err) {
    const char *const name[2] = {job->set->mapped.source, target};
    struct cli_progress progress;
    struct progress *p = cli_progress_begin(&progress, job->cli, job->set->progress);
    bool ok = mapped_map(&job->mapped, &job->map, name[job->set->mapped.inverse], p, err);
    cli_progress_end(&progress);
    if (ok && job->set->verbose) icc_notes_mapped(job->cli, &job->map, name);
    return ok;
}

static bool write_mapped(const struct job *job, struct out *out, const char *path,
                         struct err *err) {
    if (!out_open(out, path, err)) return false;
    if (mapped_write(out, &job->mapped, &job->source, err)) return true;
    out_discard(out);
    return false;
}

/* Points, a model or coordinates. */
static bool run_mapped(struct job *job, struct err *err) {
    const char *target = job->set->mapped.target;
    struct out out;
    return bind_target(job, target, err) && map(job, target, err) &&
           write_mapped(job, &out, job->set->output, err) && out_close(&out, err);
}

static bool run_pose(struct job *job, struct pose *pose, struct err *err) {
    struct out out;
    cage_free(&job->target);
    return cage_read_like(&job->target, pose->path, &job->source, job->set->mapped.source, "",
                          err) &&
           bind_target(job, pose->path, err) && map(job, pose->path, err) &&
           write_mapped(job, &out, pose->output, err) &&
           out_close_pending(&out, &pose->pending, err);
}

/* --poses: the same for many targets. */
static bool run_poses(struct job *job, struct err *err) {
    const struct mapped_options *o = &job->set->mapped;
    struct poses poses;
    bool ok = poses_read(&poses, o->poses, o->out_dir, o->model ? ".obj" : NULL, err) &&
              poses_spare(&poses, o->poses, err) && poses_spare(&poses, o->source, err) &&
              poses_spare(&poses, o->points, err);
    for (size_t i = 0; ok && i < poses.count; i++) ok = run_pose(job, &poses.pose[i], err);
    ok = ok && poses_commit(&poses, err);
    poses_free(&poses);
    return ok;
}

static void note_mesh(const struct job *job, const struct plane_map *map,
                      const struct icc_plane_report *r) {
    const struct icc_sample_report *s = &r->sample;
    if (job->set->verbose)
        cli_note(job->cli,
                 "%zu triangles; a sample turned %zu over, so %zu vertices were added and %zu "
                 "taken away%s",
                 map->triangle_count, s->flipped, s->added, s->lost,
                 r->overlay ? "; that would not do: these are the overlay of both meshes" : "");
}

static bool write_mesh(const struct job *job, const struct plane_map *map, struct err *err) {
    char *line = cli_history(job->cli, err), *history = line ? history_add(NULL, line, err) : NULL;
    struct out out;
    bool ok = history && out_open(&out, job->set->output, err);
    if (ok) {
        plane_map_write(&out, map, history, (int)job->set->digits);
        ok = out_close(&out, err);
    }
    free(history);
    free(line);
    return ok;
}

/* --mesh: the map itself. */
static bool run_mesh(struct job *job, struct err *err) {
    const struct icc_plane plane = {&job->map, job->set->mapped.mesh, (int)job->set->digits};
    struct icc_plane_report r;
    struct plane_map map;
    bool ok = bind_target(job, job->set->mapped.target, err) && icc_plane(&map, &plane, &r, err);
    if (!ok) return false;
    note_mesh(job, &map, &r);
    ok = write_mesh(job, &map, err);
    plane_map_free(&map);
    return ok;
}

/* --lines, --show: what the method works with. */
static bool run_show(struct job *job, struct err *err) {
    const struct icc_options *icc = &job->set->icc;
    struct polylines lines;
    struct out out;
    if (!bind_target(job, NULL, err)) return false;
    bool ok = icc_show(&job->map, (enum icc_show)icc->show, (size_t)icc->lines, &lines, err) &&
              out_open(&out, job->set->output, err);
    if (ok) {
        polylines_write(&out, &lines, (int)job->set->digits);
        ok = out_close(&out, err);
    }
    polylines_free(&lines);
    return ok;
}

static bool run(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    if (!mapped_options_read(&set->mapped, (int)set->digits, &job->source, &job->target,
                             &job->mapped, err) ||
        !bind_source(job, err))
        return false;
    if (icc_options_show(&set->icc)) return run_show(job, err);
    if (set->mapped.poses) return run_poses(job, err);
    return set->mapped.mesh > 0 ? run_mesh(job, err) : run_mapped(job, err);
}

static void close_job(struct job *job) {
    icc_map_free(&job->map);
    mapped_close(&job->mapped);
    cage_free(&job->target);
    cage_free(&job->source);
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.mapped.axes = {0, 1, 2}};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) {
        struct job job = {.cli = &cli, .set = &set};
        (void)run(&job, &err);
        close_job(&job);
    }
    mapped_options_free(&set.mapped);
    return cli_finish(&cli, &err);
}
