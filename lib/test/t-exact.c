/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exact: matrices of planted rank against dense fraction-free elimination; determinants that are
 * multiples of the primes that the library begins with; conditions of whole C1 grids against the
 * rank formula. Every relation is checked in exact integers. */
#include "exact.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static size_t below(uint64_t *seed, size_t n) {
    return (size_t)(random_bits(seed) % n);
}

static int64_t within(uint64_t *seed, int64_t limit) {
    return random_in(seed, -limit, limit);
}

/* ---- dense and sparse matrices ---- */

struct dense {
    size_t m, n;
    int64_t *x; /* m x n, by rows */
};

static struct dense dense_new(size_t m, size_t n) {
    struct dense d = {m, n, calloc(m * n + 1, sizeof *d.x)};
    assert_non_null(d.x);
    return d;
}

static struct int_matrix sparse_new(size_t m, size_t n, size_t nnz) {
    struct int_matrix a = {m, n, calloc(m + 1, sizeof *a.start), calloc(nnz + 1, sizeof *a.col),
                           calloc(nnz + 1, sizeof *a.value)};
    assert_true(a.start && a.col && a.value);
    return a;
}

static void sparse_free(struct int_matrix *a) {
    free(a->start);
    free(a->col);
    free(a->value);
}

static struct int_matrix sparse_of(const struct dense *d) {
    struct int_matrix a = sparse_new(d->m, d->n, d->m * d->n);
    size_t k = 0;
    for (size_t r = 0; r < d->m; r++) {
        for (size_t c = 0; c < d->n; c++) {
            if (d->x[r * d->n + c] == 0) continue;
            a.col[k] = (uint32_t)c;
            a.value[k++] = d->x[r * d->n + c];
        }
        a.start[r + 1] = k;
    }
    return a;
}

/* ---- oracle: Bareiss' elimination of the dense matrix ---- */

static void swap_rows(mpz_t *z, size_t n, size_t r, size_t s) {
    for (size_t c = 0; c < n; c++) mpz_swap(z[r * n + c], z[s * n + c]);
}

static void bareiss_step(mpz_t *z, size_t m, size_t n, size_t rank, size_t c, const mpz_t last) {
    mpz_t t;
    mpz_init(t);
    for (size_t r = rank + 1; r < m; r++) {
        for (size_t k = c + 1; k < n; k++) {
            mpz_mul(z[r * n + k], z[r * n + k], z[rank * n + c]);
            mpz_mul(t, z[r * n + c], z[rank * n + k]);
            mpz_sub(z[r * n + k], z[r * n + k], t);
            mpz_divexact(z[r * n + k], z[r * n + k], last);
        }
        mpz_set_ui(z[r * n + c], 0);
    }
    mpz_clear(t);
}

static size_t oracle_rank(const struct dense *d) {
    size_t m = d->m, n = d->n, rank = 0;
    mpz_t *z = calloc(m * n + 1, sizeof *z), last;
    assert_non_null(z);
    mpz_init_set_ui(last, 1);
    for (size_t i = 0; i < m * n; i++) mpz_init_set_si(z[i], d->x[i]);
    for (size_t c = 0; c < n && rank < m; c++) {
        size_t p = rank;
        while (p < m && mpz_sgn(z[p * n + c]) == 0) p++;
        if (p == m) continue;
        swap_rows(z, n, p, rank);
        bareiss_step(z, m, n, rank, c, last);
        mpz_set(last, z[rank * n + c]);
        rank++;
    }
    for (size_t i = 0; i < m * n; i++) mpz_clear(z[i]);
    mpz_clear(last);
    free(z);
    return rank;
}

/* ---- what must hold of every result ---- */

/* y.A = 0, y primitive, without zeros, positive at its dependent row; the other rows independent.
 */
static bool relation_holds(const struct int_matrix *a, const struct exact_rows *e,
                           const struct exact_relation *r, mpz_t *sum) {
    bool ok = !e->independent[r->dependent], met = false;
    mpz_t g, t;
    mpz_inits(g, t, NULL);
    for (size_t k = 0; k < r->n; k++) {
        size_t row = r->row[k];
        mpz_gcd(g, g, r->y[k]);
        ok &= mpz_sgn(r->y[k]) != 0 && (k == 0 || r->row[k - 1] < row);
        ok &= row == r->dependent ? mpz_sgn(r->y[k]) > 0 : e->independent[row];
        met |= row == r->dependent;
        for (size_t i = a->start[row]; i < a->start[row + 1]; i++) {
            mpz_mul_si(t, r->y[k], a->value[i]);
            mpz_add(sum[a->col[i]], sum[a->col[i]], t);
        }
    }
    for (size_t k = 0; k < r->n; k++)
        for (size_t i = a->start[r->row[k]]; i < a->start[r->row[k] + 1]; i++)
            ok &= mpz_sgn(sum[a->col[i]]) == 0;
    ok &= met && mpz_cmp_ui(g, 1) == 0;
    mpz_clears(g, t, NULL);
    return ok;
}

/* With as many relations as rows - rank, each with a dependent row of its own, they are a basis and
 * the independent rows are independent. */
static bool result_holds(const struct int_matrix *a, const struct exact_rows *e, size_t rank) {
    mpz_t *sum = calloc(a->cols + 1, sizeof *sum);
    bool ok = e->rank == rank && e->relation_count == a->rows - rank;
    size_t independent = 0;
    assert_non_null(sum);
    for (size_t c = 0; c < a->cols; c++) mpz_init(sum[c]);
    for (size_t i = 0; i < e->relation_count && ok; i++) {
        ok = relation_holds(a, e, &e->relation[i], sum);
        ok &= i == 0 || e->relation[i - 1].dependent < e->relation[i].dependent;
    }
    for (size_t r = 0; r < a->rows; r++) independent += e->independent[r];
    for (size_t c = 0; c < a->cols; c++) mpz_clear(sum[c]);
    free(sum);
    return ok && independent == rank;
}

static void check_sparse(const struct int_matrix *a, size_t rank, uint64_t seed) {
    struct exact_rows e;
    struct err err;
    assert_true(exact_rows_init(&e, a, &err));
    if (!result_holds(a, &e, rank))
        fail_msg("%zu x %zu, rank %zu, got %zu (%zu relations), seed %llu", a->rows, a->cols, rank,
                 e.rank, e.relation_count, (unsigned long long)seed);
    exact_rows_free(&e);
}

/* Against the oracle; returns the rank; frees d. */
static size_t check_dense(struct dense d, uint64_t seed) {
    struct int_matrix a = sparse_of(&d);
    size_t rank = oracle_rank(&d);
    check_sparse(&a, rank, seed);
    sparse_free(&a);
    free(d.x);
    return rank;
}

/* ---- planted ranks ---- */

/* |entries| <= limit, a share of `percent` of them not 0. */
static void fill(struct dense *d, int64_t limit, size_t percent, uint64_t *seed) {
    for (size_t i = 0; i < d->m * d->n; i++)
        d->x[i] = below(seed, 100) < percent ? within(seed, limit) : 0;
}

static struct dense product(const struct dense *b, const struct dense *c) {
    struct dense d = dense_new(b->m, c->n);
    for (size_t i = 0; i < b->m; i++)
        for (size_t k = 0; k < b->n; k++)
            for (size_t j = 0; j < c->n; j++)
                d.x[i * c->n + j] += b->x[i * b->n + k] * c->x[k * c->n + j];
    return d;
}

static void planted_case(uint64_t seed, size_t largest) {
    static const int64_t limits[] = {1, 2, 9, 1000, 1 << 12, 1 << 23};
    static const size_t percents[] = {3, 10, 30, 100};
    uint64_t s = seed;
    size_t m = 1 + below(&s, largest), n = 1 + below(&s, largest), k = below(&s, largest);
    struct dense b = dense_new(m, k), c = dense_new(k, n);
    struct dense d;
    fill(&b, limits[below(&s, 6)], percents[below(&s, 4)], &s);
    fill(&c, limits[below(&s, 6)], percents[below(&s, 4)], &s);
    d = product(&b, &c); /* entries below 40 * 2^46 < 2^53 */
    assert_true(check_dense(d, seed) <= k);
    free(b.x);
    free(c.x);
}

static void planted_ranks(void **state) {
    (void)state;
    for (int i = 0; i < test_count(3000); i++) planted_case((uint64_t)i, 12);
    for (int i = 0; i < test_count(300); i++) planted_case(UINT64_C(1000000) + (uint64_t)i, 40);
}

static void random_sparse(void **state) {
    (void)state;
    for (int i = 0; i < test_count(1500); i++) {
        uint64_t seed = UINT64_C(2000000) + (uint64_t)i, s = seed;
        struct dense d = dense_new(1 + below(&s, 40), 1 + below(&s, 40));
        fill(&d, i % 2 ? 1 : 1000000, 4 + below(&s, 12), &s);
        check_dense(d, seed);
    }
}

/* Entries up to 2^53 in size; some rows are sums, differences or negatives of others. */
static void huge_entries(void **state) {
    const int64_t top = INT64_C(1) << 53;
    (void)state;
    for (int i = 0; i < test_count(400); i++) {
        uint64_t seed = UINT64_C(3000000) + (uint64_t)i, s = seed;
        size_t m = 3 + below(&s, 15), n = 1 + below(&s, 20);
        struct dense d = dense_new(m, n);
        fill(&d, i % 2 ? top : top / 2, 20 + below(&s, 81), &s);
        if (i % 4 == 1)
            for (size_t k = 0; k < m * n; k++) d.x[k] = d.x[k] < 0 ? -top : d.x[k] > 0 ? top : 0;
        for (size_t r = 2; r < m; r++) {
            size_t p = below(&s, r), q = below(&s, r), how = below(&s, 4);
            for (size_t c = 0; c < n; c++) {
                int64_t x = d.x[p * n + c], y = d.x[q * n + c];
                int64_t z = how == 0 ? -x : how == 1 ? x + y : x - y;
                if (how < 3 && -top <= z && z <= top) d.x[r * n + c] = z;
            }
        }
        check_dense(d, seed);
    }
}

/* Determinants of 40 rows and 2,000 bits: more primes than the library has in its table. */
static void many_primes(void **state) {
    (void)state;
    for (uint64_t seed = 0; seed < 3; seed++) {
        struct dense d = dense_new(43, 40);
        uint64_t s = seed;
        fill(&d, INT64_C(1) << 53, 100, &s);
        assert_int_equal(check_dense(d, seed), 40);
    }
}

/* ---- determinants that vanish modulo the first primes ---- */

/* The 2 x 2 block at (r,r) becomes [[2^31, c], [1, 2^30]], of determinant 2^61 - c. */
static void put_block(struct dense *d, size_t r, int64_t c) {
    d->x[r * d->n + r] = INT64_C(1) << 31;
    d->x[r * d->n + r + 1] = c;
    d->x[(r + 1) * d->n + r] = 1;
    d->x[(r + 1) * d->n + r + 1] = INT64_C(1) << 30;
}

/* x[i*step] += f * y[i*step], unless an entry would exceed 2^46. */
static void add_line(int64_t *x, const int64_t *y, size_t n, size_t step, int64_t f) {
    const int64_t limit = INT64_C(1) << 46;
    for (size_t i = 0; i < n; i++)
        if (llabs(x[i * step] + f * y[i * step]) > limit) return;
    for (size_t i = 0; i < n; i++) x[i * step] += f * y[i * step];
}

/* Adds random rows to others, and columns to others: the determinant stays as it is. */
static void mix(struct dense *d, int steps, uint64_t *seed) {
    for (int i = 0; i < steps; i++) {
        size_t r = below(seed, d->m), s = below(seed, d->m);
        size_t c = below(seed, d->n), e = below(seed, d->n);
        int64_t f = random_bits(seed) % 2 ? 1 : -1;
        if (r != s) add_line(d->x + r * d->n, d->x + s * d->n, d->n, 1, f);
        if (c != e) add_line(d->x + c, d->x + e, d->m, d->n, f);
    }
}

static void mersenne_determinant(void **state) {
    struct dense d = dense_new(2, 2);
    (void)state;
    put_block(&d, 0, 1);
    assert_int_equal(check_dense(d, 0), 2);
    d = dense_new(3, 2); /* y of the third row is 2^61 - 1 */
    put_block(&d, 0, 1);
    d.x[4] = 3;
    d.x[5] = 5;
    assert_int_equal(check_dense(d, 0), 2);
}

static const int64_t first_c[] = {1, 31, 45, 229, 259, 283};

/* Several such blocks, for one prime or for many, mixed; then rows that are truly dependent. */
static void unlucky_primes(void **state) {
    (void)state;
    for (int i = 0; i < test_count(600); i++) {
        uint64_t seed = UINT64_C(4000000) + (uint64_t)i, s = seed;
        size_t blocks = 1 + below(&s, 6), extra = below(&s, 4), n = 2 * blocks, m = n + extra;
        struct dense square = dense_new(n, n), d = dense_new(m, n + 1);
        for (size_t b = 0; b < blocks; b++)
            put_block(&square, 2 * b, first_c[i % 3 == 0 ? 0 : i % 3 == 1 ? b : below(&s, 6)]);
        mix(&square, i % 4 == 0 ? 0 : 12, &s);
        for (size_t r = 0; r < n; r++) memcpy(d.x + r * (n + 1), square.x + r * n, n * sizeof *d.x);
        for (size_t r = n; r < m; r++)
            for (size_t k = 0; k < 3; k++) {
                size_t from = below(&s, n);
                for (size_t c = 0; c < n; c++)
                    d.x[r * (n + 1) + c] += (int64_t)(k + 1) * square.x[from * n + c];
            }
        free(square.x);
        assert_int_equal(check_dense(d, seed), n);
    }
}

/* Many blocks, each with a third row that is the sum of its two, in chains of five: the first row
 * of a block has an entry in the block before it. */
static void unlucky_chains(void **state) {
    const size_t blocks = 2000;
    struct int_matrix a = sparse_new(3 * blocks, 2 * blocks, 9 * blocks);
    size_t k = 0;
    (void)state;
    for (size_t r = 0; r < a.rows; r++) {
        size_t b = r / 3, which = r % 3;
        int64_t big = INT64_C(1) << 31, half = INT64_C(1) << 30, c = first_c[b % 6];
        a.col[k] = (uint32_t)(2 * b);
        a.value[k++] = which == 0 ? big : which == 1 ? 1 : big + 1;
        a.col[k] = (uint32_t)(2 * b + 1);
        a.value[k++] = which == 0 ? c : which == 1 ? half : half + c;
        if (b % 5 > 0 && which != 1) {
            a.col[k] = (uint32_t)(2 * b - 1);
            a.value[k++] = 7;
        }
        a.start[r + 1] = k;
    }
    check_sparse(&a, 2 * blocks, 0);
    sparse_free(&a);
}

/* ---- edge cases ---- */

static void shapes_without_entries(void **state) {
    (void)state;
    for (size_t m = 0; m < 4; m++)
        for (size_t n = 0; n < 4; n++) assert_int_equal(check_dense(dense_new(m, n), 0), 0);
}

static void simple_shapes(void **state) {
    struct dense d = dense_new(1, 1);
    (void)state;
    d.x[0] = -(INT64_C(1) << 53);
    assert_int_equal(check_dense(d, 0), 1);
    d = dense_new(1, 5);
    d.x[2] = 4;
    d.x[4] = -6;
    assert_int_equal(check_dense(d, 0), 1);
    d = dense_new(5, 1);
    for (int i = 0; i < 5; i++) d.x[i] = 6 * i - 10;
    assert_int_equal(check_dense(d, 0), 1);
    d = dense_new(6, 4); /* equal rows, a row of zeros */
    for (int r = 0; r < 5; r++)
        for (int c = 0; c < 3; c++) d.x[4 * r + c] = c + 1;
    assert_int_equal(check_dense(d, 0), 1);
}

static void free_is_harmless(void **state) {
    struct exact_rows e = {0};
    (void)state;
    exact_rows_free(&e);
    exact_rows_free(&e);
    assert_null(e.relation);
}

/* The same rows in another order have the same rank. */
static void orders(void **state) {
    (void)state;
    for (int i = 0; i < test_count(300); i++) {
        uint64_t seed = UINT64_C(5000000) + (uint64_t)i, s = seed;
        size_t m = 2 + below(&s, 20), n = 2 + below(&s, 12), rank;
        struct dense d = dense_new(m, n), e = dense_new(m, n);
        fill(&d, 3, 40, &s);
        memcpy(e.x, d.x, m * n * sizeof *d.x);
        for (size_t r = m; r > 1; r--) /* Fisher and Yates */
            for (size_t c = 0, other = below(&s, r); c < n; c++) {
                int64_t x = e.x[(r - 1) * n + c];
                e.x[(r - 1) * n + c] = e.x[other * n + c];
                e.x[other * n + c] = x;
            }
        rank = check_dense(e, seed);
        assert_int_equal(check_dense(d, seed), rank);
    }
}

static bool same(const struct exact_rows *e, const struct exact_rows *f, size_t rows) {
    bool ok = e->rank == f->rank && e->relation_count == f->relation_count &&
              memcmp(e->independent, f->independent, rows) == 0;
    for (size_t i = 0; i < e->relation_count && ok; i++) {
        const struct exact_relation *r = &e->relation[i], *s = &f->relation[i];
        ok = r->n == s->n && r->dependent == s->dependent;
        for (size_t k = 0; k < r->n && ok; k++)
            ok = r->row[k] == s->row[k] && mpz_cmp(r->y[k], s->y[k]) == 0;
    }
    return ok;
}

/* Twice the same matrix: twice the same result, whatever memory it falls into. */
static void deterministic(void **state) {
    (void)state;
    for (int i = 0; i < test_count(200); i++) {
        uint64_t s = UINT64_C(6000000) + (uint64_t)i;
        struct dense d = dense_new(2 + below(&s, 30), 2 + below(&s, 30));
        struct exact_rows e, f;
        struct int_matrix a;
        struct err err;
        fill(&d, 5, 10, &s);
        a = sparse_of(&d);
        assert_true(exact_rows_init(&e, &a, &err));
        assert_true(exact_rows_init(&f, &a, &err));
        assert_true(same(&e, &f, a.rows));
        exact_rows_free(&e);
        exact_rows_free(&f);
        sparse_free(&a);
        free(d.x);
    }
}

/* ---- conditions of whole grids ---- */

/* A rectangle of n x n cells, each cut by its diagonal (2 triangles) or by both (4, with a vertex
 * at the centre). Triangles are counter-clockwise. */
struct mesh {
    size_t vertices, triangles, edges, inner_edges, inner_vertices, singular;
    int64_t (*at)[2];
    size_t (*triangle)[3];
    size_t (*edge)[4]; /* a < b, and the triangles on both sides; SIZE_MAX: none */
    size_t *first;     /* by triangle and side (opposite to its corner): the edge */
};

static void add_cell(struct mesh *g, size_t n, size_t i, size_t j, bool crossed) {
    size_t w = n + 1, p[4] = {j * w + i, j * w + i + 1, (j + 1) * w + i + 1, (j + 1) * w + i};
    size_t centre = w * w + j * n + i;
    if (!crossed) {
        const size_t t[2][3] = {{p[0], p[1], p[2]}, {p[0], p[2], p[3]}};
        memcpy(g->triangle[g->triangles], t, sizeof t);
        g->triangles += 2;
        return;
    }
    for (size_t k = 0; k < 4; k++) {
        const size_t t[3] = {p[k], p[(k + 1) % 4], centre};
        memcpy(g->triangle[g->triangles++], t, sizeof t);
    }
}

/* Vertices by the pattern, with a cell size of 2h, moved by at most `jitter` < h/2. */
static void place_vertices(struct mesh *g, size_t n, int64_t h, int64_t jitter, uint64_t *seed) {
    size_t w = n + 1;
    for (size_t v = 0; v < g->vertices; v++) {
        bool centre = v >= w * w;
        size_t k = centre ? v - w * w : v, row = centre ? n : w;
        g->at[v][0] = 2 * h * (int64_t)(k % row) + (centre ? h : 0) + within(seed, jitter);
        g->at[v][1] = 2 * h * (int64_t)(k / row) + (centre ? h : 0) + within(seed, jitter);
    }
}

/* The edge {a,b} of triangle t; vertex a keeps a list of its edges, linked by `chain`. */
static size_t find_edge(struct mesh *g, size_t *head, size_t *chain, size_t a, size_t b, size_t t) {
    size_t low = a < b ? a : b, high = a < b ? b : a, e = head[low];
    while (e != SIZE_MAX && g->edge[e][1] != high) e = chain[e];
    if (e != SIZE_MAX) {
        g->edge[e][3] = t;
        g->inner_edges++;
        return e;
    }
    e = g->edges++;
    g->edge[e][0] = low;
    g->edge[e][1] = high;
    g->edge[e][2] = t;
    g->edge[e][3] = SIZE_MAX;
    chain[e] = head[low];
    head[low] = e;
    return e;
}

static struct mesh mesh_new(size_t n, bool crossed, int64_t h, int64_t jitter, uint64_t *seed) {
    struct mesh g = {.vertices = (n + 1) * (n + 1) + (crossed ? n * n : 0)};
    size_t most = 4 * n * n, *head = malloc(g.vertices * sizeof *head);
    size_t *chain = malloc(3 * most * sizeof *chain);
    g.at = malloc(g.vertices * sizeof *g.at);
    g.triangle = malloc(most * sizeof *g.triangle);
    g.edge = malloc(3 * most * sizeof *g.edge);
    g.first = malloc(3 * most * sizeof *g.first);
    assert_true(head && chain && g.at && g.triangle && g.edge && g.first);
    place_vertices(&g, n, h, jitter, seed);
    for (size_t v = 0; v < g.vertices; v++) head[v] = SIZE_MAX;
    for (size_t j = 0; j < n; j++)
        for (size_t i = 0; i < n; i++) add_cell(&g, n, i, j, crossed);
    for (size_t t = 0; t < g.triangles; t++)
        for (size_t k = 0; k < 3; k++)
            g.first[3 * t + k] = find_edge(&g, head, chain, g.triangle[t][(k + 1) % 3],
                                           g.triangle[t][(k + 2) % 3], t);
    g.inner_vertices = (n - 1) * (n - 1) + (crossed ? n * n : 0);
    g.singular = crossed && jitter == 0 ? n * n : 0;
    free(head);
    free(chain);
    return g;
}

static void mesh_free(struct mesh *g) {
    free(g->at);
    free(g->triangle);
    free(g->edge);
    free(g->first);
}

static int64_t twice_area(const struct mesh *g, size_t a, size_t b, size_t c) {
    return (g->at[b][0] - g->at[a][0]) * (g->at[c][1] - g->at[a][1]) -
           (g->at[b][1] - g->at[a][1]) * (g->at[c][0] - g->at[a][0]);
}

/* Column of the point of triangle t with these weights of its corners: vertices, then edges, then
 * the insides of triangles. */
static size_t column(const struct mesh *g, size_t d, size_t t, const size_t weight[3]) {
    const size_t *corner = g->triangle[t];
    for (size_t k = 0; k < 3; k++)
        if (weight[k] == d) return corner[k];
    for (size_t k = 0; k < 3; k++) {
        size_t e = g->first[3 * t + k], other = (k + 1) % 3;
        if (weight[k] > 0) continue;
        if (corner[other] != g->edge[e][1]) other = (k + 2) % 3;
        return g->vertices + e * (d - 1) + weight[other] - 1;
    }
    return g->vertices + g->edges * (d - 1) + t * (d * d) + (weight[0] - 1) * d + weight[1] - 1;
}

static void add_entry(struct int_matrix *a, size_t *nnz, size_t c, int64_t value) {
    if (value == 0) return;
    a->col[*nnz] = (uint32_t)c;
    a->value[(*nnz)++] = value;
}

static size_t place_in(const struct mesh *g, size_t t, size_t v) {
    size_t k = 0;
    while (g->triangle[t][k] != v) k++;
    return k;
}

/* [14] (4)(6) times twice the area of u: with k = m, j = d-1-m, for the edge e between u and v. */
static void add_condition(const struct mesh *g, size_t d, size_t e, size_t m, struct int_matrix *x,
                          size_t *nnz) {
    size_t a = g->edge[e][0], b = g->edge[e][1], u = g->edge[e][2], v = g->edge[e][3],
           j = d - 1 - m;
    size_t ua = place_in(g, u, a), ub = place_in(g, u, b), u0 = 3 - ua - ub;
    size_t va = place_in(g, v, a), vb = place_in(g, v, b), v0 = 3 - va - vb;
    size_t pu = g->triangle[u][u0], pv = g->triangle[v][v0], w[3];
    w[v0] = 1, w[va] = j, w[vb] = m;
    add_entry(x, nnz, column(g, d, v, w), -twice_area(g, pu, a, b));
    w[u0] = 1, w[ua] = j, w[ub] = m;
    add_entry(x, nnz, column(g, d, u, w), twice_area(g, pv, a, b));
    w[u0] = 0, w[ua] = j + 1, w[ub] = m;
    add_entry(x, nnz, column(g, d, u, w), twice_area(g, pu, pv, b));
    w[u0] = 0, w[ua] = j, w[ub] = m + 1;
    add_entry(x, nnz, column(g, d, u, w), twice_area(g, pu, a, pv));
    x->start[++x->rows] = *nnz;
}

static struct int_matrix conditions(const struct mesh *g, size_t d) {
    size_t cols = g->vertices + g->edges * (d - 1) + g->triangles * d * d, nnz = 0;
    struct int_matrix a = sparse_new(d * g->inner_edges, cols, 4 * d * g->inner_edges);
    a.rows = 0;
    for (size_t e = 0; e < g->edges; e++)
        for (size_t m = 0; m < d && g->edge[e][3] != SIZE_MAX; m++)
            add_condition(g, d, e, m, &a, &nnz);
    return a;
}

/* rank = d E_I - 2 V_I - s on a simply connected domain: [LS]. */
static void whole_grids(void **state) {
    static const int64_t sizes[] = {1, 20, 300, 1 << 15, 1 << 19};
    (void)state;
    for (size_t i = 0; i < 5 * 2 * 2 * 3; i++) {
        uint64_t seed = UINT64_C(7000000) + i;
        size_t d = 5 + i % 3, n = 2 + i % 6;
        bool crossed = i / 3 % 2;
        int64_t h = sizes[i / 12];
        struct mesh g = mesh_new(n, crossed, h, i / 6 % 2 ? h * 2 / 5 : 0, &seed);
        struct int_matrix a = conditions(&g, d);
        /* unit cells cannot be moved, so they are regular, too */
        if (h == 1 && crossed) g.singular = n * n;
        check_sparse(&a, d * g.inner_edges - 2 * g.inner_vertices - g.singular, i);
        sparse_free(&a);
        mesh_free(&g);
    }
}

/* |y| times the largest entry of its row: what the row weighs in the relation. */
static double share(const struct int_matrix *a, const struct exact_relation *r, size_t k) {
    int64_t largest = 0;
    for (size_t i = a->start[r->row[k]]; i < a->start[r->row[k] + 1]; i++)
        if (llabs(a->value[i]) > largest) largest = llabs(a->value[i]);
    return (double)largest * fabs(mpz_get_d(r->y[k]));
}

/* No row is dropped that the others determine badly, also where vertices are all but singular. */
static void stable_choice(void **state) {
    (void)state;
    for (uint64_t i = 0; i < 8; i++) {
        uint64_t seed = UINT64_C(9000000) + i;
        struct mesh g = mesh_new(12, i % 2 == 0, 30000, i < 4 ? 12000 : 1, &seed);
        struct int_matrix a = conditions(&g, 5);
        struct exact_rows e;
        struct err err;
        assert_true(exact_rows_init(&e, &a, &err));
        for (size_t j = 0; j < e.relation_count; j++) {
            const struct exact_relation *r = &e.relation[j];
            double largest = 0, own = 0;
            for (size_t k = 0; k < r->n; k++) {
                double x = share(&a, r, k);
                if (x > largest) largest = x;
                if (r->row[k] == r->dependent) own = x;
            }
            assert_true(own >= largest / 4);
        }
        exact_rows_free(&e);
        sparse_free(&a);
        mesh_free(&g);
    }
}

/* Only some columns, and the rows that meet them: what an edit asks for. */
static struct int_matrix columns_of(const struct int_matrix *a, size_t percent, uint64_t *seed) {
    struct int_matrix b = sparse_new(a->rows, a->cols, a->start[a->rows]);
    bool *in = calloc(a->cols, 1);
    size_t k = 0;
    assert_non_null(in);
    for (size_t c = 0; c < a->cols; c++) in[c] = below(seed, 100) < percent;
    for (size_t r = 0; r < a->rows; r++) {
        for (size_t i = a->start[r]; i < a->start[r + 1]; i++)
            if (in[a->col[i]]) add_entry(&b, &k, a->col[i], a->value[i]);
        b.start[r + 1] = k;
    }
    free(in);
    return b;
}

static struct dense dense_of(const struct int_matrix *a) {
    struct dense d = dense_new(a->rows, a->cols);
    for (size_t r = 0; r < a->rows; r++)
        for (size_t i = a->start[r]; i < a->start[r + 1]; i++)
            d.x[r * d.n + a->col[i]] = a->value[i];
    return d;
}

static void parts_of_grids(void **state) {
    (void)state;
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = UINT64_C(8000000) + (uint64_t)i, s = seed;
        struct mesh g = mesh_new(2, i % 2 == 0, 5000, i % 3 ? 1900 : 0, &s);
        struct int_matrix a = conditions(&g, 5), b = columns_of(&a, 20 + below(&s, 80), &s);
        check_dense(dense_of(&b), seed);
        sparse_free(&a);
        sparse_free(&b);
        mesh_free(&g);
    }
}

/* ---- time, for information ---- */

static double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void time_one(const char *what, const struct int_matrix *a, int times) {
    double begin = seconds();
    size_t rank = 0;
    for (int i = 0; i < times; i++) {
        struct exact_rows e;
        struct err err;
        assert_true(exact_rows_init(&e, a, &err));
        rank = e.rank;
        exact_rows_free(&e);
    }
    print_message("%s: %zu x %zu, rank %zu: %.1f us\n", what, a->rows, a->cols, rank,
                  1e6 * (seconds() - begin) / times);
}

static void timing(void **state) {
    uint64_t seed = 9;
    struct mesh small = mesh_new(3, false, 300, 120, &seed);
    struct mesh regular = mesh_new(60, false, 300, 0, &seed);
    struct mesh jittered = mesh_new(60, false, 300, 120, &seed);
    struct mesh wide = mesh_new(60, false, 1 << 18, 100000, &seed);
    struct int_matrix a = conditions(&small, 5), b = conditions(&regular, 5);
    struct int_matrix c = conditions(&jittered, 5), d = conditions(&wide, 5);
    (void)state;
    time_one("3 x 3 cells", &a, 200);
    time_one("60 x 60 cells", &b, 3);
    time_one("60 x 60 cells, moved", &c, 3);
    time_one("60 x 60 cells, 24 bits", &d, 3);
    sparse_free(&a), sparse_free(&b), sparse_free(&c), sparse_free(&d);
    mesh_free(&small), mesh_free(&regular), mesh_free(&jittered), mesh_free(&wide);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planted_ranks),
        cmocka_unit_test(random_sparse),
        cmocka_unit_test(huge_entries),
        cmocka_unit_test(many_primes),
        cmocka_unit_test(mersenne_determinant),
        cmocka_unit_test(unlucky_primes),
        cmocka_unit_test(unlucky_chains),
        cmocka_unit_test(shapes_without_entries),
        cmocka_unit_test(simple_shapes),
        cmocka_unit_test(free_is_harmless),
        cmocka_unit_test(orders),
        cmocka_unit_test(deterministic),
        cmocka_unit_test(whole_grids),
        cmocka_unit_test(parts_of_grids),
        cmocka_unit_test(stable_choice),
        cmocka_unit_test(timing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
