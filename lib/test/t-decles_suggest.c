/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Suggested positions against all distances by brute force, and libm. */
#include "editing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FAR = 1000000 };

/* Distances from p in the global net: neighbours are the points of a triangle whose weights differ
 * by 1, 1 and 0. Bellman and Ford, without a queue. */
static void distances(const struct grid *g, uint32_t from, int *distance) {
    bool changed = true;
    for (uint32_t p = 0; p < g->point_count; p++) distance[p] = p == from ? 0 : FAR;
    while (changed) {
        changed = false;
        for (uint32_t t = 0; t < g->triangle_count; t++)
            for (int i = 0; i <= g->degree; i++)
                for (int j = 0; i + j <= g->degree; j++)
                    for (int di = -1; di <= 1; di++)
                        for (int dj = -1; dj <= 1; dj++) {
                            int k = g->degree - i - j, a = i + di, b = j + dj, c = k - di - dj;
                            uint32_t p, r;
                            if (di == dj || a < 0 || b < 0 || c < 0) continue;
                            p = grid_point(g, t, i, j, k);
                            r = grid_point(g, t, a, b, c);
                            if (distance[r] <= distance[p] + 1) continue;
                            distance[r] = distance[p] + 1;
                            changed = true;
                        }
    }
}

struct plan {
    struct decles_edit edit;
    struct decles_anchor anchor[8];
    struct decles_motion motion[8];
    struct decles_wish wish[2];
    uint32_t slave[60];
};

/* Some anchors share motions. */
static void fill_plan(struct plan *b, const struct editing *s, uint64_t *random, int k) {
    size_t anchors = (size_t)random_in(random, 1, 8), slaves = (size_t)random_in(random, 0, 60),
           wishes = (size_t)random_in(random, 0, 2);
    uint32_t p[70];
    memset(b, 0, sizeof *b);
    random_points(&s->g, random, p, anchors + slaves + wishes);
    b->edit = (struct decles_edit){anchors,  slaves,    8,       wishes, b->anchor,
                                   b->slave, b->motion, b->wish, 0};
    for (int m = 0; m < 8; m++) {
        b->motion[m].kind = k == 1 ? DECLES_TRANSLATE : (enum decles_kind)random_in(random, 0, 2);
        for (int c = 0; c < 2; c++) {
            b->motion[m].by[c] = random_unit(random) * s->magnitude;
            b->motion[m].centre[c] = random_unit(random) * s->magnitude;
        }
        b->motion[m].degrees = 720 * random_unit(random) - 360;
        b->motion[m].factor = 0.5 + random_unit(random);
    }
    for (size_t i = 0; i < anchors; i++) {
        b->anchor[i].point = p[i];
        b->anchor[i].motion = (uint32_t)random_in(random, 0, k == 1 ? 0 : 7);
        memcpy(b->anchor[i].to, s->q + 2 * p[i], sizeof b->anchor[i].to);
    }
    memcpy(b->slave, p + anchors, slaves * sizeof *p);
    for (size_t i = 0; i < wishes; i++)
        b->wish[i] = (struct decles_wish){p[anchors + slaves + i], {3.5, -2}};
}

static void carry(const struct decles_motion *m, double theta, const double *q, double to[2]) {
    const double pi = 3.14159265358979323846;
    double x = q[0] - m->centre[0], y = q[1] - m->centre[1], turn = theta * m->degrees * pi / 180;
    double factor = pow(m->factor, theta);
    to[0] = q[0] + theta * m->by[0];
    to[1] = q[1] + theta * m->by[1];
    if (m->kind == DECLES_ROTATE) {
        to[0] = m->centre[0] + cos(turn) * x - sin(turn) * y;
        to[1] = m->centre[1] + sin(turn) * x + cos(turn) * y;
    } else if (m->kind == DECLES_SCALE) {
        to[0] = m->centre[0] + factor * x;
        to[1] = m->centre[1] + factor * y;
    }
}

static void expect(const struct editing *s, const struct plan *b, uint32_t p, double to[2]) {
    const struct grid *g = &s->g;
    int *distance = malloc(g->point_count * sizeof *distance), near = FAR, far = FAR, count = 0;
    char *inside = calloc(g->point_count, 1);
    const double *q = s->old + 2 * p;
    distances(g, p, distance);
    for (size_t i = 0; i < s->report.derived; i++) inside[s->report.derived_point[i]] = 1;
    for (size_t i = 0; i < b->edit.anchor_count; i++) {
        inside[b->anchor[i].point] = 1;
        if (distance[b->anchor[i].point] < near) near = distance[b->anchor[i].point];
    }
    for (uint32_t r = 0; r < g->point_count; r++)
        if (!inside[r] && distance[r] < far) far = distance[r];
    to[0] = to[1] = 0;
    for (size_t i = 0; i < b->edit.anchor_count; i++) {
        double each[2];
        if (near == FAR || distance[b->anchor[i].point] != near) continue;
        carry(&b->motion[b->anchor[i].motion], far == FAR ? 1 : far / (double)(near + far), q,
              each);
        to[0] += each[0];
        to[1] += each[1];
        count++;
    }
    for (int c = 0; c < 2; c++) to[c] = count > 0 ? to[c] / count : q[c];
    for (size_t i = 0; i < b->edit.wish_count; i++)
        if (b->wish[i].point == p) memcpy(to, b->wish[i].to, sizeof b->wish[i].to);
    free(distance);
    free(inside);
}

/* No edit is refused: without continuity the suggestions are all there is, and D = S; with it, the
 * anchors stay where they are, while the suggestions for the others are as wild as without. */
static void suggestions(void **state) {
    (void)state;
    for (int run = 0, n = test_count(40); run < n; run++) {
        uint64_t seed = 7000 + (uint64_t)run, random = seed;
        int k = 1 + run % 2;
        struct grid g;
        struct editing s;
        struct plan b;
        do random_grid(&g, 2, 2 + run % 5, random++);
        while (g.point_count < 70 && (grid_free(&g), true));
        editing_begin(&s, &g, g.degree >= 5 && run % 3 > 0, INFINITY, seed);
        for (int edit = 0; edit < 3; edit++) {
            fill_plan(&b, &s, &random, k);
            check_seed(seed, editing_apply(&s, &b.edit, k));
            for (size_t i = 0; i < s.report.derived; i++) {
                double to[2];
                expect(&s, &b, s.report.derived_point[i], to);
                for (int c = 0; c < k; c++)
                    check_seed(seed, fabs(to[c] - s.report.suggested[i * (size_t)k + (size_t)c]) <=
                                         1e-13 * (s.magnitude + fabs(to[c])));
            }
            editing_undo(&s);
        }
        editing_end(&s);
    }
}

/* All points turn about an anchor that stays: theta = 1, and the turn is exact. */
static void everything_turns(void **state) {
    (void)state;
    struct recipe recipe = {.nx = 3, .ny = 3, .spacing = 10, .components = 1};
    struct err err = {0};
    struct grid g;
    struct editing s;
    uint32_t *all;
    struct decles_motion motion = {.kind = DECLES_ROTATE, .centre = {10, 20}, .degrees = 90};
    struct decles_anchor anchor = {0, 0, {30, 10}};
    struct decles_edit edit = {
        .anchor_count = 1, .anchor = &anchor, .motion_count = 1, .motion = &motion};
    triangulate(&g, &recipe, 5, 1);
    assert_true(grid_build(&g, &err));
    editing_begin(&s, &g, 1, 100, 1);
    all = malloc(s.g.point_count * sizeof *all);
    for (uint32_t p = 0; p < s.g.point_count; p++) all[p] = p;
    edit.slave_count = s.g.point_count;
    edit.slave = all;
    assert_true(editing_apply(&s, &edit, 2));
    assert_int_equal(s.report.derived, s.g.point_count - 1);
    for (uint32_t p = 0; p < s.g.point_count; p++) {
        assert_true(fabs(s.q[2 * p] - (10 - (s.old[2 * p + 1] - 20))) < 1e-13);
        assert_true(fabs(s.q[2 * p + 1] - (20 + (s.old[2 * p] - 10))) < 1e-13);
    }
    free(all);
    editing_end(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(suggestions),
        cmocka_unit_test(everything_turns),
    };
    return cmocka_run_group_tests_name("decles_suggest", tests, NULL, NULL);
}
