/* SPDX-License-Identifier: GPL-3.0-or-later */
/* draw-grid - draws a deformation and what is known of it. */
#include "cli.h"
#include "drawing_io.h"
#include "edits_io.h"
#include "figure.h"
#include "figure_image.h"
#include "figure_model.h"
#include "figure_options.h"
#include "grid_io.h"
#include "mem.h"
#include "num.h"
#include "obj_io.h"
#include "picture_options.h"
#include "polylines_io.h"

#include <stdio.h>
#include <string.h>

enum {
    KEY_EDIT = 256,
    KEY_MODEL,
    KEY_LINES,
    KEY_IMAGE,
    KEY_FRAME,
    KEY_MAX_PIXELS,
    KEY_TO,
    KEY_NO_GRID
};

static const struct cli_option options[] = {
    {KEY_EDIT, "edit", "EDITS:LINE", "carry out EDITS up to this line and show what that does"},
    {KEY_MODEL, "model", "FILE", "with the silhouette of this OBJ model"},
    {KEY_LINES, "lines", "FILE", "with these polylines: x y LABEL, a blank line ends one"},
    {KEY_IMAGE, "image", "FILE", "over this image"},
    {KEY_FRAME, "frame", "X0,Y0,X1,Y1", "where the image lies (default: one unit a pixel, y down)"},
    {KEY_MAX_PIXELS, "max-pixels", "N", "refuse a larger image (default 100000000)"},
    {KEY_NO_GRID, "no-grid", NULL, "draw the lines or the image alone"},
    FIGURE_OPTIONS,
    {KEY_TO, "to", "FORMAT", "png, svg or pdf (default: by the name of -o, else png)"},
    {'o', "output", "FILE", "write there (stdout)"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "draw-grid",
    .synopsis = "[OPTION]... [GRID]",
    .options = options,
    .epilogue =
        "examples:\n"
        "  mkgrid --rect 0,0,8,4 --cells 8x4 | decles-edit -e 'move ^4,2 by 1 0.5 reach 6' | "
        "draw-grid -o bent.png\n"
        "  mkgrid --rect 0,0,8,4 --cells 8x4 | draw-grid --layers outline,net,types -o net.svg\n",
};

struct settings {
    struct figure_options figure;
    int to, digits;
    const char *edit, *model, *lines, *image, *output, *grid;
    double frame[4];
    int64_t max_pixels;
    bool has_frame, no_grid, styled;
    char *edits; /* the file of --edit */
    size_t line;
    enum drawing_format format;
};

/* EDITS:LINE */
static bool parse_edit(const struct cli *cli, struct settings *set, struct err *err) {
    const char *colon = strrchr(cli->value, ':'), *end;
    int64_t line = 0;
    if (!colon || num_read_int(colon + 1, colon + strlen(colon), &line, &end) != NUM_OK || *end ||
        line < 1)
        return cli_bad_value(cli, err, "EDITS:LINE");
    set->edit = cli->value;
    set->line = (size_t)line;
    free(set->edits);
    set->edits = strndup(cli->value, (size_t)(colon - cli->value));
    return set->edits || err_memory(err);
}

static bool set_option(struct settings *set, const struct cli *cli, int key, struct err *err) {
    set->styled |= figure_option_of_lines(key);
    if (figure_option_is(key)) return figure_option(&set->figure, cli, key, err);
    switch (key) {
    case KEY_EDIT:
        return parse_edit(cli, set, err);
    case KEY_MODEL:
        set->model = cli->value;
        return true;
    case KEY_LINES:
        set->lines = cli->value;
        return true;
    case KEY_IMAGE:
        set->image = cli->value;
        return true;
    case KEY_FRAME:
        set->has_frame = true;
        return picture_frame(cli, set->frame, err);
    case KEY_MAX_PIXELS:
        return cli_int(cli, 1, INT64_MAX, &set->max_pixels, err);
    case KEY_NO_GRID:
        set->no_grid = true;
        return true;
    case KEY_TO:
        return cli_choice(cli, drawing_format_names, &set->to, err);
    default: /* 'o' */
        set->output = cli->value;
        return true;
    }
}

/* Without a choice of layers: what suits the figure. */
static unsigned usual_layers(const struct settings *set) {
    unsigned layers = 1u << FIGURE_TRIANGLES | 1u << FIGURE_OUTLINE;
    return set->edit ? layers | 1u << FIGURE_SETS | 1u << FIGURE_QUADS : layers;
}

static bool check(const struct cli *cli, struct settings *set, struct err *err) {
    const char *files[] = {NULL, set->edits, set->model, set->lines, set->image};
    if (set->figure.layers == 0) set->figure.layers = usual_layers(set);
    if ((set->figure.layers >> FIGURE_SETS & 1) && !set->edit)
        return err_set(err, ERR_USAGE,
                       "the layer sets needs --edit EDITS:LINE; try draw-grid --help");
    if (set->no_grid && !set->lines && !set->image)
        return err_set(err, ERR_USAGE, "--no-grid needs --lines or --image; try draw-grid --help");
    if (set->styled && !set->lines)
        return err_set(err, ERR_USAGE,
                       "--line-width, --dots, --squares, --dot-labels and --colors need --lines; "
                       "try draw-grid --help");
    if (set->has_frame && !set->image)
        return err_set(err, ERR_USAGE, "--frame needs --image FILE; try draw-grid --help");
    if (set->image && !set->has_frame) set->figure.y_down = true;
    if (set->no_grid && (set->edit || set->model || cli->operand_count > 0))
        return err_set(err, ERR_USAGE,
                       "--no-grid goes without --edit, --model and GRID; try draw-grid --help");
    set->grid = cli_operand(cli, 0);
    if (!set->no_grid) files[0] = set->grid;
    return cli_check_stdin(cli, 5, files, err) &&
           drawing_format(set->to, set->output, &set->format, err);
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(set, cli, key, err)) return false;
    return key == CLI_END && cli_check_operands(cli, 0, 1, err) && check(cli, set, err);
}

/* What a run holds. */
struct job {
    struct grid_file grid;
    struct model model, deformed;
    struct edit_trace trace;
    struct polylines lines;
    struct figure_image image;
    struct drawing drawing;
};

static bool carry_out(struct job *job, const struct settings *set, struct err *err) {
    const struct decles_options decles = {.continuity = 1, .max_gain = 100};
    struct script script;
    bool ok;
    if (!edits_read(&script, set->edits, err)) return false;
    ok = edit_trace(&job->trace, &script, set->line, &job->grid.spline, &decles, err);
    script_free(&script);
    return ok;
}

static bool read_image(struct job *job, const struct settings *set, struct err *err) {
    const struct image_request request = {
        .path = set->image, .page = 1, .max_pixels = set->max_pixels};
    struct image image;
    bool ok;
    if (!image_read(&image, &request, err)) return false;
    ok = figure_image(&job->image, &image, set->has_frame ? set->frame : NULL, err);
    image_free(&image);
    return ok;
}

static bool gather(struct job *job, const struct settings *set, struct figure_content *content,
                   struct err *err) {
    if (set->lines && !polylines_read(&job->lines, set->lines, err)) return false;
    if (set->lines) content->lines = &job->lines;
    if (set->image && !read_image(job, set, err)) return false;
    if (set->image) content->image = &job->image;
    if (set->no_grid) return true;
    if (!grid_read(&job->grid, set->grid, err)) return false;
    content->spline = &job->grid.spline;
    if (set->edit && !carry_out(job, set, err)) return false;
    if (set->edit) content->edit = &job->trace;
    if (!set->model) return true;
    if (!model_read(&job->model, set->model, err) ||
        !figure_model(&job->model, &job->deformed, &job->grid.spline, err))
        return false;
    content->model[0] = &job->model;
    content->model[1] = &job->deformed;
    return true;
}

static bool draw(struct job *job, const struct settings *set, struct err *err) {
    struct figure_content content = {0};
    struct out out;
    if (!gather(job, set, &content, err) ||
        !figure_draw(&job->drawing, &content, &set->figure, err) ||
        !out_open(&out, set->output, err))
        return false;
    if (drawing_write(&out, &job->drawing, set->format, err)) return out_close(&out, err);
    out_discard(&out);
    return false;
}

static void run(const struct settings *set, struct err *err) {
    struct job job = {0};
    (void)draw(&job, set, err);
    drawing_free(&job.drawing);
    polylines_free(&job.lines);
    free(job.image.pixel);
    edit_trace_free(&job.trace);
    free(job.deformed.vertex);
    model_free(&job.model);
    grid_file_free(&job.grid);
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.to = DRAWING_BY_NAME, .max_pixels = IMAGE_PIXELS_DEFAULT};
    figure_options_init(&set.figure);
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) run(&set, &err);
    free(set.edits);
    return cli_finish(&cli, &err);
}
