/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tests of the resolution against definitions: flood, all cells, all edges with all sides,
 * samples of the cage; and that, where they pass, the inside is a ball. The width against all
 * pairs. */
#include "icc_resolution.h"

#include "balls.h"
#include "predicate.h"
#include "testing.h"

#include <stdlib.h>
#include <string.h>

struct scene {
    struct icc_domain domain;
    struct icc_function function;
    struct icc_cells cells;
    struct icc_field field;
};

static bool scene_init(struct scene *s, const double (*vertex)[2], size_t n, double h) {
    const struct icc_function_rule rule = {.kind = ICC_COUSIN};
    struct err err = {0};
    const double middle[2] = {0, 0};
    assert_true(icc_domain_init(&s->domain, vertex, n, h, &err));
    if (s->domain.inside_count == 0) {
        icc_domain_free(&s->domain);
        return false;
    }
    assert_true(icc_function_init(&s->function, &s->domain, icc_domain_nearest(&s->domain, middle),
                                  &rule, &err));
    assert_true(icc_cells_init(&s->cells, &s->domain, &err));
    s->field = (struct icc_field){&s->domain, &s->function, &s->cells};
    return true;
}

static void scene_free(struct scene *s) {
    icc_domain_free(&s->domain);
    icc_function_free(&s->function);
    icc_cells_free(&s->cells);
}

static bool cuts(const struct icc_domain *d, double x, double y, double dx, double dy) {
    const double p[2] = {x, y}, q[2] = {x + dx, y + dy};
    for (size_t i = 0; i < d->count; i++) {
        const double *a = d->cage[i], *b = d->cage[i + 1 < d->count ? i + 1 : 0];
        if (predicate_orient(a, b, p) * predicate_orient(a, b, q) < 0 &&
            predicate_orient(p, q, a) * predicate_orient(p, q, b) < 0)
            return true;
    }
    return false;
}

static void count_vertices(const struct scene *s, size_t count[ICC_TESTS]) {
    const struct icc_domain *d = &s->domain;
    for (uint32_t j = 0; j + 1 < d->ny; j++)
        for (uint32_t i = 0; i + 1 < d->nx; i++) {
            const unsigned char *in = &d->inside[j * d->nx + i];
            count[ICC_TEST_REACHED] += in[0] && isnan(s->function.height[j * d->nx + i]);
            count[ICC_TEST_DIAGONAL] += (in[0] && in[d->nx + 1] && !in[1] && !in[d->nx]) ||
                                        (!in[0] && !in[d->nx + 1] && in[1] && in[d->nx]);
            count[ICC_TEST_CUT] += in[0] && in[1] && cuts(d, i, j, 1, 0);
            count[ICC_TEST_CUT] += in[0] && in[d->nx] && cuts(d, i, j, 0, 1);
        }
}

static bool is_bare(const struct scene *s, const double p[2]) {
    uint32_t i = (uint32_t)p[0], j = (uint32_t)p[1], nx = s->domain.nx, v = j * nx + i;
    uint32_t third = p[0] - i >= p[1] - j ? v + 1 : v + nx;
    return isnan(s->function.height[v] + s->function.height[v + nx + 1] +
                 s->function.height[third]);
}

/* Samples of the cage in triangles without values. */
static size_t count_bare(const struct scene *s) {
    const struct icc_domain *d = &s->domain;
    size_t n = 0;
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k <= 400; k++) {
            const double *a = d->cage[i], *b = d->cage[i + 1 < d->count ? i + 1 : 0];
            double p[2] = {a[0] + k / 400.0 * (b[0] - a[0]), a[1] + k / 400.0 * (b[1] - a[1])};
            n += is_bare(s, p);
        }
    return n;
}

static void check(const struct scene *s, uint64_t seed, size_t seen[ICC_TESTS + 1]) {
    struct icc_failures failures[ICC_TESTS];
    size_t count[ICC_TESTS] = {0}, all = 0;
    double p[2];
    icc_resolution(&s->field, failures);
    count_vertices(s, count);
    for (int t = 0; t < ICC_TEST_BARE; t++) check_seed(seed, failures[t].count == count[t]);
    count[ICC_TEST_BARE] = count_bare(s);
    if (count[ICC_TEST_BARE]) check_seed(seed, failures[ICC_TEST_BARE].count > 0);
    for (int t = 0; t < ICC_TESTS; t++) {
        seen[t] += failures[t].count > 0;
        all += failures[t].count;
    }
    seen[ICC_TESTS] += all == 0;
    if (failures[0].count + failures[1].count + failures[2].count == 0)
        check_seed(seed, is_ball(&s->domain));
    if (failures[ICC_TEST_BARE].count == 0) return;
    /* the witness is an end of a piece; beside it, it is bare */
    icc_domain_to_grid(&s->domain, failures[ICC_TEST_BARE].at, p);
    bool bare = false;
    for (int k = 0; k < 9; k++) {
        const double q[2] = {p[0] + (k % 3 - 1) * 1e-9, p[1] + (k / 3 - 1) * 1e-9};
        bare = bare || is_bare(s, q);
    }
    check_seed(seed, bare);
}

static void against_definitions(void **state) {
    size_t seen[ICC_TESTS + 1] = {0};
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(2000); seed++) {
        double vertex[40][2];
        uint64_t random = seed;
        size_t n = (size_t)random_in(&random, 3, 40);
        struct scene s;
        random_cage(vertex, n, 0.97 * random_unit(&random), &random);
        if (!scene_init(&s, (const double(*)[2])vertex, n, 0.03 + 0.2 * random_unit(&random)))
            continue;
        check(&s, seed, seen);
        scene_free(&s);
    }
    print_message("failed: %zu reached, %zu diagonal, %zu cut, %zu bare; %zu passed all\n", seen[0],
                  seen[1], seen[2], seen[3], seen[4]);
    for (int t = 0; t <= ICC_TESTS; t++) assert_true(seen[t] > 0);
}

static void words(void **state) {
    const struct icc_failures failures = {.count = 3, .at = {0.5, -2}, .side = 7};
    char text[ICC_FAILURE_TEXT_MAX];
    (void)state;
    icc_failure_describe(ICC_TEST_DIAGONAL, &failures, text);
    assert_string_equal(text, "grid cells with two opposite corners inside and two outside: 3, "
                              "the first at (0.5, -2)");
    icc_failure_describe(ICC_TEST_BARE, &failures, text);
    assert_string_equal(text, "pieces of the cage too far from grid vertices inside: 3, the first "
                              "at (0.5, -2) on side 7");
}

static double length(const double a[2], const double b[2]) {
    return sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]));
}

static double brute_width(const double (*v)[2], size_t n, double limit) {
    double way[64] = {0}, least = limit, before = -1;
    for (size_t k = 0; k < n; k++) way[k + 1] = way[k] + length(v[k], v[(k + 1) % n]);
    for (size_t k = 0; k < n; k++) {
        if (way[k] - before < limit / 64) continue;
        before = way[k];
        for (size_t side = 0; side < n; side++) {
            const double *a = v[side], *b = v[(side + 1) % n];
            double x = b[0] - a[0], y = b[1] - a[1];
            double t = ((v[k][0] - a[0]) * x + (v[k][1] - a[1]) * y) / (x * x + y * y);
            t = fmin(fmax(t, 0), 1);
            double q[2] = {a[0] + t * x, a[1] + t * y}, d = length(v[k], q);
            double there = fabs(way[k] - way[side] - length(a, q));
            there = fmin(there, way[n] - there);
            if (d > 1e-9 && there > 3 * d && d < least) least = d;
        }
    }
    return least;
}

static void widths(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(300); seed++) {
        double vertex[60][2], width, limit;
        uint64_t random = seed;
        struct err err = {0};
        size_t n = (size_t)random_in(&random, 3, 60);
        random_cage(vertex, n, 0.9, &random);
        limit = 0.05 + 0.4 * random_unit(&random);
        assert_true(icc_width((const double(*)[2])vertex, n, limit, &width, &err));
        check_seed(seed, fabs(width - brute_width((const double(*)[2])vertex, n, limit)) < 1e-12);
    }
}

/* A strip is not narrow by itself, nor is a spike; a neck is. */
static void known_widths(void **state) {
    const double strip[4][2] = {{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}};
    const double spike[3][2] = {{0, 0}, {10, 0}, {0, 0.1}};
    const double neck[6][2] = {{0, 0}, {1, 0.4}, {2, 0}, {2, 1}, {1, 0.5}, {0, 1}};
    double width;
    struct err err = {0};
    (void)state;
    assert_true(icc_width(strip, 4, 1, &width, &err) && width == 1);
    assert_true(icc_width(spike, 3, 1, &width, &err) && width == 1);
    assert_true(icc_width(neck, 6, 1, &width, &err) && fabs(width - 0.1) < 1e-9);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(against_definitions),
        cmocka_unit_test(words),
        cmocka_unit_test(widths),
        cmocka_unit_test(known_widths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
