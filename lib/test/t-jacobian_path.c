/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ways from the identity to linear maps, whose determinant is a quadratic in the share that exact
 * rationals decide: first exits, exits that are undone later, dips of any width, near misses. Then
 * random nets against dense samples and exact values. */
#include "jacobian_path.h"
#include "rational.h"

#include "folding.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEGS = 840 };

/* The identity of the given degree on one triangle (0,0), (LEGS,0), (0,LEGS); *to shares its grid.
 */
static void set_up(struct spline *from, struct spline *to, int degree, bool depth) {
    struct grid g = {.degree = degree,
                     .axes = {0, 1, 2},
                     .lattice = {1, 0, 0},
                     .vertex_count = 3,
                     .triangle_count = 1,
                     .has_depth = depth,
                     .depth = {-1, 2}};
    struct err err;
    g.vertex = calloc(3, sizeof *g.vertex);
    g.triangle = calloc(1, sizeof *g.triangle);
    g.vertex[1][0] = g.vertex[2][1] = LEGS;
    for (uint32_t l = 0; l < 3; l++) g.triangle[0][l] = l;
    assert_true(grid_build(&g, &err));
    assert_true(spline_identity(from, &g, &err));
    *to = *from;
    to->phi = calloc(from->grid.point_count, sizeof *to->phi);
    memcpy(to->phi, from->phi, from->grid.point_count * sizeof *to->phi);
    if (!depth) return;
    to->sigma = calloc(from->grid.point_count, sizeof *to->sigma);
    memcpy(to->sigma, from->sigma, from->grid.point_count * sizeof *to->sigma);
}

static void tear_down(struct spline *from, struct spline *to) {
    free(to->phi);
    free(to->sigma);
    spline_free(from);
}

static struct jacobian_exit find_exit(const struct spline *from, const struct spline *to,
                                      enum jacobian_kind kind, double margin,
                                      struct least_place *place) {
    struct jacobian_path path;
    struct jacobian_exit exit;
    struct least_room *room;
    struct err err;
    assert_non_null(room = least_room_new(&err));
    jacobian_path_init(&path, from, to, kind, 0, margin);
    assert_true(jacobian_path_exit(&path, room, 1, &exit, place, &err));
    least_room_free(room);
    return exit;
}

/* ---- linear maps ---- */

/* f(s) = c + b s + a s^2 */
struct quadratic {
    mpq_t a, b, c;
};

static int sign_at(const struct quadratic *f, const mpq_t s) {
    mpq_t sum;
    int sign;
    mpq_init(sum);
    mpq_mul(sum, f->a, s);
    mpq_add(sum, sum, f->b);
    mpq_mul(sum, sum, s);
    mpq_add(sum, sum, f->c);
    sign = mpq_sgn(sum);
    mpq_clear(sum);
    return sign;
}

static int sign_at_double(const struct quadratic *f, double s) {
    mpq_t exact;
    int sign;
    mpq_init(exact);
    mpq_set_d(exact, s);
    sign = sign_at(f, exact);
    mpq_clear(exact);
    return sign;
}

/* f > 0 on [0,upto]: at both ends and, if it lies there, where f' = 0. */
static bool is_positive(const struct quadratic *f, double upto) {
    mpq_t least, end;
    bool positive = sign_at_double(f, 0) > 0 && sign_at_double(f, upto) > 0;
    mpq_inits(least, end, NULL);
    mpq_set_d(end, upto);
    if (mpq_sgn(f->a) > 0) {
        mpq_div(least, f->b, f->a);
        mpq_div_2exp(least, least, 1);
        mpq_neg(least, least);
        if (mpq_sgn(least) > 0 && mpq_cmp(least, end) < 0)
            positive = positive && sign_at(f, least) > 0;
    }
    mpq_clears(least, end, NULL);
    return positive;
}

/* 1 + (trace - 2) s + (det - trace + 1) s^2 - margin */
static void set_quadratic(struct quadratic *f, double trace, double det, double margin) {
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    mpq_set_d(f->c, margin);
    mpq_sub(f->c, one, f->c);
    mpq_set_d(f->b, trace);
    mpq_set_d(f->a, det);
    mpq_sub(f->b, f->b, one);
    mpq_sub(f->a, f->a, f->b);
    mpq_sub(f->b, f->b, one);
    mpq_clear(one);
}

/* From the identity to M = ((0, -det), (1, trace)). Both are multiples of 2^-34 and small, so that
 * everything is exact. */
static struct jacobian_exit linear_exit(int degree, double trace, double det, double margin,
                                        struct quadratic *f) {
    struct spline from, to;
    struct jacobian_exit exit;
    struct least_place place;
    set_up(&from, &to, degree, false);
    for (uint32_t p = 0; p < from.grid.point_count; p++) {
        double x = from.phi[p][0], y = from.phi[p][1];
        to.phi[p][0] = -det * y;
        to.phi[p][1] = x + trace * y;
    }
    set_quadratic(f, trace, det, margin);
    least_place_init(&place);
    exit = find_exit(&from, &to, JACOBIAN_PLANE, margin, &place);
    least_place_free(&place);
    tear_down(&from, &to);
    return exit;
}

/* What must hold of every exit. */
static void check_exit(const struct quadratic *f, struct jacobian_exit exit, uint64_t seed) {
    if (exit.verdict == JACOBIAN_CERTIFIED) {
        check_seed(seed, exit.held == 1 && is_positive(f, 1));
        return;
    }
    check_seed(seed, exit.held == 0 || is_positive(f, exit.held));
    check_seed(seed, exit.held < exit.lost || exit.lost == 0);
    if (exit.held > 0) check_seed(seed, exit.lost - exit.held <= 0x1p-9 * exit.held);
    if (exit.held == 0) check_seed(seed, exit.lost <= 0x1p-20);
    if (exit.verdict == JACOBIAN_FOLDS) check_seed(seed, sign_at_double(f, exit.lost) < 0);
    if (exit.verdict == JACOBIAN_DEGENERATE) check_seed(seed, sign_at_double(f, exit.lost) == 0);
}

/* trace and det of f = (1 - margin)(1 - s/r)(1 - s/q), on multiples of 2^-34. */
static void with_roots(double r, double q, double margin, double *trace, double *det) {
    double b = -(1 - margin) * (1 / r + 1 / q), a = (1 - margin) / (r * q);
    *trace = ldexp(rint(ldexp(b + 2, 34)), -34);
    *det = ldexp(rint(ldexp(a + *trace - 1, 34)), -34);
}

static void quadratic_init(struct quadratic *f) {
    mpq_inits(f->a, f->b, f->c, NULL);
}

static void quadratic_free(struct quadratic *f) {
    mpq_clears(f->a, f->b, f->c, NULL);
}

/* Two roots: the map folds at the first, and unfolds at the second. The dips between them are down
 * to 2e-4 wide, at margins too. */
static void test_dips(void **unused) {
    struct quadratic f;
    uint64_t seed = 5;
    (void)unused;
    quadratic_init(&f);
    for (int n = test_count(2000); n > 0; n--) {
        uint64_t start = seed;
        int degree = (int)random_in(&seed, 1, 5);
        double r = 0.1 + random_unit(&seed), width = ldexp(1, -(int)random_in(&seed, 0, 12));
        double margin = random_bits(&seed) & 1 ? 0 : 0.25 * random_unit(&seed), trace, det;
        struct jacobian_exit exit;
        with_roots(r, r + width, margin, &trace, &det);
        exit = linear_exit(degree, trace, det, margin, &f);
        check_exit(&f, exit, start);
        if (r < 0.999) check_seed(start, exit.verdict == JACOBIAN_FOLDS && exit.held > 0.998 * r);
        if (r > 1.001) check_seed(start, exit.verdict == JACOBIAN_CERTIFIED);
    }
    quadratic_free(&f);
}

/* f comes down to 2^-4 ... 2^-30 of its size, and up again. */
static void test_near_misses(void **unused) {
    struct quadratic f;
    uint64_t seed = 6;
    (void)unused;
    quadratic_init(&f);
    for (int n = test_count(500); n > 0; n--) {
        uint64_t start = seed;
        int degree = (int)random_in(&seed, 1, 5);
        double r = 0.1 + 0.8 * random_unit(&seed), trace, det;
        double gap = ldexp(1, -(int)random_in(&seed, 4, 30));
        with_roots(r, r, 0, &trace, &det);
        det = ldexp(rint(ldexp(det + gap / (r * r), 34)), -34); /* adds gap (s/r)^2 */
        check_seed(start, linear_exit(degree, trace, det, 0, &f).verdict == JACOBIAN_CERTIFIED);
        check_seed(start, is_positive(&f, 1));
    }
    quadratic_free(&f);
}

static void test_touching(void **unused) {
    struct quadratic f;
    struct jacobian_exit exit;
    (void)unused;
    quadratic_init(&f);
    exit = linear_exit(5, -2, 1, 0, &f); /* (1 - 2s)^2: a half turn */
    check_exit(&f, exit, 0);
    assert_true(exit.verdict == JACOBIAN_DEGENERATE && exit.lost == 0.5);
    exit = linear_exit(5, -4, 4, 0, &f); /* (1 - 3s)^2: 1/3 is no double */
    check_exit(&f, exit, 0);
    assert_true(exit.verdict == JACOBIAN_UNDECIDED && exit.held < 1.0 / 3 && exit.lost > 1.0 / 3);
    assert_true(exit.lost - exit.held < 1e-12);
    exit = linear_exit(5, 2, 1, 0, &f); /* stays at 1 */
    assert_true(exit.verdict == JACOBIAN_CERTIFIED);
    exit = linear_exit(5, 2, 1, 1, &f); /* is at the margin all the time */
    assert_true(exit.verdict == JACOBIAN_DEGENERATE && exit.held == 0 && exit.lost == 0);
    exit = linear_exit(5, 2, 1, 1.5, &f);
    assert_true(exit.verdict == JACOBIAN_FOLDS && exit.held == 0 && exit.lost == 0);
    exit = linear_exit(5, 2, 0, 0, &f); /* 1 - s^2 */
    check_exit(&f, exit, 0);
    assert_true(exit.verdict == JACOBIAN_DEGENERATE && exit.lost == 1);
    exit = linear_exit(5, 2 - 0x1p22, 1 - 0x1p22, 0, &f); /* 1 - 2^22 s */
    check_exit(&f, exit, 0);
    assert_true(exit.verdict == JACOBIAN_FOLDS && exit.held == 0 && exit.lost > 0);
    exit = linear_exit(5, 2 - 0x1p18, 1 - 0x1p18, 0, &f); /* 1 - 2^18 s */
    check_exit(&f, exit, 0);
    assert_true(exit.verdict != JACOBIAN_CERTIFIED && exit.held > 0.998 * 0x1p-18);
    quadratic_free(&f);
}

/* ---- random nets ---- */

/* Moves all points at random, by up to `wild` times what is between them. */
static void shake(struct spline *s, double wild, uint64_t *seed) {
    double by = wild * LEGS / s->grid.degree;
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int c = 0; c < 2; c++) {
            s->phi[p][c] += by * (random_unit(seed) - 0.5);
            if (s->sigma) s->sigma[p][c] += 2 * wild * (random_unit(seed) - 0.5);
        }
}

static void set_place(const struct least_place *place, mpq_t b[3]) {
    mpz_t sum;
    mpz_init(sum);
    for (int l = 0; l < 3; l++) mpz_add(sum, sum, place->weight[l]);
    for (int l = 0; l < 3; l++) {
        mpz_set(mpq_numref(b[l]), place->weight[l]);
        mpz_set(mpq_denref(b[l]), sum);
        mpq_canonicalize(b[l]);
    }
    mpz_clear(sum);
}

/* The witness is one, and its value is rounded once. */
static void check_witness(const struct folding *way, struct jacobian_exit exit, double margin,
                          const struct least_place *place, uint64_t seed) {
    struct jacobian_path path;
    struct err err;
    mpq_t b[3], s, value, least;
    double rounded;
    mpq_inits(b[0], b[1], b[2], s, value, least, NULL);
    set_place(place, b);
    mpq_set_d(s, exit.lost);
    mpq_set_d(least, margin);
    folding_value(way, s, (const mpq_t *)b, value);
    check_seed(seed, mpq_cmp(value, least) <= 0);
    jacobian_path_init(&path, way->from, way->to, (enum jacobian_kind)way->thickness, 0, margin);
    assert_true(jacobian_path_value(&path, exit.lost, place, &rounded, &err));
    check_seed(seed, rounded == rational_round(value));
    mpq_clears(b[0], b[1], b[2], s, value, least, NULL);
}

/* Returns 0 if it does not fold, 1 if it does, 2 if the samples do not find the exit as near. */
static int check_random(uint64_t seed, bool thickness) {
    uint64_t state = seed;
    struct spline from, to;
    struct jacobian_exit exit;
    struct least_place place;
    struct folding way = {&from, &to, thickness, 0};
    double margin = random_bits(&state) & 1 ? 0 : 0.2, sampled;
    set_up(&from, &to, (int)random_in(&state, 1, seed % 20 == 0 ? 15 : 8), thickness);
    shake(&from, 0.4, &state);
    shake(&to, 2.5 * random_unit(&state), &state);
    least_place_init(&place);
    exit = find_exit(&from, &to, (enum jacobian_kind)thickness, margin, &place);
    sampled = folding_first_loss(&way, margin, 24);
    check_seed(seed, sampled >= exit.held);
    if (exit.verdict == JACOBIAN_CERTIFIED) {
        check_seed(seed, sampled == INFINITY);
    } else {
        check_seed(seed, exit.verdict == JACOBIAN_FOLDS || exit.verdict == JACOBIAN_DEGENERATE);
        check_seed(seed, exit.lost <= exit.held + 0x1p-9 * exit.held || exit.held == 0);
        check_witness(&way, exit, margin, &place, seed);
    }
    least_place_free(&place);
    tear_down(&from, &to);
    if (exit.verdict == JACOBIAN_CERTIFIED) return 0;
    return sampled <= 1.005 * exit.held || exit.lost == 0 ? 1 : 2;
}

static void test_random(void **unused) {
    int count[3] = {0}, n = test_count(600);
    (void)unused;
    for (int i = 0; i < n; i++) count[check_random(1000 + (uint64_t)i, i % 2)]++;
    assert_true(count[0] >= n / 10 && count[1] >= n / 10); /* both happen */
    assert_true(count[2] <= n / 50);
}

/* ---- signs ---- */

/* In degree 1 the determinant is the same everywhere: margins within some ulps of it, far from the
 * origin too. */
static void check_hairline(struct least_room *room, uint64_t seed) {
    uint64_t state = seed;
    struct spline from, to;
    struct jacobian_path path;
    struct least_place place;
    struct folding way = {&from, &to, false, 0};
    enum jacobian_verdict verdict;
    struct err err;
    double share = random_unit(&state), margin, shift = ldexp(1, (int)random_in(&state, 0, 40));
    mpq_t b[3], s, value, least;
    mpq_inits(b[0], b[1], b[2], s, value, least, NULL);
    set_up(&from, &to, 1, false);
    shake(&from, 0.2, &state);
    shake(&to, 0.2, &state);
    for (uint32_t p = 0; p < 3; p++) from.phi[p][0] += shift, to.phi[p][1] -= shift;
    mpq_set_d(s, share);
    mpq_set_ui(b[0], 1, 1);
    folding_value(&way, s, (const mpq_t *)b, value);
    margin = rational_round(value);
    for (int ulps = (int)random_in(&state, 0, 4); ulps > 0; ulps--)
        margin = nextafter(margin, random_bits(&state) & 1 ? INFINITY : 0);
    mpq_set_d(least, margin);
    jacobian_path_init(&path, &from, &to, JACOBIAN_PLANE, 0, margin);
    least_place_init(&place);
    assert_true(jacobian_path_sign(&path, room, share, share, &verdict, &place, &err));
    check_seed(seed, verdict == jacobian_verdict_of(mpq_cmp(value, least), mpq_cmp(value, least)));
    least_place_free(&place);
    mpq_clears(b[0], b[1], b[2], s, value, least, NULL);
    tear_down(&from, &to);
}

static void test_hairlines(void **unused) {
    struct least_room *room;
    struct err err;
    (void)unused;
    assert_non_null(room = least_room_new(&err));
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(1000); seed++) check_hairline(room, seed);
    least_room_free(room);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dips),      cmocka_unit_test(test_near_misses),
        cmocka_unit_test(test_touching),  cmocka_unit_test(test_random),
        cmocka_unit_test(test_hairlines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
