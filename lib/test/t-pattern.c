/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pattern.h"

#include "testing.h"

#include <stdlib.h>
#include <string.h>

static void random_pattern(struct pattern *p, uint64_t seed) {
    uint64_t s = seed;
    enum pattern_kind kind = (enum pattern_kind)(seed % 3);
    struct err err = {0};
    uint32_t cells[2];
    int32_t low[2], high[2];
    for (int c = 0; c < 2; c++) {
        cells[c] = (uint32_t)random_in(&s, 1, 7);
        low[c] = (int32_t)random_in(&s, -1000, 1000);
        high[c] = low[c] + (int32_t)cells[c] * 2 + (int32_t)random_in(&s, 0, 100);
    }
    check_seed(seed, pattern_init(p, kind, cells, low, high, &err));
}

static int64_t area2(const int32_t *a, const int32_t *b, const int32_t *c) {
    return (int64_t)(b[0] - a[0]) * (c[1] - a[1]) - (int64_t)(b[1] - a[1]) * (c[0] - a[0]);
}

static int64_t cell_area2(const struct pattern *p, uint32_t column, uint32_t row) {
    int32_t c[4][2];
    int64_t sum = 0;
    for (int n = pattern_cell(p, column, row, c), i = 1; i + 1 < n; i++) {
        int64_t area = area2(c[0], c[i], c[i + 1]);
        assert_true(area > 0);
        sum += area;
    }
    return sum;
}

static int64_t grid_area2(const struct grid *g) {
    int64_t sum = 0;
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const uint32_t *c = g->triangle[t];
        sum += area2(g->vertex[c[0]], g->vertex[c[1]], g->vertex[c[2]]);
    }
    return sum;
}

static uint32_t boundary_edges(const struct grid *g) {
    uint32_t n = 0;
    for (uint32_t e = 0; e < g->edge_count; e++) n += !grid_edge_is_inner(g, e);
    return n;
}

/* The whole rectangle: valid, of its area, a disk (V - E + T = 1), with the expected boundary. */
static void test_whole(void **state) {
    int count = test_count(600);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        struct grid g = {.degree = 1, .axes = {0, 1, 2}, .lattice = {1, 0, 0}};
        struct err err = {0};
        struct pattern p;
        random_pattern(&p, seed);
        check_seed(seed, pattern_triangulate(&p, NULL, &g, &err) && grid_build(&g, &err));
        check_seed(seed,
                   grid_area2(&g) == 2 * (int64_t)(p.x[p.nx] - p.x[0]) * (p.y[p.ny] - p.y[0]));
        check_seed(seed, (int64_t)g.vertex_count - g.edge_count + g.triangle_count == 1);
        uint32_t shifted = p.kind == PATTERN_HEX && p.ny % 2 ? 1 : 0;
        check_seed(seed, boundary_edges(&g) == 2 * (p.nx + p.ny) + shifted);
        uint32_t strip =
            p.kind == PATTERN_HEX ? 2 * p.nx + 1 : p.nx * (p.kind == PATTERN_CROSS ? 4 : 2);
        check_seed(seed, g.triangle_count == strip * p.ny);
        grid_free(&g);
        pattern_free(&p);
    }
}

/* Some cells: their area, and no vertex without a triangle (grid_build says so only of the ones
 * that are sound otherwise, so vertices are counted here). */
static void test_part(void **state) {
    int count = test_count(600);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        struct grid g = {0};
        struct err err = {0};
        struct pattern p;
        uint8_t keep[20 * 7] = {1};
        int64_t area = 0;
        uint64_t s = seed * 77;
        random_pattern(&p, seed);
        for (uint32_t c = 1; c < p.columns * p.ny; c++) keep[c] = random_in(&s, 0, 2) == 0;
        for (uint32_t row = 0; row < p.ny; row++)
            for (uint32_t column = 0; column < p.columns; column++)
                if (keep[row * p.columns + column]) area += cell_area2(&p, column, row);
        check_seed(seed, pattern_triangulate(&p, keep, &g, &err));
        check_seed(seed, grid_area2(&g) == area);
        for (uint32_t v = 0; v < g.vertex_count; v++) {
            bool used = false;
            for (uint32_t t = 0; t < g.triangle_count; t++)
                for (int l = 0; l < 3; l++) used = used || g.triangle[t][l] == v;
            check_seed(seed, used);
        }
        grid_free(&g);
        pattern_free(&p);
    }
}

/* Position of vertex i of row j, found among the corners of all cells: the i-th from the left. */
static int32_t row_x(const struct pattern *p, uint32_t i, uint32_t j) {
    int32_t x[200];
    uint32_t n = 0;
    for (uint32_t row = 0; row < p->ny; row++)
        for (uint32_t column = 0; column < p->columns; column++) {
            int32_t c[4][2];
            for (int k = 0, m = pattern_cell(p, column, row, c); k < m; k++) {
                uint32_t at = 0, known = 0;
                if (c[k][1] != p->y[j]) continue;
                while (at < n && x[at] < c[k][0]) at++;
                known = at < n && x[at] == c[k][0];
                if (known) continue;
                memmove(x + at + 1, x + at, (n - at) * sizeof *x);
                x[at] = c[k][0];
                n++;
            }
        }
    assert_int_equal(n, pattern_row_vertices(p, j));
    return x[i];
}

/* The corner after v and the one before it, of a cell that has v. */
static bool sides_at(const struct pattern *p, uint32_t column, uint32_t row, const int32_t v[2],
                     int32_t after[2], int32_t before[2]) {
    int32_t c[4][2];
    int n = pattern_cell(p, column, row, c);
    for (int k = 0; k < n; k++)
        if (memcmp(c[k], v, sizeof c[k]) == 0) {
            memcpy(after, c[(k + 1) % n], sizeof c[k]);
            memcpy(before, c[(k + n - 1) % n], sizeof c[k]);
            return true;
        }
    return false;
}

/* The cells around a vertex are those that have it, each following the one before. */
static void check_around(const struct pattern *p, uint32_t i, uint32_t j, uint64_t seed) {
    int32_t v[2] = {row_x(p, i, j), p->y[j]}, after[2], before[2], last[2] = {0};
    int64_t column[6];
    int n = pattern_around(p, i, j, column), found = 0, expect = 0;
    bool follows = false;
    for (uint32_t row = 0; row < p->ny; row++)
        for (uint32_t c = 0; c < p->columns; c++) expect += sides_at(p, c, row, v, after, before);
    for (int k = 0; k < n; k++) {
        int64_t row = k < n / 2 ? j : (int64_t)j - 1;
        bool there = column[k] >= 0 && row >= 0 && row < p->ny;
        if (there) {
            check_seed(seed, sides_at(p, (uint32_t)column[k], (uint32_t)row, v, after, before));
            check_seed(seed, !follows || memcmp(after, last, sizeof last) == 0);
            memcpy(last, before, sizeof last);
            found++;
        }
        follows = there;
    }
    check_seed(seed, found == expect);
}

static void test_around(void **state) {
    int count = test_count(60);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        struct pattern p;
        random_pattern(&p, seed);
        for (uint32_t j = 0; j <= p.ny; j++)
            for (uint32_t i = 0; i < pattern_row_vertices(&p, j); i++) check_around(&p, i, j, seed);
        pattern_free(&p);
    }
}

static void test_too_coarse(void **state) {
    const uint32_t cells[2] = {4, 3}, many[2] = {1 << 14, 1 << 13};
    const int32_t low[2] = {0, 0}, high[2] = {4, 3}, wide[2] = {8, 3};
    const int32_t far[2] = {1 << 20, 1 << 20};
    struct err err = {0};
    struct pattern p;
    (void)state;
    assert_true(pattern_init(&p, PATTERN_DIAGONAL, cells, low, high, &err));
    pattern_free(&p);
    assert_false(pattern_init(&p, PATTERN_CROSS, cells, low, high, &err));
    assert_string_equal(err.message, "lattice too coarse: 4 cells would share 4 lattice steps");
    assert_false(pattern_init(&p, PATTERN_CROSS, cells, low, wide, &err));
    assert_string_equal(err.message, "lattice too coarse: 3 cells would share 3 lattice steps");
    assert_true(pattern_init(&p, PATTERN_HEX, cells, low, wide, &err));
    pattern_free(&p);
    assert_false(pattern_init(&p, PATTERN_HEX, cells, low, high, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_false(pattern_init(&p, PATTERN_DIAGONAL, many, low, far, &err));
    assert_string_equal(err.message, "16384 x 8192 cells are more than 67108864");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole),
        cmocka_unit_test(test_part),
        cmocka_unit_test(test_around),
        cmocka_unit_test(test_too_coarse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
