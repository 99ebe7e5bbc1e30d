/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sets D and E, single anchors, many edits, the solution. */
#include "editing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void regular(struct grid *g, int nx, int ny, int degree) {
    struct recipe recipe = {.nx = nx, .ny = ny, .spacing = 10, .components = 1};
    struct err err = {0};
    triangulate(g, &recipe, degree, 1);
    assert_true(grid_build(g, &err));
}

/* A point by its weights against vertices a, b, c. */
static uint32_t point_of(const struct grid *g, uint32_t a, int i, uint32_t b, int j, uint32_t c,
                         int k) {
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        int w[3] = {-1, -1, -1};
        for (int l = 0; l < 3; l++) {
            if (g->triangle[t][l] == a) w[l] = i;
            if (g->triangle[t][l] == b) w[l] = j;
            if (g->triangle[t][l] == c) w[l] = k;
        }
        if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) return grid_point(g, t, w[0], w[1], w[2]);
    }
    fail_msg("no such triangle");
    return 0;
}

static void expect_counts(struct editing *s, uint32_t p, size_t derived, size_t conditions) {
    assert_true(editing_move(s, p, 0.5, -0.25));
    assert_int_equal(s->report.anchors, 1);
    assert_int_equal(s->report.derived, derived);
    assert_int_equal(s->report.conditions, conditions);
    assert_int_equal(s->report.added, 0);
    editing_check_c1(s);
    editing_check_solution(s, NULL, 2);
    editing_undo(s);
}

/* 3 x 3 vertices; 4 is the inner one, of degree 6; 4-5-8 is a triangle. */
static void counts_at_an_inner_vertex(void **state) {
    (void)state;
    struct grid g;
    struct editing s;
    regular(&g, 2, 2, 5);
    editing_begin(&s, &g, 1, 100, 1);
    expect_counts(&s, 4, 30, 18);
    expect_counts(&s, point_of(&s.g, 4, 4, 5, 1, 8, 0), 29, 18);
    expect_counts(&s, point_of(&s.g, 4, 3, 5, 2, 8, 0), 23, 12);
    expect_counts(&s, point_of(&s.g, 4, 3, 5, 1, 8, 1), 23, 12);
    expect_counts(&s, point_of(&s.g, 4, 2, 5, 2, 8, 1), 1, 1);
    editing_end(&s);
}

/* [14] figure 14: an edge point between two triangles alone. */
static void counts_of_figure_14(void **state) {
    (void)state;
    struct grid g;
    struct editing s;
    regular(&g, 1, 1, 5);
    editing_begin(&s, &g, 1, 100, 1);
    expect_counts(&s, point_of(&s.g, 0, 3, 3, 2, 1, 0), 4, 2);
    editing_end(&s);
}

/* Step 2 by brute force, over all points and conditions. */
struct closure {
    const struct grid *g;
    char *in;
};

static bool has_condition(const struct grid *g, uint32_t p) {
    for (uint32_t e = 0; e < g->edge_count; e++)
        for (int m = 0; grid_edge_is_inner(g, e) && m < g->degree; m++) {
            struct c1_condition c = c1_condition(g, e, m);
            for (int i = 0; i < 4; i++)
                if (c.point[i] == p && c.coefficient[i] != 0) return true;
        }
    return false;
}

static void add_middle(struct closure *d, uint32_t p) {
    for (uint32_t e = 0; e < d->g->edge_count; e++)
        for (int m = 2; grid_edge_is_inner(d->g, e) && m <= d->g->degree - 3; m++) {
            struct c1_condition c = c1_condition(d->g, e, m);
            if (c.point[2] == p || c.point[3] == p) d->in[c.point[0]] = d->in[c.point[1]] = 1;
        }
}

/* All points with the given weight against v; with middle conditions for those on edges. */
static void add_ring(struct closure *d, uint32_t v, int weight) {
    for (uint32_t t = 0; t < d->g->triangle_count; t++)
        for (int l = 0; l < 3; l++) {
            if (d->g->triangle[t][l] != v) continue;
            for (int k = 0; k <= d->g->degree - weight; k++) {
                int w[3];
                uint32_t p;
                w[l] = weight;
                w[(l + 1) % 3] = k;
                w[(l + 2) % 3] = d->g->degree - weight - k;
                p = grid_point(d->g, t, w[0], w[1], w[2]);
                d->in[p] = 1;
                if (c1_type(d->g, p) == TYPE_EDGE) add_middle(d, p);
            }
        }
}

static void expect_closure(const struct grid *g, uint32_t p, char *in) {
    struct closure d = {g, in};
    struct grid_place place = grid_place(g, p);
    const uint32_t *corner = g->triangle[place.triangle];
    memset(in, 0, g->point_count);
    for (int l = 0; l < 3; l++) {
        if (place.weight[l] >= g->degree - 1) add_ring(&d, corner[l], g->degree - 1);
        if (place.weight[l] >= g->degree - 2) add_ring(&d, corner[l], g->degree - 2);
    }
    if (c1_type(g, p) == TYPE_EDGE) add_middle(&d, p);
    for (uint32_t e = 0; c1_type(g, p) == TYPE_INNER_EDGE && e < g->edge_count; e++)
        for (int m = 2; grid_edge_is_inner(g, e) && m <= g->degree - 3; m++) {
            struct c1_condition c = c1_condition(g, e, m);
            if (c.point[0] == p || c.point[1] == p) in[c.point[0]] = in[c.point[1]] = 1;
        }
    for (uint32_t r = 0; r < g->point_count; r++) in[r] = in[r] && r != p && has_condition(g, r);
}

static void every_point_as_anchor(void **state) {
    (void)state;
    for (int run = 0, n = test_count(10); run < n; run++) {
        uint64_t seed = 1000 + (uint64_t)run, random = seed;
        struct grid g;
        struct editing s;
        random_grid(&g, 2, 5 + run % 3, seed);
        editing_begin(&s, &g, 1, INFINITY, seed);
        char *in = malloc(s.g.point_count);
        for (uint32_t p = 0; p < s.g.point_count; p++) {
            double dx = random_unit(&random) - 0.5, dy = random_unit(&random) - 0.5;
            size_t count = 0;
            check_seed(seed, editing_move(&s, p, dx * s.magnitude, dy * s.magnitude));
            check_seed(seed, s.report.added == 0);
            expect_closure(&s.g, p, in);
            for (uint32_t r = 0; r < s.g.point_count; r++) count += in[r] != 0;
            check_seed(seed, count == s.report.derived);
            for (size_t i = 0; i < s.report.derived; i++)
                check_seed(seed, in[s.report.derived_point[i]]);
            if (s.report.gain < 100) {
                editing_check_c1(&s);
                editing_check_solution(&s, NULL, 2);
            }
            editing_undo(&s);
        }
        free(in);
        editing_end(&s);
    }
}

/* A random edit: anchors, motions, slaves and wishes. */
struct random_edit {
    struct decles_edit edit;
    struct decles_anchor anchor[6];
    struct decles_motion motion[6];
    struct decles_wish wish[3];
    uint32_t slave[30];
};

static struct decles_motion random_motion(const struct editing *s, uint64_t *random, int k) {
    struct decles_motion m = {.kind = k == 1 ? DECLES_TRANSLATE
                                             : (enum decles_kind)random_in(random, 0, 2)};
    for (int c = 0; c < 2; c++) {
        m.by[c] = (random_unit(random) - 0.5) * s->magnitude * 0.1;
        m.centre[c] = (random_unit(random) - 0.5) * s->magnitude;
    }
    m.degrees = random_unit(random) * 20 - 10;
    m.factor = 0.9 + 0.2 * random_unit(random);
    return m;
}

static void carry(const struct decles_motion *m, const double *q, double to[2]) {
    const double pi = 3.14159265358979323846;
    double x = q[0] - m->centre[0], y = q[1] - m->centre[1], angle = m->degrees * pi / 180;
    to[0] = q[0] + m->by[0];
    to[1] = q[1] + m->by[1];
    if (m->kind == DECLES_ROTATE) {
        to[0] = m->centre[0] + cos(angle) * x - sin(angle) * y;
        to[1] = m->centre[1] + sin(angle) * x + cos(angle) * y;
    } else if (m->kind == DECLES_SCALE) {
        to[0] = m->centre[0] + m->factor * x;
        to[1] = m->centre[1] + m->factor * y;
    }
}

static void fill_edit(struct random_edit *r, const struct editing *s, uint64_t *random, int k,
                      size_t anchors) {
    uint32_t points[39];
    size_t slaves = random_in(random, 0, 1) ? (size_t)random_in(random, 0, 30) : 0,
           wishes = random_in(random, 0, 2) ? 0 : (size_t)random_in(random, 1, 3);
    memset(r, 0, sizeof *r);
    random_points(&s->g, random, points, anchors + slaves + wishes);
    r->edit = (struct decles_edit){anchors,  slaves,    anchors, wishes, r->anchor,
                                   r->slave, r->motion, r->wish, 0};
    for (size_t i = 0; i < anchors; i++) {
        r->motion[i] = random_motion(s, random, k);
        r->anchor[i].point = points[i];
        r->anchor[i].motion = (uint32_t)i;
        carry(&r->motion[i], s->q + 2 * points[i], r->anchor[i].to);
    }
    memcpy(r->slave, points + anchors, slaves * sizeof *points);
    for (size_t i = 0; i < wishes; i++) {
        const double *q = s->q + 2 * points[anchors + slaves + i];
        r->wish[i].point = points[anchors + slaves + i];
        for (int c = 0; c < 2; c++)
            r->wish[i].to[c] = q[c] + (random_unit(random) - 0.5) * s->magnitude * 0.1;
    }
}

/* Is the refusal one that the mathematics demands (a conflict, a gain)? */
static bool is_honest(const struct editing *s) {
    return strstr(s->err.message, "whatever other points do") ||
           strstr(s->err.message, "what was asked for");
}

static void solution_is_the_least_one(void **state) {
    (void)state;
    for (int run = 0, n = test_count(60); run < n; run++) {
        uint64_t seed = 2000 + (uint64_t)run, random = seed;
        struct grid g;
        struct editing s;
        struct random_edit r;
        random_grid(&g, 3, 5 + run % 4, seed);
        editing_begin(&s, &g, 1, 100, seed);
        double *weight = malloc(s.g.point_count * sizeof *weight);
        for (uint32_t p = 0; p < s.g.point_count; p++) {
            weight[p] = random_in(&random, 0, 1)
                            ? 1
                            : ldexp(1 + random_unit(&random), (int)random_in(&random, -4, 4));
            decles_weigh(s.editor, p, weight[p]);
            if (random_in(&random, 0, 40) == 0) decles_pin(s.editor, p, true);
        }
        for (int edit = 0; edit < 12; edit++) {
            int k = 1 + (int)random_in(&random, 0, 1);
            fill_edit(&r, &s, &random, k, (size_t)random_in(&random, 1, 4));
            if (!editing_apply(&s, &r.edit, k)) {
                bool pinned = false;
                for (size_t i = 0; i < r.edit.anchor_count; i++)
                    pinned = pinned || decles_is_pinned(s.editor, r.anchor[i].point);
                check_seed(seed, pinned == (strstr(s.err.message, "pinned") && !is_honest(&s)));
                check_seed(seed, pinned || is_honest(&s));
                continue;
            }
            editing_check_solution(&s, weight, k);
            editing_check_c1(&s);
        }
        free(weight);
        editing_end(&s);
    }
}

/* Errors do not pile up on one grid, whatever the number of edits, and what an edit leaves passes
 * step 0 of the next. Points drift: the size of the map is that of the farthest. */
static void many_edits(void **state) {
    (void)state;
    for (int degree = 5; degree <= 7; degree++) {
        int wanted = test_count(1000) / (degree == 5 ? 1 : 4);
        uint64_t seed = 3000 + (uint64_t)degree, random = seed;
        struct grid g;
        struct editing s;
        struct random_edit r;
        random_grid(&g, 4, degree, seed);
        editing_begin(&s, &g, 1, 100, seed);
        for (int done = 0, tried = 0; done < wanted; tried++) {
            int k = 1 + (int)random_in(&random, 0, 1);
            fill_edit(&r, &s, &random, k, (size_t)random_in(&random, 1, 3));
            if (editing_apply(&s, &r.edit, k))
                done++;
            else
                check_seed(seed, is_honest(&s) && tried < 4 * wanted + 100);
        }
        for (size_t i = 0; i < 2 * (size_t)s.g.point_count; i++)
            s.magnitude = fmax(s.magnitude, fabs(s.q[i]));
        editing_check_c1(&s);
        editing_end(&s);
    }
}

/* Around singular vertices ring 2 has a relation of its own, tied to the roundings of ring 1. What
 * they leave in the dropped condition must stay small, and not grow from edit to edit. */
static void singular_grids_stay_c1(void **state) {
    (void)state;
    for (int run = 0, n = test_count(10); run < n; run++) {
        uint64_t seed = 4000 + (uint64_t)run, random = seed;
        struct recipe recipe = {.nx = 2, .ny = 2, .spacing = 2, .crossed = true, .components = 1};
        int64_t a = random_in(&random, 1, 2000), b = random_in(&random, -3000, 3000),
                d = random_in(&random, 1, 2000);
        struct err err = {0};
        struct grid g;
        struct editing s;
        struct random_edit r;
        triangulate(&g, &recipe, 5, seed);
        for (uint32_t v = 0; v < g.vertex_count; v++) { /* an affine map keeps them singular */
            int64_t x = g.vertex[v][0], y = g.vertex[v][1];
            g.vertex[v][0] = (int32_t)(a * x + b * y);
            g.vertex[v][1] = (int32_t)(d * y);
        }
        check_seed(seed, grid_build(&g, &err));
        editing_begin(&s, &g, 1, 100, seed);
        for (int i = 0; i < 1000; i++) {
            fill_edit(&r, &s, &random, 2, (size_t)random_in(&random, 1, 3));
            r.edit.slave_count = r.edit.wish_count = 0;
            check_seed(seed, editing_apply(&s, &r.edit, 2) || is_honest(&s));
        }
        editing_check_c1(&s);
        editing_end(&s);
    }
}

/* Two lines cross; the four arms are as unlike as the lattice allows. Four triangles. */
static void crossed_arms(struct grid *g, uint64_t *random) {
    struct err err = {0};
    const uint32_t triangle[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    *g = (struct grid){.degree = 5, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
    g->vertex_count = 5;
    g->triangle_count = 4;
    g->vertex = calloc(5, sizeof *g->vertex);
    g->triangle = calloc(4, sizeof *g->triangle);
    memcpy(g->triangle, triangle, sizeof triangle);
    for (int arm = 0; arm < 4; arm++) {
        int32_t length = 1 << random_in(random, 0, 15), sign = arm < 2 ? 1 : -1;
        g->vertex[1 + arm][0] = arm % 2 ? 0 : sign * length;
        g->vertex[1 + arm][1] = arm % 2 ? sign * length : 0;
    }
    assert_true(grid_build(g, &err));
}

static void singular_vertex_with_unlike_arms(void **state) {
    (void)state;
    for (int run = 0, n = test_count(40); run < n; run++) {
        uint64_t seed = 4300 + (uint64_t)run, random = seed;
        struct grid g;
        struct editing s;
        struct random_edit r;
        crossed_arms(&g, &random);
        editing_begin(&s, &g, 1, 100, seed);
        double worst = 0;
        for (int i = 0; i < 300; i++) {
            fill_edit(&r, &s, &random, 2, (size_t)random_in(&random, 1, 3));
            r.edit.slave_count = r.edit.wish_count = 0;
            if (editing_apply(&s, &r.edit, 2))
                worst = fmax(worst, s.report.residual);
            else
                check_seed(seed, is_honest(&s));
        }
        editing_check_c1(&s);
        check_seed(seed, worst <= 4 * 0x1p-53);
        editing_end(&s);
    }
}

/* Heights are often 0 over wide parts, and forced to stay so: what the solver leaves there must not
 * count as broken later. */
static void flat_heights(void **state) {
    (void)state;
    for (int run = 0, n = test_count(20); run < n; run++) {
        uint64_t seed = 4500 + (uint64_t)run, random = seed;
        struct grid g;
        struct editing s;
        struct random_edit r;
        random_grid(&g, 4, 5 + run % 3, seed);
        editing_begin(&s, &g, 1, 1000, seed);
        memset(s.q, 0, s.g.point_count * 2 * sizeof *s.q);
        for (uint32_t p = 0; p < s.g.point_count; p++)
            if (random_in(&random, 0, 20) == 0) decles_pin(s.editor, p, true);
        for (int i = 0; i < 100; i++) {
            fill_edit(&r, &s, &random, 1, (size_t)random_in(&random, 1, 3));
            if (!editing_apply(&s, &r.edit, 1))
                check_seed(seed, is_honest(&s) || strstr(s.err.message, "is pinned"));
        }
        editing_check_c1(&s);
        editing_end(&s);
    }
}

/* Continuity 0: D = S, and each goes exactly where it is suggested to. */
static void without_continuity(void **state) {
    (void)state;
    for (int run = 0, n = test_count(20); run < n; run++) {
        uint64_t seed = 4700 + (uint64_t)run, random = seed;
        struct grid g;
        struct editing s;
        struct random_edit r;
        random_grid(&g, 4, 1 + run % 8, seed);
        if (g.point_count < 60) {
            grid_free(&g);
            continue;
        }
        editing_begin(&s, &g, 0, 100, seed);
        for (int i = 0; i < 10; i++) {
            int k = 1 + i % 2;
            fill_edit(&r, &s, &random, k, 2);
            check_seed(seed, editing_apply(&s, &r.edit, k));
            check_seed(seed, s.report.conditions == 0 && s.report.derived == s.report.slaves);
            check_seed(seed, s.report.derived == r.edit.slave_count + r.edit.wish_count);
            for (size_t j = 0; j < s.report.derived; j++)
                check_seed(seed, memcmp(s.q + 2 * s.report.derived_point[j],
                                        s.report.suggested + j * (size_t)k,
                                        (size_t)k * sizeof *s.q) == 0);
        }
        editing_end(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts_at_an_inner_vertex),
        cmocka_unit_test(counts_of_figure_14),
        cmocka_unit_test(every_point_as_anchor),
        cmocka_unit_test(solution_is_the_least_one),
        cmocka_unit_test(many_edits),
        cmocka_unit_test(singular_grids_stay_c1),
        cmocka_unit_test(singular_vertex_with_unlike_arms),
        cmocka_unit_test(flat_heights),
        cmocka_unit_test(without_continuity),
    };
    return cmocka_run_group_tests_name("decles", tests, NULL, NULL);
}
