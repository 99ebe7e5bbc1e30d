/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture_options.h"

#include "colour_io.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { SIDE_MAX = 32767, USUAL_SIDE = 800 };

void picture_options_init(struct picture_options *o) {
    *o = (struct picture_options){
        .antialias = 4, .background = 0xffffffff, .max_pixels = IMAGE_PIXELS_DEFAULT, .to = -1};
}

bool picture_colour(const struct cli *cli, uint32_t *colour, struct err *err) {
    return colour_read(cli->value, strlen(cli->value), colour) ||
           cli_bad_value(cli, err, "%s", COLOUR_SYNTAX);
}

bool picture_frame(const struct cli *cli, double frame[4], struct err *err) {
    if (!cli_doubles(cli, 4, frame, err)) return false;
    for (int k = 0; k < 2; k++)
        if (frame[k] == frame[k + 2] || !isfinite(frame[k + 2] - frame[k]))
            return cli_bad_value(cli, err, "X0 != X1 and Y0 != Y1, not too far from each other");
    return true;
}

static bool read_size(struct picture_options *o, const struct cli *cli, struct err *err) {
    int64_t n[2];
    if (!cli_cells(cli, SIDE_MAX, n, err)) return false;
    o->has_size = true;
    o->size[0] = (uint32_t)n[0];
    o->size[1] = (uint32_t)n[1];
    return true;
}

bool picture_option(struct picture_options *o, const struct cli *cli, int key, struct err *err) {
    switch (key) {
    case PICTURE_SIZE:
        return read_size(o, cli, err);
    case PICTURE_SCALE:
        o->has_scale = true;
        return cli_double(cli, 1e-300, 1e300, &o->scale, err);
    case PICTURE_Y_DOWN:
        return o->y_down = true;
    case PICTURE_ANTIALIAS:
        return cli_int(cli, 1, 16, &o->antialias, err);
    case PICTURE_BACKGROUND:
        return picture_colour(cli, &o->background, err);
    case PICTURE_MAX_PIXELS:
        return cli_int(cli, 1, INT64_MAX, &o->max_pixels, err);
    case PICTURE_PROGRESS:
        return o->progress = true;
    case PICTURE_FRAMES:
        o->frames = cli->value;
        return true;
    case PICTURE_TO:
        return cli_choice(cli, image_format_names, &o->to, err);
    default: /* 'o' */
        o->output = cli->value;
        return true;
    }
}

bool picture_options_end(struct picture_options *o, const struct cli *cli, int operands,
                         struct err *err) {
    if (o->has_size && o->has_scale)
        return err_set(err, ERR_USAGE, "--size and --scale exclude each other; try %s --help",
                       cli->program->name);
    if (!cli_check_operands(cli, 0, operands, err)) return false;
    if (operands > 0) o->input = cli_operand(cli, 0);
    if (!o->frames) return image_output_format(o->to, o->output, &o->format, err);
    return (!o->output && cli->operand_count == 0) ||
           err_set(err, ERR_USAGE, "--frames goes without -o and an operand; try %s --help",
                   cli->program->name);
}

bool picture_make(const struct picture_options *o, frames_maker *make, void *context,
                  struct err *err) {
    return o->frames ? frames_make(o->frames, o->to, make, context, err)
                     : make(context, o->input, o->output, o->format, err);
}

/* The usual size: the longer side of the box has USUAL_SIDE pixels. */
static void usual_size(const double lo[2], const double hi[2], uint32_t size[2]) {
    double w = hi[0] - lo[0], h = hi[1] - lo[1], most = fmax(w, h);
    size[0] = most > 0 ? (uint32_t)fmax(1, floor(USUAL_SIDE * (w / most) + 0.5)) : 1;
    size[1] = most > 0 ? (uint32_t)fmax(1, floor(USUAL_SIDE * (h / most) + 0.5)) : 1;
}

/* The size of a picture of this box. */
static bool set_view(const struct picture_options *o, const double lo[2], const double hi[2],
                     struct viewport *view, struct err *err) {
    uint32_t size[2] = {o->size[0], o->size[1]};
    if (!isfinite(hi[0] - lo[0]) || !isfinite(hi[1] - lo[1]))
        return err_set(err, ERR_REFUSAL, "what is to be seen extends beyond the range of numbers");
    if (o->has_scale && !viewport_scale(view, lo, hi, o->scale, SIDE_MAX, o->y_down))
        return err_set(err, ERR_REFUSAL,
                       "with --scale %g the picture has more than %d pixels a side", o->scale,
                       SIDE_MAX);
    if (!o->has_size) usual_size(lo, hi, size);
    if (!o->has_scale) *view = viewport_fit(lo, hi, size, o->y_down);
    return (int64_t)view->width * view->height <= o->max_pixels ||
           err_set(err, o->has_size ? ERR_USAGE : ERR_REFUSAL,
                   "%" PRIu32 "x%" PRIu32 " pixels are more than %" PRId64 "; see --max-pixels",
                   view->width, view->height, o->max_pixels);
}

bool picture_begin(const struct picture_options *o, enum image_format format, const double lo[2],
                   const double hi[2], struct viewport *view, struct image *image,
                   struct err *err) {
    bool opaque = (o->background & 255) == 255;
    *image = (struct image){0};
    if (!set_view(o, lo, hi, view, err)) return false;
    image->width = view->width;
    image->height = view->height;
    image->channels = opaque ? 3 : 4;
    image->alpha = opaque ? -1 : 3;
    image->straight = !opaque && format != IMAGE_OPENEXR;
    image->sample = format == IMAGE_OPENEXR ? IMAGE_HALF : IMAGE_U8;
    return image_fits(image, format, err) && image_allocate(image, err);
}
