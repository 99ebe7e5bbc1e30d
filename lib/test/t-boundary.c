/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids that are rolled up, scattered, edited boldly: held against dense polylines of their
 * boundaries. */
#include "injective.h"

#include "curves.h"
#include "editing.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <string.h>

enum { CUTS = 24, SEGMENTS_MAX = 6000 };

/* The boundary as polylines. Points on a common edge or vertex have the same number. */
struct polylines {
    int count;
    double at[SEGMENTS_MAX][2][2];
    uint32_t point[SEGMENTS_MAX][2];
    uint32_t component[SEGMENTS_MAX];
    double error; /* no arc is farther from its polyline */
};

/* Lowest vertex that can be reached along edges. */
static void components_of(const struct grid *g, uint32_t *component) {
    bool changed = true;
    for (uint32_t v = 0; v < g->vertex_count; v++) component[v] = v;
    while (changed) {
        changed = false;
        for (uint32_t e = 0; e < g->edge_count; e++)
            for (int i = 0; i < 2; i++) {
                uint32_t v = g->edge[e][i], w = g->edge[e][1 - i];
                if (component[w] >= component[v]) continue;
                component[v] = component[w];
                changed = true;
            }
    }
}

static void add_edge(struct polylines *p, const struct spline *s, uint32_t e, uint32_t component) {
    const struct grid *g = &s->grid;
    uint32_t t = g->edge_triangle[e][0];
    int l = grid_opposite(g, t, e), d = g->degree, weight[3] = {0};
    double q[16][2], bend = 0;
    for (int k = 0; k <= d; k++) {
        weight[(l + 1) % 3] = d - k;
        weight[(l + 2) % 3] = k;
        memcpy(q[k], s->phi[grid_point(g, t, weight[0], weight[1], weight[2])], sizeof q[k]);
    }
    for (int k = 0; k + 2 <= d; k++)
        bend = fmax(bend, hypot(q[k][0] - 2 * q[k + 1][0] + q[k + 2][0],
                                q[k][1] - 2 * q[k + 1][1] + q[k + 2][1]));
    p->error = fmax(p->error, d * (d - 1) * bend / (8.0 * CUTS * CUTS));
    for (int i = 0; i < CUTS; i++) {
        int n = p->count++;
        assert_true(n < SEGMENTS_MAX);
        for (int end = 0; end < 2; end++) {
            int k = i + end;
            curve_point(d, (const double(*)[2])q, (double)k / CUTS, p->at[n][end]);
            p->point[n][end] = k == 0      ? g->triangle[t][(l + 1) % 3]
                               : k == CUTS ? g->triangle[t][(l + 2) % 3]
                                           : g->vertex_count + e * CUTS + (uint32_t)k;
        }
        p->component[n] = component;
    }
}

static void polylines_of(struct polylines *p, const struct spline *s) {
    const struct grid *g = &s->grid;
    uint32_t component[4096];
    assert_true(g->vertex_count <= 4096);
    components_of(g, component);
    p->count = 0;
    p->error = 0;
    for (uint32_t e = 0; e < g->edge_count; e++)
        if (!grid_edge_is_inner(g, e)) add_edge(p, s, e, component[g->edge[e][0]]);
}

struct truth {
    double
        depth; /* how far segments that cross reach beyond each other, at most; negative: none do */
    double distance; /* of segments that do not share a point; 0 if some cross; at most `far` */
    bool nested;
};

/* Are the segments' boxes farther apart than this? */
static bool are_far(const double (*a)[2], const double (*b)[2], double far) {
    for (int c = 0; c < 2; c++)
        if (fmin(a[0][c], a[1][c]) - fmax(b[0][c], b[1][c]) > far ||
            fmin(b[0][c], b[1][c]) - fmax(a[0][c], a[1][c]) > far)
            return true;
    return false;
}

static bool do_cross(const double (*a)[2], const double (*b)[2]) {
    return !are_far(a, b, 0) &&
           predicate_orient(a[0], a[1], b[0]) * predicate_orient(a[0], a[1], b[1]) <= 0 &&
           predicate_orient(b[0], b[1], a[0]) * predicate_orient(b[0], b[1], a[1]) <= 0;
}

static void compare_segments(const struct polylines *p, int i, int j, struct truth *truth) {
    const double(*a)[2] = (const double(*)[2])p->at[i], (*b)[2] = (const double(*)[2])p->at[j];
    double depth = INFINITY;
    for (int k = 0; k < 4; k++)
        if (p->point[i][k & 1] == p->point[j][k >> 1]) return;
    if (are_far(a, b, truth->distance)) return;
    for (int k = 0; k < 2; k++) {
        depth = fmin(depth, segment_distance(a[0], a[1], b[k]));
        depth = fmin(depth, segment_distance(b[0], b[1], a[k]));
    }
    if (do_cross(a, b)) truth->depth = fmax(truth->depth, depth);
    truth->distance = truth->depth >= 0 ? 0 : fmin(truth->distance, depth);
}

/* Winding number of the other components around a point of component c. */
static int winding(const struct polylines *p, uint32_t c, const double q[2]) {
    int n = 0;
    for (int i = 0; i < p->count; i++) {
        const double *a = p->at[i][0], *b = p->at[i][1];
        if (p->component[i] == c || (a[1] > q[1]) == (b[1] > q[1])) continue;
        if (predicate_orient(a, b, q) == (b[1] > a[1] ? 1 : -1)) n += b[1] > a[1] ? 1 : -1;
    }
    return n;
}

static struct truth brute(const struct polylines *p, double far) {
    struct truth truth = {.depth = -1, .distance = far};
    for (int i = 0; i < p->count; i++)
        for (int j = i + 1; j < p->count; j++) compare_segments(p, i, j, &truth);
    for (int i = 0; i < p->count && truth.distance > 0; i += CUTS)
        if (winding(p, p->component[i], p->at[i][0]) != 0) truth.nested = true;
    return truth;
}

/* Rolls the grid round the origin, as a ring or a spiral; `turns` is the ring's share of a turn. */
static void roll(struct spline *s, double turns, double climb, double shake, uint64_t *seed) {
    double lo[2] = {1e9, 1e9}, hi[2] = {-1e9, -1e9};
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int c = 0; c < 2; c++) {
            lo[c] = fmin(lo[c], s->phi[p][c]);
            hi[c] = fmax(hi[c], s->phi[p][c]);
        }
    for (uint32_t p = 0; p < s->grid.point_count; p++) {
        double u = (s->phi[p][0] - lo[0]) / (hi[0] - lo[0]);
        double v = (s->phi[p][1] - lo[1]) / (hi[1] - lo[1]);
        double radius = 2 - v + climb * u, angle = 6.283185307179586 * turns * u;
        s->phi[p][0] = radius * cos(angle) + shake * (random_unit(seed) - 0.5);
        s->phi[p][1] = radius * sin(angle) + shake * (random_unit(seed) - 0.5);
    }
}

/* Moves and scales components by themselves. */
static void scatter(struct spline *s, double by, uint64_t *seed) {
    const struct grid *g = &s->grid;
    uint32_t component[4096];
    double move[4096][3];
    components_of(g, component);
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        for (int c = 0; c < 2; c++) move[v][c] = by * (random_unit(seed) - 0.5);
        move[v][2] = random_bits(seed) & 1 ? 1 : 0.05 + 0.4 * random_unit(seed);
    }
    for (uint32_t p = 0; p < g->point_count; p++) {
        const double *m = move[component[g->triangle[grid_place(g, p).triangle][0]]];
        for (int c = 0; c < 2; c++) s->phi[p][c] = m[c] + m[2] * s->phi[p][c];
    }
}

static void check_global(const struct spline *s, int count[3], uint64_t seed) {
    static struct polylines lines;
    struct jacobian_report plane;
    struct injective j;
    struct truth truth;
    struct err err;
    enum meet_verdict met;
    bool local;
    assert_true(
        jacobian_report_init(&plane, s, JACOBIAN_PLANE, &jacobian_default_rule, false, &err));
    assert_true(injective_init(&j, s, &plane, NULL, &jacobian_default_rule, &err));
    local = plane.least.verdict == JACOBIAN_CERTIFIED && j.fans == FAN_SOUND;
    met = j.boundary.meet.verdict;
    polylines_of(&lines, s);
    truth = brute(&lines, 4 * lines.error + 1e-9);
    check_seed(seed, met != MEET_UNDECIDED && met != MEET_POINT);
    check_seed(seed, j.overlap.kind == OVERLAP_NONE);
    if (truth.depth > 2 * lines.error) check_seed(seed, met == MEET_CROSS);
    if (local && truth.distance > 2 * lines.error) check_seed(seed, met == MEET_NOT);
    if (met == MEET_NOT) check_seed(seed, (j.nesting.verdict == NESTING_INSIDE) == truth.nested);
    check_seed(seed, (j.phi == INJECTIVE_YES) ==
                         (local && met == MEET_NOT && j.nesting.verdict == NESTING_NONE));
    check_seed(seed, (j.phi == INJECTIVE_YES) == injective_prove(s, &err));
    count[j.phi == INJECTIVE_YES ? 0 : met == MEET_NOT ? 1 : 2]++;
    injective_free(&j);
    jacobian_report_free(&plane);
}

static void random_domain(struct grid *g, int components, int degree, uint64_t *seed) {
    struct recipe r = {.nx = (int)random_in(seed, 2, 6),
                       .ny = (int)random_in(seed, 1, 3),
                       .spacing = 840,
                       .jitter = random_bits(seed) & 1,
                       .flips = 1,
                       .removals = (int)random_in(seed, 0, 5),
                       .components = components};
    struct err err;
    triangulate(g, &r, degree, random_bits(seed));
    assert_true(grid_build(g, &err));
}

static void test_maps(void **state) {
    uint64_t seed = 21;
    int count[3] = {0};
    (void)state;
    for (int n = test_count(300); n > 0; n--) {
        uint64_t start = seed;
        struct grid g;
        struct spline s;
        struct err err;
        random_domain(&g, (int)random_in(&seed, 1, 2), (int)random_in(&seed, 1, 6), &seed);
        assert_true(spline_identity(&s, &g, &err));
        if (random_bits(&seed) & 1)
            scatter(&s, 840 * 9, &seed);
        else
            roll(&s, 0.5 + 0.8 * random_unit(&seed), random_unit(&seed) - 0.3,
                 random_bits(&seed) & 1 ? 0 : 0.1, &seed);
        check_global(&s, count, start);
        spline_free(&s);
    }
    for (int i = 0; i < 3; i++) assert_true(count[i] > 0);
}

/* Points of the boundary are moved far, and those that keep it C1 with them. */
static void test_edits(void **state) {
    uint64_t seed = 8;
    int count[3] = {0};
    (void)state;
    for (int n = test_count(300); n > 0; n--) {
        uint64_t start = seed;
        struct grid g;
        struct editing e;
        random_domain(&g, 1, 5, &seed);
        editing_begin(&e, &g, 1, 1e6, start);
        for (int k = (int)random_in(&seed, 1, 4); k > 0; k--) {
            uint32_t point = (uint32_t)random_in(&seed, 0, e.g.point_count - 1);
            (void)editing_move(&e, point, 1200 * (random_unit(&seed) - 0.5),
                               1200 * (random_unit(&seed) - 0.5));
        }
        check_global(&(struct spline){.grid = e.g, .phi = (double(*)[2])e.q}, count, start);
        editing_end(&e);
    }
    assert_true(count[0] > 0 && count[2] > 0);
}

/* Few values, so that points coincide; all alike; on a line; of all magnitudes; far out; the
 * largest and the least numbers. */
static double hostile(int kind, double x, int c, uint64_t *seed) {
    switch (kind) {
    case 0:
        return (double)random_in(seed, 0, 2);
    case 1:
        return 7;
    case 2:
        return c ? 0 : x;
    case 3:
        return ldexp(random_unit(seed) - 0.5, (int)random_in(seed, -1074, 1024));
    case 4:
        return x + 0x1p60;
    case 5:
        return 0x1.fp1023 * (random_unit(seed) * 2 - 1);
    default:
        return (double)random_in(seed, 0, 2) * 0x1p-1074;
    }
}

/* There is an answer, and it is no better than that of the certificate. */
static void test_hostile(void **state) {
    struct least_rule rule = {0.01, 0x1p-100, 64};
    uint64_t seed = 13;
    (void)state;
    for (int n = 0; n < test_count(70); n++) {
        uint64_t start = seed;
        struct jacobian_report plane;
        struct injective j;
        struct grid g;
        struct spline s;
        struct err err;
        random_domain(&g, 1, (int)random_in(&seed, 1, 7), &seed);
        assert_true(spline_identity(&s, &g, &err));
        for (uint32_t p = 0; p < s.grid.point_count; p++)
            for (int c = 0; c < 2; c++) s.phi[p][c] = hostile(n % 7, s.phi[p][c], c, &seed);
        assert_true(jacobian_report_init(&plane, &s, JACOBIAN_PLANE, &rule, false, &err));
        assert_true(injective_init(&j, &s, &plane, NULL, &rule, &err));
        check_seed(start, plane.least.verdict == JACOBIAN_CERTIFIED || j.phi != INJECTIVE_YES);
        check_seed(start, plane.least.verdict != JACOBIAN_FOLDS || j.phi == INJECTIVE_NO);
        check_seed(start, j.phi == INJECTIVE_YES || !injective_holds(&j, &err) ||
                              plane.least.verdict != JACOBIAN_CERTIFIED);
        injective_free(&j);
        jacobian_report_free(&plane);
        spline_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_maps), cmocka_unit_test(test_edits),
                                       cmocka_unit_test(test_hostile)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
