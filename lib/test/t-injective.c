/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stars: triangles around the vertex 0, whose images turn round it by a planted number of steps of
 * 15 degrees. Maps for which the answer is planted. */
#include "fans.h"
#include "injective.h"
#include "mem.h"

#include "testing.h"

#include <math.h>
#include <string.h>

/* n triangles of degree 1 around vertex 0: all of a turn if closed, else the last side is open. */
static void star(struct spline *s, uint32_t n, bool closed) {
    uint32_t rim = closed ? n : n + 1;
    struct grid g = {.degree = 1,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .vertex_count = rim + 1,
                     .triangle_count = n};
    struct err err;
    assert_true(mem_new(g.vertex, rim + 1, &err) && mem_new(g.triangle, n, &err));
    for (uint32_t i = 0; i < rim; i++) {
        double angle = 6.283185307179586 * i / (closed ? n : n + 2);
        g.vertex[i + 1][0] = (int32_t)(10000 * cos(angle));
        g.vertex[i + 1][1] = (int32_t)(10000 * sin(angle));
    }
    for (uint32_t t = 0; t < n; t++) {
        g.triangle[t][1] = t + 1;
        g.triangle[t][2] = t + 1 == rim ? 1 : t + 2;
    }
    assert_true(grid_build(&g, &err) && spline_identity(s, &g, &err));
}

/* Gives rim vertex i+1 the direction of angle[i] x 15 degrees; multiples of 24 are the same. */
static void turn_rim(struct spline *s, uint32_t rim, const int *angle) {
    for (uint32_t i = 0; i < rim; i++) {
        double x = 0.2617993877991494 * ((angle[i] + 24) % 24), length = 1 + i % 3;
        s->phi[i + 1][0] = length * cos(x);
        s->phi[i + 1][1] = length * sin(x);
    }
}

/* n steps of 1..11 that add up to `total`. */
static void random_steps(int *step, int n, int total, uint64_t *seed) {
    for (int i = 0; i < n; i++) step[i] = 1;
    for (int left = total - n; left > 0;) {
        int i = (int)random_in(seed, 0, n - 1);
        if (step[i] < 11) step[i]++, left--;
    }
}

static void test_stars(void **state) {
    uint64_t seed = 1;
    (void)state;
    for (int cases = test_count(300); cases > 0; cases--) {
        uint64_t start = seed;
        bool closed = random_bits(&seed) & 1;
        int n = (int)random_in(&seed, closed ? 5 : 1, 12), step[16], angle[16] = {0};
        int total = closed ? 24 * (int)random_in(&seed, 1, (11 * n - 1) / 24)
                           : (int)random_in(&seed, n, 11 * n);
        uint32_t turns;
        struct spline s;
        struct err err;
        enum fan_kind kind, expected;
        random_steps(step, n, total, &seed);
        angle[0] = (int)random_in(&seed, 0, 23);
        for (int i = 0; i < n; i++) angle[i + 1] = angle[i] + step[i];
        star(&s, (uint32_t)n, closed);
        turn_rim(&s, (uint32_t)(closed ? n : n + 1), angle);
        expected = closed ? (total == 24 ? FAN_SOUND : FAN_COVERS)
                          : (total < 24   ? FAN_SOUND
                             : total > 24 ? FAN_COVERS
                                          : FAN_CLOSES);
        /* rounded directions need not be the same */
        if (!closed && total % 24 == 0) memcpy(s.phi[n + 1], s.phi[1], sizeof s.phi[1]);
        kind = fan_of_vertex(&s, 0, &turns);
        check_seed(start, kind == expected);
        check_seed(start, turns == (uint32_t)(total / 24));
        check_seed(start, fans_worst(&s, &kind, &turns) == (kind == FAN_SOUND ? GRID_NONE : 0));
        if (kind != FAN_SOUND)
            check_seed(start, !injective_prove(&s, &err) && err.kind == ERR_REFUSAL);
        if (kind == FAN_SOUND && closed) check_seed(start, injective_prove(&s, &err));
        spline_free(&s);
    }
}

static void test_negative_corner(void **state) {
    const int angle[] = {0, 8, 16, 12, 20};
    uint32_t turns;
    struct spline s;
    (void)state;
    star(&s, 5, true);
    turn_rim(&s, 5, angle);
    assert_int_equal(fan_of_vertex(&s, 0, &turns), FAN_UNKNOWN);
    spline_free(&s);
}

/* The identity of a degree. */
static void make(struct spline *s, int degree, uint32_t vertices, const int32_t (*vertex)[2],
                 uint32_t triangles, const uint32_t (*triangle)[3]) {
    struct grid g = {.degree = degree,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .vertex_count = vertices,
                     .triangle_count = triangles};
    struct err err;
    assert_true(mem_new(g.vertex, vertices, &err) && mem_new(g.triangle, triangles, &err));
    memcpy(g.vertex, vertex, vertices * sizeof *vertex);
    memcpy(g.triangle, triangle, triangles * sizeof *triangle);
    assert_true(grid_build(&g, &err) && spline_identity(s, &g, &err));
}

/* Examines and frees; injective_prove must agree. */
static void examine(struct spline *s, struct injective *j) {
    const struct least_rule *rule = &jacobian_default_rule;
    struct jacobian_report plane, thickness = {0};
    struct err err;
    assert_true(jacobian_report_init(&plane, s, JACOBIAN_PLANE, rule, false, &err));
    assert_int_equal(plane.least.verdict, JACOBIAN_CERTIFIED);
    if (s->sigma)
        assert_true(jacobian_report_init(&thickness, s, JACOBIAN_THICKNESS, rule, false, &err));
    assert_true(injective_init(j, s, &plane, s->sigma ? &thickness : NULL, rule, &err));
    assert_true(injective_prove(s, &err) == (j->psi == INJECTIVE_YES));
    if (j->psi == INJECTIVE_NO)
        assert_memory_equal(err.message, "not one-to-one: ", 16);
    else if (j->psi == INJECTIVE_UNDECIDED)
        assert_memory_equal(err.message, "not proved to be one-to-one: ", 29);
    jacobian_report_free(&plane);
    jacobian_report_free(&thickness);
    spline_free(s);
}

/* The double cover of a disc with branch points at (1,0) and (-1,0): two sheets that cross between
 * them. The outer boundary, vertices 0 to 7, is that of one sheet; the inner one is drawn in, from
 * the boundary of the other sheet, as far as the branch points, 8 and 10. All images of triangles
 * are positive, the curves are simple and disjoint, the inner vertices 9 and 11 on the slit are
 * sound, and yet all that the inner curve surrounds is covered twice. Round the branch points, on
 * the boundary, the fans make more than a turn. */
static void test_double_cover(void **state) {
    static const int32_t vertex[14][2] = {{8, 0},   {6, 6},  {0, 8},  {-6, 6}, {-8, 0},
                                          {-6, -6}, {0, -8}, {6, -6}, {4, 0},  {0, 4},
                                          {-4, 0},  {0, -4}, {0, 2},  {0, -2}};
    static const double image[14][2] = {{8, 0},   {6, 6},  {0, 8},  {-6, 6}, {-8, 0},
                                        {-6, -6}, {0, -8}, {6, -6}, {1, 0},  {0, 0},
                                        {-1, 0},  {0, 0},  {0, -1}, {0, 1}};
    static const uint32_t triangle[16][3] = {{0, 1, 8},  {1, 9, 8},   {1, 2, 9},    {2, 3, 9},
                                             {3, 10, 9}, {3, 4, 10},  {4, 5, 10},   {5, 11, 10},
                                             {5, 6, 11}, {6, 7, 11},  {7, 8, 11},   {7, 0, 8},
                                             {8, 9, 12}, {9, 10, 12}, {10, 11, 13}, {11, 8, 13}};
    struct spline s;
    struct injective j;
    (void)state;
    make(&s, 1, 14, vertex, 16, triangle);
    memcpy(s.phi, image, sizeof image);
    examine(&s, &j);
    assert_int_equal(j.boundary.meet.verdict, MEET_NOT);
    assert_int_equal(j.fans, FAN_COVERS);
    assert_int_equal(j.fan_turns, 1);
    assert_true(j.fan_vertex == 8 || j.fan_vertex == 10);
    assert_int_equal(j.phi, INJECTIVE_NO);
    injective_free(&j);
}

/* A ring, and a triangle that is put beside it, on it, into it, into its hole. */
static const int32_t ring_vertex[11][2] = {{0, 0}, {12, 0}, {12, 12}, {0, 12}, {3, 3}, {9, 3},
                                           {9, 9}, {3, 9},  {20, 0},  {22, 0}, {20, 2}};
static const uint32_t ring_triangle[9][3] = {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6},
                                             {3, 7, 6}, {3, 0, 7}, {0, 4, 7}, {8, 9, 10}};

static void put_triangle(double x, double y, enum meet_verdict met, enum nesting_verdict nested) {
    struct spline s;
    struct injective j;
    make(&s, 1, 11, ring_vertex, 9, ring_triangle);
    for (int v = 8; v < 11; v++) {
        s.phi[v][0] += x - 20;
        s.phi[v][1] += y;
    }
    examine(&s, &j);
    assert_int_equal(j.boundary.meet.verdict, met);
    assert_int_equal(j.nesting.verdict, nested);
    assert_int_equal(j.phi,
                     met == MEET_NOT && nested == NESTING_NONE ? INJECTIVE_YES : INJECTIVE_NO);
    if (nested == NESTING_INSIDE) {
        assert_int_equal(j.nesting.vertex, 8);
        assert_int_equal(j.nesting.triangle, x > 6 ? 3 : 6);
    }
    if (met >= MEET_CROSS)
        for (int i = 0; i < 2; i++)
            for (int c = 0; c < 2; c++) { /* the ring is the identity */
                const struct boundary_place *place = &j.boundary.place[i];
                double move = place->from >= 8 ? (c ? y : x - 20) : 0;
                assert_true(fabs(place->position[c] + move - j.boundary.image[c]) < 1e-9);
            }
    injective_free(&j);
}

static void test_ring_and_triangle(void **state) {
    (void)state;
    put_triangle(20, 0, MEET_NOT, NESTING_NONE);
    put_triangle(20, 11.5, MEET_NOT, NESTING_NONE);
    put_triangle(5, 5, MEET_NOT, NESTING_NONE); /* in the hole */
    put_triangle(9.5, 6, MEET_NOT, NESTING_INSIDE);
    put_triangle(0.5, 9, MEET_NOT, NESTING_INSIDE);
    put_triangle(-1.3, 5.1, MEET_CROSS, NESTING_NONE); /* both boundaries */
    put_triangle(8.3, 8.1, MEET_CROSS, NESTING_NONE);
    put_triangle(12, 5, MEET_POINT, NESTING_NONE);  /* a side on a side */
    put_triangle(12, 12, MEET_POINT, NESTING_NONE); /* two corners */
    put_triangle(10, -2, MEET_POINT, NESTING_NONE); /* a corner on a side */
    put_triangle(11, 11, MEET_POINT, NESTING_NONE); /* a corner in the middle of a side */
    put_triangle(3, 3, MEET_POINT, NESTING_NONE);   /* a corner in a corner of the hole */
    put_triangle(nextafter(12, 13), 5, MEET_NOT, NESTING_NONE);
    put_triangle(nextafter(12, 11), 5, MEET_CROSS, NESTING_NONE);
}

/* Two rings of different size, one within the hole of the other, or the other way round. */
static void test_rings(void **state) {
    int32_t vertex[16][2];
    uint32_t triangle[16][3];
    (void)state;
    for (int i = 0; i < 32; i++)
        vertex[i / 2][i % 2] = ring_vertex[i / 2 % 8][i % 2] + (i % 2 == 0 && i >= 16 ? 20 : 0);
    for (uint32_t i = 0; i < 48; i++)
        triangle[i / 3][i % 3] = ring_triangle[i / 3 % 8][i % 3] + (i >= 24 ? 8 : 0);
    for (int k = 0; k < 8; k++) {
        double factor = k & 1 ? 0.2 : 0.75;
        int first = k & 2 ? 8 : 0, other = 8 - first; /* the small one */
        struct spline s;
        struct injective j;
        make(&s, 1, 16, (const int32_t(*)[2])vertex, 16, (const uint32_t(*)[3])triangle);
        for (int v = 0; v < 8; v++)
            for (int c = 0; c < 2; c++) {
                s.phi[other + v][c] = ring_vertex[v][c] - 6;
                s.phi[first + v][c] = (ring_vertex[v][c] - 6) * factor;
                if (k & 4) s.phi[first + v][c] += c ? 0 : k & 1 ? 4.5 : 7;
            }
        examine(&s, &j);
        if (k & 4) /* within the other's body, or across its boundary */
            assert_true(k & 1 ? j.nesting.verdict == NESTING_INSIDE
                              : j.boundary.meet.verdict >= MEET_CROSS);
        else if (k & 1)
            assert_int_equal(j.phi, INJECTIVE_YES);
        else
            assert_true(j.boundary.meet.verdict >= MEET_CROSS ||
                        j.nesting.verdict == NESTING_INSIDE);
        injective_free(&j);
    }
}

/* The upper triangle's lower edge becomes y = 12 (x^2 - 1/2)^2, by adding that to y: the
 * determinant stays 1. The lower triangle's upper edge is y = -height. */
static void test_irrational_contact(void **state) {
    static const int32_t vertex[6][2] = {{0, 0}, {1, -1}, {1, 0}, {0, 10}, {1, 10}, {0, 11}};
    static const uint32_t triangle[2][3] = {{0, 1, 2}, {3, 4, 5}};
    static const double quartic[5] = {3, 3, 1, -3, 3}; /* in Bernstein form */
    static const double heights[] = {0x1p-60, 0x1p-90, 0, -0x1p-90, -0x1p-60};
    (void)state;
    for (int n = 0; n < 5; n++) {
        struct spline s;
        struct injective j;
        uint32_t q[GRID_PATCH_MAX];
        make(&s, 4, 6, vertex, 2, triangle);
        grid_patch(&s.grid, 1, q);
        for (int r = 0, i = 0; r <= 4; r++)
            for (int k = 0; k <= r; k++, i++) s.phi[q[i]][1] = k / 4.0 + quartic[r - k];
        grid_patch(&s.grid, 0, q);
        for (int i = 0; i < 15; i++)
            if (s.phi[q[i]][1] == 0) s.phi[q[i]][1] = -heights[n];
        examine(&s, &j);
        assert_int_equal(j.phi, n < 2    ? INJECTIVE_YES
                                : n == 2 ? INJECTIVE_UNDECIDED
                                         : INJECTIVE_NO);
        injective_free(&j);
    }
}

/* One triangle, sigma1 - sigma0 = 1 at its corners and `least` in the middle of an edge. */
static void test_depth(void **state) {
    static const int32_t vertex[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    static const uint32_t triangle[1][3] = {{0, 1, 2}};
    static const enum injective_verdict expected[] = {INJECTIVE_YES, INJECTIVE_NO, INJECTIVE_NO};
    (void)state;
    for (int n = 0; n < 3; n++) {
        double least = n == 0 ? 0.5 : n == 1 ? 0 : -0.5;
        struct spline s;
        struct injective j;
        make(&s, 2, 3, vertex, 1, triangle);
        s.grid.has_depth = true;
        s.grid.depth[1] = 1;
        assert_non_null(s.sigma = calloc(6, sizeof *s.sigma));
        for (int i = 0; i < 6; i++) s.sigma[i][1] = 1;
        s.sigma[grid_point(&s.grid, 0, 1, 1, 0)][1] = 2 * least - 1;
        examine(&s, &j);
        assert_int_equal(j.phi, INJECTIVE_YES);
        assert_int_equal(j.psi, expected[n]);
        injective_free(&j);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stars),        cmocka_unit_test(test_negative_corner),
        cmocka_unit_test(test_double_cover), cmocka_unit_test(test_ring_and_triangle),
        cmocka_unit_test(test_rings),        cmocka_unit_test(test_irrational_contact),
        cmocka_unit_test(test_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
