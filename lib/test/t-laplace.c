/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Means of neighbours against dense elimination in rationals, rounded once; the same bits however
 * vertices and edges are numbered. */
#include "laplace.h"

#include "testing.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { VERTICES_MAX = 24, EDGES_MAX = 200 };

struct graph {
    uint32_t n, fixed;
    size_t edge_count;
    struct laplace_edge edge[EDGES_MAX];
    double at[VERTICES_MAX][2];
};

static void add_edge(struct graph *g, uint32_t i, uint32_t j, double weight) {
    for (size_t e = 0; e < g->edge_count; e++)
        if ((g->edge[e].end[0] == i && g->edge[e].end[1] == j) ||
            (g->edge[e].end[0] == j && g->edge[e].end[1] == i))
            return;
    if (i != j) g->edge[g->edge_count++] = (struct laplace_edge){{i, j}, weight};
}

/* Every free vertex hangs on one with a lower number, so on a fixed one in the end. */
static void random_graph(struct graph *g, uint64_t *state) {
    *g = (struct graph){.n = (uint32_t)random_in(state, 2, VERTICES_MAX)};
    bool plain = random_in(state, 0, 1); /* weights and places with few bits: ties in rounding */
    g->fixed = (uint32_t)random_in(state, 1, g->n);
    for (uint32_t i = 0; i < g->fixed; i++)
        for (int k = 0; k < 2; k++)
            g->at[i][k] = plain ? (double)random_in(state, -2, 2) / 2 : 2 * random_unit(state) - 1;
    for (uint32_t i = 1; i < g->n; i++)
        for (int64_t many = random_in(state, 1, 4); many > 0; many--) {
            uint32_t j = (uint32_t)random_in(state, 0, (int64_t)i - 1);
            add_edge(g, i, j,
                     plain ? 1 : ldexp(0.5 + random_unit(state), (int)random_in(state, -4, 4)));
        }
}

static bool solve(const struct graph *g, double (*u)[2]) {
    struct err err = {0};
    struct laplace_problem p = {g->n, g->fixed, NULL, g->edge_count};
    p.edge = malloc((g->edge_count + 1) * sizeof *p.edge);
    assert_non_null(p.edge);
    memcpy(p.edge, g->edge, g->edge_count * sizeof *p.edge);
    memcpy(u, g->at, g->n * sizeof *u);
    bool ok = laplace_solve(&p, u, &err);
    assert_null(p.edge);
    return ok;
}

/* Gauss-Jordan elimination of the free vertices' equations for coordinate k, in the rows of a. */
static void eliminate(mpq_t *a, size_t n) {
    mpq_t factor, product;
    mpq_inits(factor, product, NULL);
    for (size_t c = 0; c < n; c++) /* diagonally dominant: pivots do not vanish */
        for (size_t r = 0; r < n; r++) {
            if (r == c || mpq_sgn(a[r * (n + 1) + c]) == 0) continue;
            mpq_div(factor, a[r * (n + 1) + c], a[c * (n + 1) + c]);
            for (size_t j = c; j <= n; j++) {
                mpq_mul(product, factor, a[c * (n + 1) + j]);
                mpq_sub(a[r * (n + 1) + j], a[r * (n + 1) + j], product);
            }
        }
    mpq_clears(factor, product, NULL);
}

static void add_entry(mpq_t *a, size_t n, size_t row, size_t column, double value) {
    mpq_t term;
    mpq_init(term);
    mpq_set_d(term, value);
    mpq_add(a[row * (n + 1) + column], a[row * (n + 1) + column], term);
    mpq_clear(term);
}

/* To row i of coordinate k: w (u_i - u_j) = 0. */
static void add_term(const struct graph *g, mpq_t *a, uint32_t i, uint32_t j, double w, int k) {
    size_t n = g->n - g->fixed;
    mpq_t product, weight;
    if (i < g->fixed) return;
    add_entry(a, n, i - g->fixed, i - g->fixed, w);
    if (j >= g->fixed) {
        add_entry(a, n, i - g->fixed, j - g->fixed, -w);
        return;
    }
    mpq_inits(product, weight, NULL);
    mpq_set_d(weight, w);
    mpq_set_d(product, g->at[j][k]);
    mpq_mul(product, product, weight);
    mpq_add(a[(i - g->fixed) * (n + 1) + n], a[(i - g->fixed) * (n + 1) + n], product);
    mpq_clears(product, weight, NULL);
}

/* Is u the double nearest to q, or one of two that are as near to within 2^-95? */
static bool is_rounded(double u, const mpq_t q) {
    double step = 1;
    mpq_t error, bound;
    bool near;
    mpq_inits(error, bound, NULL);
    mpq_set_d(error, u);
    mpq_sub(error, error, q);
    mpq_abs(error, error);
    step = nextafter(fabs(u), 2) - fabs(u);
    mpq_set_d(bound, step / 2 + 0x1p-95);
    near = mpq_cmp(error, bound) <= 0;
    mpq_clears(error, bound, NULL);
    return near;
}

static void check_exact(const struct graph *g, const double (*u)[2], uint64_t seed) {
    size_t n = g->n - g->fixed, size = n * (n + 1);
    mpq_t *a = malloc((size + 1) * sizeof *a), value;
    assert_non_null(a);
    mpq_init(value);
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < size; i++) mpq_init(a[i]);
        for (size_t e = 0; e < g->edge_count; e++) {
            const struct laplace_edge *edge = &g->edge[e];
            add_term(g, a, edge->end[0], edge->end[1], edge->weight, k);
            add_term(g, a, edge->end[1], edge->end[0], edge->weight, k);
        }
        eliminate(a, n);
        for (size_t i = 0; i < n; i++) {
            mpq_div(value, a[i * (n + 1) + n], a[i * (n + 1) + i]);
            check_seed(seed, is_rounded(u[g->fixed + i][k], value));
            check_seed(seed, mpq_sgn(value) != 0 || u[g->fixed + i][k] == 0);
        }
        for (size_t i = 0; i < size; i++) mpq_clear(a[i]);
    }
    mpq_clear(value);
    free(a);
}

static void test_exact(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(600); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct graph g;
        double u[VERTICES_MAX][2];
        random_graph(&g, &state);
        check_seed(seed, solve(&g, u));
        check_seed(seed, memcmp(u, g.at, g.fixed * sizeof *u) == 0);
        check_exact(&g, (const double(*)[2])u, seed);
    }
}

static void test_renumbered(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(600); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct graph g, h;
        uint32_t number[VERTICES_MAX];
        double u[VERTICES_MAX][2], v[VERTICES_MAX][2];
        random_graph(&g, &state);
        h = g;
        for (uint32_t i = 0; i < g.n; i++) number[i] = i;
        for (uint32_t i = g.n - 1; i > g.fixed; i--) {
            uint32_t j = (uint32_t)random_in(&state, g.fixed, i), t = number[i];
            number[i] = number[j];
            number[j] = t;
        }
        for (size_t e = 0; e < g.edge_count; e++) {
            const struct laplace_edge *from = &g.edge[g.edge_count - 1 - e];
            h.edge[e] =
                (struct laplace_edge){{number[from->end[1]], number[from->end[0]]}, from->weight};
        }
        check_seed(seed, solve(&g, u) && solve(&h, v));
        for (uint32_t i = 0; i < g.n; i++)
            check_seed(seed, memcmp(u[i], v[number[i]], sizeof u[i]) == 0);
    }
}

/* A long chain, of condition 10^9: u_i = i / n, also where weights differ by 2^20. */
static void test_chain(void **unused) {
    uint32_t n = 30000;
    double(*u)[2] = calloc(n + 1, sizeof *u);
    struct err err = {0};
    (void)unused;
    assert_non_null(u);
    for (int kind = 0; kind < 2; kind++) {
        struct laplace_problem p = {n + 1, 2, malloc(n * sizeof *p.edge), n};
        assert_non_null(p.edge);
        u[0][0] = u[0][1] = -1;
        u[1][0] = u[1][1] = 1; /* the chain is 0, 2, 3, .. n, 1 */
        for (uint32_t i = 0; i < n; i++)
            p.edge[i] = (struct laplace_edge){{i == 0 ? 0 : i + 1, i + 1 == n ? 1 : i + 2},
                                              kind && i < n / 2 ? 0x1p20 : 1};
        assert_true(laplace_solve(&p, u, &err));
        for (uint32_t i = 2; i <= n; i++) {
            double half = n / 2, j = i - 1, ratio = kind ? 0x1p-20 : 1;
            double way = j < half ? j * ratio : half * ratio + (j - half);
            double all = half * ratio + half;
            assert_true(fabs(u[i][0] - (2 * way / all - 1)) < 1e-15 && u[i][0] == u[i][1]);
        }
    }
    free(u);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact),
        cmocka_unit_test(test_renumbered),
        cmocka_unit_test(test_chain),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
