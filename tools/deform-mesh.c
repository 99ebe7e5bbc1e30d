/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deform-mesh - applies the deformation of a grid to an OBJ model. */
#include "cli.h"
#include "deform.h"
#include "filemap.h"
#include "grid_io.h"
#include "mem.h"
#include "num.h"
#include "obj_copy.h"

#include <string.h>

static const struct cli_option options[] = {
    {256, "outside", "WHAT", "vertices outside the grid: error (default) or keep"},
    {257, "normals", "WHAT", "transform (default), drop or keep"},
    {258, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},
    {259, "plane", "AXES", "insist that this is the grid's plane, e.g. zy"},
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
    int outside, normals;
    int64_t digits;
    bool has_plane;
    int axes[3];
    const char *output;
};

enum { OUTSIDE_ERROR, OUTSIDE_KEEP };
static const char *const outside_names[] = {"error", "keep", NULL};
static const char *const normals_names[] = {"transform", "drop", "keep",
                                            NULL}; /* obj_normal_mode */

static bool parse_plane(const struct cli *cli, struct settings *set, struct err *err) {
    set->has_plane = grid_axes(cli->value, strlen(cli->value), set->axes);
    return set->has_plane || cli_bad_value(cli, err, "two of the letters x, y, z");
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    bool ok = true;
    while (ok && (key = cli_next(cli, err)) != CLI_END) {
        switch (key) {
        case 256:
            ok = cli_choice(cli, outside_names, &set->outside, err);
            break;
        case 257:
            ok = cli_choice(cli, normals_names, &set->normals, err);
            break;
        case 258:
            ok = cli_int(cli, 1, 17, &set->digits, err);
            break;
        case 259:
            ok = parse_plane(cli, set, err);
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
    struct filemap file;
    struct obj_points points;
    struct deform deform;
    double (*result)[3]; /* points.vertex itself unless the old positions are still needed */
    struct obj_normals normals;
};

static bool read_inputs(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    const char *path = cli_operand(job->cli, 1);
    const int *axes;
    if (!grid_read(&job->grid, path, err)) return false;
    axes = job->grid.spline.grid.axes;
    if (set->has_plane && (axes[0] != set->axes[0] || axes[1] != set->axes[1]))
        return err_set(err, ERR_INPUT, "the plane of the grid is %c%c, not %c%c", "xyz"[axes[0]],
                       "xyz"[axes[1]], "xyz"[set->axes[0]], "xyz"[set->axes[1]]);
    return filemap_open(&job->file, cli_operand(job->cli, 0), err) &&
           obj_points_read(&job->points, &job->file, err);
}

/* Refuses the model because of a vertex; `outside` of them lie outside, or none: an overflow. */
static bool refuse(const struct job *job, size_t vertex, size_t outside, struct err *err) {
    const double *x = job->points.vertex[vertex];
    size_t line = obj_points_line(&job->file, vertex);
    char text[3][NUM_TEXT_MAX + 1] = {{0}};
    for (int c = 0; c < 3; c++) num_print(text[c], x[c], 0);
    if (outside == 0)
        return err_set_at(err, ERR_REFUSAL, job->file.name, line, 0,
                          "the image of vertex %zu at %s %s %s exceeds the range of numbers",
                          vertex + 1, text[0], text[1], text[2]);
    return err_set_at(err, ERR_REFUSAL, job->file.name, line, 0,
                      "%zu of %zu vertices outside the grid; the first is vertex %zu at %s %s %s",
                      outside, job->points.vertex_count, vertex + 1, text[0], text[1], text[2]);
}

/* Old positions stay where normals need derivatives at them. */
static bool deform_vertices(struct job *job, struct err *err) {
    struct obj_points *p = &job->points;
    size_t outside, first = 0;
    job->result = p->vertex;
    if (job->set->normals == OBJ_NORMALS_TRANSFORM && p->normal_count > 0 &&
        !mem_new(job->result, p->vertex_count, err))
        return false;
    if (!deform_points(&job->deform, p->vertex_count, p->vertex, job->result, &outside, &first))
        return refuse(job, first, 0, err);
    if (outside > 0 && job->set->outside == OUTSIDE_ERROR) return refuse(job, first, outside, err);
    return true;
}

/* Turns a normal of the model at a vertex. Outside nothing moves. */
static bool turn(void *context, size_t vertex, const double normal[3], double result[3]) {
    struct job *job = context;
    double image[3], jacobian[3][3];
    memcpy(result, normal, 3 * sizeof *result);
    if (!deform_point(&job->deform, job->points.vertex[vertex], image, jacobian)) return true;
    return deform_normal(jacobian, normal, result);
}

static bool plan_normals(struct job *job, struct err *err) {
    struct obj_normals *n = &job->normals;
    if (job->set->normals == OBJ_NORMALS_DROP) return obj_normals_check(&job->file, err);
    if (job->set->normals == OBJ_NORMALS_KEEP) return true;
    if (!obj_normals_plan(n, &job->file, &job->points, turn, job, err)) return false;
    if (n->stuck_count > 0)
        cli_note(job->cli,
                 "warning: normals kept at %zu vertices where the Jacobian is singular; "
                 "the first is vertex %zu, line %zu of %s",
                 n->stuck_count, n->stuck_first + 1, obj_points_line(&job->file, n->stuck_first),
                 job->file.name);
    return true;
}

static bool print(struct job *job, struct err *err) {
    const struct obj_change change = {.vertex = job->result,
                                      .normals = (enum obj_normal_mode)job->set->normals,
                                      .plan = &job->normals,
                                      .digits = (int)job->set->digits};
    struct out out;
    if (!out_open(&out, job->set->output, err)) return false;
    if (obj_copy(&out, &job->file, &job->points, &change, err)) return out_close(&out, err);
    out_discard(&out);
    return false;
}

static void close_job(struct job *job) {
    if (job->result != job->points.vertex) free(job->result);
    obj_normals_free(&job->normals);
    deform_free(&job->deform);
    obj_points_free(&job->points);
    filemap_close(&job->file);
    grid_file_free(&job->grid);
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct job job = {.cli = cli, .set = set};
    bool ok = read_inputs(&job, err) && deform_init(&job.deform, &job.grid.spline, err) &&
              deform_vertices(&job, err) && plan_normals(&job, err) && print(&job, err);
    close_job(&job);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {0};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
