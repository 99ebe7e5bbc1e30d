/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Judged by inverse.h, by the defining sum in long double, and by differences. */
#include "inverse_row.h"

#include "injective.h"
#include "polynomials.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = 200 };
#define TOLERANCE 0x1p-36

/* A spline near the identity, on a grid of the square [-2,2]^2 or part of it: control points moved
 * each by itself, so that not even slopes are continuous, or a polynomial. */
static void make_spline(struct spline *s, int degree, uint64_t seed) {
    uint64_t state = seed;
    double amount = 0.3 * random_unit(&state) / degree;
    struct err err = {0};
    struct grid g;
    struct polynomial f[2];
    random_grid(&g, 5, degree, seed);
    g.lattice = (struct lattice){0x1p-10, -1, -2};
    if (seed % 3 == 0) {
        for (int c = 0; c < 2; c++) {
            random_polynomial(&f[c], degree, &state);
            for (int p = 0; p <= degree; p++)
                for (int q = 0; p + q <= degree; q++) f[c].c[p][q] *= 0.02L;
            f[c].c[1 - c][c] += 1;
        }
        polynomial_spline(s, &g, f);
        return;
    }
    assert_true(spline_identity(s, &g, &err));
    for (uint32_t p = 0; p < s->grid.point_count && seed % 7; p++)
        for (int c = 0; c < 2; c++)
            if (seed % 5 || c == 0) s->phi[p][c] += amount * (random_unit(&state) - 0.5);
}

struct world {
    struct spline s;
    struct inverse v;
    struct inverse_row r;
    struct inverse_cursor c;
    uint64_t seed;
    int inside;
};

static void check_derivative(const struct world *w, const struct inverse_spot *spot) {
    struct place place;
    struct locator l;
    long double f[2], j[2][2], b[3], unit;
    uint32_t hint = spot->triangle;
    struct err err = {0};
    check_seed(w->seed, locator_init(&l, &w->s.grid, &err));
    if (locate(&l, spot->p, &hint, &place.triangle, place.b) && place.triangle == spot->triangle) {
        for (int k = 0; k < 3; k++) b[k] = place.b[k];
        sum_at(&w->s, place.triangle, b, f, j);
        for (int r = 0; r < 2; r++)
            for (int c = 0; c < 2; c++) {
                unit = j[r][0] * spot->derivative[0][c] + j[r][1] * spot->derivative[1][c];
                check_seed(w->seed, fabsl(unit - (r == c)) < 1e-2);
            }
    }
    locator_free(&l);
}

/* Beside edges, rounding may tell a neighbour. */
static void check_spot(struct world *w, const double q[2], const struct inverse_spot *spot) {
    struct place place;
    double p[2], size;
    bool found = inverse_find(&w->c, q, NULL, NULL, &place);
    check_seed(w->seed, found == (spot->triangle != GRID_NONE));
    if (!found) return;
    w->inside++;
    inverse_point(&w->v, q, &place, p);
    size = fmax(fabs(q[0]), fabs(q[1])) + 1;
    for (int k = 0; k < 2; k++)
        check_seed(w->seed, fabs(p[k] - spot->p[k]) <= TOLERANCE + 1e-14 * size);
    if (place.b[0] > 1e-9 && place.b[1] > 1e-9 && place.b[2] > 1e-9)
        check_seed(w->seed, place.triangle == spot->triangle);
}

static void check_row(struct world *w, uint64_t *state) {
    double q[POINTS][2], step[2] = {ldexp(random_unit(state), -(int)random_in(state, 5, 10)), 0};
    struct inverse_spot spot[POINTS];
    const double *v = w->v.vertex[random_in(state, 0, w->s.grid.vertex_count - 1)];
    for (int k = 0; k < 2; k++) q[0][k] = v[k] + 0.2 * (random_unit(state) - 0.5);
    if (random_in(state, 0, 2) == 0) step[1] = step[0] * (random_unit(state) - 0.5);
    for (int i = 1; i < POINTS; i++)
        for (int k = 0; k < 2; k++) {
            q[i][k] = q[0][k] + i * step[k];
            if (w->seed % 8 == 1) q[i][k] += 0.1 * random_unit(state); /* not evenly at all */
        }
    inverse_row_find(&w->r, POINTS, (const double(*)[2])q, spot);
    for (int i = 0; i < POINTS; i++) check_spot(w, q[i], &spot[i]);
    if (spot[POINTS / 2].triangle != GRID_NONE) check_derivative(w, &spot[POINTS / 2]);
}

static void as_one_by_one(void **unused) {
    int inside = 0, proved = 0;
    for (int i = 0; i < test_count(150); i++) {
        struct world w = {.seed = 0x4e60000 + (uint64_t)i};
        uint64_t state = w.seed;
        struct err err = {0};
        bool one_to_one;
        make_spline(&w.s, 1 + i % 9, w.seed);
        one_to_one = injective_prove(&w.s, &err);
        proved += one_to_one;
        check_seed(w.seed, inverse_init(&w.v, &w.s, one_to_one, &err));
        check_seed(w.seed, inverse_row_init(&w.r, &w.v, TOLERANCE, &err));
        check_seed(w.seed, inverse_cursor_init(&w.c, &w.v, &err));
        for (int k = 0; k < 8; k++) check_row(&w, &state);
        inside += w.inside;
        inverse_row_free(&w.r);
        inverse_cursor_free(&w.c);
        inverse_free(&w.v);
        spline_free(&w.s);
    }
    assert_true(inside > test_count(150) * 200);
    assert_true(proved > test_count(150) / 2);
    (void)unused;
}

/* Where nothing moves, a point is its own preimage bit for bit. */
static void nothing_moves(void **unused) {
    for (int i = 0; i < test_count(20); i++) {
        uint64_t seed = 0x1d0000 + (uint64_t)i, state = seed;
        double q[POINTS][2];
        struct inverse_spot spot[POINTS];
        struct inverse_row r;
        struct inverse v;
        struct spline s;
        struct grid g;
        struct err err = {0};
        random_grid(&g, 4, 1 + i % 7, seed);
        g.lattice = (struct lattice){0.1, -1, -2};
        assert_true(spline_identity(&s, &g, &err));
        assert_true(inverse_init(&v, &s, true, &err) && inverse_row_init(&r, &v, 1e-9, &err));
        for (int k = 0; k < POINTS; k++) {
            q[k][0] = -1 + k * 0.7 * random_unit(&state);
            q[k][1] = -1.9 + k * 0.3;
        }
        inverse_row_find(&r, POINTS, (const double(*)[2])q, spot);
        for (int k = 0; k < POINTS; k++)
            check_seed(seed, spot[k].triangle == GRID_NONE ||
                                 (spot[k].p[0] == q[k][0] && spot[k].p[1] == q[k][1]));
        inverse_row_free(&r);
        inverse_free(&v);
        spline_free(&s);
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_one_by_one),
                                       cmocka_unit_test(nothing_moves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
