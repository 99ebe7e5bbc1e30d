/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deform-mesh - applies the deformation of a grid, or its inverse, to an OBJ model or a list of
 * points. */
#include "bary_io.h"
#include "deform.h"
#include "list_io.h"
#include "mem.h"
#include "model_options.h"
#include "obj_copy.h"

enum { NORMALS = 256, DIGITS, BARY, JACOBIAN, PROGRESS, INVERSE, ANY };

static const struct cli_option options[] = {
    MODEL_OPTIONS,
    {NORMALS, "normals", "WHAT", "transform (default), drop or keep"},
    {DIGITS, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},
    {BARY, "bary", "FILE", "take the places of the vertices from FILE, see bary(1)"},
    {JACOBIAN, "jacobian", NULL, "append derivatives of the map and their determinant to points"},
    {INVERSE, "inverse", NULL, "apply the inverse: MODEL has been deformed by GRID, undo it"},
    {ANY, "any", NULL, "with --inverse: any preimage will do where there are several"},
    {PROGRESS, "progress", NULL, "show progress on stderr also if that is no terminal"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "deform-mesh",
    .synopsis = "[OPTION]... MODEL [GRID]",
    .options = options,
    .epilogue =
        "examples:\n"
        "  mkgrid --model worm.obj --plane zy | deform-mesh worm.obj >same.obj\n"
        "  mkgrid --model worm.obj --plane zy | decles-edit -e 'rotate all about 0 0 by 90' | "
        "deform-mesh worm.obj -o turned.obj\n",
};

struct settings {
    struct model_options model;
    int normals; /* enum obj_normal_mode */
    int64_t digits;
    bool inverse, any, jacobian, progress;
    const char *bary, *output;
};

static const char *const normals_names[] = {"transform", "drop", "keep", NULL};

/* What no single option can know. */
static bool check(const struct cli *cli, struct settings *set, struct err *err) {
    if (!model_options_end(&set->model, cli, set->bary, err)) return false;
    if (set->any && !set->inverse)
        return err_set(err, ERR_USAGE, "--any goes with --inverse; try %s --help", program.name);
    if (set->jacobian && set->model.format == VERTICES_OBJ)
        return err_set(err, ERR_USAGE, "--jacobian is for lists of points; try %s --help",
                       program.name);
    return true;
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    bool ok = true;
    while (ok && (key = cli_next(cli, err)) != CLI_END) {
        if (key == CLI_STOP) return false;
        if (model_option_is(key)) ok = model_option(&set->model, cli, key, err);
        if (key == NORMALS) ok = cli_choice(cli, normals_names, &set->normals, err);
        if (key == DIGITS) ok = cli_int(cli, 1, 17, &set->digits, err);
        if (key == BARY) set->bary = cli->value;
        if (key == INVERSE) set->inverse = true;
        if (key == ANY) set->any = true;
        if (key == JACOBIAN) set->jacobian = true;
        if (key == PROGRESS) set->progress = true;
        if (key == 'o') set->output = cli->value;
    }
    return ok && check(cli, set, err);
}

/* What a run holds; released by close_job. */
struct job {
    const struct cli *cli;
    const struct settings *set;
    struct grid_file grid;
    struct vertices vertices;
    struct bary bary;
    struct deform deform;
    double (*image)[3];    /* the vertices themselves unless the old ones are still needed */
    double (*gradient)[5]; /* for --jacobian, else NULL */
    struct obj_normals normals;
};

/* The map must be one-to-one, unless any preimage will do. */
static bool invert(struct job *job, const struct projection *projection, struct err *err) {
    const struct spline *s = &job->grid.spline;
    struct err why = {0};
    bool proved = deform_prove(s, projection, &why);
    if (!proved && (why.kind != ERR_REFUSAL || !job->set->any)) {
        *err = why;
        return false;
    }
    if (!proved) cli_note(job->cli, "warning: %s; of several preimages, one is taken", why.message);
    return deform_init_inverse(&job->deform, s, projection, job->bary.place, proved, err);
}

/* Makes job->deform, with places that are known or without. */
static bool place(struct job *job, struct err *err) {
    const struct spline *s = &job->grid.spline;
    struct projection projection = vertices_projection(&job->vertices, &s->grid);
    struct bary_key key;
    if (job->set->bary) {
        if (!bary_key(&key, &s->grid, &job->vertices, err)) return false;
        key.any_model = job->set->inverse; /* that of the model before it was deformed */
        if (!bary_read(&job->bary, job->set->bary, &key, err)) return false;
    }
    if (job->set->inverse) return invert(job, &projection, err);
    return deform_init(&job->deform, s, &projection, job->bary.place, err);
}

/* Old positions stay where normals need derivatives at them. */
static bool deform(struct job *job, struct err *err) {
    struct obj_points *p = &job->vertices.points;
    struct cli_progress progress;
    struct deform_batch batch = {.count = p->vertex_count, .points = p->vertex};
    bool ok;
    job->image = p->vertex;
    if (job->set->normals == OBJ_NORMALS_TRANSFORM && p->normal_count > 0 &&
        !mem_new(job->image, p->vertex_count, err))
        return false;
    if (job->set->jacobian && !mem_new(job->gradient, p->vertex_count, err)) return false;
    batch.images = job->image;
    batch.gradient = job->gradient;
    batch.progress = cli_progress_begin(&progress, job->cli, job->set->progress);
    ok = deform_points(&job->deform, &batch);
    cli_progress_end(&progress);
    if (!ok)
        return vertices_refuse_result(&job->vertices,
                                      job->gradient ? "the image or derivative" : "the image",
                                      batch.first, err);
    return model_options_accept(&job->set->model, &job->vertices,
                                job->set->inverse ? "the deformed grid" : "the grid", batch.outside,
                                batch.first, err);
}

/* Turns a normal of the model at a vertex. */
static bool turn(void *context, size_t vertex, const double normal[3], double result[3]) {
    struct job *job = context;
    const double *point = job->vertices.points.vertex[vertex];
    return deform_turn(&job->deform, vertex, point, normal, result);
}

static bool plan_normals(struct job *job, struct err *err) {
    struct obj_normals *n = &job->normals;
    const struct vertices *v = &job->vertices;
    if (v->format != VERTICES_OBJ || job->set->normals == OBJ_NORMALS_KEEP) return true;
    if (job->set->normals == OBJ_NORMALS_DROP) return obj_normals_check(&v->file, err);
    if (!obj_normals_plan(n, &v->file, &v->points, turn, job, err)) return false;
    if (n->stuck_count > 0)
        cli_note(job->cli,
                 "warning: normals kept at %zu vertices where the Jacobian is singular; "
                 "the first is vertex %zu, line %zu of %s",
                 n->stuck_count, n->stuck_first + 1, vertices_line(v, n->stuck_first),
                 v->file.name);
    return true;
}

static bool copy_model(const struct job *job, struct out *out, struct err *err) {
    const struct vertices *v = &job->vertices;
    const struct obj_change change = {.vertex = job->image,
                                      .normals = (enum obj_normal_mode)job->set->normals,
                                      .plan = &job->normals,
                                      .digits = (int)job->set->digits};
    const struct list_change list_change = {.columns = vertices_columns(v),
                                            .point = job->image,
                                            .further = job->gradient,
                                            .digits = (int)job->set->digits};
    return v->format == VERTICES_OBJ
               ? obj_copy(out, &v->file, &v->points, &change, err)
               : list_copy(out, &v->file, v->points.vertex_count, &list_change, err);
}

static bool print(const struct job *job, struct err *err) {
    struct out out;
    if (!out_open(&out, job->set->output, err)) return false;
    if (copy_model(job, &out, err)) return out_close(&out, err);
    out_discard(&out);
    return false;
}

static void close_job(struct job *job) {
    if (job->image != job->vertices.points.vertex) free(job->image);
    free(job->gradient);
    obj_normals_free(&job->normals);
    deform_free(&job->deform);
    bary_free(&job->bary);
    vertices_close(&job->vertices);
    grid_file_free(&job->grid);
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct job job = {.cli = cli, .set = set};
    bool ok = model_options_open(&set->model, cli, &job.grid, &job.vertices, err) &&
              place(&job, err) && deform(&job, err) && plan_normals(&job, err) && print(&job, err);
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
