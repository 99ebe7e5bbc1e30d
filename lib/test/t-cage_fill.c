/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The points of a lattice in a cage against all points of that lattice, one by one. */
#include "cage_fill.h"

#include "cages.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double distance(const double a[2], const double b[2]) {
    return hypot(a[0] - b[0], a[1] - b[1]);
}

/* From the nearest side, positive inside. */
static double depth(const double (*v)[2], size_t n, const double p[2]) {
    double least = INFINITY;
    bool inside = false;
    for (size_t i = 0; i < n; i++) {
        const double *a = v[i], *b = v[(i + 1) % n];
        double x = b[0] - a[0], y = b[1] - a[1];
        double s = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
        s = s < 0 ? 0 : s > 1 ? 1 : s;
        least = fmin(least, hypot(a[0] + s * x - p[0], a[1] + s * y - p[1]));
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + x * (p[1] - a[1]) / y) inside = !inside;
    }
    return inside ? least : -least;
}

/* Two neighbours in a row give the lattice. */
static bool find_row(const double (*point)[2], size_t count, double h, double e[2]) {
    for (size_t i = 0; i + 1 < count; i++)
        if (fabs(distance(point[i], point[i + 1]) - h) < 1e-9 * h) {
            for (int k = 0; k < 2; k++) e[k] = point[i + 1][k] - point[i][k];
            return true;
        }
    return false;
}

static size_t count_near(const double (*point)[2], size_t count, const double p[2], double r) {
    size_t n = 0;
    for (size_t i = 0; i < count; i++) n += distance(point[i], p) < r;
    return n;
}

static void check(const double (*v)[2], size_t n, double h, double r, uint64_t seed) {
    struct cage c;
    struct err err = {0};
    double(*point)[2], e[2], reach = 0;
    size_t count;
    assert_true(cage_init(&c, v, n, &err));
    assert_true(cage_fill(&c, NULL, h, r, 100000, &point, &count, &err));
    for (size_t i = 0; i < count; i++) check_seed(seed, depth(v, n, point[i]) > r * (1 - 1e-9));
    if (find_row((const double(*)[2])point, count, h, e)) {
        for (size_t i = 0; i < n; i++) reach = fmax(reach, distance(v[i], point[0]));
        int many = (int)ceil(2 * reach / h) + 1;
        for (int i = -many; i <= many; i++)
            for (int j = -many; j <= many; j++) {
                double p[2] = {point[0][0] + i * e[0] + j * (e[0] / 2 - sqrt(0.75) * e[1]),
                               point[0][1] + i * e[1] + j * (e[1] / 2 + sqrt(0.75) * e[0])};
                double d = depth(v, n, p);
                size_t found;
                if (fabs(d - r) < 1e-6 * h) continue;
                found = count_near((const double(*)[2])point, count, p, 1e-6 * h);
                check_seed(seed, found == (d > r));
            }
    }
    free(point);
    cage_free(&c);
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(60); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct cage_pair pair;
        cage_pair_random(&pair, 3, 30, seed);
        double h = 0.02 + 0.1 * random_unit(&state);
        check((const double(*)[2])pair.source, pair.count, h, h * (0.1 + random_unit(&state)),
              seed);
        cage_pair_free(&pair);
    }
}

static void test_planted(void **unused) {
    const double thin[4][2] = {{0, 0}, {10, 0}, {10, 0.5}, {0, 0.5}};
    const double square[4][2] = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
    struct cage c;
    struct err err = {0};
    double(*point)[2];
    size_t count;
    (void)unused;
    assert_true(cage_init(&c, thin, 4, &err)); /* no room: half as wide as the clearance wants */
    assert_true(cage_fill(&c, NULL, 1, 0.45, 10, &point, &count, &err));
    assert_int_equal(count, 0);
    cage_free(&c);
    assert_true(cage_init(&c, square, 4, &err));
    assert_true(
        cage_fill(&c, NULL, 1, 2.9, 10, &point, &count, &err)); /* the centroid is a point */
    assert_int_equal(count, 1);
    assert_true(fabs(point[0][0]) < 1e-15 && fabs(point[0][1]) < 1e-15);
    free(point);
    assert_false(cage_fill(&c, NULL, 1, 0.1, 10, &point, &count, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message, "more than 10 points inside");
    cage_free(&c);
}

/* A regular polygon has no axis; one side that weighs more gives it one. Then a similarity of the
 * polygon is one of the points. */
static void test_symmetric(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(40); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        const double turn = 6.283185307179586 * random_unit(&state), size = 1 + random_unit(&state);
        size_t sides = (size_t)random_in(&state, 3, 12), count[2];
        double v[2][12][2], weight[12], (*point[2])[2];
        for (size_t i = 0; i < sides; i++) {
            double angle = 6.283185307179586 * (double)i / (double)sides;
            weight[i] = i == 1 ? 2 : 1;
            for (int m = 0; m < 2; m++) {
                v[m][i][0] = (m ? size : 1) * cos(angle + m * turn) + 3 * m;
                v[m][i][1] = (m ? size : 1) * sin(angle + m * turn);
            }
        }
        for (int m = 0; m < 2; m++) {
            struct cage c;
            struct err err = {0};
            double ordered[12], h = m ? 0.1 * size : 0.1;
            assert_true(cage_init(&c, (const double(*)[2])v[m], sides, &err));
            for (size_t k = 0; k < sides; k++) ordered[k] = weight[(c.shift + k) % sides];
            assert_true(cage_fill(&c, ordered, h, h / 2, 100000, &point[m], &count[m], &err));
            cage_free(&c);
        }
        check_seed(seed, count[0] == count[1] && count[0] > 50);
        for (size_t i = 0; i < count[0]; i++) {
            double x = point[0][i][0], y = point[0][i][1];
            double image[2] = {size * (cos(turn) * x - sin(turn) * y) + 3,
                               size * (sin(turn) * x + cos(turn) * y)};
            check_seed(seed, count_near((const double(*)[2])point[1], count[1], image, 1e-9) == 1);
        }
        free(point[0]);
        free(point[1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_planted),
        cmocka_unit_test(test_symmetric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
