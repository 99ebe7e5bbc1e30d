/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mapped_options.h"

#include "cage_io.h"
#include "model_options.h"

#include <float.h>

static const char *const outside_names[] = {"error", "keep", NULL};

bool mapped_option(struct mapped_options *o, const struct cli *cli, int key, struct err *err) {
    switch (key) {
    case MAPPED_INVERSE:
        return o->inverse = true;
    case MAPPED_COORDS:
        return o->coords = true;
    case MAPPED_FROM_COORDS:
        return o->from_coords = true;
    case MAPPED_MODEL:
        o->model = cli->value;
        return true;
    case MAPPED_PLANE:
        return o->has_plane = model_option_axes(cli, o->axes, err);
    case MAPPED_OUTSIDE:
        return cli_choice(cli, outside_names, &o->outside, err);
    case MAPPED_MESH:
        return cli_double(cli, DBL_MIN, DBL_MAX, &o->mesh, err);
    case MAPPED_POSES:
        o->poses = cli->value;
        return true;
    case MAPPED_OUT_DIR:
        o->out_dir = cli->value;
        return true;
    default:
        return match_option(&o->match, cli, key, err);
    }
}

static bool misuse(const struct cli *cli, struct err *err, const char *what) {
    return err_set(err, ERR_USAGE, "%s; try %s --help", what, cli->program->name);
}

/* SOURCE [TARGET] [POINTS]. There is no target where the source is drawn, and coordinates are
 * printed without one, unless the source is to be matched with it. */
static bool take_operands(struct mapped_options *o, const struct cli *cli, bool show,
                          struct err *err) {
    int cages = show || o->poses || (o->coords && !o->match.match) ? 1 : 2;
    bool has_points = !show && !o->model && o->mesh == 0;
    if (!cli_check_operands(cli, cages, cages + has_points, err)) return false;
    o->source = cli_operand(cli, 0);
    o->target = cages == 2 ? cli_operand(cli, 1) : NULL;
    o->points = has_points ? cli_operand(cli, cages) : o->model;
    return cli_check_stdin(cli, 4, (const char *const[]){o->source, o->target, o->points, o->poses},
                           err);
}

static bool check(const struct mapped_options *o, const struct cli *cli, bool show,
                  const char *output, struct err *err) {
    bool coordinates = o->coords || o->from_coords;
    if (o->inverse + o->coords + o->from_coords > 1)
        return misuse(cli, err, "--inverse, --coords and --from-coords exclude each other");
    if (show &&
        (o->inverse || coordinates || o->model || o->mesh > 0 || o->poses || o->match.match))
        return misuse(cli, err, "--lines and --show map nothing");
    if (o->model && coordinates) return misuse(cli, err, "--model is not for coordinates");
    if (o->has_plane && !o->model) return misuse(cli, err, "--plane needs --model");
    if (o->mesh > 0 && (o->model || coordinates || o->poses || o->outside))
        return misuse(cli, err,
                      "--mesh maps no points, so it excludes --model, --coords, --from-coords, "
                      "--outside and --poses");
    if (!o->poses != !o->out_dir) return misuse(cli, err, "--poses and --out-dir need each other");
    if (o->poses && (o->inverse || o->coords || o->match.match || output))
        return misuse(cli, err, "--poses excludes --inverse, --coords, --match and --output");
    return match_options_end(&o->match, cli, err);
}

bool mapped_options_end(struct mapped_options *o, const struct cli *cli, bool show,
                        const char *output, struct err *err) {
    o->use = o->coords || show ? ICC_NAME
             : o->from_coords  ? ICC_ASK
             : o->inverse      ? ICC_INVERSE
                               : ICC_FORWARD;
    return check(o, cli, show, output, err) && take_operands(o, cli, show, err);
}

void mapped_options_free(struct mapped_options *o) {
    match_options_free(&o->match);
}

bool mapped_options_read(const struct mapped_options *o, int digits, struct cage *source,
                         struct cage *target, struct mapped *mapped, struct err *err) {
    *mapped = (struct mapped){.use = o->use,
                              .model = o->model,
                              .axes = {o->axes[0], o->axes[1]},
                              .keep_outside = o->outside,
                              .digits = digits};
    return (o->target ? match_options_read(&o->match, source, o->source, target, o->target, err)
                      : cage_read(source, o->source, err)) &&
           (!o->points || mapped_open(mapped, o->points, source, o->poses, err));
}
