/* SPDX-License-Identifier: GPL-3.0-or-later */
/* render-checker - a picture of a checkerboard, or of an image, under a map. */
#include "cli.h"
#include "colour_io.h"
#include "filemap.h"
#include "grid_io.h"
#include "model_options.h"
#include "picture_options.h"
#include "render.h"
#include "textured_io.h"

#include <math.h>
#include <stdlib.h>

enum {
    KEY_SQUARES = 256,
    KEY_SQUARE,
    KEY_COLORS,
    KEY_TEXTURE,
    KEY_FRAME,
    KEY_LINES,
    KEY_FOLDS,
    KEY_PLANE,
};

static const struct cli_option options[] = {
    {KEY_SQUARES, "squares", "N", "squares along the pattern's longer side (default 16)"},
    {KEY_SQUARE, "square", "SIZE", "or the side of a square, one corner at 0,0"},
    {KEY_COLORS, "colors", "A,B", "of the squares (default 2f5d8a,f2e9d8)"},
    {KEY_TEXTURE, "texture", "IMAGE", "an image instead of squares"},
    {KEY_FRAME, "frame", "X0,Y0,X1,Y1", "where it lies in the pattern (default: one unit a pixel)"},
    {KEY_LINES, "mesh-lines", NULL, "draw the edges of the triangles"},
    {KEY_FOLDS, "mark-folds", NULL, "mark where the map turns over"},
    {KEY_PLANE, "plane", "AXES", "of an OBJ: what points right and up (default xy)"},
    PICTURE_OPTIONS,
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "render-checker",
    .synopsis = "[OPTION]... [INPUT]",
    .options = options,
    .epilogue = "examples:\n"
                "  mkgrid --rect 0,0,8,6 --cells 8x6 | decles-edit -e 'move @4,3 by 1 0 reach 5' | "
                "render-checker -o pushed.png\n"
                "  mkgrid --rect 0,0,8,6 --cells 8x6 | convert-grid --to obj | "
                "render-checker --mesh-lines --size 400x300 >cells.png\n",
};

struct settings {
    int64_t squares;
    double square; /* 0: by `squares` */
    uint32_t colour[2];
    const char *texture;
    bool has_frame, has_squares, lines, folds;
    double frame[4];
    int axes[3];
    struct picture_options picture;
};

static bool set_option(struct settings *set, const struct cli *cli, int key, struct err *err) {
    switch (key) {
    case KEY_SQUARES:
        set->has_squares = true;
        return cli_int(cli, 1, 1000000000, &set->squares, err);
    case KEY_SQUARE:
        return cli_double(cli, 1e-300, 1e300, &set->square, err);
    case KEY_COLORS:
        return colour_read_pair(cli->value, set->colour) ||
               cli_bad_value(cli, err, "two colours with a comma between, each %s", COLOUR_SYNTAX);
    case KEY_TEXTURE:
        set->texture = cli->value;
        return true;
    case KEY_FRAME:
        set->has_frame = true;
        return picture_frame(cli, set->frame, err);
    case KEY_LINES:
        return set->lines = true;
    case KEY_FOLDS:
        return set->folds = true;
    case KEY_PLANE:
        return model_option_axes(cli, set->axes, err);
    default:
        return picture_option(&set->picture, cli, key, err);
    }
}

/* What no single option can know. */
static bool check(const struct cli *cli, struct settings *set, struct err *err) {
    const char *files[2];
    if (set->texture && (set->has_squares || set->square > 0))
        return err_set(err, ERR_USAGE, "--texture goes without squares; try %s --help",
                       program.name);
    if (set->has_squares && set->square > 0)
        return err_set(err, ERR_USAGE, "--squares and --square exclude each other; try %s --help",
                       program.name);
    if (set->has_frame && !set->texture)
        return err_set(err, ERR_USAGE, "--frame needs --texture IMAGE; try %s --help",
                       program.name);
    if (!picture_options_end(&set->picture, cli, 1, err)) return false;
    files[0] = set->picture.frames ? set->picture.frames : set->picture.input;
    files[1] = set->texture;
    return cli_check_stdin(cli, 2, files, err);
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    picture_options_init(&set->picture);
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(set, cli, key, err)) return false;
    return key == CLI_END && check(cli, set, err);
}

/* What a run holds; from `format` on, of one picture. */
struct job {
    const struct settings *set;
    struct cli_progress progress;
    struct render_style style;
    struct image texture;
    enum image_format format;
    struct image picture;
    struct viewport view;
};

/* What all pictures share. */
static bool begin(struct job *job, const struct cli *cli, struct err *err) {
    const struct settings *set = job->set;
    const struct image_request request = {
        .path = set->texture, .page = 1, .max_pixels = set->picture.max_pixels};
    struct render_style *style = &job->style;
    struct texture *t = &style->texture;
    *style = (struct render_style){
        .antialias = (int)set->picture.antialias,
        .lines = set->lines,
        .folds = set->folds,
        .progress = cli_progress_begin(&job->progress, cli, set->picture.progress)};
    texture_colour(set->picture.background, style->background);
    for (int i = 0; i < 2; i++) texture_colour(set->colour[i], t->colour[i]);
    t->square = set->square;
    if (!set->texture) return true;
    if (!image_read(&job->texture, &request, err)) return false;
    t->image = &job->texture;
    t->view = viewport_of_frame(job->texture.width, job->texture.height,
                                set->has_frame ? set->frame : NULL);
    return true;
}

/* The pattern, which fills this box. */
static void fill(struct job *job, const double lo[2], const double hi[2]) {
    if (!job->set->texture && !(job->set->square > 0))
        texture_squares(&job->style.texture, lo, hi, (double)job->set->squares);
}

static bool render_obj(struct job *job, const struct filemap *f, struct err *err) {
    const struct settings *set = job->set;
    struct textured surface;
    double lo[2], hi[2];
    bool ok = textured_read(&surface, f, err);
    if (!ok) return false;
    textured_pattern_box(&surface, lo, hi);
    fill(job, lo, hi);
    textured_box(&surface, set->axes, lo, hi);
    ok = picture_begin(&set->picture, job->format, lo, hi, &job->view, &job->picture, err) &&
         render_surface(&job->style, &surface, set->axes, &job->view, &job->picture, err);
    textured_free(&surface);
    return ok;
}

static bool render_grid(struct job *job, const struct filemap *f, struct err *err) {
    struct grid_file grid = {.history = NULL};
    double lo[2], hi[2];
    bool ok = grid_read_text(&grid, f->name, f->data, f->length, err);
    if (!ok) return false;
    render_domain_box(&grid.spline.grid, lo, hi);
    fill(job, lo, hi);
    ok = render_map_box(&grid.spline, lo, hi, err) &&
         picture_begin(&job->set->picture, job->format, lo, hi, &job->view, &job->picture, err) &&
         render_map(&job->style, &grid.spline, &job->view, &job->picture, err);
    grid_file_free(&grid);
    return ok;
}

static bool make_picture(void *context, const char *input, const char *output,
                         enum image_format format, struct err *err) {
    struct job *job = context;
    struct filemap file;
    bool ok = filemap_open(&file, input, err);
    job->format = format;
    job->picture = (struct image){0};
    ok = ok && (grid_is_text(file.data, file.length) ? render_grid(job, &file, err)
                                                     : render_obj(job, &file, err));
    cli_progress_end(&job->progress);
    ok = ok && image_write(&job->picture, format, output, err);
    image_free(&job->picture);
    filemap_close(&file);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.squares = 16, .colour = {0x2f5d8aff, 0xf2e9d8ff}, .axes = {0, 1, 2}};
    struct job job = {.set = &set};
    cli_init(&cli, &program, argc, argv);
    (void)(parse(&cli, &set, &err) && begin(&job, &cli, &err) &&
           picture_make(&set.picture, make_picture, &job, &err));
    image_free(&job.texture);
    return cli_finish(&cli, &err);
}
