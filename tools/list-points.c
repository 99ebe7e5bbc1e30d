/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list-points - tells numbers, places, types and positions of control points. */
#include "c1.h"
#include "cli.h"
#include "grid_io.h"
#include "out.h"
#include "points_io.h"

#include <stdlib.h>

enum { KEY_TYPE = 256, KEY_DIGITS };

static const struct cli_option options[] = {
    {KEY_TYPE, "type", "TYPE", "only points of this type, such as corner"},
    {KEY_DIGITS, "digits", "N", "write N significant digits, not all"},
    {'o', "output", "FILE", "write there (stdout)"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "list-points",
    .synopsis = "[OPTION]... [POINTS]... [GRID]",
    .options = options,
    .epilogue = "examples:\n"
                "  mkgrid --rect 0,0,8,4 --cells 8x4 | list-points --type corner\n"
                "  mkgrid --rect 0,0,8,4 --cells 8x4 | list-points @4,2 v:3 | cut -d ' ' -f 1,2\n",
};

struct settings {
    int type; /* -1: all */
    int digits, words;
    const char *output, *grid;
    char **word; /* POINTS */
};

/* The operands are POINTS; one at the end that has not their form is the grid. */
static bool split_operands(const struct cli *cli, struct settings *set, struct err *err) {
    int n = cli->operand_count;
    bool grid = n > 0 && !points_is_word(cli->operands[n - 1]);
    set->grid = grid ? cli->operands[n - 1] : "-";
    set->word = cli->operands;
    set->words = n - grid;
    for (int i = 0; i < set->words; i++)
        if (!points_is_word(set->word[i]))
            return err_set(err, ERR_USAGE, "expected POINTS before the last operand, got '%s'",
                           set->word[i]);
    return true;
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    int64_t n = 0;
    while ((key = cli_next(cli, err)) >= 0) {
        if (key == 'o') set->output = cli->value;
        if (key == KEY_TYPE && !cli_choice(cli, c1_type_names, &set->type, err)) return false;
        if (key == KEY_DIGITS && !cli_int(cli, 1, 17, &n, err)) return false;
        if (key == KEY_DIGITS) set->digits = (int)n;
    }
    return key == CLI_END && split_operands(cli, set, err);
}

/* All words of POINTS, before a grid is read. */
static bool parse_words(const struct settings *set, struct script *script, struct err *err) {
    struct selector all = {.kind = SELECT_ALL};
    if (set->words == 0) return script_add_selector(script, &all, err);
    for (int i = 0; i < set->words; i++)
        if (!points_parse_word(script, set->word[i], err)) return false;
    return true;
}

static bool select_all_words(const struct settings *set, const struct script *script,
                             const struct spline *s, struct point_set *points, struct err *err) {
    struct select_space space;
    bool ok = true;
    select_init(&space, &s->grid, (const double(*)[2])s->phi);
    for (size_t i = 0; ok && i < script->selector_count; i++)
        if (!(ok = select_points(&space, &script->selector[i], points, err)) && set->words) {
            struct err inner = *err;
            err_set(err, inner.kind, "%s: %s", set->word[i], inner.message);
        }
    point_set_sort(points);
    select_free(&space);
    return ok;
}

static void put_pair(struct out *out, const double xy[2], int digits) {
    for (int c = 0; c < 2; c++) {
        out_char(out, ' ');
        out_double(out, xy[c], digits);
    }
}

static void put_point(struct out *out, const struct spline *s, uint32_t p, int digits) {
    const char *type = c1_type_names[c1_type(&s->grid, p)];
    struct grid_place place = grid_place(&s->grid, p);
    double nominal[2];
    out_format(out, "%u %u:%d,%d,%d %s", p, place.triangle, place.weight[0], place.weight[1],
               place.weight[2], type);
    grid_nominal(&s->grid, p, nominal);
    put_pair(out, nominal, digits);
    put_pair(out, s->phi[p], digits);
    if (s->sigma) put_pair(out, s->sigma[p], digits);
    out_char(out, '\n');
}

static bool list(const struct settings *set, const struct spline *s, const struct point_set *points,
                 struct err *err) {
    struct out out;
    if (!out_open(&out, set->output, err)) return false;
    for (size_t i = 0; i < points->count; i++)
        if (set->type < 0 || (int)c1_type(&s->grid, points->point[i]) == set->type)
            put_point(&out, s, points->point[i], set->digits);
    return out_close(&out, err);
}

static void run(const struct settings *set, struct err *err) {
    struct script script;
    struct grid_file file;
    struct point_set points = {0};
    if (!script_init(&script, "", err)) return;
    if (parse_words(set, &script, err) && grid_read(&file, set->grid, err)) {
        if (select_all_words(set, &script, &file.spline, &points, err))
            (void)list(set, &file.spline, &points, err);
        grid_file_free(&file);
    }
    free(points.point);
    script_free(&script);
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.type = -1};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) run(&set, &err);
    return cli_finish(&cli, &err);
}
