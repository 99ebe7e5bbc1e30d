/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps 0 and 3: what is accepted, what is refused, and what the refusal says. */
#include "decles_rank.h"

#include "decles_motion.h"

#include "dense.h"
#include "editing.h"
#include "triangulations.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Is there a C1 spline for any position of the anchors, all other points being free but the pinned
 * ones? rank A_D = rank [A_D | A_A] with D = all points, over all conditions. */
static bool is_free(const struct editing *s, const uint32_t *anchor, size_t n) {
    const struct grid *g = &s->g;
    size_t rows = 0, cols = g->point_count, rank;
    int64_t *a = calloc((size_t)g->edge_count * (size_t)g->degree * cols, sizeof *a);
    char *is_anchor = calloc(cols, 1);
    for (size_t i = 0; i < n; i++) is_anchor[anchor[i]] = 1;
    for (uint32_t e = 0; e < g->edge_count; e++)
        for (int m = 0; grid_edge_is_inner(g, e) && m < g->degree; m++, rows++) {
            struct c1_condition c = c1_condition(g, e, m);
            for (int i = 0; i < 4; i++)
                if (!decles_is_pinned(s->editor, c.point[i]))
                    a[rows * cols + c.point[i]] = c.coefficient[i];
        }
    rank = dense_rank(a, rows, cols);
    for (size_t i = 0; i < rows * cols; i++)
        if (is_anchor[i % cols]) a[i] = 0;
    rank -= dense_rank(a, rows, cols);
    free(a);
    free(is_anchor);
    return rank == 0;
}

static bool is_conflict(const struct editing *s) {
    return s->err.kind == ERR_REFUSAL && strstr(s->err.message, "whatever other points do");
}

struct group {
    struct decles_edit edit;
    struct decles_motion motion;
    struct decles_anchor anchor[400];
};

static void fill_group(struct group *b, const struct editing *s, const uint32_t *p, size_t n) {
    INVARIANT(n <= 400);
    memset(b, 0, sizeof *b);
    b->motion.by[0] = 0.04 * s->magnitude;
    b->edit = (struct decles_edit){
        .anchor_count = n, .anchor = b->anchor, .motion_count = 1, .motion = &b->motion};
    for (size_t i = 0; i < n; i++) {
        b->anchor[i].point = p[i];
        b->anchor[i].to[0] = s->q[2 * p[i]] + b->motion.by[0];
        b->anchor[i].to[1] = s->q[2 * p[i] + 1];
    }
}

static void scatter_anchors(struct group *b, const struct editing *s, uint64_t *random) {
    for (size_t i = 0; i < b->edit.anchor_count; i++)
        for (int c = 0; c < 2; c++)
            b->anchor[i].to[c] += (random_unit(random) - 0.5) * 0.05 * s->magnitude;
}

/* n anchors close to each other: points of one triangle and its neighbours. */
static void near_points(const struct grid *g, uint64_t *random, uint32_t *p, size_t n) {
    uint32_t t = (uint32_t)random_in(random, 0, g->triangle_count - 1), patch[GRID_PATCH_MAX];
    for (size_t i = 0; i < n; i++) {
        bool fresh;
        do {
            uint32_t e = g->triangle_edge[t][random_in(random, 0, 2)];
            uint32_t u = g->edge_triangle[e][random_in(random, 0, 1)];
            grid_patch(g, u == GRID_NONE ? t : u, patch);
            p[i] = patch[random_in(random, 0, grid_patch_size(g->degree) - 1)];
            fresh = true;
            for (size_t j = 0; j < i; j++) fresh = fresh && p[j] != p[i];
        } while (!fresh);
    }
}

/* An edit with 2 to 5 anchors goes through exactly if some C1 spline could do it. */
static void feasible_as_with_all_points(void **state) {
    (void)state;
    int free_count = 0, grown = 0, bound = 0, runs = test_count(150);
    if (runs < 150) runs = 150; /* all three kinds must occur */
    for (int run = 0; run < runs; run++) {
        uint64_t seed = 5000 + (uint64_t)run, random = seed;
        uint32_t p[12];
        size_t n = (size_t)random_in(&random, 2, run % 3 ? 5 : 12);
        struct grid g;
        struct editing s;
        struct group b;
        bool expected;
        do random_grid(&g, 2, 5 + run % 2, random++);
        while (g.point_count < 40 && (grid_free(&g), true));
        editing_begin(&s, &g, 1, INFINITY, seed);
        near_points(&s.g, &random, p, n);
        for (uint32_t r = 0; r < s.g.point_count; r++) {
            bool anchor = false;
            for (size_t i = 0; i < n; i++) anchor = anchor || p[i] == r;
            if (!anchor && random_in(&random, 0, 99) < 3 * (run % 4)) decles_pin(s.editor, r, true);
        }
        fill_group(&b, &s, p, n);
        scatter_anchors(&b, &s, &random);
        expected = is_free(&s, p, n);
        check_seed(seed, editing_apply(&s, &b.edit, 2) == expected);
        check_seed(seed, expected || is_conflict(&s));
        if (expected && s.report.gain < 100) editing_check_c1(&s);
        free_count += expected;
        grown += expected && s.report.added > 0;
        bound += !expected;
        editing_end(&s);
    }
    assert_true(free_count > 0 && grown > 0 && bound > 0);
}

static uint32_t random_inner_edge(const struct grid *g, uint64_t *random) {
    uint32_t e;
    do e = (uint32_t)random_in(random, 0, g->edge_count - 1);
    while (!grid_edge_is_inner(g, e));
    return e;
}

/* The points of both triangles of an edge, each once. */
static size_t edge_points(const struct grid *g, uint32_t e, uint32_t *p) {
    uint32_t patch[GRID_PATCH_MAX];
    size_t first = (size_t)grid_patch_size(g->degree), n = first;
    grid_patch(g, g->edge_triangle[e][0], p);
    grid_patch(g, g->edge_triangle[e][1], patch);
    for (size_t i = 0; i < first; i++) {
        bool fresh = true;
        for (size_t j = 0; j < first; j++) fresh = fresh && p[j] != patch[i];
        if (fresh) p[n++] = patch[i];
    }
    return n;
}

/* The group turns, grows or moves. */
static void move_group(struct group *b, const struct editing *s, uint64_t *random) {
    b->motion.kind = (enum decles_kind)random_in(random, 0, 2);
    b->motion.degrees = 360 * random_unit(random) - 180;
    b->motion.factor = 0.5 + random_unit(random);
    for (int c = 0; c < 2; c++) b->motion.centre[c] = (4 * random_unit(random) - 2) * s->magnitude;
    struct decles_turn turn = decles_turn(&b->motion, 1);
    for (size_t i = 0; i < b->edit.anchor_count; i++)
        decles_move(&b->motion, 1, turn, s->q + 2 * b->anchor[i].point, 2, b->anchor[i].to);
}

/* All points of two neighbouring triangles move together: over-determined, but they agree. One of
 * them displaced by 1e-9 of the extent, or more, breaks a condition of anchors alone: a row of A_D
 * that is zero, which the paper's 4.3.2 would drop. */
static void rigid_groups(void **state) {
    (void)state;
    for (int run = 0, runs = test_count(60); run < runs; run++) {
        uint64_t seed = 6000 + (uint64_t)run, random = seed;
        uint32_t p[2 * GRID_PATCH_MAX];
        struct grid g;
        struct editing s;
        struct group b;
        do random_grid(&g, 3, 5 + run % 3, random++);
        while (g.triangle_count < 6 && (grid_free(&g), true));
        editing_begin(&s, &g, 1, 1e6, seed);
        uint32_t e = random_inner_edge(&s.g, &random);
        size_t n = edge_points(&s.g, e, p);
        for (int turns = 0; turns < 3; turns++) {
            fill_group(&b, &s, p, n);
            move_group(&b, &s, &random);
            check_seed(seed, editing_apply(&s, &b.edit, 2));
            for (size_t i = 0; i < 2 * (size_t)s.g.point_count; i++)
                s.magnitude = fmax(s.magnitude, fabs(s.q[i]));
            editing_check_c1(&s);
            editing_check_solution(&s, NULL, 2);
        }
        fill_group(&b, &s, p, n);
        for (int m = 0; m < s.g.degree; m++) {
            struct c1_condition c = c1_condition(&s.g, e, m);
            int i = (int)random_in(&random, 0, 3);
            double off = pow(10, -9 + 9 * random_unit(&random) * (m > 0)) * s.magnitude;
            for (size_t j = 0; j < n; j++)
                if (p[j] == c.point[i]) b.anchor[j].to[1] += off;
            if (c.coefficient[i] != 0) {
                check_seed(seed, !editing_apply(&s, &b.edit, 2));
                check_seed(seed, is_conflict(&s));
            }
            fill_group(&b, &s, p, n);
        }
        editing_end(&s);
    }
}

/* The four points of one condition as anchors, in conflict: the message names them all, and the
 * edge. */
static void conflict_is_named(void **state) {
    (void)state;
    struct recipe recipe = {.nx = 3, .ny = 3, .spacing = 10, .components = 1};
    struct err err = {0};
    struct grid g;
    struct editing s;
    struct group b;
    char name[40];
    uint64_t random = 1;
    triangulate(&g, &recipe, 5, 1);
    assert_true(grid_build(&g, &err));
    editing_begin(&s, &g, 1, 100, 1);
    uint32_t e = random_inner_edge(&s.g, &random);
    struct c1_condition c = c1_condition(&s.g, e, 2);
    fill_group(&b, &s, c.point, 4);
    assert_true(editing_apply(&s, &b.edit, 2));
    fill_group(&b, &s, c.point, 4);
    b.anchor[0].to[0] += 1;
    assert_false(editing_apply(&s, &b.edit, 2));
    assert_true(is_conflict(&s));
    for (int i = 0; i < 4; i++) {
        snprintf(name, sizeof name, "%u", c.point[i]);
        assert_non_null(strstr(s.err.message, name));
    }
    snprintf(name, sizeof name, "%u-%u", s.g.edge[e][0], s.g.edge[e][1]);
    assert_non_null(strstr(s.err.message, name));
    decles_pin(s.editor, c.point[3], true); /* three anchors and a pin in the way */
    fill_group(&b, &s, c.point, 3);
    assert_false(editing_apply(&s, &b.edit, 2));
    snprintf(name, sizeof name, "pinned points %u", c.point[3]);
    assert_non_null(strstr(s.err.message, name));
    fill_group(&b, &s, c.point, 4);
    assert_false(editing_apply(&s, &b.edit, 2));
    snprintf(name, sizeof name, "anchor %u is pinned", c.point[3]);
    assert_string_equal(s.err.message, name);
    editing_end(&s);
}

/* Step 0: every broken condition that an edit touches is found, and its edge named; conditions that
 * it does not touch are not looked at. */
static void broken_input(void **state) {
    (void)state;
    struct recipe recipe = {.nx = 4, .ny = 4, .spacing = 10, .components = 1};
    struct err err = {0};
    struct grid g;
    struct editing s;
    char name[40];
    triangulate(&g, &recipe, 5, 1);
    assert_true(grid_build(&g, &err));
    editing_begin(&s, &g, 1, 100, 1);
    for (uint32_t e = 0; e < s.g.edge_count; e++) {
        struct c1_condition c;
        double kept;
        if (!grid_edge_is_inner(&s.g, e)) continue;
        c = c1_condition(&s.g, e, 2); /* its extremes are in no other condition */
        kept = s.q[2 * c.point[0] + 1];
        s.q[2 * c.point[0] + 1] += 1e-11;
        assert_false(editing_move(&s, c.point[1], 1, 1));
        snprintf(name, sizeof name, "not C1 across the edge %u-%u:", s.g.edge[e][0],
                 s.g.edge[e][1]);
        assert_non_null(strstr(s.err.message, name));
        bool touched = s.g.edge[e][0] == 0 || s.g.edge[e][1] == 0;
        assert_true(editing_move(&s, 0, 0.1, 0.1) != touched);
        editing_undo(&s);
        s.q[2 * c.point[0] + 1] = kept;
    }
    editing_end(&s);
}

/* The edge corner at the end `from` of the edge between two vertices. */
static uint32_t edge_corner(const struct grid *g, uint32_t from, uint32_t to) {
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        int w[3] = {0, 0, 0};
        for (int l = 0; l < 3; l++) {
            if (g->triangle[t][l] == from) w[l] = g->degree - 1;
            if (g->triangle[t][l] == to) w[l] = 1;
        }
        if (w[0] + w[1] + w[2] == g->degree) return grid_point(g, t, w[0], w[1], w[2]);
    }
    fail_msg("no such edge");
    return 0;
}

/* One square with both diagonals; vertex 0 lies `off` steps off its place. */
static void begin_crossed(struct editing *s, int32_t off, double max_gain) {
    struct recipe recipe = {.nx = 1, .ny = 1, .spacing = 32000, .crossed = true, .components = 1};
    struct err err = {0};
    struct grid g;
    triangulate(&g, &recipe, 5, 1);
    g.vertex[0][0] += off;
    assert_true(grid_build(&g, &err));
    editing_begin(s, &g, 1, max_gain, 1);
}

/* The edge corners on opposite edges of the centre 4: one moves, one stays; as a third anchor, also
 * the centre stays. If the centre is singular, the three lie on a line, and keep its proportions:
 * the centre must come along (step 3 adds it), or there is a conflict. If the slopes differ by
 * 1/32000, no condition says so, but other points are thrown far out. */
static void move_opposite(struct editing *s, int32_t off, double max_gain, size_t anchors,
                          bool *done) {
    struct group b;
    uint32_t p[3];
    begin_crossed(s, off, max_gain);
    p[0] = edge_corner(&s->g, 4, 0);
    p[1] = edge_corner(&s->g, 4, 3);
    p[2] = 4;
    fill_group(&b, s, p, anchors);
    for (size_t i = 1; i < anchors; i++)
        memcpy(b.anchor[i].to, s->q + 2 * p[i], sizeof b.anchor[i].to);
    *done = editing_apply(s, &b.edit, 2);
}

static void near_singular_vertex(void **state) {
    (void)state;
    struct editing s;
    bool done;
    move_opposite(&s, 0, 100, 2, &done);
    assert_true(done && s.report.added == 1 && s.report.gain <= 1);
    editing_check_c1(&s);
    editing_end(&s);
    move_opposite(&s, 0, 100, 3, &done);
    assert_true(!done && is_conflict(&s));
    editing_end(&s);
    for (size_t anchors = 2; anchors <= 3; anchors++) {
        move_opposite(&s, 1, 100, anchors, &done);
        assert_false(done);
        assert_non_null(strstr(s.err.message, "times as far as what was asked for"));
        assert_true(s.report.gain > 10000);
        editing_end(&s);
        move_opposite(&s, 1, INFINITY, anchors, &done);
        assert_true(done && s.report.added == 0 && s.report.gain > 10000);
        s.magnitude = s.report.displacement;
        editing_check_c1(&s);
        editing_end(&s);
    }
}

static void refused_at_once(void **state) {
    (void)state;
    struct decles_options options = {1, 100};
    struct err err = {0};
    struct grid g;
    struct editing s;
    struct group b;
    random_grid(&g, 2, 4, 1);
    assert_null(decles_new(&g, &options, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message,
                        "editing with continuity 1 needs degree 5 or more, the grid has 4");
    editing_begin(&s, &g, 0, 100, 1);
    fill_group(&b, &s, (uint32_t[]){3, 5, 3}, 3);
    assert_false(decles_apply(s.editor, s.q, 2, 2, &b.edit, &s.report, &s.err));
    assert_int_equal(s.err.kind, ERR_INPUT);
    assert_string_equal(s.err.message, "point 3 is an anchor twice");
    assert_true(editing_move(&s, 3, 1, 1)); /* the marks were taken away */
    editing_end(&s);
}

static void move_all(struct group *b, const struct editing *s, double dx) {
    uint32_t all[400];
    for (uint32_t p = 0; p < s->g.point_count; p++) all[p % 400] = p;
    fill_group(b, s, all, s->g.point_count);
    for (uint32_t p = 0; p < s->g.point_count; p++) b->anchor[p].to[0] = s->q[2 * p] + dx;
}

/* Beyond the largest double: an anchor, a suggested position. With conditions their sums are the
 * limit, also for points that all move alike. */
static void huge_numbers(void **state) {
    (void)state;
    for (int continuity = 0; continuity <= 1; continuity++) {
        struct grid g;
        struct editing s;
        struct group b;
        random_grid(&g, 2, 5, 1);
        editing_begin(&s, &g, continuity, 100, 1);
        fill_group(&b, &s, (uint32_t[]){0}, 1);
        b.anchor[0].to[0] = INFINITY;
        assert_false(editing_apply(&s, &b.edit, 2));
        assert_string_equal(s.err.message,
                            continuity == 0
                                ? "point 0 would leave the range of numbers, 1.8e+308 either way"
                                : "point 0 would leave the range of numbers, 9.7e+288 either way");
        fill_group(&b, &s, (uint32_t[]){0}, 1);
        b.edit.slave_count = 1;
        b.edit.slave = (uint32_t[]){1};
        b.motion.kind = DECLES_SCALE;
        b.motion.factor = DBL_MAX;
        b.motion.centre[0] = b.motion.centre[1] = -DBL_MAX;
        assert_false(editing_apply(&s, &b.edit, 2));
        assert_non_null(strstr(s.err.message, "would leave the range of numbers"));
        fill_group(&b, &s, (uint32_t[]){0}, 1);
        b.anchor[0].to[0] = DBL_MAX;
        assert_true(editing_apply(&s, &b.edit, 2) == (continuity == 0));
        for (int e = 959; continuity == 1 && e <= 961; e += 2) {
            move_all(&b, &s, ldexp(1, e));
            assert_true(editing_apply(&s, &b.edit, 2) == (e == 959));
            if (e == 959)
                editing_undo(&s);
            else
                assert_non_null(strstr(s.err.message, "would leave the range of numbers"));
        }
        editing_end(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(feasible_as_with_all_points),
        cmocka_unit_test(rigid_groups),
        cmocka_unit_test(conflict_is_named),
        cmocka_unit_test(broken_input),
        cmocka_unit_test(near_singular_vertex),
        cmocka_unit_test(refused_at_once),
        cmocka_unit_test(huge_numbers),
    };
    return cmocka_run_group_tests_name("decles_rank", tests, NULL, NULL);
}
