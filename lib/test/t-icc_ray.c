/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The theorems of a bijective map, on cages that are hard and on random ones: the boundary goes
 * where it should, nothing flips or collapses, nothing leaves the cage, inverses undo. */
#include "icc_ray.h"

#include "cages.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A pair of cages, bound, for both directions. */
struct binding {
    const struct cage_pair *pair;
    struct cage source, target;
    struct icc_ray s, t;
    struct icc_ray_cursor to, back;
};

static void bind(struct binding *b, const struct cage_pair *pair, size_t points) {
    struct err err = {0};
    *b = (struct binding){.pair = pair};
    assert_true(cage_init(&b->source, (const double(*)[2])pair->source, pair->count, &err));
    assert_true(cage_init_like(&b->target, (const double(*)[2])pair->target, pair->count,
                               &b->source, &err));
    if (!icc_ray_init(&b->s, &b->source, NULL, points, &err) ||
        !icc_ray_init(&b->t, &b->target, &b->s, points, &err))
        fail_msg("%s: %s", pair->name, err.message);
    assert_true(icc_ray_prepare(&b->s, ICC_RAY_LOOK_UP | ICC_RAY_ASK, &err));
    assert_true(icc_ray_prepare(&b->t, ICC_RAY_LOOK_UP | ICC_RAY_ASK, &err));
}

static void release(struct binding *b) {
    icc_ray_free(&b->t);
    icc_ray_free(&b->s);
    cage_free(&b->target);
    cage_free(&b->source);
}

static double distance(const double a[2], const double b[2]) {
    double x = a[0] - b[0], y = a[1] - b[1];
    return sqrt(x * x + y * y);
}

static void random_inside(const struct cage *c, uint64_t *state, double p[2]) {
    const struct polygon *g = &c->polygon;
    do {
        for (int k = 0; k < 2; k++) p[k] = g->lo[k] + random_unit(state) * (g->hi[k] - g->lo[k]);
    } while (polygon_side(g, p) <= 0);
}

/* A point in a random triangle of the mesh: thin parts of the cage get their share. */
static void random_in_mesh(const struct icc_ray *r, uint64_t *state, double p[2]) {
    const struct mesh *m = &r->mesh.mesh;
    const uint32_t *v = m->triangle[random_in(state, 0, (int64_t)m->triangle_count - 1)];
    double a = random_unit(state), b = random_unit(state) * (1 - a);
    for (int k = 0; k < 2; k++)
        p[k] = m->vertex[v[0]][k] + a * (m->vertex[v[1]][k] - m->vertex[v[0]][k]) +
               b * (m->vertex[v[2]][k] - m->vertex[v[0]][k]);
}

/* Vertices exactly; points computed on a side to where the same lambda is on the other cage, but
 * for the rounding of these points, which counts more where a side grows or its surroundings do. */
static void check_cage(struct binding *b, uint64_t *state) {
    for (uint32_t k = 0; k < b->source.count; k++) {
        const double *from = b->source.vertex[k], *to = b->target.vertex[k];
        uint32_t next = cage_next(&b->source, k);
        double growth =
            distance(to, b->target.vertex[next]) / distance(from, b->source.vertex[next]);
        double rounding = 1e-11 * (growth * b->source.diameter + b->target.diameter);
        double p[2], q[2], h[2], lambda = random_unit(state);
        assert_true(icc_ray_map(&b->s, &b->t, &b->to, from, q));
        assert_true(memcmp(q, to, sizeof q) == 0);
        cage_point(&b->source, k, lambda, p);
        cage_point(&b->target, k, lambda, h);
        assert_true(icc_ray_map(&b->s, &b->t, &b->to, p, q));
        if (distance(q, h) > rounding)
            fail_msg("%s: side %u, lambda %g: off by %g instead of %g", b->pair->name, k, lambda,
                     distance(q, h), rounding);
    }
}

/* Is a small triangle at p mapped to a counter-clockwise one? Where it lies across edges of the
 * mesh it may not be, so a smaller one may do. */
static bool keeps_sense(struct binding *b, const double p[2], const double q[2]) {
    for (double d = 1e-5; d > 1e-10; d /= 100) {
        const struct polygon *g = &b->source.polygon;
        double x[2] = {p[0] + d * (g->hi[0] - g->lo[0]), p[1]}, u[2], v[2];
        double y[2] = {p[0], p[1] + d * (g->hi[1] - g->lo[1])};
        if (!icc_ray_map(&b->s, &b->t, &b->to, x, u) || !icc_ray_map(&b->s, &b->t, &b->to, y, v))
            continue; /* outside */
        if ((u[0] - q[0]) * (v[1] - q[1]) > (u[1] - q[1]) * (v[0] - q[0])) return true;
    }
    return false;
}

static void check_point(struct binding *b, const double p[2], bool check_sense) {
    double q[2], r[2], lambda;
    struct icc_place place;
    uint32_t side;
    assert_true(icc_ray_map(&b->s, &b->t, &b->to, p, q));
    assert_int_not_equal(cage_find(&b->target, q, &side, &lambda), CAGE_OUTSIDE);
    assert_true(icc_ray_map(&b->t, &b->s, &b->back, q, r));
    if (distance(p, r) > b->pair->back * b->source.diameter)
        fail_msg("%s: there and back: %g of the diameter", b->pair->name,
                 distance(p, r) / b->source.diameter);
    assert_true(icc_ray_coordinates(&b->s, &b->to, p, &place));
    assert_true(place.side < b->source.count && place.lambda >= 0 && place.lambda < 1);
    assert_true(place.t >= 0 && place.t <= 1);
    icc_ray_point(&b->t, &b->to, &place, r);
    if (distance(q, r) > 1e-12 * b->target.diameter)
        fail_msg("%s: by coordinates: %g of the diameter", b->pair->name,
                 distance(q, r) / b->target.diameter);
    if (check_sense && !keeps_sense(b, p, q))
        fail_msg("%s: turned over at %.17g %.17g", b->pair->name, p[0], p[1]);
}

static void check_pair(const struct cage_pair *pair, size_t points, int samples, uint64_t seed) {
    struct binding b;
    uint64_t state = seed;
    double p[2];
    bind(&b, pair, points);
    for (int i = 0; i < 5; i++) check_cage(&b, &state);
    for (int i = 0; i < samples; i++) {
        random_inside(&b.source, &state, p);
        check_point(&b, p, true);
        random_in_mesh(&b.s, &state, p);
        if (polygon_side(&b.source.polygon, p) > 0) check_point(&b, p, false);
    }
    release(&b);
}

static void test_hard(void **unused) {
    (void)unused;
    for (int i = 0; i < CAGE_PAIRS; i++) {
        struct cage_pair pair;
        cage_pair_make(&pair, i);
        check_pair(&pair, icc_mesh_points(pair.count), test_count(500), (uint64_t)i);
        cage_pair_free(&pair);
    }
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(200); n++) {
        struct cage_pair pair;
        cage_pair_random(&pair, 4, 60, (uint64_t)n);
        check_pair(&pair, icc_mesh_points(pair.count), 100, (uint64_t)n);
        cage_pair_free(&pair);
    }
}

/* The same points through both bindings, bit for bit. */
static void check_same_bits(const struct cage_pair *pair, const struct cage_pair *other,
                            uint64_t seed) {
    struct binding b, c;
    uint64_t state = seed;
    bind(&b, pair, icc_mesh_points(pair->count));
    bind(&c, other, icc_mesh_points(pair->count));
    for (int i = 0; i < 300; i++) {
        double p[2], q[2], r[2];
        struct icc_place place, same;
        random_inside(&b.source, &state, p);
        check_seed(seed, icc_ray_map(&b.s, &b.t, &b.to, p, q));
        check_seed(seed, icc_ray_map(&c.s, &c.t, &c.to, p, r));
        check_seed(seed, memcmp(q, r, sizeof q) == 0);
        check_seed(seed, icc_ray_coordinates(&b.s, &b.to, p, &place));
        check_seed(seed, icc_ray_coordinates(&c.s, &c.to, p, &same));
        check_seed(seed, place.side == same.side && place.lambda == same.lambda);
        check_seed(seed, place.t == same.t);
    }
    release(&b);
    release(&c);
}

/* Where the lists begin, and whether they are clockwise, changes nothing. */
static void test_rotated_lists(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(40); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct cage_pair pair, turned;
        if (n < CAGE_PAIRS_QUICK)
            cage_pair_make(&pair, n);
        else
            cage_pair_random(&pair, 4, 60, seed);
        cage_pair_turn(&turned, &pair, (size_t)random_in(&state, 1, (int64_t)pair.count - 1),
                       n % 2);
        check_same_bits(&pair, &turned, seed);
        cage_pair_free(&pair);
        cage_pair_free(&turned);
    }
}

static void test_identity(void **unused) {
    (void)unused;
    for (int n = 0; n < CAGE_PAIRS_QUICK + test_count(20); n++) {
        uint64_t state = (uint64_t)n;
        struct cage_pair pair;
        struct binding b;
        if (n < CAGE_PAIRS_QUICK)
            cage_pair_make(&pair, n);
        else
            cage_pair_random(&pair, 4, 60, state);
        memcpy(pair.target, pair.source, pair.count * sizeof *pair.target);
        bind(&b, &pair, icc_mesh_points(pair.count));
        for (int i = 0; i < 300; i++) {
            double p[2], q[2];
            random_inside(&b.source, &state, p);
            assert_true(icc_ray_map(&b.s, &b.t, &b.to, p, q));
            if (distance(p, q) > 1e-12 * b.source.diameter)
                fail_msg("%s: identity: %g", pair.name, distance(p, q) / b.source.diameter);
        }
        release(&b);
        cage_pair_free(&pair);
    }
}

/* A similarity of the plane: (c + i s) z + x + i y. */
struct similarity {
    double c, s, x, y;
};

static void apply(const struct similarity *a, const double p[2], double q[2]) {
    q[0] = a->c * p[0] - a->s * p[1] + a->x;
    q[1] = a->s * p[0] + a->c * p[1] + a->y;
}

/* What a similarity of both cages changes, over the diameter: the mean square; the largest. */
static double similarity_error(const struct cage_pair *pair, const struct similarity *a,
                               size_t points, double *largest) {
    struct cage_pair moved;
    struct binding b, c;
    uint64_t state = 1;
    double sum = 0;
    int samples = 200;
    cage_pair_turn(&moved, pair, 0, 0);
    for (size_t i = 0; i < pair->count; i++) {
        apply(a, pair->source[i], moved.source[i]);
        apply(a, pair->target[i], moved.target[i]);
    }
    bind(&b, pair, points);
    bind(&c, &moved, points);
    for (int i = 0; i < samples; i++) {
        double p[2], q[2], r[2], x[2], y[2], d;
        random_inside(&b.source, &state, p);
        apply(a, p, x);
        assert_true(icc_ray_map(&b.s, &b.t, &b.to, p, q));
        if (!icc_ray_map(&c.s, &c.t, &c.to, x, y)) continue; /* rounded to the outside */
        apply(a, q, r);
        d = distance(r, y) / c.target.diameter;
        sum += d * d / samples;
        *largest = fmax(*largest, d);
    }
    release(&b);
    release(&c);
    cage_pair_free(&moved);
    return sum;
}

static const struct similarity similarities[] = {
    {0.6, 0.8, 3, -2}, {-200, 150, 1e4, 0}, {1e-3, 3e-3, 0, 0}, {0.04, 0.99, 0, 0}};

/* A cage with two different principal axes, or whose sides tell them apart, takes its mesh along,
 * and nothing changes but by rounding. A symmetric one gets another mesh: at most 1 % of the
 * diameter at the default number of points, half of that at four times as many. */
static void test_similarity(void **unused) {
    double coarse = 0, fine = 0;
    (void)unused;
    for (int n = 0; n < CAGE_PAIRS_QUICK + test_count(20); n++) {
        const struct similarity *a = &similarities[n % 4];
        struct cage_pair pair;
        double largest = 0;
        if (n < CAGE_PAIRS_QUICK)
            cage_pair_make(&pair, n);
        else
            cage_pair_random(&pair, 4, 60, (uint64_t)n);
        size_t points = icc_mesh_points(pair.count);
        (void)similarity_error(&pair, a, points, &largest);
        if (largest > 0.01 || (n >= CAGE_PAIRS_QUICK && largest > 1e-7) ||
            (strcmp(pair.name, "comb to a circle") == 0 && largest > 1e-9))
            fail_msg("%s: a similarity changes %g", pair.name, largest);
        for (int i = 0; n < 4 && i < 4; i++) {
            coarse += similarity_error(&pair, &similarities[i], points, &largest);
            fine += similarity_error(&pair, &similarities[i], 4 * points, &largest);
        }
        cage_pair_free(&pair);
    }
    if (!(fine * 4 <= coarse)) fail_msg("not halved: %g to %g", sqrt(coarse), sqrt(fine));
}

/* Coordinates name one point, and the point has these coordinates. */
static void test_coordinates(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(30); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct cage_pair pair;
        struct binding b;
        double centre[2], p[2];
        cage_pair_random(&pair, 3, 30, seed);
        bind(&b, &pair, n % 3 ? icc_mesh_points(pair.count) : 0);
        icc_ray_point(&b.s, &b.to, &(struct icc_place){0, 0, 0}, centre);
        check_seed(seed, polygon_side(&b.source.polygon, centre) > 0);
        for (int i = 0; i < 300; i++) {
            uint32_t side = (uint32_t)random_in(&state, 0, (int64_t)pair.count - 1);
            struct icc_place place = {side, random_unit(&state), random_unit(&state)}, found;
            icc_ray_point(&b.s, &b.to, &place, p);
            check_seed(seed, icc_ray_coordinates(&b.s, &b.to, p, &found));
            check_seed(seed, fabs(found.t - place.t) < 1e-9);
            check_seed(seed, place.t < 1e-3 || found.side == place.side ||
                                 place.lambda > 1 - 1e-6 || place.lambda < 1e-6);
            check_seed(seed, place.t < 1e-3 || found.side != place.side ||
                                 fabs(found.lambda - place.lambda) < 1e-6);
            place.t = 0;
            icc_ray_point(&b.s, &b.to, &place, p);
            check_seed(seed, memcmp(p, centre, sizeof p) == 0);
            place.t = 1;
            icc_ray_point(&b.s, &b.to, &place, p);
            cage_point(&b.source, place.side, place.lambda, centre);
            check_seed(seed, memcmp(p, centre, sizeof p) == 0);
            icc_ray_point(&b.s, &b.to, &(struct icc_place){0, 0, 0}, centre);
        }
        release(&b);
        cage_pair_free(&pair);
    }
}

/* Towards the maximum t falls, along a line that stays on its ray. */
static void test_rays(void **unused) {
    struct cage_pair pair;
    struct binding b;
    uint64_t state = 1;
    (void)unused;
    cage_pair_random(&pair, 20, 20, 7);
    bind(&b, &pair, 600);
    for (int i = 0; i < 100; i++) {
        struct icc_place place = {(uint32_t)random_in(&state, 0, 19),
                                  0.1 + 0.8 * random_unit(&state), 1},
                         found;
        double before = 1, p[2];
        for (place.t = 0.95; place.t > 0.01; place.t -= 0.05) {
            icc_ray_point(&b.s, &b.to, &place, p);
            assert_true(icc_ray_coordinates(&b.s, &b.to, p, &found));
            assert_true(found.t < before && found.side == place.side);
            assert_true(fabs(found.lambda - place.lambda) < 1e-9);
            before = found.t;
        }
    }
    release(&b);
    cage_pair_free(&pair);
}

/* As near to the cage as doubles come, inside and outside, the image is near the image's cage. */
static void test_near_rim(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(60); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct cage_pair pair;
        struct binding b;
        cage_pair_random(&pair, 4, 40, seed);
        bind(&b, &pair, icc_mesh_points(pair.count));
        for (int i = 0; i < 200; i++) {
            uint32_t k = (uint32_t)random_in(&state, 0, (int64_t)pair.count - 1);
            double lambda = random_unit(&state), p[2], q[2], h[2], gap;
            cage_point(&b.source, k, lambda, p);
            cage_point(&b.target, k, lambda, h);
            for (int c = 0; c < 2; c++)
                p[c] = nextafter(p[c], random_in(&state, 0, 1) ? INFINITY : -INFINITY);
            check_seed(seed, icc_ray_map(&b.s, &b.t, &b.to, p, q));
            gap = distance(q, h) / b.target.diameter;
            check_seed(seed, gap < 1e-11);
            check_seed(seed, icc_ray_map(&b.t, &b.s, &b.back, q, h));
            check_seed(seed, distance(p, h) < 1e-11);
        }
        release(&b);
        cage_pair_free(&pair);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hard),          cmocka_unit_test(test_random),
        cmocka_unit_test(test_rotated_lists), cmocka_unit_test(test_identity),
        cmocka_unit_test(test_similarity),    cmocka_unit_test(test_coordinates),
        cmocka_unit_test(test_rays),          cmocka_unit_test(test_near_rim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
