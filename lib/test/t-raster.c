/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracle: the three sides of the sample moved by (h, h^2), h infinitely small, in GMP rationals:
 * the determinant is a polynomial in h, whose first coefficient that is not zero has its sign. */
#include "raster.h"

#include "testing.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 23, HEIGHT = 17, SAMPLES = WIDTH * HEIGHT };

/* Of (bx-ax)(py-ay) - (by-ay)(px-ax), exactly. */
static int exact_side(const double a[2], const double b[2], double px, double py) {
    const double number[6] = {a[0], a[1], b[0], b[1], px, py};
    mpq_t q[6], l, r;
    int sign;
    mpq_inits(l, r, NULL);
    for (int i = 0; i < 6; i++) {
        mpq_init(q[i]);
        mpq_set_d(q[i], number[i]);
    }
    mpq_sub(l, q[2], q[0]);
    mpq_sub(r, q[5], q[1]);
    mpq_mul(l, l, r);
    mpq_sub(r, q[3], q[1]);
    mpq_sub(q[4], q[4], q[0]);
    mpq_mul(r, r, q[4]);
    sign = mpq_cmp(l, r);
    for (int i = 0; i < 6; i++) mpq_clear(q[i]);
    mpq_clears(l, r, NULL);
    return (sign > 0) - (sign < 0);
}

static int moved_side(const double a[2], const double b[2], uint32_t column, uint32_t row) {
    int side = exact_side(a, b, column + 0.5, row + 0.5);
    if (side == 0) side = (a[1] > b[1]) - (a[1] < b[1]);
    if (side == 0) side = (b[0] > a[0]) - (b[0] < a[0]);
    return side;
}

static bool covered(const double corner[3][2], uint32_t column, uint32_t row, int *turn) {
    *turn = exact_side(corner[0], corner[1], corner[2][0], corner[2][1]);
    for (int l = 0; l < 3 && *turn; l++)
        if (moved_side(corner[l], corner[(l + 1) % 3], column, row) != *turn) return false;
    return *turn != 0;
}

/* Coordinates of all kinds: on samples, between them, anywhere, far off. */
static double random_coordinate(int64_t side, uint64_t *state) {
    switch (random_in(state, 0, 5)) {
    case 0:
        return (double)random_in(state, -4, 2 * side + 4) / 2;
    case 1:
        return (double)random_in(state, -4, 8 * side + 4) / 8;
    case 2:
        return ldexp(random_unit(state) - 0.5, (int)random_in(state, 3, 40));
    case 3:
        return random_in(state, 0, 20) ? random_unit(state) : (random_unit(state) - 0.5) * 1e308;
    default:
        return random_unit(state) * (double)(side + 4) - 2;
    }
}

static void random_triangle(double corner[3][2], uint64_t *state) {
    double t;
    for (int c = 0; c < 3; c++) {
        corner[c][0] = random_coordinate(WIDTH, state);
        corner[c][1] = random_coordinate(HEIGHT, state);
    }
    t = (double)random_in(state, -1, 5) / 4;
    if (random_in(state, 0, 3) == 0) /* thin, often flat */
        for (int k = 0; k < 2; k++) corner[2][k] = corner[0][k] + t * (corner[1][k] - corner[0][k]);
    if (random_in(state, 0, 9) == 0) corner[1][random_in(state, 0, 1)] = corner[0][0];
}

static void scan(const double corner[3][2], uint32_t first_row, uint32_t end_row,
                 unsigned char *count, int *turn) {
    struct raster_scan s;
    uint32_t last = first_row;
    raster_scan_begin(&s, corner, WIDTH, first_row, end_row);
    while (raster_scan_next(&s)) {
        assert_true(s.row >= last && s.row < end_row && s.begin < s.end && s.end <= WIDTH);
        last = s.row + 1;
        for (uint32_t c = s.begin; c < s.end; c++) count[s.row * WIDTH + c]++;
    }
    *turn = s.turn;
}

static void single_triangles(void **unused) {
    size_t total = 0;
    for (int i = 0; i < test_count(1200); i++) {
        uint64_t seed = 0x3a57e0000 + (uint64_t)i, state = seed;
        double corner[3][2];
        unsigned char count[SAMPLES] = {0}, parts[SAMPLES] = {0};
        uint32_t cut = (uint32_t)random_in(&state, 0, HEIGHT);
        int turn, want;
        random_triangle(corner, &state);
        scan(corner, 0, HEIGHT, count, &turn);
        for (uint32_t k = 0; k < SAMPLES; k++) {
            bool is = covered(corner, k % WIDTH, k / WIDTH, &want);
            check_seed(seed, count[k] == is);
            total += is;
        }
        check_seed(seed, turn == want);
        scan(corner, 0, cut, parts, &turn); /* in bands, the same */
        scan(corner, cut, HEIGHT, parts, &turn);
        check_seed(seed, memcmp(count, parts, sizeof count) == 0);
    }
    assert_true(total > (size_t)test_count(1200));
    (void)unused;
}

/* A triangulated rectangle with lines through samples, whose inner points are moved anywhere near:
 * the triangles may turn over, but as long as none does, each sample is in one of them. */
static void sheets(void **unused) {
    enum { CELLS = 4 };
    int sheets = 0;
    for (int i = 0; i < test_count(4000); i++) {
        uint64_t seed = 0x5ee70000 + (uint64_t)i, state = seed;
        double point[CELLS + 1][CELLS + 1][2];
        unsigned char count[SAMPLES] = {0};
        bool turned = false;
        for (int y = 0; y <= CELLS; y++)
            for (int x = 0; x <= CELLS; x++) {
                double amount = x > 0 && x < CELLS && y > 0 && y < CELLS ? 2 : 0;
                int places = (int)random_in(&state, 0, 2);
                for (int k = 0; k < 2; k++) {
                    double side = k ? HEIGHT : WIDTH;
                    double at = (k ? y : x) * side / CELLS + amount * (random_unit(&state) - 0.5);
                    if (amount > 0 && places < 2) at = floor(at) + 0.5 * places;
                    point[y][x][k] = at;
                }
            }
        for (int n = 0; n < 2 * CELLS * CELLS; n++) {
            static const int pick[2][2][3] = {{{0, 1, 2}, {0, 2, 3}}, {{0, 1, 3}, {1, 2, 3}}};
            int x = n / 2 % CELLS, y = n / 2 / CELLS, turn;
            double corner[3][2];
            for (int c = 0; c < 3; c++) {
                int q = pick[(x + y) % 2][n % 2][c]; /* of a cell, (0,0) (1,0) (1,1) (0,1) */
                memcpy(corner[c], point[y + q / 2][x + (q == 1 || q == 2)], sizeof *corner);
            }
            scan(corner, 0, HEIGHT, count, &turn);
            turned = turned || turn <= 0;
        }
        if (turned) continue;
        sheets++;
        for (int k = 0; k < SAMPLES; k++) check_seed(seed, count[k] == 1);
    }
    assert_true(sheets > test_count(4000) / 4);
    (void)unused;
}

/* Faces over each other, against a look at all of them for each sample. */
static void who_is_seen(void **unused) {
    enum { FACES = 12 };
    for (int i = 0; i < test_count(100); i++) {
        uint64_t seed = 0xface0000 + (uint64_t)i, state = seed;
        double corner[FACES][3][2], near[FACES][3];
        struct raster r;
        struct err err = {0};
        bool flat = random_in(&state, 0, 2) == 0;
        for (int f = 0; f < FACES; f++) {
            random_triangle(corner[f], &state);
            for (int c = 0; c < 3; c++)
                near[f][c] = (double)random_in(&state, 0, random_in(&state, 0, 3) ? 9 : 0);
        }
        assert_true(raster_init(&r, WIDTH, HEIGHT, 1, (size_t)random_in(&state, 1, SAMPLES), &err));
        while (raster_next_band(&r)) {
            for (uint32_t f = 0; f < FACES; f++)
                raster_draw(&r, f, corner[f], flat ? NULL : near[f]);
            for (uint32_t k = 0; k < r.rows * WIDTH; k++) {
                uint32_t column = k % WIDTH, row = r.first_row + k / WIDTH, best = RASTER_NONE;
                double nearest = -INFINITY;
                int turn;
                for (uint32_t f = 0; f < FACES; f++) {
                    struct raster_plane plane;
                    double z = 0;
                    if (!covered(corner[f], column, row, &turn)) continue;
                    raster_plane_set(&plane, corner[f], near[f]);
                    if (!flat) z = raster_plane_at(&plane, column + 0.5, row + 0.5);
                    if (z >= nearest) best = f;
                    if (z >= nearest) nearest = z;
                }
                check_seed(seed, r.face[k] == best && r.nearness[k] == nearest);
            }
        }
        raster_free(&r);
    }
    (void)unused;
}

static void planes_are_linear(void **unused) {
    for (int i = 0; i < test_count(10000); i++) {
        uint64_t seed = 0x91a0000 + (uint64_t)i, state = seed;
        double corner[3][2], value[3], b[3] = {0}, sum = 0, want = 0, x = 0, y = 0, got;
        struct raster_plane plane;
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 2; k++) corner[c][k] = 100 * random_unit(&state);
            value[c] = random_unit(&state);
            b[c] = random_unit(&state);
            sum += b[c];
        }
        for (int c = 0; c < 3; c++) {
            x += b[c] / sum * corner[c][0];
            y += b[c] / sum * corner[c][1];
            want += b[c] / sum * value[c];
        }
        raster_plane_set(&plane, corner, value);
        got = raster_plane_at(&plane, x, y);
        check_seed(seed, fabs(got - want) < 1e-9 ||
                             exact_side(corner[0], corner[1], corner[2][0], corner[2][1]) == 0);
        for (int c = 0; c < 3; c++) /* and beyond the triangle no farther than its corners */
            check_seed(seed,
                       raster_plane_at(&plane, 200 * random_unit(&state), -1e300) <= plane.most);
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(single_triangles),
        cmocka_unit_test(sheets),
        cmocka_unit_test(who_is_seen),
        cmocka_unit_test(planes_are_linear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
