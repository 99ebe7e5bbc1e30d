/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planted contacts, and random arcs against dense polylines. */
#include "meet.h"
#include "rational.h"

#include "curves.h"
#include "testing.h"

#include <math.h>
#include <string.h>

enum { POINTS = ARC_DEGREE_MAX + 1 };

static const struct meet_rule rule = {0x1p-100, 4096};

/* Control points of x = x0 + (x1 - x0) t, y = sum y[k] t^k, exact where divisions are. */
static void graph(int d, double x0, double x1, const double *y, double (*q)[2]) {
    for (int i = 0; i <= d; i++) {
        double ratio = 1;
        q[i][0] = x0 + (x1 - x0) * i / d;
        q[i][1] = 0;
        for (int k = 0; k <= i; k++) {
            q[i][1] += y[k] * ratio;
            if (k < i) ratio = ratio * (i - k) / (d - k);
        }
    }
}

static void turn(int d, double c, double s, double (*q)[2]) {
    for (int i = 0; i <= d; i++) {
        double x = q[i][0], y = q[i][1];
        q[i][0] = c * x - s * y;
        q[i][1] = s * x + c * y;
    }
}

static void check_apart(int d, const double (*a)[2], const double (*b)[2],
                        enum meet_verdict expected, double s, double t) {
    struct meet m;
    meet_init(&m);
    for (int swap = 0; swap < 2; swap++) {
        meet_arcs(d, swap ? b : a, swap ? a : b, MEET_APART, &rule, &m);
        assert_int_equal(m.verdict, expected);
        if (expected == MEET_POINT)
            for (int i = 0; i < 2; i++)
                assert_true(mpq_equal(m.lo[i], m.hi[i]) &&
                            rational_round(m.lo[i]) == (i == swap ? s : t));
        if (expected == MEET_CROSS) {
            assert_true(rational_round(m.lo[swap]) <= s && s <= rational_round(m.hi[swap]));
            assert_true(rational_round(m.lo[1 - swap]) <= t && t <= rational_round(m.hi[1 - swap]));
            for (int i = 0; i < 2; i++)
                assert_true(rational_round(m.hi[i]) - rational_round(m.lo[i]) <= 0x1p-38);
        }
        if (expected == MEET_UNDECIDED) assert_true(m.distance > 0 && m.distance <= 0x1p-98);
    }
    meet_free(&m);
}

/* The parabola y = 192 (x - 1/2)^2 and lines below, on, and above its top. */
static void test_parabola(void **state) {
    static const double heights[] = {-3, -3 * 0x1p-60, -3 * 0x1p-96, 0, 3 * 0x1p-90, 3 * 0x1p-61,
                                     3};
    double a[POINTS][2], b[POINTS][2];
    (void)state;
    for (int n = 0; n < 28; n++) {
        int d = n & 1 ? 2 : 4;
        double height = heights[n / 4], y[POINTS] = {height}, y2[POINTS] = {48, -192, 192};
        graph(d, 0, 1, y2, a);
        graph(d, -1, 2, y, b);
        if (n & 2) { /* exactly */
            int c = fabs(height) > 1 || height == 0 ? 4 : 0;
            turn(d, c, 3, a);
            turn(d, c, 3, b);
        }
        if (height > 0) { /* two crossings: either is found */
            struct meet m;
            meet_init(&m);
            meet_arcs(d, (const double(*)[2])a, (const double(*)[2])b, MEET_APART, &rule, &m);
            assert_true(m.verdict >= MEET_CROSS);
            assert_true(fabs(fabs(rational_round(m.lo[0]) - 0.5) - sqrt(height / 192)) < 1e-9);
            meet_free(&m);
        } else
            check_apart(d, (const double(*)[2])a, (const double(*)[2])b,
                        height < 0 ? MEET_NOT : MEET_POINT, 0.5, 0.5);
    }
}

/* y = 12 (x^2 - 1/2)^2 touches y = 0 at an irrational place; 2^-90 above and below it. */
static void test_irrational_touch(void **state) {
    double a[POINTS][2], b[POINTS][2];
    struct meet m;
    (void)state;
    meet_init(&m);
    for (int i = -1; i <= 1; i++) {
        double y[POINTS] = {i * 0x1p-90}, c[POINTS] = {3, 0, -12, 0, 12};
        graph(4, 0, 1, c, a);
        graph(4, -0.25, 1, y, b);
        meet_arcs(4, (const double(*)[2])a, (const double(*)[2])b, MEET_APART, &rule, &m);
        assert_int_equal(m.verdict, i < 0 ? MEET_NOT : i == 0 ? MEET_UNDECIDED : MEET_CROSS);
        if (i == 0) assert_true(m.distance > 0 && m.distance <= 16 * 0x1p-100);
        if (i >= 0) assert_true(fabs(rational_round(m.lo[0]) - sqrt(0.5)) < 1e-9);
    }
    meet_free(&m);
}

/* Lines that cross at planted rational places, dyadic ones, and at their ends. */
static void test_lines(void **state) {
    uint64_t seed = 3;
    (void)state;
    for (int n = test_count(500); n > 0; n--) {
        uint64_t start = seed;
        int d = (int)random_in(&seed, 1, 5), p = (int)random_in(&seed, 0, 12);
        int q = (int)random_in(&seed, 0, 12), ways = random_in(&seed, 0, 1) ? 12 : 8;
        double x = (double)random_in(&seed, -99, 99), y = (double)random_in(&seed, -99, 99);
        double u[2] = {(double)random_in(&seed, 1, 99), (double)random_in(&seed, -99, 99)};
        double v[2] = {(double)random_in(&seed, -99, 99), (double)random_in(&seed, 100, 199)};
        double a[POINTS][2], b[POINTS][2];
        struct meet m;
        p = p > ways ? ways : p;
        q = q > ways ? ways : q;
        if (u[0] * v[1] - u[1] * v[0] == 0) continue;
        for (int i = 0; i <= d; i++) /* the point (x,y) at p/ways of a and q/ways of b */
            for (int c = 0; c < 2; c++) {
                a[i][c] = d * (c ? y : x) * 60 + 60 * u[c] * (i * ways - p * d);
                b[i][c] = d * (c ? y : x) * 60 + 60 * v[c] * (i * ways - q * d);
            }
        meet_init(&m);
        meet_arcs(d, (const double(*)[2])a, (const double(*)[2])b, MEET_APART, &rule, &m);
        check_seed(start, m.verdict == MEET_POINT);
        check_seed(start, mpq_equal(m.lo[0], m.hi[0]) && mpq_equal(m.lo[1], m.hi[1]));
        check_seed(start, rational_round(m.lo[0]) == (double)p / ways);
        check_seed(start, rational_round(m.lo[1]) == (double)q / ways);
        meet_free(&m);
    }
}

/* From (1,0) to a corner in (0,0), and back along y = slope x + bend x^2; and the mirror image of
 * that, backwards. */
static void test_corners(void **state) {
    static const struct {
        double slope, bend;
        enum meet_verdict expected;
    } cases[] = {{1, 0, MEET_NOT},
                 {0x1p-30, 0, MEET_NOT},
                 {0x1p-95, 0, MEET_NOT},
                 {0x1p-900, 0, MEET_NOT},
                 {0x1p-40, 1, MEET_NOT},
                 {-0x1p-40, -3, MEET_NOT},
                 {0.5, -3, MEET_CROSS},           /* again at x = 1/6 */
                 {0x1p-40, -3, MEET_CROSS},       /* and at 2^-40 / 3 */
                 {0x1p-30, -0x1p-20, MEET_CROSS}, /* and at 2^-10 */
                 {0, 1, MEET_UNDECIDED},          /* leaves in the same direction */
                 {0, 0, MEET_POINT}};             /* comes back on itself */
    const double a[3][2] = {{1, 0}, {0.5, 0}, {0, 0}}, c[3][2] = {{0, 0}, {-0.5, 0}, {-1, 0}};
    struct meet m;
    (void)state;
    meet_init(&m);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double y[3] = {0, cases[i].slope, cases[i].bend}, b[3][2], back[3][2];
        graph(2, 0, 1, y, b);
        for (int k = 0; k < 3; k++) {
            back[k][0] = -b[2 - k][0];
            back[k][1] = b[2 - k][1];
        }
        for (int mirrored = 0; mirrored < 2; mirrored++) {
            meet_arcs(2, mirrored ? (const double(*)[2])back : a,
                      mirrored ? c : (const double(*)[2])b, MEET_JOINED, &rule, &m);
            if (cases[i].expected == MEET_CROSS)
                assert_true(m.verdict >= MEET_CROSS);
            else
                assert_int_equal(m.verdict, cases[i].expected);
            if (m.verdict >= MEET_CROSS) /* not in the corner */
                assert_true(mpq_sgn(m.lo[1]) > 0 && mpq_cmp_ui(m.hi[0], 1, 1) < 0);
        }
    }
    meet_free(&m);
}

enum { CUTS = 200 };

static void polyline(int d, const double (*q)[2], double (*p)[2]) {
    for (int i = 0; i <= CUTS; i++) curve_point(d, q, (double)i / CUTS, p[i]);
}

static double side(const double a[2], const double b[2], const double c[2]) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

struct truth {
    double distance; /* least, of the two polylines */
    bool cross;
};

/* Segments i of a and j of b with |i - j| <= skip are left out (one arc against itself). */
static struct truth brute(const double (*a)[2], const double (*b)[2], int skip) {
    struct truth t = {1e9, false};
    for (int i = 0; i < CUTS; i++)
        for (int j = 0; j < CUTS; j++) {
            if (skip > 0 && j <= i + skip) continue;
            t.distance = fmin(t.distance, segment_distance(a[i], a[i + 1], b[j]));
            t.distance = fmin(t.distance, segment_distance(b[j], b[j + 1], a[i]));
            if (side(a[i], a[i + 1], b[j]) * side(a[i], a[i + 1], b[j + 1]) < 0 &&
                side(b[j], b[j + 1], a[i]) * side(b[j], b[j + 1], a[i + 1]) < 0)
                t.cross = true;
        }
    if (t.cross) t.distance = 0;
    return t;
}

static void random_arc(int d, uint64_t *seed, double wild, double (*q)[2]) {
    double x = random_unit(seed), y = random_unit(seed), angle = 6.28 * random_unit(seed);
    double length = random_unit(seed);
    for (int i = 0; i <= d; i++) {
        q[i][0] = x + length * cos(angle) * i / d + wild * (random_unit(seed) - 0.5);
        q[i][1] = y + length * sin(angle) * i / d + wild * (random_unit(seed) - 0.5);
    }
}

/* The intervals of a crossing hold places whose images are one point. */
static void check_witness(int d, const double (*a)[2], const double (*b)[2], const struct meet *m,
                          uint64_t seed) {
    double p[2], q[2];
    for (int i = 0; i < 2; i++) {
        check_seed(seed, mpq_sgn(m->lo[i]) >= 0 && mpq_cmp_ui(m->hi[i], 1, 1) <= 0);
        check_seed(seed, mpq_cmp(m->lo[i], m->hi[i]) <= 0);
        check_seed(seed, rational_round(m->hi[i]) - rational_round(m->lo[i]) <= 0x1p-30);
    }
    curve_point(d, a, rational_round(m->lo[0]), p);
    curve_point(d, b, rational_round(m->lo[1]), q);
    check_seed(seed, hypot(p[0] - q[0], p[1] - q[1]) < 1e-7);
}

static void test_random_pairs(void **state) {
    static double pa[CUTS + 1][2], pb[CUTS + 1][2];
    uint64_t seed = 11;
    int met = 0, not = 0;
    struct meet m;
    (void)state;
    meet_init(&m);
    for (int n = test_count(600); n > 0; n--) {
        uint64_t start = seed;
        int d = (int)random_in(&seed, 1, ARC_DEGREE_MAX);
        double a[POINTS][2], b[POINTS][2], wild = (double)random_in(&seed, 0, 2) * 0.5;
        struct truth t;
        random_arc(d, &seed, wild, a);
        random_arc(d, &seed, wild, b);
        meet_arcs(d, (const double(*)[2])a, (const double(*)[2])b, MEET_APART, &rule, &m);
        polyline(d, (const double(*)[2])a, pa);
        polyline(d, (const double(*)[2])b, pb);
        t = brute((const double(*)[2])pa, (const double(*)[2])pb, 0);
        check_seed(start, m.verdict == MEET_NOT || m.verdict == MEET_CROSS);
        if (t.distance > 2e-3) check_seed(start, m.verdict == MEET_NOT);
        if (m.verdict == MEET_NOT) check_seed(start, t.distance > 0 || d > 1);
        if (t.cross) check_seed(start, m.verdict == MEET_CROSS || d > 1);
        if (m.verdict == MEET_CROSS) {
            check_seed(start, t.distance <= 2e-3);
            check_witness(d, (const double(*)[2])a, (const double(*)[2])b, &m, start);
        }
        met += m.verdict == MEET_CROSS;
        not += m.verdict == MEET_NOT;
    }
    assert_true(met > not / 8 && not > met / 8);
    meet_free(&m);
}

/* The polylines of two arcs that follow one another, or twice that of one. The common end moves
 * apart. */
static struct truth brute_chain(int d, const double (*a)[2], const double (*b)[2], bool joined) {
    static double pa[CUTS + 1][2], pb[CUTS + 1][2];
    polyline(d, a, pa);
    polyline(d, b, pb);
    for (int c = 0; c < 2 && joined; c++) {
        pa[CUTS][c] = (pa[CUTS - 1][c] + pa[CUTS][c]) / 2;
        pb[0][c] = (pb[0][c] + pb[1][c]) / 2;
    }
    return brute((const double(*)[2])pa, (const double(*)[2])pb, joined ? 0 : 1);
}

/* Polylines miss loops that are small, and invent none: all but a few agree. */
static void test_random_chains(void **state) {
    uint64_t seed = 5;
    int count[2][2][2] = {{{0}}}; /* joined, as found, truth */
    struct meet m;
    (void)state;
    meet_init(&m);
    for (int n = test_count(600); n > 0; n--) {
        uint64_t start = seed;
        int d = (int)random_in(&seed, 2, 8);
        bool joined = random_bits(&seed) & 1;
        double qa[POINTS][2], qb[POINTS][2], wild = 0.2 + random_unit(&seed);
        const double(*a)[2] = (const double(*)[2])qa, (*b)[2] = (const double(*)[2])qb;
        random_arc(d, &seed, wild, qa);
        random_arc(d, &seed, wild, qb);
        memcpy(qb[0], qa[d], sizeof qb[0]);
        if (!joined) memcpy(qb, qa, sizeof qb);
        meet_arcs(d, a, b, joined ? MEET_JOINED : MEET_SELF, &rule, &m);
        check_seed(start, m.verdict == MEET_NOT || m.verdict == MEET_CROSS);
        if (m.verdict == MEET_CROSS) {
            check_witness(d, a, b, &m, start);
            if (!joined) check_seed(start, mpq_cmp(m.hi[0], m.lo[1]) < 0);
        }
        count[joined][m.verdict == MEET_CROSS][brute_chain(d, a, b, joined).cross]++;
    }
    for (int joined = 0; joined < 2; joined++) {
        assert_true(count[joined][0][0] > 0 && count[joined][1][1] > 0);
        assert_true(20 * count[joined][0][1] <= count[joined][1][1] + 20);
        assert_true(20 * count[joined][1][0] <= count[joined][1][1] + 20);
    }
    meet_free(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parabola),     cmocka_unit_test(test_irrational_touch),
        cmocka_unit_test(test_lines),        cmocka_unit_test(test_corners),
        cmocka_unit_test(test_random_pairs), cmocka_unit_test(test_random_chains),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
