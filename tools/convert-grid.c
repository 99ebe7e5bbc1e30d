/* SPDX-License-Identifier: GPL-3.0-or-later */
/* convert-grid - writes a deformation in the formats of other programs. */
#include "cli.h"
#include "grid_io.h"
#include "history.h"
#include "json_io.h"
#include "msh_io.h"
#include "surface_io.h"
#include "vtu_io.h"

#include <stdlib.h>
#include <string.h>

enum { TO = 256, STEPS, FLAT, DIGITS };

static const struct cli_option options[] = {
    {TO, "to", "FORMAT", "msh, vtu, obj or json (default: what FILE of -o ends with)"},
    {STEPS, "steps", "N", "with obj: cuts of a triangle's edge, 1..1000 (default 8)"},
    {FLAT, "flat", NULL, "the plane map only, without depth"},
    {DIGITS, "digits", "N", "significant digits, 1..17 (default: shortest exact)"},
    {'o', "output", "FILE", "write to FILE instead of stdout"},
    {0, NULL, NULL, NULL},
};

static const struct cli_program program = {
    .name = "convert-grid",
    .synopsis = "--to FORMAT [OPTION]... [GRID]",
    .options = options,
    .epilogue =
        "formats:\n"
        "  msh   MSH 4.1 of Gmsh: triangles of the grid's degree\n"
        "  vtu   XML of VTK, for ParaView: Bezier triangles or wedges, exact\n"
        "  obj   Wavefront OBJ: small flat triangles\n"
        "  json  JSON: the grid as it is\n"
        "\n"
        "examples:\n"
        "  mkgrid --rect 0,0,8,6 --cells 8x6 --depth 0,1 | convert-grid --to vtu -o slab.vtu\n"
        "  decles-edit bend.edits worm.grid | convert-grid --to obj --steps 4 >bent.obj\n",
};

enum format { MSH, VTU, OBJ, JSON };
static const char *const format_names[] = {"msh", "vtu", "obj", "json", NULL};

struct settings {
    int format; /* -1: not given */
    bool flat;
    int64_t steps, digits; /* 0: not given */
    const char *output;
};

static bool parse_one(const struct cli *cli, int key, struct settings *set, struct err *err) {
    switch (key) {
    case TO:
        return cli_choice(cli, format_names, &set->format, err);
    case STEPS:
        return cli_int(cli, 1, TESSELLATE_STEPS_MAX, &set->steps, err);
    case FLAT:
        return set->flat = true;
    case DIGITS:
        return cli_int(cli, 1, 17, &set->digits, err);
    default:
        set->output = cli->value;
        return true;
    }
}

/* The format whose name ends the name of the output, or -1. */
static int format_of(const char *output) {
    const char *dot = output ? strrchr(output, '.') : NULL;
    for (int i = 0; dot && format_names[i]; i++)
        if (strcmp(dot + 1, format_names[i]) == 0) return i;
    return -1;
}

static bool parse(struct cli *cli, struct settings *set, struct err *err) {
    int key;
    while ((key = cli_next(cli, err)) != CLI_END)
        if (key == CLI_STOP || !parse_one(cli, key, set, err)) return false;
    if (!cli_check_operands(cli, 0, 1, err)) return false;
    if (set->format < 0) set->format = format_of(set->output);
    if (set->format < 0)
        return err_set(err, ERR_USAGE,
                       "expected --to msh, vtu, obj or json; try convert-grid --help");
    if (set->steps && set->format != OBJ)
        return err_set(err, ERR_USAGE, "--steps goes with --to obj only; try convert-grid --help");
    if (!set->steps) set->steps = 8;
    return true;
}

/* Forgets the depth. */
static void flatten(struct spline *s) {
    free(s->sigma);
    s->sigma = NULL;
    s->grid.has_depth = false;
}

/* What is to be printed: of msh and obj, samples. */
static bool sample(const struct settings *set, const struct spline *s, struct tessellation *t,
                   struct err *err) {
    int degree = s->grid.degree;
    if (set->format == OBJ) return tessellate(t, s, (int)set->steps, err);
    if (set->format != MSH) return true;
    if (degree > MSH_DEGREE_MAX)
        return err_set(err, ERR_REFUSAL,
                       "the degree is %d, and the triangles of msh end with %d; vtu, obj and json "
                       "take every degree",
                       degree, MSH_DEGREE_MAX);
    return tessellate(t, s, degree, err);
}

static void write_format(struct out *out, const struct settings *set, const struct spline *s,
                         const struct tessellation *t, const char *history) {
    int digits = (int)set->digits;
    switch ((enum format)set->format) {
    case MSH:
        msh_write(out, t, history, digits);
        break;
    case VTU:
        vtu_write(out, s, history, digits);
        break;
    case OBJ:
        surface_write(out, t, history, digits);
        break;
    case JSON:
        json_write(out, s, history, digits);
        break;
    }
}

static bool print(const struct cli *cli, const struct settings *set, const struct grid_file *file,
                  const struct tessellation *t, struct err *err) {
    char *line = cli_history(cli, err);
    char *history = line ? history_add(file->history, line, err) : NULL;
    struct out out;
    bool ok = history && out_open(&out, set->output, err);
    if (ok) {
        write_format(&out, set, &file->spline, t, history);
        ok = out_close(&out, err);
    }
    free(history);
    free(line);
    return ok;
}

static bool run(const struct cli *cli, const struct settings *set, struct err *err) {
    struct grid_file file;
    struct tessellation t = {0};
    bool ok;
    if (!grid_read(&file, cli_operand(cli, 0), err)) return false;
    if (set->flat) flatten(&file.spline);
    ok = sample(set, &file.spline, &t, err) && print(cli, set, &file, &t, err);
    tessellation_free(&t);
    grid_file_free(&file);
    return ok;
}

int main(int argc, char **argv) {
    struct err err = {0};
    struct cli cli;
    struct settings set = {.format = -1};
    cli_init(&cli, &program, argc, argv);
    if (parse(&cli, &set, &err)) (void)run(&cli, &set, &err);
    return cli_finish(&cli, &err);
}
