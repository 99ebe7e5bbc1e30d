/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_options.h"

#include <string.h>

#define CELL_MIN       1e-110
#define CELL_MAX       1e110
#define RESOLUTION_MAX 1000
#define LINES_MAX      1000000

static const struct cli_option options[] = {ICC_OPTIONS};
static const char *const function_names[] = {"cousin", "manhattan", "harmonic", "biharmonic", NULL};
static const char *const axes_names[] = {"xy", "yx", NULL};
static const char *const outside_names[] = {"inward", "literal", NULL};
static const char *const check_names[] = {"refuse", "warn", NULL};

static bool given(const struct icc_options *o, int key) {
    return o->given[key - ICC_KEY];
}

/* X,Y of the source; with U,V of the target, too. */
static bool parse_maximum(struct icc_rule *rule, const struct cli *cli, struct err *err) {
    double at[4];
    int commas = 0, n;
    for (const char *s = cli->value; *s; s++) commas += *s == ',';
    n = commas == 3 ? 4 : 2;
    if (!cli_doubles(cli, n, at, err)) return false;
    for (int k = 0; k < n / 2; k++) {
        rule->grid[k].has_maximum = true;
        memcpy(rule->grid[k].maximum, at + 2 * k, sizeof rule->grid[k].maximum);
    }
    return true;
}

/* What holds for both cages goes to the source. */
static bool grid_option(struct icc_grid_rule *rule, const struct cli *cli, int key,
                        struct err *err) {
    int64_t n = 0;
    int choice = 0;
    bool ok;
    switch (key) {
    case ICC_RESOLUTION:
        ok = cli_int(cli, 1, RESOLUTION_MAX, &n, err);
        rule->resolution = (double)n;
        return ok;
    case ICC_FUNCTION:
        ok = cli_choice(cli, function_names, &choice, err);
        rule->function.kind = (enum icc_kind)choice;
        return ok;
    case ICC_AXES:
        ok = cli_choice(cli, axes_names, &choice, err);
        rule->function.axes = (enum icc_axes)choice;
        return ok;
    case ICC_OUTSIDE_VALUES:
        ok = cli_choice(cli, outside_names, &choice, err);
        rule->function.outside = (enum icc_outside)choice;
        return ok;
    default: /* ICC_RESOLUTION_CHECK */
        ok = cli_choice(cli, check_names, &choice, err);
        rule->warn = choice == 1;
        return ok;
    }
}

bool icc_option(struct icc_options *o, const struct cli *cli, int key, struct err *err) {
    struct icc_rule *rule = &o->rule;
    int method;
    int64_t points;
    o->given[key - ICC_KEY] = true;
    switch (key) {
    case ICC_METHOD:
        if (!cli_choice(cli, icc_method_names, &method, err)) return false;
        rule->method = (enum icc_method)method;
        return true;
    case ICC_POINTS:
        if (!cli_int(cli, 0, ICC_POINTS_MAX, &points, err)) return false;
        rule->points = (size_t)points;
        rule->has_points = true;
        return true;
    case ICC_CELL:
        return cli_double(cli, CELL_MIN, CELL_MAX, &rule->cell, err);
    case ICC_LINES:
        return cli_int(cli, 1, LINES_MAX, &o->lines, err);
    case ICC_SHOW:
        return cli_choice(cli, icc_show_names, &o->show, err);
    case ICC_MAXIMUM:
        return parse_maximum(rule, cli, err);
    default:
        return grid_option(&rule->grid[0], cli, key, err);
    }
}

static bool misuse(const struct cli *cli, struct err *err, const char *what) {
    return err_set(err, ERR_USAGE, "%s; try %s --help", what, cli->program->name);
}

static bool check_method(const struct icc_options *o, const struct cli *cli, struct err *err) {
    const struct icc_rule *rule = &o->rule;
    bool grid = rule->method == ICC_GRID;
    for (int key = ICC_RESOLUTION; key < ICC_KEY_END; key++)
        if (given(o, key) && !grid)
            return err_set(err, ERR_USAGE, "--%s goes with --method grid; try %s --help",
                           options[key - ICC_KEY].name, cli->program->name);
    if (grid && rule->has_points && rule->points == 0)
        return misuse(cli, err, "--method grid takes points inside, not 0");
    if (rule->grid[0].function.outside == ICC_LITERAL &&
        rule->grid[0].function.kind >= ICC_HARMONIC)
        return misuse(cli, err,
                      "--outside-values literal goes with the functions cousin and manhattan");
    if (given(o, ICC_SHOW) && !icc_show_has((enum icc_show)o->show, grid))
        return err_set(err, ERR_USAGE, "--show %s goes with --method %s; try %s --help",
                       icc_show_names[o->show], icc_method_names[grid ? ICC_RAY : ICC_GRID],
                       cli->program->name);
    return true;
}

bool icc_options_end(struct icc_options *o, const struct cli *cli, struct err *err) {
    struct icc_grid_rule *source = &o->rule.grid[0], *target = &o->rule.grid[1];
    if (o->rule.has_points && o->rule.cell > 0)
        return misuse(cli, err, "--points and --cell exclude each other");
    if (given(o, ICC_LINES) && given(o, ICC_SHOW))
        return misuse(cli, err, "--lines and --show exclude each other");
    target->resolution = source->resolution;
    target->function = source->function;
    target->warn = source->warn;
    return check_method(o, cli, err);
}

bool icc_options_show(const struct icc_options *o) {
    return given(o, ICC_LINES) || given(o, ICC_SHOW);
}
