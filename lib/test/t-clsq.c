// SPDX-License-Identifier: GPL-3.0-or-later
/* clsq against the dense equations of Lagrange, solved in rationals and rounded by MPFR. */
#include "clsq.h"

#include "testing.h"

#include <inttypes.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- random problems ---- */

static double random_real(uint64_t *state) { /* in [-1, 1) */
    return (double)(int64_t)random_bits(state) * 0x1p-63;
}

enum { MAX_ROWS = 12, MAX_COLS = 24 };

/* A small problem with room for its arrays. */
struct small {
    struct int_matrix a, f;
    size_t a_start[MAX_ROWS + 1], f_start[MAX_ROWS + 1];
    uint32_t a_col[MAX_ROWS * MAX_COLS], f_col[MAX_ROWS * MAX_COLS];
    int64_t a_value[MAX_ROWS * MAX_COLS], f_value[MAX_ROWS * MAX_COLS];
    double weight[MAX_COLS], target[2 * MAX_COLS], fixed[2 * MAX_COLS];
    struct clsq_problem p;
};

static void connect(struct small *s, size_t m, size_t n, size_t p, int k) {
    s->a = (struct int_matrix){m, n, s->a_start, s->a_col, s->a_value};
    s->f = (struct int_matrix){m, p, s->f_start, s->f_col, s->f_value};
    s->p = (struct clsq_problem){.a = &s->a,
                                 .f = &s->f,
                                 .k = k,
                                 .weight = s->weight,
                                 .target = s->target,
                                 .fixed = s->fixed};
}

static void append(struct int_matrix *a, size_t row, size_t col, int64_t value) {
    size_t at = a->start[row + 1];
    if (!value) return;
    a->col[at] = (uint32_t)col;
    a->value[at] = value;
    a->start[row + 1]++;
}

/* How the entries of a random problem are made. */
struct kind {
    int64_t coefficient;  /* |values| up to this */
    int percent;          /* of non-zero entries */
    double weight_digits; /* weights are 10^-this .. 10^this */
    double magnitude;     /* of targets and fixed values */
    int64_t near;         /* > 0: the last row is `near` times the first, one entry changed by 1 */
    bool integers;        /* targets and fixed values are integers, weights 1 */
    bool may_refuse;      /* beyond what doubles can do, but never a wrong answer */
};

static void fill_row(struct small *s, uint64_t *seed, const struct kind *kind, size_t i) {
    s->a.start[i + 1] = s->a.start[i];
    s->f.start[i + 1] = s->f.start[i];
    for (size_t j = 0; j < s->a.cols; j++) {
        int64_t value = random_in(seed, -kind->coefficient, kind->coefficient);
        if (j == i || random_in(seed, 0, 99) < kind->percent) append(&s->a, i, j, value);
    }
    if (s->a.start[i + 1] == s->a.start[i]) append(&s->a, i, i, 1);
    for (size_t j = 0; j < s->f.cols; j++)
        append(&s->f, i, j, random_in(seed, -kind->coefficient, kind->coefficient));
}

static void copy_row_nearly(struct small *s, uint64_t *seed, size_t i, int64_t factor) {
    size_t length = s->a.start[1], changed = (size_t)random_in(seed, 0, (int64_t)length - 1);
    s->a.start[i + 1] = s->a.start[i];
    for (size_t e = 0; e < length; e++)
        append(&s->a, i, s->a.col[e], factor * s->a.value[e] + (e == changed));
}

static void fill(struct small *s, uint64_t *seed, const struct kind *kind) {
    for (size_t i = 0; i < s->a.rows; i++) fill_row(s, seed, kind, i);
    if (kind->near && s->a.rows > 1) copy_row_nearly(s, seed, s->a.rows - 1, kind->near);
    for (size_t j = 0; j < s->a.cols; j++)
        s->weight[j] = kind->integers ? 1 : pow(10, kind->weight_digits * random_real(seed));
    for (size_t j = 0; j < MAX_COLS * 2; j++) {
        double t = random_real(seed), f = random_real(seed);
        s->target[j] = kind->integers ? nearbyint(64 * t) : kind->magnitude * t;
        s->fixed[j] = kind->integers ? nearbyint(64 * f) : kind->magnitude * f;
    }
}

/* ---- the oracle ---- */

enum { MAX_SIZE = MAX_ROWS + MAX_COLS, MAX_WIDTH = MAX_SIZE + 2 };

struct dense {
    size_t size, width;
    mpq_t at[MAX_SIZE][MAX_WIDTH];
};

/* sum += value * x */
static void add_product(mpq_t sum, int64_t value, double x) {
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    mpq_set_d(a, (double)value);
    mpq_set_d(b, x);
    mpq_mul(a, a, b);
    mpq_add(sum, sum, a);
    mpq_clears(a, b, NULL);
}

/* W x - A^T l = W t and A x = -F f; the unknowns are x, l. */
static void dense_fill(struct dense *d, const struct clsq_problem *p) {
    size_t n = p->a->cols, m = p->a->rows, k = (size_t)p->k;
    d->size = n + m, d->width = n + m + k;
    for (size_t i = 0; i < d->size; i++)
        for (size_t j = 0; j < d->width; j++) mpq_init(d->at[i][j]);
    for (size_t j = 0; j < n; j++) {
        mpq_set_d(d->at[j][j], p->weight[j]);
        for (size_t c = 0; c < k; c++) {
            mpq_set_d(d->at[j][n + m + c], p->target[j * k + c]);
            mpq_mul(d->at[j][n + m + c], d->at[j][n + m + c], d->at[j][j]);
        }
    }
    for (size_t i = 0; i < m; i++) {
        for (size_t e = p->a->start[i]; e < p->a->start[i + 1]; e++) {
            mpq_set_d(d->at[n + i][p->a->col[e]], (double)p->a->value[e]);
            mpq_set_d(d->at[p->a->col[e]][n + i], -(double)p->a->value[e]);
        }
        for (size_t e = p->f->start[i]; e < p->f->start[i + 1]; e++)
            for (size_t c = 0; c < k; c++)
                add_product(d->at[n + i][n + m + c], -p->f->value[e],
                            p->fixed[p->f->col[e] * k + c]);
    }
}

/* row i -= factor * row r from column r on */
static void dense_subtract(struct dense *d, size_t i, size_t r) {
    mpq_t factor, product;
    mpq_inits(factor, product, NULL);
    mpq_div(factor, d->at[i][r], d->at[r][r]);
    for (size_t j = r; mpq_sgn(factor) && j < d->width; j++) {
        mpq_mul(product, factor, d->at[r][j]);
        mpq_sub(d->at[i][j], d->at[i][j], product);
    }
    mpq_clears(factor, product, NULL);
}

/* Gauss-Jordan; false if the matrix is singular. */
static bool dense_solve(struct dense *d) {
    for (size_t r = 0; r < d->size; r++) {
        size_t pivot = r;
        while (pivot < d->size && !mpq_sgn(d->at[pivot][r])) pivot++;
        if (pivot == d->size) return false;
        for (size_t j = 0; pivot != r && j < d->width; j++) mpq_swap(d->at[pivot][j], d->at[r][j]);
        for (size_t i = 0; i < d->size; i++)
            if (i != r) dense_subtract(d, i, r);
    }
    return true;
}

static double dense_value(struct dense *d, size_t j, size_t c) {
    mpq_div(d->at[j][d->size + c], d->at[j][d->size + c], d->at[j][j]);
    mpfr_t x;
    mpfr_init2(x, 53);
    mpfr_set_q(x, d->at[j][d->size + c], MPFR_RNDN);
    double value = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return value;
}

static void dense_clear(struct dense *d) {
    for (size_t i = 0; i < d->size; i++)
        for (size_t j = 0; j < d->width; j++) mpq_clear(d->at[i][j]);
}

/* What was compared so far. */
struct tally {
    size_t entries, equal, problems, by_qr, refused;
    int refinements;
};

/* Compares x with the oracle's answer: equal or an ulp apart, but for dust far below the largest.
 */
static void compare(struct dense *d, const struct small *s, const double *x, uint64_t seed,
                    struct tally *tally) {
    size_t k = (size_t)s->p.k, count = s->a.cols * k;
    double exact[2 * MAX_COLS], largest = 0;
    for (size_t j = 0; j < count; j++) {
        exact[j] = dense_value(d, j / k, j % k);
        largest = fmax(largest, fabs(exact[j]));
    }
    for (size_t j = 0; j < count; j++) {
        bool near = x[j] == exact[j] || nextafter(x[j], exact[j]) == exact[j] ||
                    fabs(x[j] - exact[j]) <= largest * 0x1p-100;
        if (!near) print_error("seed %" PRIu64 " x[%zu] %.17g != %.17g\n", seed, j, x[j], exact[j]);
        assert_true(near);
        tally->equal += x[j] == exact[j];
    }
    tally->entries += count;
}

/* Solves s and compares. Problems whose rows happen to be dependent are passed over. */
static void check(struct small *s, uint64_t seed, bool may_refuse, struct tally *tally) {
    struct dense *d = malloc(sizeof *d);
    struct clsq_report report;
    struct err err = {0};
    double x[2 * MAX_COLS];
    assert_non_null(d);
    dense_fill(d, &s->p);
    if (dense_solve(d)) {
        bool ok = clsq_solve(&s->p, x, &report, &err);
        if (!ok && !may_refuse) print_error("seed %" PRIu64 ": %s\n", seed, err.message);
        assert_true(ok || (may_refuse && err.kind == ERR_REFUSAL));
        tally->problems++;
        tally->refused += !ok;
        tally->by_qr += report.by_qr;
        if (report.refinements > tally->refinements) tally->refinements = report.refinements;
        if (ok) compare(d, s, x, seed, tally);
    }
    dense_clear(d);
    free(d);
}

static void run(const struct kind *kind, int count, uint64_t first_seed, bool use_qr,
                struct tally *tally) {
    struct small *s = calloc(1, sizeof *s);
    assert_non_null(s);
    for (int i = 0; i < count; i++) {
        uint64_t state = first_seed + (uint64_t)i;
        size_t m = (size_t)random_in(&state, 1, MAX_ROWS - 4);
        size_t n = (size_t)random_in(&state, (int64_t)m, (int64_t)m * 2);
        size_t p = (size_t)random_in(&state, 0, 3);
        connect(s, m, n, p, (int)random_in(&state, 1, 2));
        fill(s, &state, kind);
        s->p.use_qr = use_qr;
        check(s, first_seed + (uint64_t)i, kind->may_refuse, tally);
    }
    free(s);
    assert_true(tally->problems * 2 > (size_t)count);
    print_message("    %zu problems, %zu by QR, %zu refused, %zu of %zu entries equal, "
                  "<= %d refinements\n",
                  tally->problems, tally->by_qr, tally->refused, tally->equal, tally->entries,
                  tally->refinements);
}

/* ---- tests ---- */

static void test_random(void **state) {
    (void)state;
    static const struct kind kinds[] = {
        {.coefficient = 9, .percent = 30, .magnitude = 1},
        {.coefficient = 9, .percent = 30, .magnitude = 1, .weight_digits = 6},
        {.coefficient = INT64_C(1) << 50, .percent = 60, .magnitude = 100, .weight_digits = 2},
        {.coefficient = 99, .percent = 40, .magnitude = 1e150, .weight_digits = 1},
        {.coefficient = 99, .percent = 40, .magnitude = 1e-150, .weight_digits = 1},
        {.coefficient = 9, .percent = 30, .magnitude = 1, .weight_digits = 100, .may_refuse = true},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct tally tally = {0};
        run(&kinds[i], test_count(100), 100000 * i, false, &tally);
        /* weights from 1e-100 to 1e100 leave some x far below the largest displacement */
        size_t allowed = kinds[i].may_refuse ? tally.entries / 50 : 0;
        assert_true(tally.entries - tally.equal <= allowed);
    }
}

/* Small integers everywhere: answers that are 0, or halfway between two doubles, come out as such,
 * whatever the factorisation. */
static void test_structured(void **state) {
    (void)state;
    const struct kind kind = {.coefficient = 1, .percent = 30, .integers = true};
    struct tally cholesky = {0}, qr = {0};
    run(&kind, test_count(300), 7000000, false, &cholesky);
    run(&kind, test_count(300), 7000000, true, &qr);
    assert_int_equal(cholesky.equal, cholesky.entries);
    assert_int_equal(qr.equal, qr.entries);
}

static void test_qr(void **state) {
    (void)state;
    const struct kind kind = {.coefficient = 9, .percent = 30, .magnitude = 1, .weight_digits = 3};
    struct tally tally = {0};
    run(&kind, test_count(100), 8000000, true, &tally);
    assert_int_equal(tally.equal, tally.entries);
    assert_int_equal(tally.by_qr, tally.problems);
}

static void test_nearly_dependent(void **state) {
    (void)state;
    size_t by_qr = 0;
    for (int digits = 3; digits <= 12; digits++) {
        const struct kind kind = {.coefficient = 99,
                                  .percent = 50,
                                  .magnitude = 1,
                                  .near = (int64_t)pow(10, digits),
                                  .may_refuse = digits > 10};
        struct tally tally = {0};
        run(&kind, test_count(30), 9000000 + 100000 * (uint64_t)digits, false, &tally);
        assert_true((tally.entries - tally.equal) * 100 <= tally.entries);
        assert_true(tally.refused * 2 <= tally.problems);
        by_qr += tally.by_qr;
    }
    assert_true(by_qr > 0);
}

static void test_no_rows(void **state) {
    (void)state;
    struct small *s = calloc(1, sizeof *s);
    struct clsq_report report;
    struct err err = {0};
    double x[6];
    connect(s, 0, 3, 0, 2);
    for (size_t j = 0; j < 6; j++) s->target[j] = j == 2 ? -0.0 : (double)j / 3;
    assert_true(clsq_solve(&s->p, x, &report, &err));
    assert_memory_equal(x, s->target, sizeof x);
    assert_int_equal(report.refinements, 0);
    free(s);
}

static void test_no_columns(void **state) {
    (void)state;
    struct small *s = calloc(1, sizeof *s);
    struct clsq_report report;
    struct err err = {0};
    connect(s, 0, 0, 0, 1);
    s->p.target = s->p.weight = NULL;
    assert_true(clsq_solve(&s->p, NULL, &report, &err));
    free(s);
}

/* x0 = x1 at ties, column 2 in no row: its bits stay, the sign of -0 too. */
static void test_ties(void **state) {
    (void)state;
    struct small *s = calloc(1, sizeof *s);
    struct clsq_report report;
    struct err err = {0};
    double x[3];
    connect(s, 1, 3, 0, 1);
    append(&s->a, 0, 0, 3);
    append(&s->a, 0, 1, -3);
    s->weight[0] = s->weight[1] = s->weight[2] = 0.7;
    s->target[2] = -0.0;
    for (int i = 0; i < 100; i++) {
        s->target[0] = 1 + i * 0x1p-52;
        s->target[1] = 1 + (3 * i + 1) * 0x1p-52;
        s->p.use_qr = i % 2;
        assert_true(clsq_solve(&s->p, x, &report, &err));
        double mean = (s->target[0] + s->target[1]) / 2; /* rounded to even */
        assert_true(x[0] == mean && x[1] == mean);
        assert_true(x[2] == 0 && signbit(x[2]));
    }
    free(s);
}

/* Rows equal as doubles: no solver in doubles can tell them apart. */
static void test_refusal(void **state) {
    (void)state;
    struct small *s = calloc(1, sizeof *s);
    struct clsq_report report;
    struct err err = {0};
    double x[3];
    int64_t big = INT64_C(1) << 53;
    connect(s, 2, 3, 0, 1);
    append(&s->a, 0, 0, big);
    append(&s->a, 0, 1, big - 1);
    s->a.start[2] = s->a.start[1];
    append(&s->a, 1, 0, big - 1);
    append(&s->a, 1, 1, big - 2); /* determinant -1 */
    s->weight[0] = s->weight[1] = s->weight[2] = 1;
    s->target[0] = 1;
    assert_false(clsq_solve(&s->p, x, &report, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_string_equal(err.message, "conditions too near to dependent for double precision");
    free(s);
}

static void test_overflow(void **state) {
    (void)state;
    struct small *s = calloc(1, sizeof *s);
    struct clsq_report report;
    struct err err = {0};
    double x[1];
    connect(s, 1, 1, 1, 1);
    append(&s->a, 0, 0, 1);
    append(&s->f, 0, 0, 2);
    s->weight[0] = 1;
    s->fixed[0] = 1e308;
    assert_false(clsq_solve(&s->p, x, &report, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    s->fixed[0] = 8e307;
    assert_true(clsq_solve(&s->p, x, &report, &err));
    assert_true(x[0] == -16e307);
    free(s);
}

/* ---- a strip of the shape of C1 conditions, large: residuals and time ---- */

struct large {
    struct int_matrix a, f;
    double *weight, *target, *fixed, *x;
};

/* side x side points, a condition with 4 coefficients around every second cell of the lattice. */
static void large_init(struct large *l, size_t side) {
    size_t n = side * side, m = 0;
    uint64_t seed = 5;
    l->a.start = calloc(n + 1, sizeof *l->a.start);
    l->a.col = calloc(4 * n, sizeof *l->a.col);
    l->a.value = calloc(4 * n, sizeof *l->a.value);
    for (size_t y = 0; y + 1 < side; y++) {
        for (size_t x = y % 2; x + 1 < side; x += 2, m++) {
            uint32_t p = (uint32_t)(y * side + x), q = p + (uint32_t)side;
            const uint32_t points[4] = {p, p + 1, q, q + 1};
            l->a.start[m + 1] = l->a.start[m];
            for (int e = 0; e < 4; e++)
                append(&l->a, m, points[e],
                       (e == 0 || e == 3 ? 1 : -1) * random_in(&seed, 900, 1100));
        }
    }
    l->a.rows = m, l->a.cols = n;
    l->f = (struct int_matrix){m, 0, calloc(m + 1, sizeof *l->f.start), NULL, NULL};
    l->weight = calloc(n, sizeof *l->weight);
    l->target = calloc(2 * n, sizeof *l->target);
    l->x = calloc(2 * n, sizeof *l->x);
    for (size_t j = 0; j < n; j++) l->weight[j] = 1;
    for (size_t j = 0; j < 2 * n; j++) l->target[j] = 100 * random_real(&seed);
}

static void large_free(struct large *l) {
    void *const all[] = {l->a.start, l->a.col, l->a.value, l->f.start, l->weight, l->target, l->x};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) free(all[i]);
}

static double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void large_check(size_t side, int times, bool use_qr) {
    struct large l = {0};
    struct clsq_report report;
    struct err err = {0};
    large_init(&l, side);
    struct clsq_problem p = {
        .a = &l.a, .f = &l.f, .k = 2, .weight = l.weight, .target = l.target, .use_qr = use_qr};
    double begin = seconds();
    for (int i = 0; i < times; i++) assert_true(clsq_solve(&p, l.x, &report, &err));
    double time = (seconds() - begin) / times;
    for (size_t i = 0; i < l.a.rows; i++) {
        for (size_t c = 0; c < 2; c++) {
            long double sum = 0, terms = 0;
            for (size_t e = l.a.start[i]; e < l.a.start[i + 1]; e++) {
                long double term = (long double)l.a.value[e] * l.x[2 * l.a.col[e] + c];
                sum += term, terms += fabsl(term);
            }
            assert_true(fabsl(sum) <= 0x1p-53L * terms * 1.001L);
        }
    }
    print_message("    %zu x %zu: %.6f s, %d refinements%s\n", l.a.rows, l.a.cols, time,
                  report.refinements, report.by_qr ? ", QR" : "");
    large_free(&l);
}

static void test_large(void **state) {
    (void)state;
    large_check(11, 200, false);
    large_check(100, 1, false);
    large_check(100, 1, true);
    large_check(440, 1, false);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),   cmocka_unit_test(test_structured),
        cmocka_unit_test(test_qr),       cmocka_unit_test(test_nearly_dependent),
        cmocka_unit_test(test_no_rows),  cmocka_unit_test(test_no_columns),
        cmocka_unit_test(test_ties),     cmocka_unit_test(test_refusal),
        cmocka_unit_test(test_overflow), cmocka_unit_test(test_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
