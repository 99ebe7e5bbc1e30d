/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Guarded scripts. Strong random edits are held against the same edits unguarded, whose ways are
 * searched for folds by dense samples, and every fold that is named is looked at in exact
 * rationals. Planted exits in closed form; what is refused, and that nothing has changed then. */
#include "edits_io.h"
#include "script_run.h"

#include "folding.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 12 };

/* ---- splines and scripts ---- */

static void with_depth(struct grid *g) {
    g->has_depth = true;
    g->depth[0] = -1;
    g->depth[1] = 1;
}

/* 4 x 3 squares: vertex v lies at (side (v mod 5), side (v div 5)); depth -1 to 1. */
static void set_up_squares(struct spline *s, int side) {
    struct recipe r = {.nx = 4, .ny = 3, .spacing = side};
    struct grid g;
    struct err err;
    triangulate(&g, &r, 5, 0);
    with_depth(&g);
    assert_true(grid_build(&g, &err));
    assert_true(spline_identity(s, &g, &err));
}

static void set_up(struct spline *s) {
    set_up_squares(s, 2);
}

/* The same grid, with points of its own. */
static struct spline copy(const struct spline *s) {
    size_t n = s->grid.point_count;
    struct spline c = *s;
    c.phi = malloc(n * sizeof *c.phi);
    memcpy(c.phi, s->phi, n * sizeof *c.phi);
    if (!s->sigma) return c;
    c.sigma = malloc(n * sizeof *c.sigma);
    memcpy(c.sigma, s->sigma, n * sizeof *c.sigma);
    return c;
}

static void free_copy(struct spline *c) {
    free(c->phi);
    free(c->sigma);
}

static bool is_same(const struct spline *s, const struct spline *r) {
    size_t n = s->grid.point_count;
    return memcmp(s->phi, r->phi, n * sizeof *s->phi) == 0 &&
           (!s->sigma || memcmp(s->sigma, r->sigma, n * sizeof *s->sigma) == 0);
}

/* What an observer saw of the last block. */
struct seen {
    int edits, limited;
    struct foldfree_exit exit; /* share = 1: not limited */
    double share;              /* of the edits */
    bool touched[100000];      /* points of A and D */
};

static bool see(void *context, const struct script_event *e, struct err *err) {
    struct seen *seen = context;
    (void)err;
    if (!e->edit) return true;
    seen->edits++;
    seen->limited += e->exit != NULL;
    if (e->exit) seen->exit = *e->exit;
    seen->share = e->edit->share;
    for (size_t i = 0; i < e->edit->anchor_count; i++)
        seen->touched[e->edit->anchor[i].point] = true;
    for (size_t i = 0; i < e->report->derived; i++)
        seen->touched[e->report->derived_point[i]] = true;
    return true;
}

enum mode { PLAIN, NO_FOLD, LIMIT };

static bool run(struct spline *s, const char *text, enum mode mode, double margin,
                struct seen *seen, struct err *err) {
    struct script_options options = {{1, 1e9}, mode != PLAIN, mode == LIMIT, margin};
    struct script_observer observer = {see, seen};
    struct script script;
    bool ok;
    *seen = (struct seen){.exit.share = 1};
    assert_true(edits_parse(&script, "t", text, strlen(text), err));
    ok = script_run(&script, s, &options, &observer, err);
    script_free(&script);
    return ok;
}

/* ---- strong random edits ---- */

static void put_statement(FILE *to, const struct spline *s, uint64_t *random, uint32_t v) {
    double at[2], extent = 0;
    uint32_t reach = (uint32_t)random_in(random, 0, 6);
    for (uint32_t i = 0; i < s->grid.vertex_count; i++) {
        grid_vertex(&s->grid, i, at);
        extent = fmax(extent, fmax(fabs(at[0]), fabs(at[1])));
    }
    grid_vertex(&s->grid, v, at);
    extent *= 0.5 * random_unit(random);
    switch (random_in(random, 0, s->sigma ? 4 : 2)) {
    case 0:
        fprintf(to, "move v:%u by %.17g %.17g reach %u\n", v,
                extent * (2 * random_unit(random) - 1), extent * (2 * random_unit(random) - 1),
                reach);
        break;
    case 1:
        fprintf(to, "rotate v:%u about %.17g %.17g by %.17g reach %u\n", v, at[0] + extent, at[1],
                360 * random_unit(random) - 180, reach);
        break;
    case 2:
        fprintf(to, "scale v:%u about %.17g %.17g by %.17g reach %u\n", v, at[0], at[1] - extent,
                3 * random_unit(random), reach);
        break;
    case 3:
        fprintf(to, "raise top v:%u by %.17g reach %u\n", v, 4 * random_unit(random) - 3, reach);
        break;
    default:
        fprintf(to, "raise both v:%u by %.17g reach %u\n", v, random_unit(random), reach);
    }
}

/* One statement, or a block of two and a wish. */
static char *random_edit(const struct spline *s, uint64_t *random) {
    uint32_t v = (uint32_t)random_in(random, 0, s->grid.vertex_count - 2);
    char *text = NULL;
    size_t size;
    FILE *to = open_memstream(&text, &size);
    bool block = random_in(random, 0, 2) == 0;
    if (block) fprintf(to, "begin\nmove v:%u by 0.5 0.25 reach 3\n", s->grid.vertex_count - 1);
    put_statement(to, s, random, v);
    if (block) fprintf(to, "suggest %u by 1 -1\nend\n", s->grid.point_count - 1);
    fclose(to);
    return text;
}

/* A mildly edited spline of a random recipe. */
static void random_spline(struct spline *s, double margin, uint64_t *random) {
    struct grid g;
    struct seen seen;
    struct err err;
    char text[200];
    int degree = 5 + (int)random_in(random, 0, 2);
    do random_grid(&g, 2, degree, random_bits(random));
    while (g.triangle_count < 6 && (grid_free(&g), true));
    if (random_bits(random) & 1) with_depth(&g);
    assert_true(spline_identity(s, &g, &err));
    snprintf(text, sizeof text, "move v:%u by 0.5 -0.25 reach 5",
             (uint32_t)random_in(random, 0, s->grid.vertex_count - 1));
    (void)run(s, text, NO_FOLD, margin, &seen, &err);
}

/* The first loss on the way between two splines over all triangles, by samples. */
static double first_loss(const struct spline *from, const struct spline *to, double margin) {
    double least = INFINITY;
    for (int kind = 0; kind < (from->sigma ? 2 : 1); kind++)
        for (uint32_t t = 0; t < from->grid.triangle_count; t++) {
            struct folding way = {from, to, kind == 1, t};
            least = fmin(least, folding_first_loss(&way, margin, SAMPLES));
        }
    return least;
}

/* An edit that is not limited is carried out as ever, or refused for a fold that is there. */
static void check_no_fold(const struct spline *before, const struct spline *after, const char *text,
                          double margin, uint64_t seed) {
    struct spline s = copy(before);
    struct seen seen;
    struct err err;
    if (run(&s, text, NO_FOLD, margin, &seen, &err)) {
        check_seed(seed, is_same(&s, after));
        check_seed(seed, first_loss(after, after, margin) == INFINITY);
    } else {
        check_seed(seed, err.kind == ERR_REFUSAL && strcmp(err.file, "t") == 0 && err.line == 1);
        check_seed(seed, is_same(&s, before));
        check_seed(seed, folding_sign_of_text(before, after, err.message, 1, margin) <= 0);
    }
    free_copy(&s);
}

/* Each point has gone the same share of its way, and the others nowhere. */
static void check_share(const struct spline *before, const struct spline *after,
                        const struct spline *s, const struct seen *seen, uint64_t seed) {
    double share = seen->exit.share;
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int c = 0; c < (s->sigma ? 4 : 2); c++) {
            double from = c < 2 ? before->phi[p][c] : before->sigma[p][c - 2];
            double to = c < 2 ? after->phi[p][c] : after->sigma[p][c - 2];
            double is = c < 2 ? s->phi[p][c] : s->sigma[p][c - 2];
            double size = 10 + fabs(from) + fabs(to);
            if (!seen->touched[p]) check_seed(seed, memcmp(&is, &from, sizeof is) == 0);
            check_seed(seed, fabs(is - (from + share * (to - from))) <= 1e-11 * size);
        }
}

static void check_c1(const struct spline *s, uint64_t seed) {
    struct c1_field phi = {&s->phi[0][0], 2, 2, c1_extent(&s->grid)};
    struct c1_field sigma = {s->sigma ? &s->sigma[0][0] : NULL, 2, 2, phi.extent};
    double absolute, relative;
    uint32_t edge;
    c1_residual(&s->grid, &phi, &absolute, &relative, &edge);
    check_seed(seed, relative <= 64 * 0x1p-53);
    if (!s->sigma) return;
    c1_residual(&s->grid, &sigma, &absolute, &relative, &edge);
    check_seed(seed, relative <= 64 * 0x1p-53);
}

/* 100 lost <= 101 share, exactly. */
static bool is_within_one_percent(double share, double lost) {
    mpq_t left, right, factor;
    bool within;
    mpq_inits(left, right, factor, NULL);
    mpq_set_d(left, lost);
    mpq_set_ui(factor, 100, 1);
    mpq_mul(left, left, factor);
    mpq_set_d(right, share);
    mpq_set_ui(factor, 101, 1);
    mpq_mul(right, right, factor);
    within = mpq_cmp(left, right) <= 0;
    mpq_clears(left, right, factor, NULL);
    return within;
}

enum outcome { WHOLE, LIMITED, SHORT_OF_SAMPLES, REFUSED };

static enum outcome check_limit(const struct spline *before, const struct spline *after,
                                const char *text, double margin, uint64_t seed) {
    struct spline s = copy(before);
    struct seen seen;
    struct err err;
    double sampled = first_loss(before, after, margin), share;
    enum outcome outcome = WHOLE;
    if (!run(&s, text, LIMIT, margin, &seen, &err)) {
        check_seed(seed, err.kind == ERR_REFUSAL && strstr(err.message, "so it was before"));
        check_seed(seed, is_same(&s, before) && sampled == 0);
        free_copy(&s);
        return REFUSED;
    }
    share = seen.exit.share;
    check_seed(seed, seen.limited == 0 || seen.limited == seen.edits);
    check_seed(seed, seen.share == share);
    check_seed(seed, sampled > share); /* never beyond the first loss */
    check_share(before, after, &s, &seen, seed);
    check_c1(&s, seed);
    check_seed(seed, first_loss(&s, &s, margin) == INFINITY);
    if (share == 1) {
        check_seed(seed, seen.limited == 0 && is_same(&s, after));
    } else {
        check_seed(seed, seen.exit.lost > share && is_within_one_percent(share, seen.exit.lost));
        check_seed(
            seed, folding_sign_of_text(before, after, seen.exit.text, seen.exit.lost, margin) <= 0);
        outcome = sampled <= 1.01 * share ? LIMITED : SHORT_OF_SAMPLES;
    }
    free_copy(&s);
    return outcome;
}

static void test_random(void **unused) {
    int count[4] = {0}, n = test_count(300);
    (void)unused;
    for (uint64_t seed = 1; seed <= (uint64_t)n; seed++) {
        uint64_t random = seed;
        double margin = random_bits(&random) & 1 ? 0 : 0.2;
        struct spline before, after;
        struct seen seen;
        struct err err;
        char *text;
        random_spline(&before, margin, &random);
        after = copy(&before);
        text = random_edit(&before, &random);
        if (run(&after, text, PLAIN, 0, &seen, &err)) {
            check_no_fold(&before, &after, text, margin, seed);
            count[check_limit(&before, &after, text, margin, seed)]++;
        }
        free(text);
        free_copy(&after);
        spline_free(&before);
    }
    assert_true(count[WHOLE] >= n / 5 && count[LIMITED] >= n / 5);
    assert_true(count[SHORT_OF_SAMPLES] <= n / 50);
}

/* ---- planted exits ---- */

static const struct {
    const char *text;
    double margin, exit; /* exit >= 1: none */
} planted[] = {
    {"rotate all about 4 3 by 180", 0, 0.5}, /* det = (1-2s)^2: it folds, and unfolds again */
    {"rotate all about 4 3 by 180", 0.2, 0.27639320225002106},  /* (1 - sqrt 0.2) / 2 */
    {"rotate all about -9 7 by 120", 0.5, 0.21132486540518713}, /* 1-3s(1-s): (3 - sqrt 3) / 6 */
    {"rotate all about -9 7 by 120", 0.2, 2},                   /* least: 1/4 */
    {"scale all about 0 0 by 0.1", 0.25, 0.55555555555555556},  /* (1-0.9s)^2 */
    {"scale all about 0 0 by 9", 0, 2},
    {"raise top all by -3", 0, 0.66666666666666667}, /* 1-1.5s */
    {"raise top all by -3", 0.4, 0.4},
    {"raise both all by 9", 0.5, 2},
    {"move all by 1e6 0", 0.9, 2},
    /* one share for the block: 1-2s(1-s) and 1-1.5s */
    {"begin\nrotate all about 1 1 by 90\nraise top all by -3\nend", 0.6, 0.26666666666666667},
    {"begin\nrotate all about 1 1 by 90\nraise top all by -3\nend", 0.8, 0.11270166537925831},
    {"begin\nrotate all about 1 1 by 90\nraise top all by -3\nend", 0.3, 0.46666666666666667},
};

static void test_planted(void **unused) {
    (void)unused;
    for (size_t i = 0; i < sizeof planted / sizeof *planted; i++) {
        double exit = planted[i].exit;
        struct spline before, after, s;
        struct seen seen;
        struct err err;
        set_up(&before);
        after = copy(&before);
        s = copy(&before);
        assert_true(run(&after, planted[i].text, PLAIN, 0, &seen, &err));
        assert_true(run(&s, planted[i].text, LIMIT, planted[i].margin, &seen, &err));
        check_share(&before, &after, &s, &seen, i);
        check_seed(i, (exit < 1) == (seen.limited > 0));
        check_seed(i, exit > 1 || (seen.share > 0.99 * exit && seen.share < exit));
        check_seed(i, exit > 1 || (seen.exit.lost >= exit && seen.exit.lost <= 1.01 * seen.share));
        free_copy(&after);
        free_copy(&s);
        spline_free(&before);
    }
}

/* Every point goes to 1e5 - 2 times where it is: det = (1-3s)^2, whose zero is no double. What is
 * held there is too near to it to survive rounding: a little less is applied. */
static void test_step_back(void **unused) {
    struct spline s;
    struct seen seen;
    struct err err;
    char *text = NULL;
    size_t size;
    FILE *to = open_memstream(&text, &size);
    (void)unused;
    set_up_squares(&s, 10); /* control points are integers */
    fputs("begin\n", to);
    for (uint32_t p = 0; p < s.grid.point_count; p++)
        fprintf(to, "move %u to %.17g %.17g\n", p, 1e5 - 2 * s.phi[p][0], 1e5 - 2 * s.phi[p][1]);
    fputs("end\n", to);
    fclose(to);
    assert_true(run(&s, text, LIMIT, 0, &seen, &err));
    assert_true(seen.share < 1.0 / 3 - 0x1p-12 && seen.share > 0.99 / 3);
    assert_non_null(strstr(seen.exit.text, ": det grad phi > 0 could not be decided"));
    assert_true(is_within_one_percent(seen.share, seen.exit.lost));
    assert_true(first_loss(&s, &s, 0) == INFINITY);
    free(text);
    spline_free(&s);
}

/* ---- refusals ---- */

static void must_refuse(struct spline *s, const char *text, enum mode mode, double margin,
                        const char *message) {
    struct spline before = copy(s);
    struct seen seen;
    struct err err = {0};
    if (run(s, text, mode, margin, &seen, &err)) fail_msg("accepted: %s", text);
    assert_string_equal(err.message, message);
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.file, "t");
    assert_true(seen.edits == 0);
    check_seed(0, is_same(s, &before));
    free_copy(&before);
}

static void must_run(struct spline *s, const char *text, enum mode mode, double margin) {
    struct seen seen;
    struct err err = {0};
    if (!run(s, text, mode, margin, &seen, &err)) fail_msg("%s: %s", text, err.message);
}

static void test_refusals(void **unused) {
    struct spline s;
    (void)unused;
    set_up_squares(&s, 10); /* control points are integers */
    must_refuse(&s, "raise top all by -3", NO_FOLD, 0,
                "raise: triangle 0: expected (sigma1-sigma0)/(b-a) > 0, got -0.5 at (1 0 0)/1 = "
                "1 0 0");
    must_refuse(&s, "raise top all by -2", NO_FOLD, 0,
                "raise: triangle 0: expected (sigma1-sigma0)/(b-a) > 0, got 0 at (1 0 0)/1 = "
                "1 0 0");
    must_refuse(&s, "begin\nmove all by 1 0\nraise top all by -1\nend", NO_FOLD, 0.75,
                "block: triangle 0: expected (sigma1-sigma0)/(b-a) > 0.75, got 0.5 at (1 0 0)/1 = "
                "1 0 0");
    must_refuse(&s, "scale all about 0 0 by 0.5", NO_FOLD, 0.25,
                "scale: triangle 0: expected det grad phi > 0.25, got 0.25 at (1 0 0)/1 = 1 0 0");
    must_refuse(&s, "move all by 1 0", LIMIT, 1,
                "move: triangle 0: expected det grad phi > 1, got 1 at (1 0 0)/1 = 1 0 0; "
                "so it was before the edit");
    must_refuse(&s, "raise top all by -1e8", LIMIT, 0,
                "raise: triangle 0: expected (sigma1-sigma0)/(b-a) > 0, got -46.6837158203125 at "
                "(1 0 0)/1 = 1 0 0 after no more than 9.5367431640625e-07 of the edit");
    spline_free(&s);
}

/* j (j-1) .. (j-n+1) */
static double falling(int j, int n) {
    return n == 0 ? 1 : j * falling(j - 1, n - 1);
}

/* The coefficient of x^a y^b with weights j, k on the triangle with legs 15/8, degree 5; exact. */
static double coefficient(int a, int b, int j, int k) {
    double power = 1;
    for (int i = 0; i < a + b; i++) power *= 15;
    return ldexp(power * falling(j, a) * falling(k, b) / falling(5, a + b), -3 * (a + b));
}

/* phi = (x, 3 (x^4 - x^2 + 1/4) y + y^3): det = 3 (x^2 - 1/2)^2 + 3 y^2 is 0 at one irrational
 * point. An edit that goes nowhere touches it. */
static void test_undecided(void **unused) {
    static const int32_t corner[3][2] = {{0, 0}, {15, 0}, {0, 15}};
    struct grid g = {.degree = 5,
                     .axes = {0, 1, 2},
                     .lattice = {0.125, 0, 0},
                     .vertex_count = 3,
                     .triangle_count = 1};
    struct spline s;
    struct err err;
    uint32_t q[GRID_PATCH_MAX];
    (void)unused;
    g.vertex = malloc(sizeof corner);
    memcpy(g.vertex, corner, sizeof corner);
    g.triangle = calloc(1, sizeof *g.triangle);
    for (uint32_t l = 0; l < 3; l++) g.triangle[0][l] = l;
    assert_true(grid_build(&g, &err));
    assert_true(spline_identity(&s, &g, &err));
    grid_patch(&s.grid, 0, q);
    for (int row = 0, i = 0; row <= 5; row++)
        for (int k = 0; k <= row; k++, i++) {
            int j = row - k;
            s.phi[q[i]][0] = coefficient(1, 0, j, k);
            s.phi[q[i]][1] = 3 * (coefficient(4, 1, j, k) - coefficient(2, 1, j, k) +
                                  0.25 * coefficient(0, 1, j, k)) +
                             coefficient(0, 3, j, k);
        }
    must_refuse(&s, "move 0 by 0 0", NO_FOLD, 0,
                "move: triangle 0: det grad phi > 0 could not be decided; so it was before the "
                "edit");
    must_refuse(&s, "move 0 by 0 0", LIMIT, 0,
                "move: triangle 0: det grad phi > 0 could not be decided; so it was before the "
                "edit");
    spline_free(&s);
}

/* What folded before: may be mended, must not be touched otherwise, and has no way without folds.
 */
static void test_folded_before(void **unused) {
    struct spline s;
    struct seen seen;
    struct err err;
    (void)unused;
    set_up(&s);
    must_run(&s, "move v:7 by 3.5 0", PLAIN, 0);
    must_run(&s, "move v:19 by 0.1 0", NO_FOLD, 0); /* elsewhere */
    assert_false(run(&s, "move v:7 by 0.1 0", NO_FOLD, 0, &seen, &err));
    assert_non_null(strstr(err.message, "; so it was before the edit"));
    assert_false(run(&s, "raise top v:7 by 0.1", NO_FOLD, 0, &seen, &err)); /* prisms fold too */
    assert_non_null(strstr(err.message, "expected det grad phi > 0, got -"));
    assert_false(run(&s, "move v:7 by -3.5 0", LIMIT, 0, &seen, &err));
    assert_non_null(strstr(err.message, "; so it was before the edit"));
    must_run(&s, "move v:7 by -3.5 0", NO_FOLD, 0);
    must_run(&s, "move v:7 by 3.5 0", LIMIT, 0);
    spline_free(&s);
}

/* Each limited edit leaves at most 1 % of the way to the fold, the next 1 % of that, and so on,
 * until it is too little. */
static void test_repeated(void **unused) {
    struct spline s;
    struct seen seen;
    struct err err = {0};
    double share = 1;
    int n = 0;
    (void)unused;
    set_up(&s);
    while (run(&s, "raise top all by -3", LIMIT, 0, &seen, &err)) {
        assert_true(seen.share < share && n++ < 4);
        share = seen.share / 50;
    }
    assert_true(n >= 2 && err.kind == ERR_REFUSAL);
    assert_non_null(strstr(err.message, " of the edit"));
    spline_free(&s);
}

static bool stop(void *context, const struct script_event *e, struct err *err) {
    (void)context;
    return e->channel != SCRIPT_TOP || err_set(err, ERR_INPUT, "enough");
}

/* An observer's refusal takes back what was limited. */
static void test_observer_stops(void **unused) {
    static const char text[] = "begin\nmove all by 1 0\nraise top all by -3\nend";
    struct script_options options = {{1, 100}, true, true, 0};
    struct script_observer observer = {stop, NULL};
    struct script script;
    struct spline s, before;
    struct err err = {0};
    (void)unused;
    set_up(&s);
    before = copy(&s);
    assert_true(edits_parse(&script, "t", text, strlen(text), &err));
    assert_false(script_run(&script, &s, &options, &observer, &err));
    assert_string_equal(err.message, "enough");
    check_seed(0, is_same(&s, &before));
    script_free(&script);
    free_copy(&before);
    spline_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),    cmocka_unit_test(test_planted),
        cmocka_unit_test(test_step_back), cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_undecided), cmocka_unit_test(test_folded_before),
        cmocka_unit_test(test_repeated),  cmocka_unit_test(test_observer_stops),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
