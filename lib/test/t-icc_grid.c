/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Coordinates of method grid: their ranges, what is exact (the cage, the maximum, points on lines
 * that no other has merged with), what the tally counts, the choice of cells, and all refusals. */
#include "icc_grid.h"

#include "balls.h"
#include "testing.h"

#include <stdlib.h>
#include <string.h>

static const double square[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

static void cage_of(struct cage *cage, const double (*vertex)[2], size_t n) {
    struct err err = {0};
    if (!cage_init(cage, vertex, n, &err)) fail_msg("%s", err.message);
}

static void make(struct icc_grid *g, const struct cage *cage, const struct icc_grid_rule *rule) {
    struct err err = {0};
    if (!icc_grid_init(g, cage, rule, &err)) fail_msg("%s", err.message);
}

static void random_point(const struct cage *cage, double p[2], uint64_t *state) {
    const struct polygon *g = &cage->polygon;
    do {
        for (int c = 0; c < 2; c++) p[c] = g->lo[c] + (g->hi[c] - g->lo[c]) * random_unit(state);
    } while (!cage_has(cage, p));
}

static double apart(const double p[2], const double q[2]) {
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
}

static struct icc_place locate(const struct icc_grid *g, const double p[2], struct icc_lines *lines,
                               struct icc_tally *tally) {
    struct icc_place place;
    struct err err = {0};
    assert_true(icc_grid_locate(g, p, lines, &place, tally, &err));
    return place;
}

static void place_at(const struct icc_grid *g, const struct icc_place *place, double p[2],
                     struct icc_lines *lines, struct icc_tally *tally) {
    struct err err = {0};
    assert_true(icc_grid_place(g, place, lines, p, tally, &err));
}

/* Coordinates are in their ranges, and where no line merged they lead back to the point. */
static void there_and_back(void **state) {
    static const enum icc_kind kinds[] = {ICC_COUSIN, ICC_MANHATTAN, ICC_HARMONIC, ICC_BIHARMONIC};
    size_t exact = 0, points = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(24); seed++) {
        double vertex[12][2];
        uint64_t random = seed;
        struct icc_grid_rule rule = {
            .points = 400, .warn = true, .function = {.kind = kinds[seed % 4]}};
        struct icc_lines lines = {0};
        struct cage cage;
        struct icc_grid g;
        random_cage(vertex, 12, 0.5, &random);
        cage_of(&cage, (const double(*)[2])vertex, 12);
        make(&g, &cage, &rule);
        for (int k = 0; k < 100; k++) {
            double p[2], q[2];
            struct icc_tally down = {0}, up = {0};
            random_point(&cage, p, &random);
            struct icc_place place = locate(&g, p, &lines, &down);
            check_seed(seed, place.side < 12 && place.lambda >= 0 && place.lambda <= 1);
            check_seed(seed, place.t >= 0 && place.t <= 1);
            place_at(&g, &place, q, &lines, &up);
            points++;
            if (down.merged + up.merged + down.lost + up.lost) continue;
            exact++;
            check_seed(seed, apart(p, q) < 1e-9);
        }
        icc_lines_free(&lines);
        icc_grid_free(&g);
        cage_free(&cage);
    }
    print_message("%zu of %zu points on lines of their own\n", exact, points);
    assert_true(exact > points / 3);
}

/* The cage and the maximum have coordinates without a line. */
static void ends_are_exact(void **state) {
    const struct icc_grid_rule rule = {.points = 100};
    struct icc_lines lines = {0};
    struct icc_tally tally = {0};
    struct cage cage;
    struct icc_grid g;
    double p[2], top[2];
    (void)state;
    cage_of(&cage, square, 4);
    make(&g, &cage, &rule);
    for (uint32_t side = 0; side < 4; side++)
        for (double lambda = 0; lambda < 1; lambda += 0.125) {
            cage_point(&cage, side, lambda, p);
            struct icc_place at = locate(&g, p, &lines, &tally);
            assert_true(at.side == side && at.lambda == lambda && at.t == 1);
            place_at(&g, &at, top, &lines, &tally);
            assert_memory_equal(p, top, sizeof p);
        }
    icc_domain_vertex(&g.domain, g.function.maximum, top);
    struct icc_place at = {.side = 3, .lambda = 0.7, .t = 0};
    place_at(&g, &at, p, &lines, &tally);
    assert_memory_equal(p, top, sizeof p);
    at = locate(&g, top, &lines, &tally);
    assert_true(at.side == 0 && at.lambda == 0 && at.t == 0);
    icc_lines_free(&lines);
    icc_grid_free(&g);
    cage_free(&cage);
}

/* A place a hair inside a side, less than grid coordinates can tell, is still on it. */
static void a_hair_inside(void **state) {
    const struct icc_grid_rule rule = {.points = 300};
    struct icc_lines lines = {0};
    struct icc_tally tally = {0};
    struct cage cage;
    struct icc_grid g;
    double vertex[7][2];
    uint64_t random = 5;
    size_t inside = 0;
    (void)state;
    random_cage(vertex, 7, 0.3, &random);
    cage_of(&cage, (const double(*)[2])vertex, 7);
    make(&g, &cage, &rule);
    for (int n = 0; n < 2000; n++) {
        uint32_t side = (uint32_t)random_in(&random, 0, 6), other;
        double lambda = random_unit(&random), p[2], unused;
        cage_point(&cage, side, lambda, p);
        for (int c = 0; c < 2; c++) p[c] += (double)random_in(&random, -2, 2) * 0x1p-53;
        inside += cage_find(&cage, p, &other, &unused) == CAGE_INSIDE;
        struct icc_place place = locate(&g, p, &lines, &tally);
        assert_true(fabs(place.lambda - lambda) < 1e-9 && place.side == side);
        assert_true(place.t > 1 - 1e-12 && place.t <= 1);
    }
    assert_true(inside > 300);
    assert_int_equal(tally.lost, 0);
    icc_lines_free(&lines);
    icc_grid_free(&g);
    cage_free(&cage);
}

/* ---- cells ------------------------------------------------------------------------------------
 */

static void cell_sides(void **state) {
    static const struct {
        struct icc_grid_rule rule;
        double h;
    } table[] = {
        {{.cell = 0.25}, 0.25},
        {{.cell = 0.25, .resolution = 2}, 0.125},
        {{.points = 100}, 0.2},
        {{.points = 100, .resolution = 4}, 0.05},
        {{.resolution = 1}, 2 / 19.104973174542800},
        {{.resolution = 5}, 0.4 / 19.104973174542800},
        {{.cell = 0}, 2 / 24.494897427831781},
    };
    struct cage cage;
    (void)state;
    cage_of(&cage, square, 4);
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct icc_grid g;
        make(&g, &cage, &table[i].rule);
        assert_true(fabs(g.domain.h - table[i].h) < 1e-14);
        icc_grid_free(&g);
    }
    cage_free(&cage);
}

/* Two squares with a neck of 0.01 between them: the cells are halved until some fit into it. */
static void cells_are_halved(void **state) {
    const double dumbbell[12][2] = {{0, 0},   {1, 0},   {1, 0.3},    {1.1, 0.3}, {1.1, 0}, {2.1, 0},
                                    {2.1, 1}, {1.1, 1}, {1.1, 0.31}, {1, 0.31},  {1, 1},   {0, 1}};
    const struct icc_grid_rule rule = {0}, coarse = {.points = 600};
    struct err err = {0};
    struct cage cage;
    struct icc_grid g;
    (void)state;
    cage_of(&cage, dumbbell, 12);
    make(&g, &cage, &rule);
    assert_true(g.domain.h <= 0.01);
    assert_int_equal(g.function.reached, g.domain.inside_count);
    icc_grid_free(&g);
    assert_false(icc_grid_init(&g, &cage, &coarse, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "not connected with the maximum: "));
    icc_grid_free(&g);
    cage_free(&cage);
}

/* Slivers: the first grids have no vertex inside, which is no error in the end. Where no grid of a
 * reasonable size has one, that is said. */
static void slivers(void **state) {
    const struct icc_grid_rule rule = {.warn = true};
    int made = 0, refused = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= 40; seed++) {
        uint64_t random = seed;
        double width = 0.0001 + 0.004 * random_unit(&random), tilt = random_unit(&random);
        const double sliver[4][2] = {{0, 0}, {1, tilt}, {1, tilt + width}, {0, width}};
        struct err err = {0};
        struct cage cage;
        struct icc_grid g;
        cage_of(&cage, sliver, 4);
        if (icc_grid_init(&g, &cage, &rule, &err)) {
            check_seed(seed, err.kind == ERR_NONE && g.domain.inside_count > 0);
            made++;
        } else {
            check_seed(seed, strstr(err.message, "resolution: no vertex of a grid") != NULL);
            refused++;
        }
        icc_grid_free(&g);
        cage_free(&cage);
    }
    print_message("%d slivers, %d refused\n", made, refused);
    assert_true(made > 20);
}

/* The side that a failure names is the user's, however the cage was given. */
static void sides_as_given(void **state) {
    const double spike[7][2] = {{0, 0},    {1, 0},    {1, 0.45}, {9, 0.5},
                                {1, 0.55}, {1, 1.07}, {0, 1.07}};
    const struct icc_grid_rule rule = {.cell = 0.1, .warn = true};
    (void)state;
    for (size_t shift = 0; shift < 7; shift++)
        for (int reversed = 0; reversed < 2; reversed++) {
            double given[7][2];
            struct cage cage;
            struct icc_grid g;
            for (size_t i = 0; i < 7; i++)
                memcpy(given[i], spike[(reversed ? 13 - i + shift : i + shift) % 7], sizeof *given);
            cage_of(&cage, (const double(*)[2])given, 7);
            make(&g, &cage, &rule);
            const struct icc_failures *f = &g.failures[ICC_TEST_BARE];
            const double *a = given[f->side], *b = given[(f->side + 1) % 7];
            assert_true(f->count > 0);
            assert_true(fabs(apart(a, f->at) + apart(f->at, b) - apart(a, b)) < 1e-9);
            icc_grid_free(&g);
            cage_free(&cage);
        }
}

static void the_maximum_chosen(void **state) {
    const struct icc_grid_rule rule = {.points = 100, .has_maximum = true, .maximum = {0.5, 1.5}};
    const struct icc_grid_rule out = {.points = 100, .has_maximum = true, .maximum = {0.5, 2.5}};
    struct err err = {0};
    struct cage cage;
    struct icc_grid g;
    double p[2];
    (void)state;
    cage_of(&cage, square, 4);
    make(&g, &cage, &rule);
    icc_domain_vertex(&g.domain, g.function.maximum, p);
    assert_true(apart(p, rule.maximum) <= 0.1 * sqrt(2) + 1e-12);
    icc_grid_free(&g);
    assert_false(icc_grid_init(&g, &cage, &out, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message, "the maximum (0.5, 2.5) is not inside the cage");
    icc_grid_free(&g);
    cage_free(&cage);
}

static void refuse(const double (*vertex)[2], size_t n, const struct icc_grid_rule *rule,
                   const char *what) {
    struct icc_grid_rule warn = *rule;
    struct err err = {0};
    struct cage cage;
    struct icc_grid g;
    cage_of(&cage, vertex, n);
    assert_false(icc_grid_init(&g, &cage, rule, &err));
    icc_grid_free(&g);
    assert_int_equal(err.kind, ERR_REFUSAL);
    if (!strstr(err.message, what)) fail_msg("%s", err.message);
    if (strstr(err.message, ", the first at (")) {
        warn.warn = true;
        make(&g, &cage, &warn);
        icc_grid_free(&g);
    }
    cage_free(&cage);
}

static void refusals(void **state) {
    const double slit[7][2] = {{0, 0}, {2, 0}, {2, 2}, {1.06, 2}, {1.055, 0.6}, {1.05, 2}, {0, 2}};
    const double spike[7][2] = {{0, 0},    {1, 0},    {1, 0.45}, {9, 0.5},
                                {1, 0.55}, {1, 1.07}, {0, 1.07}};
    const double thin[4][2] = {{0, 0}, {1, 0.001}, {1, 0.002}, {0, 0.001}};
    (void)state;
    refuse(slit, 7, &(struct icc_grid_rule){.cell = 0.125},
           "between vertices inside that cross the cage");
    refuse(spike, 7, &(struct icc_grid_rule){.cell = 0.1}, "too far from grid vertices inside");
    refuse(spike, 7, &(struct icc_grid_rule){0}, "resolution: with cells of");
    refuse(thin, 4, &(struct icc_grid_rule){.cell = 0.1}, "no vertex of a grid with cells of 0.1 ");
    refuse(square, 4, &(struct icc_grid_rule){.cell = 1e-5}, "more than 33554432");
    refuse(square, 4, &(struct icc_grid_rule){.cell = 1e-12}, "precision: cells of 1e-12");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_and_back),   cmocka_unit_test(ends_are_exact),
        cmocka_unit_test(a_hair_inside),    cmocka_unit_test(cell_sides),
        cmocka_unit_test(cells_are_halved), cmocka_unit_test(the_maximum_chosen),
        cmocka_unit_test(refusals),         cmocka_unit_test(slivers),
        cmocka_unit_test(sides_as_given),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
