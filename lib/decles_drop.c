/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A relation y.A = 0 over all points needs no care: where its other conditions hold, the dropped
 * one holds too, and rounding its own points leaves it within 1 u of its terms. A relation that
 * vanishes on the columns of D only is tied to points outside: y.A_F f is 0 up to the rounding
 * of earlier edits, and after the solution that stands in the dropped condition alone. With t_r the
 * terms of condition r, the others within u of theirs allow
 *
 *     |sum_r y_r t_r| u / (|y_dropped| t_dropped)
 *
 * relative to its terms: so the one with about the largest share |y_r| t_r is dropped. This happens
 * around singular vertices, whose ring 2 has a relation of its own, tied to ring 1. */
#include "decles_drop.h"

#include "mem.h"

#include <math.h>

/* For each row, the relations that may contain it: a list that only grows. */
struct node {
    size_t relation, next; /* next: 1 + a node, or 0 */
};

struct index {
    size_t *first; /* of each row: 1 + a node, or 0; NULL until it is needed */
    struct node *node;
    size_t n, cap;
};

static bool index_add(struct index *x, const struct exact_relation *y, size_t i, struct err *err) {
    if (!mem_grow(x->node, &x->cap, x->n + y->n, err)) return false;
    for (size_t j = 0; j < y->n; j++) {
        x->node[x->n] = (struct node){i, x->first[y->row[j]]};
        x->first[y->row[j]] = ++x->n;
    }
    return true;
}

static bool index_init(struct index *x, const struct exact_rows *rows, size_t row_count,
                       struct err *err) {
    if (!mem_new(x->first, row_count, err)) return false;
    for (size_t i = 0; i < rows->relation_count; i++)
        if (!index_add(x, &rows->relation[i], i, err)) return false;
    return true;
}

/* Place of a row in the relation, or its n. */
static size_t find(const struct exact_relation *y, size_t row) {
    size_t j = 0;
    while (j < y->n && y->row[j] != row) j++;
    return j;
}

static void relation_clear(struct exact_relation *y) {
    for (size_t j = 0; j < y->n; j++) mpz_clear(y->y[j]);
    free(y->row);
    free(y->y);
}

/* Divides by the greatest common divisor and forgets zeros. */
static void make_primitive(struct exact_relation *y) {
    size_t n = 0;
    mpz_t divisor;
    mpz_init(divisor);
    for (size_t j = 0; j < y->n; j++) {
        mpz_gcd(divisor, divisor, y->y[j]);
        if (mpz_sgn(y->y[j]) == 0) continue;
        y->row[n] = y->row[j];
        mpz_swap(y->y[n++], y->y[j]);
    }
    for (size_t j = n; j < y->n; j++) mpz_clear(y->y[j]);
    y->n = n;
    for (size_t j = 0; j < n; j++) mpz_divexact(y->y[j], y->y[j], divisor);
    mpz_clear(divisor);
}

/* Takes row[at] of y out of relation z: z := y[at] z - z[same] y. */
static bool eliminate(struct exact_relation *z, const struct exact_relation *y, size_t at,
                      struct err *err) {
    struct exact_relation sum = {.dependent = z->dependent};
    size_t same = find(z, y->row[at]);
    if (same == z->n) return true;
    if (!mem_new(sum.row, z->n + y->n, err)) return false;
    if (!mem_new(sum.y, z->n + y->n, err)) {
        free(sum.row);
        return false;
    }
    for (size_t j = 0; j < z->n; j++) {
        sum.row[sum.n] = z->row[j];
        mpz_init(sum.y[sum.n]);
        mpz_mul(sum.y[sum.n++], z->y[j], y->y[at]);
    }
    for (size_t j = 0; j < y->n; j++) {
        size_t place = find(&sum, y->row[j]);
        if (place == sum.n) {
            sum.row[sum.n] = y->row[j];
            mpz_init(sum.y[sum.n++]);
        }
        mpz_submul(sum.y[place], y->y[j], z->y[same]);
    }
    make_primitive(&sum);
    relation_clear(z);
    *z = sum;
    return true;
}

/* Makes row[at] of relation i the dependent one. */
static bool exchange(struct exact_rows *rows, struct index *x, size_t row_count, size_t i,
                     size_t at, bool *tied, struct err *err) {
    struct exact_relation *y = &rows->relation[i];
    size_t row = y->row[at];
    if (!x->first && !index_init(x, rows, row_count, err)) return false;
    for (size_t n = x->first[row]; n > 0; n = x->node[n - 1].next) {
        size_t other = x->node[n - 1].relation;
        if (other == i || find(&rows->relation[other], row) == rows->relation[other].n) continue;
        if (!eliminate(&rows->relation[other], y, at, err) || !index_add(x, y, other, err))
            return false;
        tied[other] = true;
    }
    rows->independent[y->dependent] = true;
    rows->independent[row] = false;
    y->dependent = row;
    return true;
}

/* |y_r| t_r over the sum of all, the smaller of the components; shares[j] of row[j]. */
static void find_shares(const struct exact_relation *y, const struct decles_sets *sets,
                        const struct decles_values *values, double *shares) {
    size_t bits = 0;
    for (size_t j = 0; j < y->n; j++) {
        size_t size = mpz_sizeinbase(y->y[j], 2);
        if (size > bits) bits = size;
        shares[j] = INFINITY;
    }
    for (int c = 0; c < values->k; c++) {
        double sum = 0;
        for (int pass = 0; pass < 2; pass++)
            for (size_t j = 0; j < y->n; j++) {
                const struct c1_condition *row = &sets->row[y->row[j]];
                double terms = c1_evaluate(row, values->q + c, values->stride, sets->dust).terms;
                long exponent;
                double mantissa = mpz_get_d_2exp(&exponent, y->y[j]);
                double share = fabs(ldexp(mantissa, (int)(exponent - (long)bits))) * terms;
                if (pass == 0)
                    sum += share;
                else
                    shares[j] = fmin(shares[j], sum > 0 ? share / sum : 0);
            }
    }
}

/* The place of the row to be dropped: the present one unless another's share is over twice as
 * large. */
static bool choose(const struct exact_relation *y, const struct decles_sets *sets,
                   const struct decles_values *values, size_t *at, struct err *err) {
    size_t present = find(y, y->dependent), best = present;
    double *shares;
    if (!mem_new(shares, y->n, err)) return false;
    find_shares(y, sets, values, shares);
    for (size_t j = 0; j < y->n; j++)
        if (shares[j] > shares[best]) best = j;
    *at = shares[best] > 2 * shares[present] ? best : present;
    free(shares);
    return true;
}

bool decles_drop(struct exact_rows *rows, const struct decles_sets *sets,
                 const struct decles_values *values, bool *tied, struct err *err) {
    struct index x = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < rows->relation_count; i++) {
        const struct exact_relation *y = &rows->relation[i];
        size_t at = 0;
        if (!tied[i]) continue;
        ok = choose(y, sets, values, &at, err);
        if (ok && y->row[at] != y->dependent)
            ok = exchange(rows, &x, sets->condition_count, i, at, tied, err);
    }
    free(x.first);
    free(x.node);
    return ok;
}
