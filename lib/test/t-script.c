/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scripts carried out on small grids: planted positions, what is refused and where, all or nothing
 * in blocks, that nothing moves but what the observer was told, and that it is the least solution;
 * long chains of turns. */
#include "edits_io.h"
#include "grid_io.h"
#include "script_run.h"

#include "editing.h"
#include "triangulations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* 4 x 3 squares of side 2, degree 5: vertex v lies at (2 (v mod 5), 2 (v div 5)). */
static void set_up(struct spline *s, bool depth) {
    struct recipe r = {.nx = 4, .ny = 3, .spacing = 2};
    struct grid g;
    struct err err;
    triangulate(&g, &r, 5, 0);
    g.has_depth = depth;
    g.depth[0] = -1;
    g.depth[1] = 1;
    assert_true(grid_build(&g, &err));
    assert_true(spline_identity(s, &g, &err));
}

static bool run_with(struct spline *s, const char *text, int continuity,
                     const struct script_observer *observer, struct err *err) {
    struct script_options options = {.decles = {.continuity = continuity, .max_gain = 100}};
    struct script script;
    bool ok;
    assert_true(edits_parse(&script, "t", text, strlen(text), err));
    ok = script_run(&script, s, &options, observer, err);
    script_free(&script);
    return ok;
}

static bool run(struct spline *s, const char *text, struct err *err) {
    return run_with(s, text, 1, NULL, err);
}

static void must_run(struct spline *s, const char *text) {
    struct err err;
    if (!run(s, text, &err)) fail_msg("line %zu: %s\n%.400s", err.line, err.message, text);
}

static void check_at(const struct spline *s, uint32_t p, double x, double y) {
    if (s->phi[p][0] != x || s->phi[p][1] != y)
        fail_msg("point %u at %.17g %.17g instead of %g %g", p, s->phi[p][0], s->phi[p][1], x, y);
}

/* ---- where anchors go ---- */

static void test_positions(void **unused) {
    static const struct {
        const char *text;
        uint32_t point;
        double x, y;
    } cases[] = {
        {"move v:7 by 0.25 -0.5", 7, 4.25, 1.5},
        {"move v:7 by 0.25 -0.5 reach 4", 7, 4.25, 1.5},
        {"move v:7 to 4.1 2.3 within 2", 7, 4.1, 2.3},
        {"move v:7 from 10 10 to 10.5 9.75", 7, 4.5, 1.75},
        {"rotate v:7 about 3.5 2 by 90", 7, 3.5, 2.5},
        {"rotate v:7 about 4 1.5 by -180", 7, 4, 1},
        {"scale v:7 about 3 2 by 1.5", 7, 4.5, 2},
        {"move @4.2,2.1 by 0.5 0\nmove v@4.6,2 by 0 0.5", 7, 4.5, 2.5},
        {"move 7 by 0.5 0\nmove ^4,2 by 0.5 0", 7, 5, 2},
        {"move 0:0,5,0 by 0.5 0", 1, 2.5, 0},
        {"weight 3 all\nmove 7 by 0.5 0 reach 3", 7, 4.5, 2},
        {"pin 7\nunpin all\nmove 7 by 0.5 0 reach 3", 7, 4.5, 2},
        /* the block's @ sees what was there before it: v@4.6,2 is 7, still at (4,2) */
        {"begin\nmove 8 by -1 0\nmove v@4.9,2 by 0.25 0 reach 3\nend", 7, 4.25, 2},
        {"move 8 by -1 0\nmove v@4.9,2 by 0.25 0 reach 3", 8, 5.25, 2},
        {"move box:4,2,4,2 by 1 1", 7, 5, 3},
    };
    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct spline s;
        set_up(&s, false);
        must_run(&s, cases[i].text);
        check_at(&s, cases[i].point, cases[i].x, cases[i].y);
        spline_free(&s);
    }
}

static void test_heights(void **unused) {
    struct spline s;
    (void)unused;
    set_up(&s, true);
    must_run(&s, "raise top 7 by 0.5 reach 3\nraise bottom 7 to -2\nraise both 12 by 0.25");
    assert_true(s.sigma[7][1] == 1.5 && s.sigma[7][0] == -2);
    assert_true(s.sigma[12][0] == -0.75 && s.sigma[12][1] == 1.25);
    for (uint32_t p = 0; p < s.grid.point_count; p++) {
        double xy[2];
        grid_nominal(&s.grid, p, xy);
        check_at(&s, p, xy[0], xy[1]);
    }
    spline_free(&s);
}

/* rotate and scale of everything are affine: each point is where the formula says. */
static void test_affine(void **unused) {
    struct spline s;
    (void)unused;
    set_up(&s, false);
    must_run(&s, "rotate all about 1 2 by 90\nscale all about 0 0 by 2\nmove all by 1 0");
    for (uint32_t p = 0; p < s.grid.point_count; p++) {
        double xy[2];
        grid_nominal(&s.grid, p, xy);
        /* quarter turns are exact, and long double holds these differences without rounding */
        check_at(&s, p, 2 * (double)(3 - (long double)xy[1]) + 1,
                 2 * (double)(1 + (long double)xy[0]));
    }
    spline_free(&s);
}

/* Without conditions every slave goes to its wish. */
static void test_wishes(void **unused) {
    struct spline s;
    struct err err;
    (void)unused;
    set_up(&s, false);
    assert_true(run_with(&s,
                         "begin\nmove 7 by 1 0\nsuggest 12 to 4.5 4.25\nsuggest 13 14 by 0 0.5\n"
                         "suggest v:0 from 0 0 to 1 1\nend",
                         0, NULL, &err));
    check_at(&s, 7, 5, 2);
    check_at(&s, 12, 4.5, 4.25);
    check_at(&s, 13, 6, 4.5);
    check_at(&s, 14, 8, 4.5);
    check_at(&s, 0, 1, 1);
    spline_free(&s);
}

/* ---- refusals ---- */

static const struct {
    const char *text;
    enum err_kind kind;
    size_t line, col;
    const char *message;
} bad[] = {
    /* on a grid without depth */
    {"move 5 999 by 1 1", ERR_INPUT, 1, 8, "expected a point in 0..335, got 999"},
    {"move 5 by 1 1 with 6 v:20", ERR_INPUT, 1, 22, "expected a vertex in 0..19, got 20"},
    {"\n pin 0:1,1,1", ERR_INPUT, 2, 6,
     "expected Bezier indices whose sum is the degree, 5, got 1,1,1"},
    {"move 5-6 to 1 1", ERR_INPUT, 1, 1, "move: expected one point with 'to', got 2"},
    {"raise top all to 1", ERR_INPUT, 1, 1, "raise: expected a grid with depth, got one without"},
    {"pin 7\n move 6-8 by 1 1", ERR_REFUSAL, 2, 2, "move: point 7 is pinned"},
    {"pin 8\nbegin\nmove 6 by 1 1\nsuggest 8 by 1 1\nend", ERR_REFUSAL, 4, 1,
     "suggest: point 8 is pinned"},
    {"begin\nmove 6-8 by 1 1\n  move 7 by 1 1\nend", ERR_INPUT, 3, 3,
     "second anchor at point 7, which is an anchor of line 2 in the same block"},
    {"begin\nsuggest 7 by 1 1\nmove 7 by 1 1\nend", ERR_INPUT, 3, 1,
     "second anchor at point 7, which is suggested by the statement of line 2 in the same "
     "block"},
    {"begin\nmove 7 by 1 1\nsuggest 7 by 1 1\nend", ERR_INPUT, 3, 1,
     "suggest for point 7, which is an anchor of line 2 in the same block"},
    {"suggest 7 by 1 1", ERR_INPUT, 1, 1,
     "suggest: expected a move, rotate or scale in the same block"},
    {"begin\n  suggest 7 by 1 1\nend", ERR_INPUT, 2, 3,
     "suggest: expected a move, rotate or scale in the same block"},
    {"\nscale 7 about -1.7e308 0 by 2", ERR_REFUSAL, 2, 1,
     "scale: the new position of point 7 is too large"},
    {"raise top 7 by 1", ERR_INPUT, 1, 1, "raise: expected a grid with depth, got one without"},
};

static void test_refusals(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct spline s;
        struct err err = {0};
        set_up(&s, false);
        /* without conditions, so that only the script is to blame */
        if (run_with(&s, bad[i].text, 0, NULL, &err)) fail_msg("accepted: %s", bad[i].text);
        assert_string_equal(err.message, bad[i].message);
        assert_string_equal(err.file, "t");
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
        assert_int_equal(err.kind, bad[i].kind);
        spline_free(&s);
    }
}

/* What decles refuses is placed, and says statement and channel. */
static void test_conflict(void **unused) {
    struct spline s;
    struct err err = {0};
    (void)unused;
    set_up(&s, false);
    assert_false(run(&s, "pin all\nunpin 7\nmove 7 by 1 0", &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_int_equal(err.line, 3);
    assert_ptr_equal(strstr(err.message, "move, phi: "), err.message);
    spline_free(&s);
}

/* ---- all or nothing ---- */

static void check_unchanged(const struct spline *s, const struct spline *before) {
    uint32_t n = s->grid.point_count;
    assert_memory_equal(s->phi, before->phi, n * sizeof *s->phi);
    assert_memory_equal(s->sigma, before->sigma, n * sizeof *s->sigma);
}

/* phi and bottom can be edited, top is not C1 where the block wants to raise it. */
static void test_undo(void **unused) {
    struct spline s, before;
    struct err err = {0};
    (void)unused;
    set_up(&s, true);
    set_up(&before, true);
    s.sigma[12][1] = before.sigma[12][1] = 1.5;
    assert_false(run(&s, "begin\nmove 7 by 0.5 0 reach 4\nraise both 12 by 1 reach 2\nend", &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_int_equal(err.line, 1);
    assert_ptr_equal(strstr(err.message, "block, top: "), err.message);
    check_unchanged(&s, &before);
    spline_free(&s);
    spline_free(&before);
}

static bool refuse_top(void *context, const struct script_event *e, struct err *err) {
    (void)context;
    return e->channel != SCRIPT_TOP || err_set(err, ERR_INPUT, "enough");
}

static void test_observer_stops(void **unused) {
    struct spline s, before;
    struct script_observer observer = {refuse_top, NULL};
    struct err err = {0};
    (void)unused;
    set_up(&s, true);
    set_up(&before, true);
    assert_false(run_with(&s, "begin\nmove 7 by 0.5 0 reach 4\nraise both 12 by 1 reach 2\nend", 1,
                          &observer, &err));
    assert_string_equal(err.message, "enough");
    check_unchanged(&s, &before);
    spline_free(&s);
    spline_free(&before);
}

/* ---- random scripts ---- */

/* Follows a script: what it is told to have moved must be all that has moved, and have moved as
 * dense least squares would have it. */
struct witness {
    const struct spline *s;
    double (*phi)[2], (*sigma)[2], *weight;
    bool *pinned;
    size_t edits, settings;
    uint64_t seed;
};

static double *kept(const struct witness *w, enum script_channel c, uint32_t p) {
    return c == SCRIPT_PHI ? w->phi[p] : &w->sigma[p][c == SCRIPT_TOP];
}

static void follow_anchors(struct witness *w, const struct script_event *e) {
    size_t k = e->channel == SCRIPT_PHI ? 2 : 1;
    for (size_t i = 0; i < e->edit->anchor_count; i++) {
        const struct decles_anchor *a = &e->edit->anchor[i];
        double *q = kept(w, e->channel, a->point);
        check_seed(w->seed, memcmp(q, e->from[i], k * sizeof *q) == 0);
        memcpy(q, a->to, k * sizeof *q);
        for (size_t j = 0; j < e->points->count; j++)
            check_seed(w->seed, e->points->point[j] != a->point);
    }
}

static void follow_derived(struct witness *w, const struct script_event *e) {
    size_t k = e->channel == SCRIPT_PHI ? 2 : 1;
    for (size_t i = 0; i < e->report->derived; i++) {
        uint32_t p = e->report->derived_point[i];
        double *q = kept(w, e->channel, p);
        check_seed(w->seed, memcmp(q, &e->report->before[k * i], k * sizeof *q) == 0);
        memcpy(q,
               e->channel == SCRIPT_PHI ? w->s->phi[p] : &w->s->sigma[p][e->channel == SCRIPT_TOP],
               k * sizeof *q);
    }
}

/* pin, unpin, weight */
static void follow_setting(struct witness *w, const struct script_event *e) {
    const struct script_statement *s = &e->script->statement[e->block->first];
    for (size_t i = 0; i < e->points->count; i++) {
        uint32_t p = e->points->point[i];
        if (s->verb == SCRIPT_WEIGHT)
            w->weight[p] = s->by[0];
        else
            w->pinned[p] = s->verb == SCRIPT_PIN;
    }
}

/* Every third edit, since it takes long. */
static void check_least(const struct witness *w, const struct script_event *e) {
    struct editing view = {
        .g = w->s->grid,
        .q = e->channel == SCRIPT_PHI ? w->s->phi[0] : &w->s->sigma[0][e->channel == SCRIPT_TOP],
        .magnitude = 8,
        .report = *e->report,
        .seed = w->seed};
    for (size_t i = 0; i < e->report->derived; i++)
        check_seed(w->seed, !w->pinned[e->report->derived_point[i]]);
    if (w->edits % 3 == 0)
        editing_check_solution(&view, w->weight, e->channel == SCRIPT_PHI ? 2 : 1);
}

static bool see(void *context, const struct script_event *e, struct err *err) {
    struct witness *w = context;
    (void)err;
    if (!e->edit) {
        w->settings++;
        follow_setting(w, e);
        return e->points->count > 0;
    }
    w->edits++;
    follow_anchors(w, e);
    follow_derived(w, e);
    check_least(w, e);
    check_seed(w->seed, memcmp(w->phi, w->s->phi, w->s->grid.point_count * sizeof *w->phi) == 0);
    return true;
}

static void put_random_statement(FILE *to, uint64_t *state, bool in_block, int *anchor) {
    double x = (double)random_in(state, 0, 16) / 2, y = (double)random_in(state, 0, 12) / 2;
    int number = (*anchor += (int)random_in(state, 20, 60)); /* distinct within a block */
    switch (random_in(state, 0, in_block ? 5 : 8)) {
    case 0:
        fprintf(to, "move %d by 0.125 -0.25 reach %d\n", number, (int)random_in(state, 0, 6));
        break;
    case 1:
        fprintf(to, "rotate %d about %g %g by 5 within 2\n", number, x, y);
        break;
    case 2:
        fprintf(to, "scale %d about %g %g by 1.0625\n", number, x, y);
        break;
    case 3:
        fprintf(to, "raise top %d by 0.5 reach 3 with v^%g,%g\n", number, x, y);
        break;
    case 4:
        fprintf(to, "raise both %d by -0.25 reach 2\n", number);
        break;
    case 5:
        if (in_block)
            fprintf(to, "suggest %d %d by 0.25 -0.125\n", number, number + 3);
        else
            fprintf(to, "move @%g,%g by 0.25 0.125 reach 4\n", x, y);
        break;
    case 6:
        fprintf(to, "pin ^%g,%g\n", x, y);
        break;
    case 7:
        fprintf(to, "weight %d box:%g,%g,8,6\n", (int)random_in(state, 1, 9), x, y);
        break;
    default:
        fprintf(to, "unpin v@%g,%g\n", x, y);
    }
}

static void put_random_script(FILE *to, uint64_t *state) {
    for (int i = 0; i < 12; i++) {
        bool block = random_in(state, 0, 3) == 0;
        int anchor = -20;
        if (block) fputs("begin\nmove 335 by 0.125 0\n", to);
        for (int n = block ? 3 : 1; n > 0; n--) put_random_statement(to, state, block, &anchor);
        if (block) fputs("end\n", to);
    }
}

static void copy_spline(struct witness *w) {
    size_t n = w->s->grid.point_count;
    w->phi = malloc(n * sizeof *w->phi);
    w->sigma = malloc(n * sizeof *w->sigma);
    w->weight = malloc(n * sizeof *w->weight);
    w->pinned = calloc(n, sizeof *w->pinned);
    for (size_t p = 0; p < n; p++) w->weight[p] = 1;
    memcpy(w->phi, w->s->phi, n * sizeof *w->phi);
    memcpy(w->sigma, w->s->sigma, n * sizeof *w->sigma);
}

static double largest_residual(const struct spline *s) {
    struct c1_field phi = {&s->phi[0][0], 2, 2, c1_extent(&s->grid)};
    struct c1_field sigma = {&s->sigma[0][0], 2, 2, phi.extent};
    double worst, absolute, relative;
    uint32_t edge;
    c1_residual(&s->grid, &phi, &absolute, &worst, &edge);
    c1_residual(&s->grid, &sigma, &absolute, &relative, &edge);
    return fmax(worst, relative);
}

/* Returns whether the script was carried out to its end. */
static bool run_random(uint64_t seed) {
    uint64_t state = seed;
    char *text = NULL;
    size_t size;
    FILE *to = open_memstream(&text, &size);
    struct spline s;
    struct witness w = {.s = &s, .seed = seed};
    struct script_observer observer = {see, &w};
    struct err err = {0};
    bool ok;
    put_random_script(to, &state);
    fclose(to);
    set_up(&s, true);
    copy_spline(&w);
    ok = run_with(&s, text, 1, &observer, &err);
    check_seed(seed, ok || err.kind == ERR_REFUSAL); /* two anchors may be in conflict */
    check_seed(seed, !ok || w.edits + w.settings >= 12);
    if (ok) {
        check_seed(seed, memcmp(w.phi, s.phi, s.grid.point_count * sizeof *s.phi) == 0);
        check_seed(seed, memcmp(w.sigma, s.sigma, s.grid.point_count * sizeof *s.sigma) == 0);
    }
    check_seed(seed, largest_residual(&s) < 1e-13);
    spline_free(&s);
    free(w.phi);
    free(w.sigma);
    free(w.weight);
    free(w.pinned);
    free(text);
    return ok;
}

static void test_random(void **unused) {
    int done = 0, n = test_count(100);
    (void)unused;
    for (int i = 0; i < n; i++) done += run_random((uint64_t)i);
    assert_true(2 * done >= n);
}

/* ---- chains of turns ---- */

/* A grid by a random recipe, with room for corners to name. */
static void set_up_random(struct spline *s, uint64_t seed) {
    struct grid g;
    struct err err;
    int degree = 5 + (int)(seed % 3);
    do random_grid(&g, 3, degree, seed++);
    while (g.triangle_count < 8 && (grid_free(&g), true));
    assert_true(spline_identity(s, &g, &err));
}

/* Turns the points around a vertex, or all, about a centre up to an extent away from where the
 * vertex is; their neighbours follow. */
static void put_turn(FILE *to, const struct spline *s, uint64_t *random) {
    double extent = c1_extent(&s->grid), r = (0.1 + 0.3 * random_unit(random)) * extent, at[2];
    uint32_t v = (uint32_t)random_in(random, 0, s->grid.vertex_count - 1);
    grid_vertex(&s->grid, v, at);
    if (random_in(random, 0, 4) == 0)
        fputs("rotate all", to);
    else
        fprintf(to, "rotate box:%.17g,%.17g,%.17g,%.17g", at[0] - r, at[1] - r, at[0] + r,
                at[1] + r);
    fprintf(to, " about %.17g %.17g by %.17g within %.17g\n",
            s->phi[v][0] + (2 * random_unit(random) - 1) * extent,
            s->phi[v][1] + (2 * random_unit(random) - 1) * extent, 360 * random_unit(random) - 180,
            0.3 * random_unit(random) * extent);
}

static double size_of(const struct spline *s) {
    double size = c1_extent(&s->grid);
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        size = fmax(size, fmax(fabs(s->phi[p][0]), fabs(s->phi[p][1])));
    return size;
}

/* Carries out n random turns, each a script; returns how many were refused for their gain, which
 * a turn about a centre in its midst may deserve. Turns that carry points more than four extents
 * away are taken back: what has been there has roundings of that size, which 64 u of the terms
 * nearer to the origin need not cover. */
static int turn(struct spline *s, int n, uint64_t *random) {
    size_t bytes = s->grid.point_count * sizeof *s->phi;
    double(*before)[2] = malloc(bytes), limit = 4 * c1_extent(&s->grid);
    int refused = 0;
    for (int done = 0; done < n;) {
        char *text = NULL;
        size_t size;
        FILE *to = open_memstream(&text, &size);
        struct err err = {0};
        memcpy(before, s->phi, bytes);
        put_turn(to, s, random);
        fclose(to);
        if (run(s, text, &err)) {
            bool far = size_of(s) > limit;
            if (far) memcpy(s->phi, before, bytes);
            done += !far;
        } else {
            if (!strstr(err.message, "what was asked for")) fail_msg("%s%s", text, err.message);
            refused++;
        }
        free(text);
    }
    free(before);
    return refused;
}

/* What another program reads of it; the ownership of s->grid and s->phi passes through. */
static void print_and_read(struct spline *s) {
    char path[] = "/tmp/t-script.XXXXXX", history[] = "";
    struct grid_file file = {*s, history}, again;
    struct out out;
    struct err err;
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    assert_true(out_open(&out, path, &err));
    grid_write(&out, &file, NULL, 0);
    assert_true(out_close(&out, &err));
    assert_true(grid_read(&again, path, &err));
    unlink(path);
    assert_memory_equal(again.spline.phi, s->phi, s->grid.point_count * sizeof *s->phi);
    spline_free(s);
    *s = again.spline;
    free(again.history);
}

/* A turn carries the rounding of y into x: errors must not be held against single coordinates,
 * nor grow with the number of turns. */
static void test_turns(void **unused) {
    int runs = test_count(12), refused = 0;
    (void)unused;
    for (int i = 0; i < runs; i++) {
        uint64_t seed = 600 + (uint64_t)i, random = seed;
        struct spline s;
        set_up_random(&s, seed);
        for (int part = 0; part < 2; part++) {
            struct c1_field phi = {&s.phi[0][0], 2, 2, c1_extent(&s.grid)};
            double absolute, relative;
            uint32_t edge;
            refused += turn(&s, part == 0 ? 100 : 10, &random);
            phi.q = &s.phi[0][0];
            c1_residual(&s.grid, &phi, &absolute, &relative, &edge);
            check_seed(seed, absolute <= 1e-13 * size_of(&s));
            print_and_read(&s);
        }
        spline_free(&s);
    }
    assert_true(refused <= runs);
}

static void test_empty(void **unused) {
    struct spline s;
    struct script script;
    struct err err;
    struct script_options options = {.decles = {.continuity = 1, .max_gain = 100}};
    (void)unused;
    set_up(&s, false);
    assert_true(script_init(&script, "t", &err));
    assert_true(script_run(&script, &s, &options, NULL, &err));
    script_free(&script);
    spline_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_positions), cmocka_unit_test(test_heights),
        cmocka_unit_test(test_affine),    cmocka_unit_test(test_wishes),
        cmocka_unit_test(test_refusals),  cmocka_unit_test(test_conflict),
        cmocka_unit_test(test_undo),      cmocka_unit_test(test_observer_stops),
        cmocka_unit_test(test_random),    cmocka_unit_test(test_turns),
        cmocka_unit_test(test_empty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
