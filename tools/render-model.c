/* SPDX-License-Identifier: GPL-3.0-or-later */
/* render-model - a lit picture of a model, with the prisms of a grid around it. */
#include "cli.h"
#include "grid_io.h"
#include "model_options.h"
#include "num.h"
#include "obj_io.h"
#include "palette.h"
#include "picture_options.h"
#include "scene_model.h"
#include "scene_prisms.h"
#include "scene_render.h"

#include <string.h>

enum {
    KEY_VIEW = 256,
    KEY_SHADE,
    KEY_GRID,
    KEY_LAYERS,
    KEY_CONTROLS,
    KEY_NO_MODEL,
    KEY_COMPARE,
    KEY_PLANE
};
enum { SHADE_SMOOTH, SHADE_FLAT };
static const uint32_t OWN = 0xd8b48cff, OTHER = 0x4f9f6f70;
static const char *const shade_names[] = {"smooth", "flat", NULL};
static const char *const controls_names[] = {"bottom", "top", "both", NULL}; /* bits, less 1 */

static const struct cli_option options[] = {
    {KEY_VIEW, "view", "WHICH",
     "top, oblique (default), or azimuth and elevation AZ,EL in degrees"},
    {KEY_SHADE, "shade", "HOW", "smooth (default) or flat"},
    {KEY_GRID, "grid", "GRID", "with the prisms of this grid, as glass"},
    {KEY_LAYERS, "layers", "LIST", "of them: of glass,triangles,points (default), net,quads"},
    {KEY_CONTROLS, "controls", "WHICH",
     "points, net and quads of the bottom, top or both (default)"},
    {KEY_NO_MODEL, "no-model", NULL, "draw the grid alone"},
    {KEY_COMPARE, "compare", "MODEL2", "with another model, as glass"},
    {KEY_PLANE, "plane", "AXES", "the model axes that are x and y (default: the grid's, or xy)"},
    PICTURE_OPTIONS,
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "render-model",
    .synopsis = "[OPTION]... [MODEL]",
    .options = options,
    .epilogue = "examples:\n"
                "  render-model --plane zy worm.obj -o worm.png\n"
                "  decles-edit bend.edits worm.grid | deform-mesh worm.obj | "
                "render-model --view top --plane zy --compare worm.obj -o bent.png\n",
};

struct settings {
    double azimuth, elevation;
    int shade;
    const char *grid, *compare;
    bool has_plane, no_model;
    struct scene_prisms_options prisms; /* layers 0: the usual */
    int axes[3];
    struct picture_options picture;
};

static bool parse_view(const struct cli *cli, struct settings *set, struct err *err) {
    double angle[2];
    if (strcmp(cli->value, "top") == 0)
        angle[0] = 0, angle[1] = 90;
    else if (strcmp(cli->value, "oblique") == 0)
        angle[0] = -25, angle[1] = 40;
    else if (!cli_doubles(cli, 2, angle, err))
        return cli_bad_value(cli, err, "top, oblique or two angles AZ,EL");
    if (!(angle[0] >= -3600 && angle[0] <= 3600 && angle[1] >= -90 && angle[1] <= 90))
        return cli_bad_value(cli, err, "AZ in -3600..3600 and EL in -90..90");
    set->azimuth = angle[0];
    set->elevation = angle[1];
    return true;
}

static bool set_option(struct settings *set, const struct cli *cli, int key, struct err *err) {
    if (picture_option_is(key)) return picture_option(&set->picture, cli, key, err);
    switch (key) {
    case KEY_VIEW:
        return parse_view(cli, set, err);
    case KEY_SHADE:
        return cli_choice(cli, shade_names, &set->shade, err);
    case KEY_GRID:
        set->grid = cli->value;
        return true;
    case KEY_LAYERS:
        return cli_names(cli, scene_prisms_layer_names, &set->prisms.layers, err);
    case KEY_CONTROLS: {
        int which = 0;
        if (!cli_choice(cli, controls_names, &which, err)) return false;
        set->prisms.sheets = (unsigned)which + 1;
        return true;
    }
    case KEY_NO_MODEL:
        set->no_model = true;
        return true;
    case KEY_COMPARE:
        set->compare = cli->value;
        return true;
    default: /* KEY_PLANE */
        set->has_plane = true;
        return model_option_axes(cli, set->axes, err);
    }
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    const char *files[] = {NULL, NULL, NULL};
    int key;
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(set, cli, key, err)) return false;
    if (key != CLI_END || !picture_options_end(&set->picture, cli, set->no_model ? 0 : 1, err))
        return false;
    if (!set->grid && (set->prisms.layers || set->prisms.sheets || set->no_model))
        return err_set(err, ERR_USAGE, "--%s without --grid; try %s --help",
                       set->no_model        ? "no-model"
                       : set->prisms.layers ? "layers"
                                            : "controls",
                       program.name);
    if (set->no_model && set->picture.frames)
        return err_set(err, ERR_USAGE, "--frames goes without --no-model; try %s --help",
                       program.name);
    files[0] = set->picture.frames ? set->picture.frames : set->picture.input;
    files[1] = set->grid;
    files[2] = set->compare;
    return cli_check_stdin(cli, 3, files, err);
}

static bool add_grid(struct scene *scene, struct settings *set, struct err *err) {
    struct grid_file file;
    const int *axes;
    bool ok = grid_read(&file, set->grid, err);
    if (!ok) return false;
    axes = file.spline.grid.axes;
    if (set->has_plane && (axes[0] != set->axes[0] || axes[1] != set->axes[1]))
        ok = err_set(err, ERR_INPUT, "the plane of the grid is %c%c, not %c%c", "xyz"[axes[0]],
                     "xyz"[axes[1]], "xyz"[set->axes[0]], "xyz"[set->axes[1]]);
    memcpy(set->axes, axes, sizeof set->axes);
    set->prisms.steps = file.spline.grid.triangle_count <= 100 ? 24 : 6; /* few are large */
    ok = ok && scene_add_prisms(scene, &file.spline, &set->prisms, err);
    grid_file_free(&file);
    return ok;
}

static bool add_model(struct scene *scene, const struct settings *set, const char *path,
                      uint32_t colour, struct err *err) {
    struct model model;
    bool ok = model_read(&model, path, err);
    if (!ok) return false;
    ok = scene_add_model(scene, &model, set->axes, set->shade == SHADE_SMOOTH, colour, err);
    model_free(&model);
    return ok;
}

/* What a run holds: first what all pictures share. */
struct job {
    const struct settings *set;
    struct scene scene;
    struct cli_progress progress;
    struct progress *shown;
};

static bool begin(struct job *job, const struct cli *cli, struct settings *set, struct err *err) {
    if (!set->prisms.layers)
        set->prisms.layers = 1u << PRISMS_GLASS | 1u << PRISMS_TRIANGLES | 1u << PRISMS_POINTS;
    if (!set->prisms.sheets) set->prisms.sheets = 3;
    if ((set->grid && !add_grid(&job->scene, set, err)) ||
        (set->compare && !add_model(&job->scene, set, set->compare, OTHER, err)))
        return false;
    job->shown = cli_progress_begin(&job->progress, cli, set->picture.progress);
    return true;
}

static bool render(struct job *job, const char *output, enum image_format format, struct err *err) {
    const struct picture_options *o = &job->set->picture;
    const struct scene_camera camera = scene_camera(job->set->azimuth, job->set->elevation);
    const struct scene_style style = {
        .antialias = (int)o->antialias, .background = o->background, .progress = job->shown};
    struct viewport view;
    struct image image;
    double lo[2], hi[2];
    bool ok;
    if (!scene_bounds(&job->scene, &camera, lo, hi, err) ||
        !picture_begin(o, format, lo, hi, &view, &image, err))
        return false;
    ok = scene_render(&job->scene, &camera, &view, &style, &image, err);
    cli_progress_end(&job->progress);
    ok = ok && image_write(&image, format, output, err);
    image_free(&image);
    return ok;
}

/* The model, if there is one, joins what is shared, and leaves it again. */
static bool make_picture(void *context, const char *input, const char *output,
                         enum image_format format, struct err *err) {
    struct job *job = context;
    const size_t faces = job->scene.face_count, lines = job->scene.line_count;
    bool ok = (!input || add_model(&job->scene, job->set, input, OWN, err)) &&
              render(job, output, format, err);
    job->scene.face_count = faces;
    job->scene.line_count = lines;
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.azimuth = -25, .elevation = 40, .axes = {0, 1, 2}};
    struct job job = {.set = &set};
    picture_options_init(&set.picture);
    cli_init(&cli, &program, argc, argv);
    (void)(parse(&cli, &set, &err) && begin(&job, &cli, &set, &err) &&
           picture_make(&set.picture, make_picture, &job, &err));
    scene_free(&job.scene);
    return cli_finish(&cli, &err);
}
