/* SPDX-License-Identifier: GPL-3.0-or-later */
/* warp-image - moves an image by a deformation. */
#include "cli.h"
#include "frames_io.h"
#include "grid_io.h"
#include "picture_options.h"
#include "warp.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    KEY_FILTER = 256,
    KEY_ANTIALIAS,
    KEY_SIZE,
    KEY_FRAME,
    KEY_INVERSE,
    KEY_BACKGROUND,
    KEY_FRAMES,
    KEY_PAGE,
    KEY_MAX_PIXELS,
    KEY_TO,
    KEY_PROGRESS,
};

static const struct cli_option options[] = {
    {KEY_FILTER, "filter", "NAME", "nearest, linear (default) or cubic"},
    {KEY_ANTIALIAS, "antialias", "N", "the mean of N x N samples a pixel, 1..16 (default 1)"},
    {KEY_SIZE, "size", "WxH", "pixels of the picture, in the same frame (default: the image's)"},
    {KEY_FRAME, "frame", "X0,Y0,X1,Y1", "where both lie (default: one unit a pixel of IMAGE)"},
    {KEY_INVERSE, "inverse", NULL, "move the image the other way"},
    {KEY_BACKGROUND, "background", "V,...", "what is outside: one number, or one a channel (0)"},
    {KEY_FRAMES, "frames", "LIST", "many pictures: lines GRID PICTURE, in file LIST"},
    {KEY_PAGE, "page", "N", "of a TIFF or OpenEXR with several images, from 1"},
    {KEY_MAX_PIXELS, "max-pixels", "N", "refuse a larger IMAGE (default 100000000)"},
    {KEY_TO, "to", "FORMAT", "png, tiff, exr or pnm (default: by the name of -o, else png)"},
    {KEY_PROGRESS, "progress", NULL, "show progress on stderr also if that is no terminal"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "warp-image",
    .synopsis = "[OPTION]... IMAGE [GRID]",
    .options = options,
    .epilogue =
        "examples:\n"
        "  mkgrid --image worm.png --cells 12 | decles-edit -e 'move v@31,29 by 4 -6 reach 9' | "
        "warp-image worm.png -o bent.png\n"
        "  mkgrid --image worm.png --cells 12 | warp-image --filter cubic --size 126x118 "
        "worm.png >large.png\n",
};

struct settings {
    int filter, to;
    int64_t antialias, size[2]; /* size[0] 0: the image's */
    bool has_frame, inverse, progress;
    double frame[4], background[IMAGE_CHANNELS_MAX];
    int background_count;
    const char *frames, *output;
    struct image_request image;
    enum image_format format; /* of the one picture */
};

/* One number, or several with commas. */
static bool parse_background(const struct cli *cli, struct settings *set, struct err *err) {
    set->background_count = 1;
    for (const char *at = cli->value; (at = strchr(at, ',')); at++) set->background_count++;
    if (set->background_count > IMAGE_CHANNELS_MAX)
        return cli_bad_value(cli, err, "at most %d numbers", IMAGE_CHANNELS_MAX);
    if (!cli_doubles(cli, set->background_count, set->background, err)) return false;
    for (int k = 0; k < set->background_count; k++)
        if (fabs(set->background[k]) > FLT_MAX)
            return cli_bad_value(cli, err, "numbers that are floats");
    return true;
}

static bool set_option(struct settings *set, const struct cli *cli, int key, struct err *err) {
    switch (key) {
    case KEY_FILTER:
        return cli_choice(cli, sampler_filter_names, &set->filter, err);
    case KEY_ANTIALIAS:
        return cli_int(cli, 1, 16, &set->antialias, err);
    case KEY_SIZE:
        return cli_cells(cli, IMAGE_SIDE_MAX, set->size, err);
    case KEY_FRAME:
        set->has_frame = true;
        return picture_frame(cli, set->frame, err);
    case KEY_INVERSE:
        return set->inverse = true;
    case KEY_BACKGROUND:
        return parse_background(cli, set, err);
    case KEY_FRAMES:
        set->frames = cli->value;
        return true;
    case KEY_PAGE:
        return cli_int(cli, 1, 65536, &set->image.page, err);
    case KEY_MAX_PIXELS:
        return cli_int(cli, 1, INT64_MAX, &set->image.max_pixels, err);
    case KEY_TO:
        return cli_choice(cli, image_format_names, &set->to, err);
    case KEY_PROGRESS:
        return set->progress = true;
    default: /* 'o' */
        set->output = cli->value;
        return true;
    }
}

/* What no single option can know. */
static bool check(const struct cli *cli, struct settings *set, struct err *err) {
    set->image.path = cli_operand(cli, 0);
    if (!set->frames) return image_output_format(set->to, set->output, &set->format, err);
    if (set->output || cli->operand_count > 1)
        return err_set(err, ERR_USAGE, "--frames goes without -o and GRID; try %s --help",
                       program.name);
    return cli_check_stdin(cli, 2, (const char *const[]){set->frames, set->image.path}, err);
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(set, cli, key, err)) return false;
    return key == CLI_END && cli_check_operands(cli, 1, set->frames ? 1 : 2, err) &&
           check(cli, set, err);
}

/* What a run holds. */
struct job {
    const struct cli *cli;
    const struct settings *set;
    struct image image;
    float background[IMAGE_CHANNELS_MAX];
    struct warp warp;
};

static bool prepare(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    const struct image *image = &job->image;
    const double *frame = set->has_frame ? set->frame : NULL;
    bool sized = set->size[0] > 0;
    if (set->background_count > 1 && set->background_count != image->channels)
        return err_set(err, ERR_USAGE,
                       "--background: expected one number or %d, as the image has channels, got %d",
                       image->channels, set->background_count);
    for (int k = 0; k < image->channels; k++)
        job->background[k] = (float)set->background[set->background_count > 1 ? k : 0];
    job->warp = (struct warp){.image = image,
                              .from = viewport_of_frame(image->width, image->height, frame),
                              .inverse = set->inverse,
                              .filter = (enum sampler_filter)set->filter,
                              .antialias = (int)set->antialias,
                              .outside = job->background};
    job->warp.to = job->warp.from;
    if (sized)
        job->warp.to =
            viewport_of_frame((uint32_t)set->size[0], (uint32_t)set->size[1],
                              frame ? frame : (const double[4]){0, 0, image->width, image->height});
    return (int64_t)job->warp.to.width * job->warp.to.height <= set->image.max_pixels ||
           err_set(err, ERR_USAGE, "--size: more pixels than --max-pixels allows");
}

/* The image through one grid. */
static bool make_picture(void *context, const char *path, const char *output,
                         enum image_format format, struct err *err) {
    struct job *job = context;
    struct warp *w = &job->warp;
    struct cli_progress progress;
    struct grid_file grid = {.history = NULL};
    struct image picture = {0};
    bool ok = grid_read(&grid, path, err) && image_fits(&job->image, format, err) &&
              image_allocate_like(&picture, &job->image, w->to.width, w->to.height, err);
    if (ok) {
        w->spline = &grid.spline;
        w->progress = cli_progress_begin(&progress, job->cli, job->set->progress);
        ok = warp(w, &picture, err);
        cli_progress_end(&progress);
    }
    ok = ok && image_write(&picture, format, output, err);
    image_free(&picture);
    grid_file_free(&grid);
    return ok;
}

static bool make_pictures(struct job *job, struct err *err) {
    const struct settings *set = job->set;
    if (!image_read(&job->image, &set->image, err) || !prepare(job, err)) return false;
    return set->frames ? frames_make(set->frames, set->to, make_picture, job, err)
                       : make_picture(job, cli_operand(job->cli, 1), set->output, set->format, err);
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.filter = SAMPLER_LINEAR,
                           .to = -1,
                           .antialias = 1,
                           .image = {.page = 1, .max_pixels = IMAGE_PIXELS_DEFAULT}};
    struct job job = {.cli = &cli, .set = &set};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)make_pictures(&job, &err);
    image_free(&job.image);
    return cli_finish(&cli, &err);
}
