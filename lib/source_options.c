/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "source_options.h"

#include "model_options.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const struct cli_option options[] = {SOURCE_OPTIONS};

/* Options that go with some sources only. */
#define WITH(source) (1u << ((source)-SOURCE_KEY))
#define REGULAR      (WITH(OPTION_RECT) | WITH(OPTION_MODEL) | WITH(OPTION_AROUND) | WITH(OPTION_IMAGE))
static const struct {
    int key;
    unsigned sources;
} limited[] = {
    {OPTION_FRAME, WITH(OPTION_IMAGE)},
    {OPTION_MARGIN, WITH(OPTION_MODEL) | WITH(OPTION_AROUND)},
    {OPTION_CELL, WITH(OPTION_MODEL) | WITH(OPTION_AROUND)},
    {OPTION_CELLS, REGULAR},
    {OPTION_PATTERN, REGULAR},
    {OPTION_MAX_AREA, WITH(OPTION_POLYGON)},
    {OPTION_MIN_ANGLE, WITH(OPTION_POLYGON)},
    {OPTION_MAX_TRIANGLES, WITH(OPTION_POLYGON)},
};

/* Options that exclude each other. */
static const int exclusive[][2] = {{OPTION_DEPTH, OPTION_FLAT}, {OPTION_CELLS, OPTION_CELL}};

void source_options_init(struct source_options *o) {
    *o = (struct source_options){
        .axes = {0, 1, 2}, .degree = 5, .cells = {16}, .bits = 16, .triangles = 1000000};
    o->source.surround = (struct surround){.margin = -1};
    o->source.domain = (struct domain){.max_area = INFINITY, .min_angle = 20};
}

static bool given(const struct source_options *o, int key) {
    return o->given[key - SOURCE_KEY];
}

static const char *name(int key) {
    return options[key - SOURCE_KEY].name;
}

static bool parse_rect(const struct cli *cli, struct rectangle *rectangle, struct err *err) {
    double r[4];
    if (!cli_doubles(cli, 4, r, err)) return false;
    memcpy(rectangle->low, r, sizeof rectangle->low);
    memcpy(rectangle->high, r + 2, sizeof rectangle->high);
    return (r[0] < r[2] && r[1] < r[3]) || cli_bad_value(cli, err, "X0 < X1 and Y0 < Y1");
}

/* Corners of an image, the first pixel's and the last one's: either axis may run backwards. */
static bool parse_corners(const struct cli *cli, struct rectangle *rectangle, struct err *err) {
    double r[4];
    if (!cli_doubles(cli, 4, r, err)) return false;
    for (int c = 0; c < 2; c++) {
        if (r[c] == r[c + 2]) return cli_bad_value(cli, err, "X0 != X1 and Y0 != Y1");
        rectangle->low[c] = fmin(r[c], r[c + 2]);
        rectangle->high[c] = fmax(r[c], r[c + 2]);
    }
    return true;
}

static bool parse_depth(const struct cli *cli, double depth[2], struct err *err) {
    if (!cli_doubles(cli, 2, depth, err)) return false;
    return depth[0] < depth[1] || cli_bad_value(cli, err, "A < B");
}

static bool parse_cells(const struct cli *cli, int64_t cells[2], struct err *err) {
    cells[1] = 0;
    if (strchr(cli->value, 'x')) return cli_cells(cli, PATTERN_CELLS_MAX, cells, err);
    return cli_int(cli, 1, SURROUND_CELLS_MAX, &cells[0], err);
}

static bool parse_pattern(const struct cli *cli, struct source *s, struct err *err) {
    int kind;
    if (!cli_choice(cli, pattern_names, &kind, err)) return false;
    s->surround.kind = s->rectangle.kind = (enum pattern_kind)kind;
    return true;
}

/* What the grid is, whatever its source. */
static bool parse_frame(struct source_options *o, const struct cli *cli, int key, struct err *err) {
    switch (key) {
    case OPTION_PLANE:
        return model_option_axes(cli, o->axes, err);
    case OPTION_DEGREE:
        return cli_int(cli, 1, GRID_DEGREE_MAX, &o->degree, err);
    case OPTION_DEPTH:
        return parse_depth(cli, o->depth, err);
    case OPTION_LATTICE:
        return cli_double(cli, DBL_MIN, DBL_MAX, &o->source.lattice.step, err);
    case OPTION_BITS:
        return cli_int(cli, 1, 24, &o->bits, err);
    default: /* OPTION_FLAT */
        return true;
    }
}

bool source_option(struct source_options *o, const struct cli *cli, int key, struct err *err) {
    struct source *s = &o->source;
    o->given[key - SOURCE_KEY] = true;
    switch (key) {
    case OPTION_RECT:
        return parse_rect(cli, &s->rectangle, err);
    case OPTION_MODEL:
    case OPTION_AROUND:
    case OPTION_POLYGON:
    case OPTION_TRIANGULATION:
    case OPTION_IMAGE:
        s->file = cli->value;
        return true;
    case OPTION_FRAME:
        return parse_corners(cli, &s->rectangle, err);
    case OPTION_MARGIN:
        return cli_double(cli, 0, DBL_MAX, &s->surround.margin, err);
    case OPTION_CELLS:
        return parse_cells(cli, o->cells, err);
    case OPTION_CELL:
        return cli_double(cli, DBL_MIN, DBL_MAX, &s->surround.cell, err);
    case OPTION_PATTERN:
        return parse_pattern(cli, s, err);
    case OPTION_MAX_AREA:
        return cli_double(cli, DBL_MIN, DBL_MAX, &s->domain.max_area, err);
    case OPTION_MIN_ANGLE:
        return cli_double(cli, 0, 60, &s->domain.min_angle, err);
    case OPTION_MAX_TRIANGLES:
        return cli_int(cli, 1, UINT32_MAX / 3, &o->triangles, err);
    default:
        return parse_frame(o, cli, key, err);
    }
}

static bool misuse(struct err *err, const char *what) {
    return err_set(err, ERR_USAGE, "%s; try mkgrid --help", what);
}

/* Exactly one source, and no option that does not go with it. */
static bool check_source(struct source_options *o, struct err *err) {
    int source = 0, n = 0;
    for (int key = OPTION_RECT; key <= OPTION_IMAGE; key++) {
        if (!given(o, key)) continue;
        source = key;
        n++;
    }
    if (n != 1)
        return misuse(err, "expected one of --rect, --model, --around, --polygon, --triangulation, "
                           "--image");
    for (size_t i = 0; i < sizeof limited / sizeof *limited; i++)
        if (given(o, limited[i].key) && !(limited[i].sources & WITH(source)))
            return err_set(err, ERR_USAGE, "--%s does not go with --%s; try mkgrid --help",
                           name(limited[i].key), name(source));
    o->source.kind = (enum source_kind)(source - OPTION_RECT);
    return true;
}

static bool check_pairs(const struct source_options *o, struct err *err) {
    for (size_t i = 0; i < sizeof exclusive / sizeof *exclusive; i++)
        if (given(o, exclusive[i][0]) && given(o, exclusive[i][1]))
            return err_set(err, ERR_USAGE, "--%s and --%s exclude each other; try mkgrid --help",
                           name(exclusive[i][0]), name(exclusive[i][1]));
    if (given(o, OPTION_RECT) && o->cells[1] == 0)
        return misuse(err, "--rect needs --cells NXxNY, as in 16x12");
    if (!given(o, OPTION_RECT) && !given(o, OPTION_IMAGE) && o->cells[1] > 0)
        return misuse(err, "--cells takes two numbers with --rect and --image only");
    return true;
}

bool source_options_end(struct source_options *o, struct err *err) {
    struct source *s = &o->source;
    if (!check_source(o, err) || !check_pairs(o, err)) return false;
    s->lattice.bits = (int)o->bits;
    s->domain.max_triangles = (size_t)o->triangles;
    s->surround.flat = given(o, OPTION_FLAT);
    s->framed = given(o, OPTION_FRAME);
    s->surround.cells = (uint32_t)o->cells[0];
    for (int c = 0; c < 2; c++) s->rectangle.cells[c] = (uint32_t)o->cells[c];
    return true;
}

bool source_options_grid(const struct source_options *o, struct grid *g,
                         struct surround_report *report, struct err *err) {
    *g = (struct grid){.degree = (int)o->degree, .has_depth = given(o, OPTION_DEPTH)};
    memcpy(g->axes, o->axes, sizeof g->axes);
    memcpy(g->depth, o->depth, sizeof g->depth);
    return source_grid(g, &o->source, report, err);
}
