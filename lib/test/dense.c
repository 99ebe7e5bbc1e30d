/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dense.h"

#include "err.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *allocate(size_t n, size_t size) {
    void *p = calloc(n ? n : 1, size);
    INVARIANT(p);
    return p;
}

static uint64_t power(uint64_t base, uint64_t exponent, uint64_t prime) {
    uint64_t result = 1;
    for (; exponent > 0; exponent >>= 1) {
        if (exponent & 1) result = result * base % prime;
        base = base * base % prime;
    }
    return result;
}

/* Primes below 2^31, so that products fit. */
static size_t rank_modulo(const int64_t *a, size_t m, size_t n, uint64_t prime) {
    uint64_t *x = allocate(m * n, sizeof *x);
    size_t rank = 0;
    for (size_t i = 0; i < m * n; i++) {
        int64_t rest = a[i] % (int64_t)prime;
        x[i] = (uint64_t)(rest < 0 ? rest + (int64_t)prime : rest);
    }
    for (size_t column = 0; column < n && rank < m; column++) {
        size_t pivot = rank;
        while (pivot < m && x[pivot * n + column] == 0) pivot++;
        if (pivot == m) continue;
        for (size_t j = 0; j < n; j++) {
            uint64_t swap = x[pivot * n + j];
            x[pivot * n + j] = x[rank * n + j];
            x[rank * n + j] = swap;
        }
        uint64_t inverse = power(x[rank * n + column], prime - 2, prime);
        for (size_t i = rank + 1; i < m; i++) {
            uint64_t factor = (prime - x[i * n + column]) * inverse % prime;
            if (factor == 0) continue;
            for (size_t j = column; j < n; j++)
                x[i * n + j] = (x[i * n + j] + factor * x[rank * n + j]) % prime;
        }
        rank++;
    }
    free(x);
    return rank;
}

size_t dense_rank(const int64_t *a, size_t m, size_t n) {
    size_t first = rank_modulo(a, m, n, 2147483647), second = rank_modulo(a, m, n, 2147483629);
    return first > second ? first : second;
}

static long double dot(const long double *a, const long double *b, size_t n) {
    long double sum = 0;
    for (size_t j = 0; j < n; j++) sum += a[j] * b[j];
    return sum;
}

/* With s = sqrt(w) (x - t): minimise |s| subject to (A W^-1/2) s = b - A t. The rows are made
 * orthonormal, largest first, carrying their right-hand sides along; s is then sum of rhs * row. */
struct rows {
    size_t m, n;
    long double *row, *rhs;
};

static void normalise(struct rows *r, size_t i) {
    long double norm = sqrtl(dot(r->row + i * r->n, r->row + i * r->n, r->n));
    if (norm == 0) return;
    for (size_t j = 0; j < r->n; j++) r->row[i * r->n + j] /= norm;
    r->rhs[i] /= norm;
}

static void subtract(struct rows *r, size_t i, size_t from) {
    long double share = dot(r->row + i * r->n, r->row + from * r->n, r->n);
    for (size_t j = 0; j < r->n; j++) r->row[i * r->n + j] -= share * r->row[from * r->n + j];
    r->rhs[i] -= share * r->rhs[from];
}

static void swap_rows(struct rows *r, size_t i, size_t k) {
    long double swap = r->rhs[i];
    r->rhs[i] = r->rhs[k];
    r->rhs[k] = swap;
    for (size_t j = 0; j < r->n; j++) {
        swap = r->row[i * r->n + j];
        r->row[i * r->n + j] = r->row[k * r->n + j];
        r->row[k * r->n + j] = swap;
    }
}

/* Returns how many independent rows there are; what is left of the others is below 1e-13. */
static size_t orthonormalise(struct rows *r) {
    for (size_t i = 0; i < r->m; i++) normalise(r, i);
    for (size_t i = 0; i < r->m; i++) {
        size_t best = i;
        long double largest = 0;
        for (size_t k = i; k < r->m; k++) {
            long double size = dot(r->row + k * r->n, r->row + k * r->n, r->n);
            if (size > largest) largest = size, best = k;
        }
        if (largest < 1e-26L) return i;
        swap_rows(r, i, best);
        for (size_t k = 0; k < i; k++) subtract(r, i, k);
        normalise(r, i);
        for (size_t k = i + 1; k < r->m; k++) subtract(r, k, i);
    }
    return r->m;
}

long double dense_least_squares(const long double *a, const long double *b, size_t m, size_t n,
                                const double *weight, const double *target, long double *x) {
    struct rows r = {m, n, allocate(m * n, sizeof *r.row), allocate(m, sizeof *r.rhs)};
    long double worst = 0;
    size_t rank;
    for (size_t i = 0; i < m; i++) {
        r.rhs[i] = b[i];
        for (size_t j = 0; j < n; j++) {
            r.rhs[i] -= a[i * n + j] * target[j];
            r.row[i * n + j] = a[i * n + j] / sqrtl(weight[j]);
        }
    }
    rank = orthonormalise(&r);
    for (size_t j = 0; j < n; j++) {
        long double sum = 0;
        for (size_t i = 0; i < rank; i++) sum += r.rhs[i] * r.row[i * n + j];
        x[j] = target[j] + sum / sqrtl(weight[j]);
    }
    for (size_t i = 0; i < m; i++) {
        long double norm = sqrtl(dot(a + i * n, a + i * n, n));
        long double off = fabsl(dot(a + i * n, x, n) - b[i]);
        if (norm > 0) off /= norm;
        if (off > worst) worst = off;
    }
    free(r.row);
    free(r.rhs);
    return worst;
}
