/* SPDX-License-Identifier: GPL-3.0-or-later */
/* refine-grid - the same deformation on a finer grid, or of a higher degree. */
#include "mem.h"
#include "num.h"
#include "refine.h"
#include "result_options.h"

#include <string.h>

enum { KEY_TIMES = 256, KEY_TRIANGLES, KEY_BOX, KEY_DEGREE };

static const struct cli_option options[] = {
    {KEY_TIMES, "times", "N", "split N times (default 1, up to 24)"},
    {KEY_TRIANGLES, "triangles", "LIST", "only these triangles, as in 3,5-9"},
    {KEY_BOX, "box", "X0,Y0,X1,Y1", "only what meets this box of the domain"},
    {KEY_DEGREE, "degree", "D", "raise the degree instead"},
    RESULT_OPTIONS,
    {0},
};

static const struct cli_program program = {
    .name = "refine-grid",
    .synopsis = "[--times N] [--triangles LIST | --box X0,Y0,X1,Y1] [--degree D] [-o FILE] [GRID]",
    .options = options,
    .epilogue =
        "The map stays the same; later edits can be finer.\n"
        "examples:\n"
        "  mkgrid --rect 0,0,8,4 --cells 4x2 | refine-grid --box 0,0,2,2 >fine.grid\n"
        "  mkgrid --rect 0,0,8,4 --cells 2x1 | refine-grid | decles-edit -e 'move v:4 by 1 0'\n",
};

struct settings {
    struct refine_request request;
    double box[4];
    const char *triangles;
    int degree;
    struct result_options result;
};

static bool set_option(struct cli *cli, int key, struct settings *set, struct err *err) {
    int64_t n = 0;
    bool ok = true;
    switch (key) {
    case KEY_TIMES:
        ok = cli_int(cli, 1, REFINE_TIMES_MAX, &n, err);
        set->request.times = (int)n;
        break;
    case KEY_TRIANGLES:
        set->triangles = cli->value;
        break;
    case KEY_BOX:
        ok = cli_doubles(cli, 4, set->box, err);
        set->request.box = set->box;
        if (ok && (set->box[0] > set->box[2] || set->box[1] > set->box[3]))
            ok = cli_bad_value(cli, err, "X0 <= X1 and Y0 <= Y1");
        break;
    case KEY_DEGREE:
        ok = cli_int(cli, 1, GRID_DEGREE_MAX, &n, err);
        set->degree = (int)n;
        break;
    default:
        ok = result_option(&set->result, cli, key, err);
    }
    return ok;
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) >= 0)
        if (!set_option(cli, key, set, err)) return false;
    if (key == CLI_STOP || !cli_check_operands(cli, 0, 1, err)) return false;
    if (set->triangles && set->request.box)
        return err_set(err, ERR_USAGE, "--triangles and --box exclude each other");
    if (set->degree && (set->request.times || set->triangles || set->request.box))
        return err_set(err, ERR_USAGE,
                       "--degree goes alone: raise the degree in a second refine-grid");
    if (!set->request.times) set->request.times = 1;
    return true;
}

/* Marks the triangles of a list like 3,5-9. */
static bool mark_triangles(const char *list, const struct grid *g, bool *mark, struct err *err) {
    const char *s = list, *end = list + strlen(list);
    for (;;) {
        int64_t first, last;
        if (num_read_int(s, end, &first, &s) != NUM_OK || first < 0) break;
        last = first;
        if (*s == '-' && (num_read_int(s + 1, end, &last, &s) != NUM_OK || last < first)) break;
        if (last >= g->triangle_count)
            return err_set(err, ERR_INPUT, "--triangles: expected numbers below %u, got %lld",
                           g->triangle_count, (long long)last);
        for (int64_t t = first; t <= last; t++) mark[t] = true;
        if (s == end) return true;
        if (*s++ != ',') break;
    }
    return err_set(err, ERR_USAGE, "--triangles: expected numbers as in 3,5-9, got '%s'", list);
}

static bool refine(struct settings *set, const struct spline *s, struct spline *result,
                   struct err *err) {
    bool *mark = NULL, ok;
    if (set->degree && set->degree < s->grid.degree)
        return err_set(err, ERR_REFUSAL, "expected a degree of %d or more, got %d", s->grid.degree,
                       set->degree);
    if (set->degree) return resample_degree(s, set->degree, result, err);
    if (set->triangles && !mem_new(mark, s->grid.triangle_count, err)) return false;
    set->request.triangle = mark;
    ok = (!mark || mark_triangles(set->triangles, &s->grid, mark, err)) &&
         refine_spline(s, &set->request, result, err);
    free(mark);
    return ok;
}

static bool run(const struct cli *cli, struct settings *set, struct err *err) {
    struct grid_file file = {0}, fine = {0};
    bool ok =
        grid_read(&file, cli_operand(cli, 0), err) && refine(set, &file.spline, &fine.spline, err);
    if (ok) {
        fine.history = file.history;
        file.history = NULL;
        ok = result_write(&set->result, cli, &fine, err);
    }
    grid_file_free(&file);
    grid_file_free(&fine);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {0};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
