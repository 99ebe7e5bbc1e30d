/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: de Casteljau's algorithm in rationals, with the place of every fine triangle found anew
 * from the vertices; a new control point must be the double nearest to the exact one. */
#include "refine.h"

#include "testing.h"
#include "triangulations.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- rationals --------------------------------------------------------------------------------
 */

static int place(int degree, int i, int j) {
    int s = degree - i;
    return s * (s + 1) / 2 + s - j;
}

/* One step of de Casteljau: a form of the given degree becomes one of degree - 1, at argument b. */
static void step(int degree, mpq_t *net, mpq_t b[3]) {
    mpq_t term;
    mpq_init(term);
    for (int i = degree - 1; i >= 0; i--)
        for (int j = degree - 1 - i; j >= 0; j--) {
            int at[3] = {place(degree, i + 1, j), place(degree, i, j + 1), place(degree, i, j)};
            mpq_t sum;
            mpq_init(sum);
            for (int l = 0; l < 3; l++) {
                mpq_mul(term, net[at[l]], b[l]);
                mpq_add(sum, sum, term);
            }
            mpq_swap(net[place(degree - 1, i, j)], sum);
            mpq_clear(sum);
        }
    mpq_clear(term);
}

/* Polar value of a patch of doubles: argument[0] i times, [1] j times, [2] k times. */
static void polar(mpq_t result, int degree, const double *patch, mpq_t argument[3][3], int i,
                  int j) {
    mpq_t net[GRID_PATCH_MAX];
    int size = grid_patch_size(degree);
    for (int n = 0; n < size; n++) {
        mpq_init(net[n]);
        mpq_set_d(net[n], patch[n]);
    }
    for (int n = 0; n < degree; n++) step(degree - n, net, argument[n < i ? 0 : n < i + j ? 1 : 2]);
    mpq_set(result, net[0]);
    for (int n = 0; n < size; n++) mpq_clear(net[n]);
}

static void distance(mpq_t result, const mpq_t exact, double x) {
    mpq_set_d(result, x);
    mpq_sub(result, result, exact);
    mpq_abs(result, result);
}

/* Is no neighbouring double nearer to the exact value? */
static bool is_nearest(const mpq_t exact, double x) {
    mpq_t here, there;
    bool nearest = true;
    mpq_inits(here, there, NULL);
    distance(here, exact, x);
    for (int side = 0; side < 2; side++) {
        distance(there, exact, nextafter(x, side ? INFINITY : -INFINITY));
        nearest = nearest && mpq_cmp(here, there) <= 0;
    }
    mpq_clears(here, there, NULL);
    return nearest;
}

/* ---- the refined spline -----------------------------------------------------------------------
 */

static int64_t area(const int64_t a[2], const int64_t b[2], const int64_t c[2]) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static void corner_at(const struct grid *g, uint32_t t, int l, int64_t scale, int64_t xy[2]) {
    for (int c = 0; c < 2; c++) xy[c] = scale * g->vertex[g->triangle[t][l]][c];
}

/* Barycentric areas of p in triangle t of the coarse grid, scaled to the fine lattice. */
static int64_t barycentric(const struct grid *g, uint32_t t, int64_t scale, const int64_t p[2],
                           int64_t b[3]) {
    int64_t u[3][2];
    for (int l = 0; l < 3; l++) corner_at(g, t, l, scale, u[l]);
    for (int l = 0; l < 3; l++) b[l] = area(p, u[(l + 1) % 3], u[(l + 2) % 3]);
    return area(u[0], u[1], u[2]);
}

/* The coarse triangle that holds all corners of fine triangle t. */
static uint32_t parent_of(const struct grid *coarse, const struct grid *fine, uint32_t t,
                          int64_t scale, mpq_t argument[3][3]) {
    for (uint32_t u = 0; u < coarse->triangle_count; u++) {
        bool inside = true;
        for (int l = 0; l < 3; l++) {
            int64_t p[2], b[3], whole;
            corner_at(fine, t, l, 1, p);
            whole = barycentric(coarse, u, scale, p, b);
            for (int c = 0; c < 3; c++) {
                inside = inside && b[c] >= 0;
                mpq_set_si(argument[l][c], b[c], (unsigned long)whole);
                mpq_canonicalize(argument[l][c]);
            }
        }
        if (inside) return u;
    }
    fail_msg("triangle %u of the refined grid lies in no triangle of the grid", t);
    return 0;
}

static void gather(const struct spline *s, uint32_t t, int component, double *patch) {
    uint32_t point[GRID_PATCH_MAX];
    grid_patch(&s->grid, t, point);
    for (int n = 0; n < grid_patch_size(s->grid.degree); n++)
        patch[n] = component < 2 ? s->phi[point[n]][component] : s->sigma[point[n]][component - 2];
}

static void check_patch(const struct spline *s, uint32_t u, const struct spline *fine, uint32_t t,
                        mpq_t argument[3][3], uint64_t seed) {
    int d = s->grid.degree;
    mpq_t exact;
    mpq_init(exact);
    for (int component = 0; component < (s->sigma ? 4 : 2); component++) {
        double old[GRID_PATCH_MAX], new[GRID_PATCH_MAX], *next = new;
        gather(s, u, component, old);
        gather(fine, t, component, new);
        for (int i = d; i >= 0; i--)
            for (int j = d - i; j >= 0; j--, next++) {
                polar(exact, d, old, argument, i, j);
                check_seed(seed, is_nearest(exact, *next));
            }
    }
    mpq_clear(exact);
}

static int64_t total_area(const struct grid *g) {
    int64_t sum = 0;
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const uint32_t *c = g->triangle[t];
        sum += predicate_area2(g->vertex[c[0]], g->vertex[c[1]], g->vertex[c[2]]);
    }
    return sum;
}

static void check_refined(const struct spline *s, const struct spline *fine, int times,
                          uint64_t seed) {
    int64_t scale = (int64_t)1 << times;
    mpq_t argument[3][3];
    for (int l = 0; l < 9; l++) mpq_init(argument[l / 3][l % 3]);
    check_seed(seed, total_area(&fine->grid) == total_area(&s->grid) * scale * scale);
    check_seed(seed, fine->grid.lattice.step * (double)scale == s->grid.lattice.step);
    for (uint32_t v = 0; v < s->grid.vertex_count; v++)
        for (int c = 0; c < 2; c++)
            check_seed(seed, fine->grid.vertex[v][c] == scale * s->grid.vertex[v][c]);
    for (uint32_t t = 0; t < fine->grid.triangle_count; t++) {
        uint32_t u = parent_of(&s->grid, &fine->grid, t, scale, argument);
        check_patch(s, u, fine, t, argument, seed);
    }
    for (int l = 0; l < 9; l++) mpq_clear(argument[l / 3][l % 3]);
}

/* A spline with random control points, of mixed magnitudes, some exactly nominal. */
static void random_spline(struct spline *s, int size, int degree, bool depth, uint64_t seed) {
    struct grid g;
    struct err err = {0};
    random_grid(&g, size, degree, seed);
    g.has_depth = depth;
    g.depth[1] = 1;
    assert_true(spline_identity(s, &g, &err));
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int c = 0; c < 2; c++) {
            if (random_in(&seed, 0, 3) == 0) continue;
            s->phi[p][c] =
                ldexp((double)random_in(&seed, -(1 << 29), 1 << 29), (int)random_in(&seed, -50, 9));
            if (depth) s->sigma[p][c] = random_unit(&seed);
        }
}

static void refine_all(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(20); seed++) {
        struct spline s, fine;
        struct err err = {0};
        struct refine_request request = {.times = 1 + (int)(seed % 2)};
        random_spline(&s, 2, 1 + (int)(seed % 6), seed % 3 == 0, seed);
        check_seed(seed, refine_spline(&s, &request, &fine, &err));
        check_seed(seed, fine.grid.triangle_count == s.grid.triangle_count << (2 * request.times));
        check_refined(&s, &fine, request.times, seed);
        spline_free(&s);
        spline_free(&fine);
    }
}

/* Parts only: what is marked is split, the rest stays conforming (grid_build would refuse it). */
static void refine_parts(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(20); seed++) {
        struct spline s, fine;
        struct err err = {0};
        bool *mark;
        uint64_t random = seed;
        struct refine_request request = {.times = 1 + (int)(seed % 3)};
        random_spline(&s, 3, 2 + (int)(seed % 4), false, seed);
        mark = calloc(s.grid.triangle_count, sizeof *mark);
        assert_non_null(mark);
        mark[random_in(&random, 0, s.grid.triangle_count - 1)] = true;
        mark[random_in(&random, 0, s.grid.triangle_count - 1)] = true;
        request.triangle = mark;
        check_seed(seed, refine_spline(&s, &request, &fine, &err));
        check_seed(seed, fine.grid.triangle_count >= s.grid.triangle_count + 3);
        check_refined(&s, &fine, request.times, seed);
        free(mark);
        spline_free(&s);
        spline_free(&fine);
    }
}

static void refine_box(void **state) {
    struct spline s, fine;
    struct err err = {0};
    struct grid g;
    struct recipe recipe = {.nx = 8, .ny = 8, .spacing = 2};
    double corner[4] = {0, 0, 0.5, 0.5}, far[4] = {100, 100, 101, 101};
    struct refine_request request = {.times = 1, .box = corner};
    (void)state;
    triangulate(&g, &recipe, 5, 1);
    assert_true(grid_build(&g, &err) && spline_identity(&s, &g, &err));
    assert_true(refine_spline(&s, &request, &fine, &err));
    /* the triangles at the corner (one or two, by their diagonal) and the green neighbours of them
     */
    assert_true(fine.grid.triangle_count > 128 + 3 && fine.grid.triangle_count < 128 + 12);
    check_refined(&s, &fine, 1, 0);
    spline_free(&fine);
    request.box = far;
    assert_true(refine_spline(&s, &request, &fine, &err));
    assert_int_equal(fine.grid.triangle_count, 128);
    spline_free(&fine);
    spline_free(&s);
}

/* sum over the patch in long double: the map itself. */
static long double value_at(const struct spline *s, uint32_t t, int component,
                            const long double b[3]) {
    double patch[GRID_PATCH_MAX], *q = patch;
    long double sum = 0, factorial[GRID_DEGREE_MAX + 1] = {1};
    int d = s->grid.degree;
    for (int n = 1; n <= d; n++) factorial[n] = n * factorial[n - 1];
    gather(s, t, component, patch);
    for (int i = d; i >= 0; i--)
        for (int j = d - i; j >= 0; j--) {
            int k = d - i - j;
            sum += *q++ * factorial[d] / (factorial[i] * factorial[j] * factorial[k]) *
                   powl(b[0], i) * powl(b[1], j) * powl(b[2], k);
        }
    return sum;
}

static void raise_degree(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(30); seed++) {
        struct spline s, raised;
        struct err err = {0};
        uint64_t random = seed;
        int degree = 1 + (int)random_in(&random, 0, 7), more = (int)random_in(&random, 0, 7);
        random_spline(&s, 2, degree, seed % 2, seed);
        check_seed(seed, resample_degree(&s, degree + more, &raised, &err));
        for (uint32_t t = 0; t < s.grid.triangle_count; t++) {
            const long double b[3] = {0.25L, 0.625L, 0.125L};
            for (int c = 0; c < 2; c++) {
                long double old = value_at(&s, t, c, b), new = value_at(&raised, t, c, b);
                double patch[GRID_PATCH_MAX], size = 0;
                gather(&s, t, c, patch);
                for (int n = 0; n < grid_patch_size(degree); n++) size = fmax(size, fabs(patch[n]));
                check_seed(seed, fabsl(old - new) <= 0x1p-52L * size);
            }
        }
        spline_free(&s);
        spline_free(&raised);
    }
}

static void refusals(void **state) {
    struct spline s, fine;
    struct err err = {0};
    struct refine_request request = {.times = 11};
    (void)state;
    random_spline(&s, 2, 5, false, 1);
    assert_false(refine_spline(&s, &request, &fine, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "several steps"));
    s.grid.vertex[0][0] = 1 << 23;
    request.times = 2;
    assert_false(refine_spline(&s, &request, &fine, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "vertex 0"));
    spline_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refine_all), cmocka_unit_test(refine_parts),
        cmocka_unit_test(refine_box), cmocka_unit_test(raise_degree),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
