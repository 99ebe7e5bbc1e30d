/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The grid over a cage: inside against winding numbers in long double and against polygon.h, cut
 * edges against all pairs of edges and sides, the grassfire against the least of all distances. */
#include "icc_domain.h"

#include "balls.h"
#include "predicate.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Does the segment from p to q cross a side, in grid coordinates, by exact signs? */
static bool is_cut(const struct icc_domain *d, const double p[2], const double q[2]) {
    for (size_t i = 0; i < d->count; i++) {
        const double *a = d->cage[i], *b = d->cage[i + 1 < d->count ? i + 1 : 0];
        if (predicate_orient(a, b, p) * predicate_orient(a, b, q) < 0 &&
            predicate_orient(p, q, a) * predicate_orient(p, q, b) < 0)
            return true;
    }
    return false;
}

static bool is_inside(const struct icc_domain *d, const double p[2]) {
    bool inside = false;
    for (size_t i = 0; i < d->count; i++) {
        const double *a = d->cage[i], *b = d->cage[i + 1 < d->count ? i + 1 : 0];
        if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
        if (predicate_orient(a, b, p) * (b[1] > a[1] ? 1 : -1) > 0) inside = !inside;
    }
    return inside;
}

static void check_domain(const struct icc_domain *d, uint64_t seed) {
    uint32_t inside = 0;
    bool cut = false;
    for (uint32_t v = 0; v < icc_domain_size(d); v++) {
        double p[2] = {v % d->nx, v / d->nx}, right[2] = {p[0] + 1, p[1]}, up[2] = {p[0], p[1] + 1};
        check_seed(seed, d->inside[v] == is_inside(d, p));
        inside += d->inside[v];
        if (!d->inside[v]) continue;
        check_seed(seed, p[0] >= 2 && p[1] >= 2 && p[0] < d->nx - 2 && p[1] < d->ny - 2);
        cut = cut || (d->inside[v + 1] && is_cut(d, p, right)) ||
              (d->inside[v + d->nx] && is_cut(d, p, up));
    }
    check_seed(seed, inside == d->inside_count);
    check_seed(seed, cut == (d->cut_count > 0));
    if (!cut) return;
    double p[2] = {d->cut[0] % d->nx, d->cut[0] / d->nx},
           q[2] = {d->cut[1] % d->nx, d->cut[1] / d->nx};
    check_seed(seed, is_cut(d, p, q) && d->inside[d->cut[0]] && d->inside[d->cut[1]]);
}

static void random_domains(void **state) {
    (void)state;
    int cuts = 0;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(1000); seed++) {
        double vertex[60][2];
        uint64_t random = seed;
        size_t n = (size_t)random_in(&random, 3, 60);
        double h = 0.02 + 0.3 * random_unit(&random);
        struct icc_domain d;
        struct err err = {0};
        random_cage(vertex, n, 0.95, &random);
        check_seed(seed, icc_domain_init(&d, (const double(*)[2])vertex, n, h, &err));
        check_domain(&d, seed);
        cuts += d.cut_count > 0;
        icc_domain_free(&d);
    }
    assert_true(cuts > 0);
}

/* Coordinates: the bounding box in the middle, two cells around it, the shift. */
static void layout(void **state) {
    const double box[4][2] = {{10, 20}, {13, 20}, {13, 21}, {10, 21}};
    struct icc_domain d;
    struct err err = {0};
    double p[2];
    (void)state;
    assert_true(icc_domain_init(&d, box, 4, 0.5, &err));
    assert_int_equal(d.nx, 11);
    assert_int_equal(d.ny, 7);
    icc_domain_vertex(&d, 0, p);
    assert_true(fabs(p[0] - (10 - 1 + 0.0137 * 0.5)) < 1e-12);
    assert_true(fabs(p[1] - (20 - 1 + 0.0071 * 0.5)) < 1e-12);
    assert_int_equal(d.inside_count, 6 * 2);
    icc_domain_free(&d);
}

static void burning(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(100); seed++) {
        struct icc_domain d;
        uint64_t random = seed;
        uint32_t last, layers, most = 0;
        random_ball(&d, 16, 12, (uint32_t)random_in(&random, 1, 120), &random);
        uint32_t *layer = calloc(icc_domain_size(&d), sizeof *layer);
        assert_non_null(layer);
        layers = icc_domain_burn(&d, layer);
        for (uint32_t v = 0; v < icc_domain_size(&d); v++) {
            uint32_t least = d.inside[v] ? UINT32_MAX : 0;
            for (uint32_t w = 0; d.inside[v] && w < icc_domain_size(&d); w++) {
                uint32_t x = (uint32_t)abs((int)(v % d.nx) - (int)(w % d.nx));
                uint32_t y = (uint32_t)abs((int)(v / d.nx) - (int)(w / d.nx));
                if (!d.inside[w] && x + y < least) least = x + y;
            }
            check_seed(seed, layer[v] == least);
            if (least > most) most = least;
        }
        check_seed(seed, layers == most);
        last = icc_domain_last(&d, layer, layers);
        check_seed(seed, layer[last] == layers);
        free(layer);
        icc_domain_free(&d);
    }
}

/* A plus: the middle. Two rows: the four in the middle are equally near, the lowest number wins. */
static void fire_ends(void **state) {
    static const unsigned char plus[25] = {0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1,
                                           1, 1, 0, 1, 1, 1, 0, 0, 0, 1, 0, 0};
    static const unsigned char rows[8] = {1, 1, 1, 1, 1, 1, 1, 1};
    struct icc_domain d;
    uint32_t layer[81];
    const double world[2] = {3.4, 2.9};
    (void)state;
    planted_domain(&d, 5, 5, plus);
    assert_int_equal(icc_domain_burn(&d, layer), 3);
    assert_int_equal(icc_domain_last(&d, layer, 3), 4 * d.nx + 4);
    icc_domain_free(&d);
    planted_domain(&d, 4, 2, rows);
    assert_int_equal(icc_domain_burn(&d, layer), 1);
    assert_int_equal(icc_domain_last(&d, layer, 1), 2 * d.nx + 3);
    assert_int_equal(icc_domain_nearest(&d, world), 3 * d.nx + 3);
    icc_domain_free(&d);
}

static void refusals(void **state) {
    const double box[4][2] = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
    const double far[4][2] = {{1e12, 0}, {1e12 + 1, 0}, {1e12 + 1, 1}, {1e12, 1}};
    struct icc_domain d;
    struct err err = {0};
    (void)state;
    assert_false(icc_domain_init(&d, box, 4, 1e-4, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "resolution: with cells of 0.0001"));
    icc_domain_free(&d);
    assert_false(icc_domain_init(&d, far, 4, 0.1, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "precision"));
    icc_domain_free(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_domains), cmocka_unit_test(layout),   cmocka_unit_test(burning),
        cmocka_unit_test(fire_ends),      cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
