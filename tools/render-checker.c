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
    KEY_MAX_PIXELS,
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
    {KEY_MAX_PIXELS, "max-pixels", "N", "refuse a larger IMAGE (default 100000000)"},
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
    int64_t squares, max_pixels;
    double square; /* 0: by `squares` */
    uint32_t colour[2];
    const char *texture, *input;
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
    case KEY_MAX_PIXELS:
        return cli_int(cli, 1, INT64_MAX, &set->max_pixels, err);
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
    set->input = cli_operand(cli, 0);
    if (set->texture && (set->has_squares || set->square > 0))
        return err_set(err, ERR_USAGE, "--texture goes without squares; try %s --help",
                       program.name);
    if (set->has_squares && set->square > 0)
        return err_set(err, ERR_USAGE, "--squares and --square exclude each other; try %s --help",
                       program.name);
    if (set->has_frame && !set->texture)
        return err_set(err, ERR_USAGE, "--frame needs --texture IMAGE; try %s --help",
                       program.name);
    return picture_options_end(&set->picture, cli, err);
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    picture_options_init(&set->picture);
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(set, cli, key, err)) return false;
    return key == CLI_END && cli_check_operands(cli, 0, 1, err) && check(cli, set, err);
}

/* What a run holds. */
struct job {
    struct filemap file;
    struct textured surface;
    struct grid_file grid;
    struct image texture, picture;
    struct viewport view;
    struct render_style style;
};

static bool read_texture(struct job *job, const struct settings *set, struct err *err) {
    const struct image_request request = {
        .path = set->texture, .page = 1, .max_pixels = set->max_pixels};
    struct texture *t = &job->style.texture;
    if (!image_read(&job->texture, &request, err)) return false;
    t->image = &job->texture;
    t->view = viewport_of_frame(job->texture.width, job->texture.height,
                                set->has_frame ? set->frame : NULL);
    return true;
}

/* The pattern, which fills this box. */
static bool prepare(struct job *job, const struct settings *set, const double lo[2],
                    const double hi[2], struct err *err) {
    struct render_style *style = &job->style;
    *style = (struct render_style){
        .antialias = (int)set->picture.antialias, .lines = set->lines, .folds = set->folds};
    texture_colour(set->picture.background, style->background);
    for (int i = 0; i < 2; i++) texture_colour(set->colour[i], style->texture.colour[i]);
    if (set->texture) return read_texture(job, set, err);
    if (set->square > 0)
        style->texture.square = set->square;
    else
        texture_squares(&style->texture, lo, hi, (double)set->squares);
    return true;
}

static bool render_obj(struct job *job, const struct settings *set, struct err *err) {
    double lo[2], hi[2];
    if (!textured_read(&job->surface, &job->file, err)) return false;
    textured_pattern_box(&job->surface, lo, hi);
    if (!prepare(job, set, lo, hi, err)) return false;
    textured_box(&job->surface, set->axes, lo, hi);
    return picture_begin(&set->picture, lo, hi, &job->view, &job->picture, err) &&
           render_surface(&job->style, &job->surface, set->axes, &job->view, &job->picture, err);
}

static bool render_grid(struct job *job, const struct settings *set, struct err *err) {
    const struct filemap *f = &job->file;
    double lo[2], hi[2];
    if (!grid_read_text(&job->grid, f->name, f->data, f->length, err)) return false;
    render_domain_box(&job->grid.spline.grid, lo, hi);
    return prepare(job, set, lo, hi, err) && render_map_box(&job->grid.spline, lo, hi, err) &&
           picture_begin(&set->picture, lo, hi, &job->view, &job->picture, err) &&
           render_map(&job->style, &job->grid.spline, &job->view, &job->picture, err);
}

static void run(const struct settings *set, struct err *err) {
    struct job job = {.file = {.name = NULL}};
    (void)(filemap_open(&job.file, set->input, err) &&
           (grid_is_text(job.file.data, job.file.length) ? render_grid(&job, set, err)
                                                         : render_obj(&job, set, err)) &&
           image_write(&job.picture, set->picture.format, set->picture.output, err));
    image_free(&job.picture);
    image_free(&job.texture);
    textured_free(&job.surface);
    grid_file_free(&job.grid);
    filemap_close(&job.file);
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.squares = 16,
                           .max_pixels = IMAGE_PIXELS_DEFAULT,
                           .colour = {0x2f5d8aff, 0xf2e9d8ff},
                           .axes = {0, 1, 2}};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) run(&set, &err);
    return cli_finish(&cli, &err);
}
