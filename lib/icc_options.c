/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_options.h"

#define CELL_MIN 1e-110
#define CELL_MAX 1e110

bool icc_option(struct icc_rule *rule, const struct cli *cli, int key, struct err *err) {
    int method;
    int64_t points;
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
    default: /* ICC_CELL */
        return cli_double(cli, CELL_MIN, CELL_MAX, &rule->cell, err);
    }
}

bool icc_options_end(const struct icc_rule *rule, const struct cli *cli, struct err *err) {
    return !rule->has_points || rule->cell == 0 ||
           err_set(err, ERR_USAGE, "--points and --cell exclude each other; try %s --help",
                   cli->program->name);
}
