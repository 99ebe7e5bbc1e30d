/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Depths against relaxation, rings against their definition, Green's functions against elimination
 * in rationals; and the theorems, on all balls in 4 x 4 vertices and on random ones:
 *
 *   Lemma 1. Depths of neighbours differ by 1. A vertex other than the maximum has one or two
 * higher neighbours; if two, they are corners of a square whose fourth corner is one higher again.
 *
 *   No inside vertex but the maximum is critical: going around it over its six neighbours in the
 *   triangulation, what is higher is one stretch and what is lower is one (Banchoff 1967), ties
 *   broken by vertex numbers. */
#include "icc_function.h"

#include "balls.h"
#include "testing.h"

#include <gmp.h>
#include <stdlib.h>
#include <string.h>

static const struct icc_function_rule cousin = {.kind = ICC_COUSIN};

static void make(struct icc_function *f, const struct icc_domain *d, uint32_t maximum,
                 const struct icc_function_rule *rule) {
    struct err err = {0};
    assert_true(icc_function_init(f, d, maximum, rule, &err));
}

static uint32_t some_inside(const struct icc_domain *d, uint64_t *state) {
    for (;;) {
        uint32_t v = (uint32_t)random_in(state, 0, icc_domain_size(d) - 1);
        if (d->inside[v]) return v;
    }
}

/* ---- theorems ---------------------------------------------------------------------------------
 */

static void lemma_1(const struct icc_domain *d, const struct icc_function *f, uint64_t seed) {
    uint32_t nx = d->nx;
    for (uint32_t v = nx; v < icc_domain_size(d) - nx; v++) {
        const uint32_t next[4] = {v + 1, v + nx, v - 1, v - nx};
        int higher = 0, which[4];
        if (!d->inside[v]) continue;
        for (int k = 0; k < 4; k++) {
            if (!d->inside[next[k]]) continue;
            check_seed(seed, fabs(f->height[next[k]] - f->height[v]) == 1);
            if (f->height[next[k]] > f->height[v]) which[higher++] = k;
        }
        check_seed(seed, v == f->maximum ? higher == 0 : higher == 1 || higher == 2);
        if (higher < 2) continue;
        check_seed(seed, (which[0] - which[1]) % 2 != 0);
        uint32_t corner = next[which[0]] + next[which[1]] - v;
        check_seed(seed, d->inside[corner] && f->height[corner] == f->height[v] + 2);
    }
}

/* How often does it change, around v, whether neighbours are higher? */
static int changes(const struct icc_domain *d, const struct icc_function *f, uint32_t v,
                   bool *any_higher) {
    uint32_t nx = d->nx;
    const uint32_t next[6] = {v + 1, v + nx + 1, v + nx, v - 1, v - nx - 1, v - nx};
    int n = 0;
    *any_higher = false;
    for (int k = 0; k < 6; k++) {
        bool a = icc_function_higher(f, next[k], v);
        n += a != icc_function_higher(f, next[(k + 1) % 6], v);
        *any_higher = *any_higher || a;
    }
    return n;
}

static bool is_regular(const struct icc_domain *d, const struct icc_function *f, uint32_t v) {
    bool any;
    int n = changes(d, f, v, &any);
    return v == f->maximum ? n == 0 && !any : n == 2;
}

static void no_critical_point(const struct icc_domain *d, const struct icc_function *f,
                              uint64_t seed) {
    for (uint32_t v = 0; v < icc_domain_size(d); v++)
        if (d->inside[v]) check_seed(seed, is_regular(d, f, v));
}

static void theorems_on_all_small_balls(void **state) {
    int balls = 0;
    (void)state;
    for (uint32_t bits = 1; bits < 1u << 16; bits++) {
        unsigned char bit[16];
        struct icc_domain d;
        for (int k = 0; k < 16; k++) bit[k] = bits >> k & 1;
        planted_domain(&d, 4, 4, bit);
        if (is_ball(&d)) {
            balls++;
            for (uint32_t v = 0; v < icc_domain_size(&d); v++) {
                struct icc_function f;
                if (!d.inside[v]) continue;
                make(&f, &d, v, &cousin);
                check_seed(bits, f.reached == d.inside_count);
                lemma_1(&d, &f, bits);
                no_critical_point(&d, &f, bits);
                icc_function_free(&f);
            }
        }
        icc_domain_free(&d);
    }
    print_message("%d balls\n", balls);
}

static void theorems_on_random_balls(void **state) {
    static const enum icc_kind kinds[] = {ICC_COUSIN, ICC_MANHATTAN, ICC_HARMONIC};
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(60); seed++) {
        uint64_t random = seed;
        struct icc_domain d;
        struct icc_function f;
        struct icc_function_rule rule = {.kind = kinds[seed % 3]};
        random_ball(&d, 30, 30, (uint32_t)random_in(&random, 1, 400), &random);
        make(&f, &d, some_inside(&d, &random), &rule);
        if (rule.kind != ICC_HARMONIC) lemma_1(&d, &f, seed);
        no_critical_point(&d, &f, seed);
        icc_function_free(&f);
        icc_domain_free(&d);
    }
}

/* ---- boundary configurations ------------------------------------------------------------------
 * [13] figure A.1 enumerates such configurations; its counts were not at hand, and these are those
 * of our own enumeration, also up to the symmetries of the square, which such a figure may leave
 * out.
 *
 * What can be around an inside vertex v beside the boundary: for each of its 8 neighbours, outside,
 * or inside with a depth relative to v's. In a ball, by the theorems on median graphs (the squares
 * of a ball are one, CAT(0)), that is what these rules leave:
 *   - v has an inside neighbour along an edge, not all 8 are inside, no diagonal pairs;
 *   - depths along edges differ by 1, and a full square has depths d, d+1, d+2, d+1 around it;
 *   - of v's neighbours along edges one is higher, or two that span a full square;
 *   - so it is, as far as can be seen here, with the neighbours of those. */

enum { OUTSIDE = 9, CONFIGURATIONS = 680, PATTERNS = 159 };
enum { DIFFERENT_CONFIGURATIONS = 94, DIFFERENT_PATTERNS = 31 }; /* up to symmetry */

/* Neighbours counter-clockwise from +x; a square at v is v, k, k + 1, k + 2 for even k. */
static bool is_square(const int *c, int k) {
    return c[k] != OUTSIDE && c[k + 1] != OUTSIDE && c[(k + 2) % 8] != OUTSIDE;
}

static bool sound_square(const int *c, int k) {
    int around[4] = {0, c[k], c[k + 1], c[(k + 2) % 8]}, least = 0;
    if (!is_square(c, k)) return true;
    for (int m = 0; m < 4; m++)
        if (around[m] < around[least]) least = m;
    int d = around[least];
    return around[(least + 1) % 4] == d + 1 && around[(least + 2) % 4] == d + 2 &&
           around[(least + 3) % 4] == d + 1;
}

static bool no_diagonal(const int *c, int k) {
    return c[k] != OUTSIDE || c[k + 1] == OUTSIDE || c[(k + 2) % 8] != OUTSIDE;
}

/* The higher neighbours of neighbour k, along an edge: of v and the corners beside it. */
static bool sound_neighbour(const int *c, int k) {
    int after = (k + 1) % 8, before = (k + 7) % 8;
    bool a = c[after] == c[k] - 1, b = c[before] == c[k] - 1;
    if (c[k] == OUTSIDE) return true;
    if (a && b) return false;
    return c[k] != 1 || ((!a || is_square(c, k)) && (!b || is_square(c, (k + 6) % 8)));
}

static bool sound_edges(const int *c) {
    for (int k = 0; k < 8; k++) {
        int next = c[(k + 1) % 8];
        if (k % 2 == 0 && c[k] != OUTSIDE && c[k] != 1 && c[k] != -1) return false;
        if (c[k] != OUTSIDE && next != OUTSIDE && abs(c[k] - next) != 1) return false;
    }
    return true;
}

static bool is_configuration(const int *c) {
    int higher = 0, along = 0, inside = 0;
    for (int k = 0; k < 8; k++) inside += c[k] != OUTSIDE;
    for (int k = 0; k < 8; k += 2) {
        if (!no_diagonal(c, k) || !sound_square(c, k) || !sound_neighbour(c, k)) return false;
        along += c[k] != OUTSIDE;
        higher += c[k] == -1;
        if (c[k] == -1 && c[(k + 2) % 8] == -1 && !is_square(c, k)) return false;
        if (c[k] == -1 && c[(k + 4) % 8] == -1) return false;
    }
    return inside < 8 && along > 0 && sound_edges(c) && (higher == 1 || higher == 2);
}

static int code(const int *c) {
    int n = 0;
    for (int k = 0; k < 8; k++) n = 6 * n + (c[k] == OUTSIDE ? 5 : c[k] + 2);
    return n;
}

/* Of the 8 that the symmetries of the square make of it, is this the first? */
static bool is_first(const int *c) {
    for (int s = 0; s < 8; s++) {
        int image[8];
        for (int k = 0; k < 8; k++) image[((s < 4 ? k : 8 - k) + 2 * s) % 8] = c[k];
        if (code(image) < code(c)) return false;
    }
    return true;
}

static bool is_first_pattern(const int *c) {
    int inside[8];
    for (int k = 0; k < 8; k++) inside[k] = c[k] == OUTSIDE ? OUTSIDE : 0;
    return is_first(inside);
}

static void decode(int n, int *c) {
    for (int k = 7; k >= 0; k--, n /= 6) c[k] = n % 6 == 5 ? OUTSIDE : n % 6 - 2;
}

/* Outside neighbours are lower (inward); equal depths, at the two corners that the triangulation
 * joins with v, are tried both ways each. */
static bool is_never_critical(const int *c) {
    for (int ties = 0; ties < 4; ties++) {
        const bool higher[6] = {c[0] < 0, c[1] < ties % 2, c[2] < 0,
                                c[4] < 0, c[5] < ties / 2, c[6] < 0};
        int n = 0;
        for (int k = 0; k < 6; k++) n += higher[k] != higher[(k + 1) % 6];
        if (n != 2) return false;
    }
    return true;
}

static void see(const struct icc_domain *d, const struct icc_function *f, unsigned char *seen) {
    int32_t nx = (int32_t)d->nx;
    const int32_t next[8] = {1, nx + 1, nx, nx - 1, -1, -nx - 1, -nx, 1 - nx};
    for (uint32_t v = 0; v < icc_domain_size(d); v++) {
        int c[8], outside = 0;
        if (!d->inside[v] || v == f->maximum) continue;
        for (int k = 0; k < 8; k++) {
            uint32_t w = (uint32_t)((int32_t)v + next[k]);
            c[k] = d->inside[w] ? (int)(f->height[v] - f->height[w]) : OUTSIDE;
            outside += !d->inside[w];
        }
        if (outside == 0) continue;
        for (int k = 0; k < 8; k++) assert_true(c[k] == OUTSIDE || abs(c[k]) <= 2);
        seen[code(c)] = 1;
    }
}

/* The configurations that random balls have are those that the rules leave, and none of them is
 * critical. */
static void boundary_configurations(void **state) {
    enum { CODES = 1679616 }; /* 6^8 */
    unsigned char *seen = calloc(CODES, 1), *patterns = calloc(256, 1);
    int configurations = 0, found = 0, pattern_count = 0, different[2] = {0, 0};
    assert_true(seen && patterns);
    (void)state;
    for (uint64_t seed = 1; seed <= 3000; seed++) {
        uint64_t random = seed;
        struct icc_domain d;
        struct icc_function f;
        random_ball(&d, 5, 5, (uint32_t)random_in(&random, 4, 18), &random);
        for (int n = 0; n < 4; n++) {
            make(&f, &d, some_inside(&d, &random), &cousin);
            see(&d, &f, seen);
            icc_function_free(&f);
        }
        icc_domain_free(&d);
    }
    for (int n = 0; n < CODES; n++) {
        int c[8], pattern = 0;
        decode(n, c);
        if (!is_configuration(c)) {
            assert_false(seen[n]);
            continue;
        }
        configurations++;
        found += seen[n];
        for (int k = 0; k < 8; k++) pattern |= (c[k] != OUTSIDE) << k;
        different[0] += is_first(c);
        different[1] += !patterns[pattern] && is_first_pattern(c);
        pattern_count += !patterns[pattern];
        patterns[pattern] = 1;
        assert_true(is_never_critical(c));
    }
    print_message("%d patterns, %d configurations (%d and %d up to symmetry), %d of them found in "
                  "random balls\n",
                  pattern_count, configurations, different[1], different[0], found);
    assert_int_equal(configurations, CONFIGURATIONS);
    assert_int_equal(pattern_count, PATTERNS);
    assert_int_equal(different[0], DIFFERENT_CONFIGURATIONS);
    assert_int_equal(different[1], DIFFERENT_PATTERNS);
    free(seen);
    free(patterns);
}

/* ---- values -----------------------------------------------------------------------------------
 */

static void check_depths(const struct icc_domain *d, const struct icc_function *f, uint64_t seed) {
    uint32_t n = icc_domain_size(d), nx = d->nx;
    double *depth = calloc(n, sizeof *depth);
    bool again = true;
    assert_non_null(depth);
    for (uint32_t v = 0; v < n; v++) depth[v] = v == f->maximum ? 0 : INFINITY;
    while (again) {
        again = false;
        for (uint32_t v = 0; v < n; v++) {
            if (!d->inside[v]) continue;
            double least =
                fmin(fmin(depth[v - 1], depth[v + 1]), fmin(depth[v - nx], depth[v + nx]));
            if (least + 1 < depth[v]) depth[v] = least + 1, again = true;
        }
    }
    for (uint32_t v = 0; v < n; v++)
        if (d->inside[v]) {
            check_seed(seed, isinf(depth[v]) ? isnan(f->height[v]) : f->height[v] == -depth[v]);
            if (v != f->maximum && !isinf(depth[v]))
                check_seed(seed, depth[f->parent[v]] == depth[v] - 1);
        }
    free(depth);
}

static bool is_inside_beside(const struct icc_domain *d, uint32_t v) {
    return d->inside[v - 1] || d->inside[v + 1] || d->inside[v - d->nx] || d->inside[v + d->nx];
}

/* The first ring by its definition; further out, lower than all neighbours that are nearer; no flat
 * triangle but, for harmonic functions, in rings of zeros. */
static void check_inward(const struct icc_domain *d, const struct icc_function *f, uint64_t seed) {
    int32_t nx = (int32_t)d->nx;
    const int32_t next[8] = {1, nx + 1, nx, nx - 1, -1, -nx - 1, -nx, 1 - nx};
    for (uint32_t v = d->nx + 1; v + d->nx + 1 < icc_domain_size(d); v++) {
        double least = INFINITY;
        if (icc_function_has(f, v) && icc_function_has(f, v + 1) &&
            icc_function_has(f, v + d->nx + 1))
            check_seed(seed, f->height[v] != f->height[v + 1] ||
                                 f->height[v] != f->height[v + d->nx + 1]);
        if (d->inside[v] || !is_inside_beside(d, v)) continue;
        for (int k = 0; k < 8; k++) {
            uint32_t w = (uint32_t)((int32_t)v + next[k]);
            if (d->inside[w]) least = fmin(least, f->height[w]);
        }
        check_seed(seed, f->height[v] <= least - 1 && f->height[v] >= least - 3);
    }
}

/* A path over outside neighbours of each vertex with a value leads down and away, or in. */
static void check_rings(const struct icc_domain *d, const struct icc_function *f, uint64_t seed) {
    uint32_t inside = 0, valued = 0;
    int32_t nx = (int32_t)d->nx;
    const int32_t next[8] = {1, nx + 1, nx, nx - 1, -1, -nx - 1, -nx, 1 - nx};
    for (uint32_t v = 0; v < icc_domain_size(d); v++) {
        int steps = 0;
        inside += d->inside[v];
        valued += icc_function_has(f, v);
        if (d->inside[v] || !icc_function_has(f, v)) continue;
        for (uint32_t w = v; !d->inside[w]; w = f->parent[w], steps++)
            check_seed(seed, steps < 6 && f->height[f->parent[w]] > f->height[w]);
        check_seed(seed, steps <= 5);
    }
    check_seed(seed, inside == f->reached && valued == f->valued);
    for (uint32_t v = 0; v < icc_domain_size(d); v++)
        for (int k = 0; d->inside[v] && k < 8; k++)
            check_seed(seed, icc_function_has(f, (uint32_t)((int32_t)v + next[k])));
}

static void values(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(100); seed++) {
        uint64_t random = seed;
        struct icc_domain d;
        struct icc_function f, other;
        struct icc_function_rule yx = {.kind = ICC_COUSIN, .axes = ICC_YX};
        random_ball(&d, 24, 20, (uint32_t)random_in(&random, 1, 200), &random);
        uint32_t maximum = some_inside(&d, &random);
        make(&f, &d, maximum, &cousin);
        check_depths(&d, &f, seed);
        check_inward(&d, &f, seed);
        check_rings(&d, &f, seed);
        make(&other, &d, maximum, &yx);
        for (uint32_t v = 0; v < icc_domain_size(&d); v++)
            check_seed(seed, f.height[v] == other.height[v] ||
                                 (isnan(f.height[v]) && isnan(other.height[v])));
        icc_function_free(&f);
        icc_function_free(&other);
        icc_domain_free(&d);
    }
}

/* Algorithm 2: outside, one below the first of the tree that is beside it. */
static void literal(void **state) {
    const struct icc_function_rule rule = {.kind = ICC_COUSIN, .outside = ICC_LITERAL};
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(50); seed++) {
        uint64_t random = seed;
        struct icc_domain d;
        struct icc_function f;
        random_ball(&d, 20, 20, (uint32_t)random_in(&random, 1, 150), &random);
        make(&f, &d, some_inside(&d, &random), &rule);
        check_depths(&d, &f, seed);
        for (uint32_t v = d.nx + 1; v + d.nx + 1 < icc_domain_size(&d); v++) {
            const uint32_t next[4] = {v - 1, v + 1, v - d.nx, v + d.nx};
            double most = -INFINITY;
            if (d.inside[v] || !is_inside_beside(&d, v)) continue;
            for (int k = 0; k < 4; k++)
                if (d.inside[next[k]]) most = fmax(most, f.height[next[k]]);
            check_seed(seed, f.height[v] == most - 1);
        }
        icc_function_free(&f);
        icc_domain_free(&d);
    }
}

/* A corridor of 20,000 vertices: 0.95^depth would be 0 at its end; in its own units it is not. */
static void deep_tree(void **state) {
    enum { LENGTH = 20000 };
    unsigned char *bits = malloc(LENGTH);
    struct icc_domain d;
    struct icc_function f;
    (void)state;
    assert_non_null(bits);
    memset(bits, 1, LENGTH);
    planted_domain(&d, LENGTH, 1, bits);
    free(bits);
    make(&f, &d, 2 * d.nx + 2, &cousin);
    uint32_t end = 2 * d.nx + LENGTH + 1;
    assert_true(f.height[end] == 1 - LENGTH);
    assert_true(icc_function_at(&f, f.height[end - 1], f.height[end]) == 0.95);
    assert_true(icc_function_at(&f, f.height[end - 1], f.height[end - 1]) == 1);
    assert_true(icc_function_at(&f, 0, f.height[end]) == 0);
    icc_function_free(&f);
    icc_domain_free(&d);
}

/* ---- Green's functions ------------------------------------------------------------------------
 */

enum { UNKNOWNS = 14 };

/* L x = b by elimination in rationals; b becomes x. */
static void eliminate(mpq_t a[UNKNOWNS][UNKNOWNS], mpq_t *b, int n) {
    mpq_t factor, term;
    mpq_inits(factor, term, NULL);
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++) {
            if (i == k) continue;
            mpq_div(factor, a[i][k], a[k][k]);
            for (int j = 0; j < n; j++) {
                mpq_mul(term, factor, a[k][j]);
                mpq_sub(a[i][j], a[i][j], term);
            }
            mpq_mul(term, factor, b[k]);
            mpq_sub(b[i], b[i], term);
        }
    for (int k = 0; k < n; k++) mpq_div(b[k], b[k], a[k][k]);
    mpq_clears(factor, term, NULL);
}

static void solve_exactly(const struct icc_domain *d, const uint32_t *list, int n, mpq_t *b) {
    mpq_t a[UNKNOWNS][UNKNOWNS];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            uint32_t v = list[i], w = list[j];
            bool beside = w == v + 1 || v == w + 1 || w == v + d->nx || v == w + d->nx;
            mpq_init(a[i][j]);
            mpq_set_si(a[i][j], i == j ? 4 : beside ? -1 : 0, 1);
        }
    eliminate(a, b, n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) mpq_clear(a[i][j]);
}

/* Within half a unit in the last place and a little. */
static bool is_rounded(const mpq_t exact, double x) {
    mpq_t error;
    bool ok;
    mpq_init(error);
    mpq_set_d(error, x);
    mpq_sub(error, error, exact);
    ok = fabs(mpq_get_d(error)) <= 0.500001 * 0x1p-52 * fabs(x);
    mpq_clear(error);
    return ok;
}

static void green(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(60); seed++) {
        uint64_t random = seed;
        struct icc_domain d;
        struct icc_function f;
        struct icc_function_rule rule = {.kind = seed % 2 ? ICC_HARMONIC : ICC_BIHARMONIC};
        uint32_t list[UNKNOWNS], maximum;
        mpq_t b[UNKNOWNS];
        int n = 0;
        random_ball(&d, 6, 6, UNKNOWNS, &random);
        maximum = some_inside(&d, &random);
        for (uint32_t v = 0; v < icc_domain_size(&d); v++)
            if (d.inside[v]) list[n++] = v;
        for (int i = 0; i < n; i++) {
            mpq_init(b[i]);
            mpq_set_si(b[i], list[i] == maximum, 1);
        }
        solve_exactly(&d, list, n, b);
        if (rule.kind == ICC_BIHARMONIC) solve_exactly(&d, list, n, b);
        make(&f, &d, maximum, &rule);
        for (int i = 0; i < n; i++) check_seed(seed, is_rounded(b[i], f.height[list[i]]));
        check_rings(&d, &f, seed);
        for (int i = 0; i < n; i++) mpq_clear(b[i]);
        icc_function_free(&f);
        icc_domain_free(&d);
    }
}

/* Far from the maximum u falls below 1e-250, and still by the factor 2 + sqrt 3 from vertex to
 * vertex, as it must in a corridor of one vertex. */
static void green_far_away(void **state) {
    enum { LENGTH = 450 };
    const struct icc_function_rule rule = {.kind = ICC_HARMONIC};
    unsigned char bits[LENGTH];
    struct icc_domain d;
    struct icc_function f;
    (void)state;
    memset(bits, 1, sizeof bits);
    planted_domain(&d, LENGTH, 1, bits);
    make(&f, &d, 2 * d.nx + 2, &rule);
    for (uint32_t v = 2 * d.nx + 2; v < 2 * d.nx + LENGTH - 30; v++)
        assert_true(fabs(f.height[v] / f.height[v + 1] - (2 + sqrt(3))) < 1e-15 * 8);
    assert_true(f.height[2 * d.nx + LENGTH + 1] < 1e-250 && f.height[2 * d.nx + LENGTH + 1] > 0);
    icc_function_free(&f);
    icc_domain_free(&d);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(theorems_on_all_small_balls),
        cmocka_unit_test(theorems_on_random_balls),
        cmocka_unit_test(boundary_configurations),
        cmocka_unit_test(values),
        cmocka_unit_test(literal),
        cmocka_unit_test(deep_tree),
        cmocka_unit_test(green),
        cmocka_unit_test(green_far_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
