/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With the pivot rows B that the log combines into the dependent row r, in their pivot columns,
 *
 *      y_r = det B,   y_i = +- det (B with row i replaced by r),
 *
 * so |y| is at most the product of the norms of all these rows but the shortest. Residues become
 * integers by Garner's algorithm: mixed radix digits v_k with
 *
 *      y = v_0 + q_0 (v_1 + q_1 (v_2 + ...)),   0 <= v_k < q_k,
 *
 * with a top digit above q/2 for negative y. Why it ends: modulo a prime that divides no non-zero
 * minor of the core, elimination sees the same zeros as over Q; only finitely many primes do. */
#include "relation.h"

#include "mem.h"

#include <limits.h>

_Static_assert(ULONG_MAX == UINT64_MAX, "mpz_addmul_ui takes 64 bits");

/* ---- the list ---- */

struct exact_relation *relation_append(struct relation_list *list, size_t n, struct err *err) {
    struct exact_relation *r;
    if (!mem_grow(list->relation, &list->cap, list->n + 1, err)) return NULL;
    r = &list->relation[list->n];
    *r = (struct exact_relation){.n = n};
    if (!mem_new(r->row, n, err)) return NULL;
    if (!mem_new(r->y, n, err)) {
        free(r->row);
        return NULL;
    }
    for (size_t i = 0; i < n; i++) mpz_init(r->y[i]);
    list->n++;
    return r;
}

void relation_cut(struct relation_list *list, size_t n) {
    while (list->n > n) {
        struct exact_relation *r = &list->relation[--list->n];
        for (size_t i = 0; i < r->n; i++) mpz_clear(r->y[i]);
        free(r->y);
        free(r->row);
    }
}

/* ---- a candidate: terms[0..n-1], the first one dependent ---- */

static bool room_for_terms(struct relation_finder *f, size_t n, size_t cols, struct err *err) {
    if (!mem_grow(f->term, &f->term_cap, n, err) || !mem_grow(f->sum, &f->sum_cap, cols, err))
        return false;
    while (f->terms < n) mpz_init(f->term[f->terms++].y);
    while (f->sums < cols) mpz_init(f->sum[f->sums++]);
    return true;
}

/* Divides by the common factor and makes the first positive. */
static void make_primitive(struct relation_term *term, size_t n, mpz_t g) {
    mpz_set(g, term[0].y);
    for (size_t i = 1; i < n && mpz_cmpabs_ui(g, 1) != 0; i++) mpz_gcd(g, g, term[i].y);
    mpz_abs(g, g);
    if (mpz_sgn(term[0].y) < 0) mpz_neg(g, g);
    if (mpz_cmp_ui(g, 1) != 0)
        for (size_t i = 0; i < n; i++) mpz_divexact(term[i].y, term[i].y, g);
    mpz_set_ui(g, 0);
}

/* Whether y.A = 0, exactly. */
static bool verify(struct relation_finder *f, const struct int_matrix *a, size_t n) {
    bool zero = true;
    for (size_t k = 0; k < n; k++) {
        uint32_t r = f->term[k].row;
        for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
            int64_t x = a->value[i];
            if (x < 0)
                mpz_submul_ui(f->sum[a->col[i]], f->term[k].y, -(uint64_t)x);
            else
                mpz_addmul_ui(f->sum[a->col[i]], f->term[k].y, (uint64_t)x);
        }
    }
    for (size_t k = 0; k < n; k++) {
        uint32_t r = f->term[k].row;
        for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
            if (mpz_sgn(f->sum[a->col[i]]) == 0) continue;
            zero = false;
            mpz_set_ui(f->sum[a->col[i]], 0);
        }
    }
    return zero;
}

static int by_row(const void *a, const void *b) {
    uint32_t r = ((const struct relation_term *)a)->row, s = ((const struct relation_term *)b)->row;
    return r < s ? -1 : r > s;
}

/* Moves the terms that are not 0 to the list, under their names, in ascending order. */
static bool emit(struct relation_finder *f, size_t n, const uint32_t *name,
                 struct relation_list *list, struct err *err) {
    struct exact_relation *r;
    size_t dependent = name[f->term[0].row], used = 0;
    for (size_t k = 0; k < n; k++) {
        if (mpz_sgn(f->term[k].y) == 0) continue;
        f->term[k].row = name[f->term[k].row];
        if (used < k) {
            f->term[used].row = f->term[k].row;
            mpz_swap(f->term[used].y, f->term[k].y);
        }
        used++;
    }
    qsort(f->term, used, sizeof *f->term, by_row);
    if (!(r = relation_append(list, used, err))) return false;
    r->dependent = dependent;
    for (size_t k = 0; k < used; k++) {
        r->row[k] = f->term[k].row;
        mpz_swap(r->y[k], f->term[k].y);
    }
    return true;
}

/* ---- from one prime: fractions with a small common denominator ---- */

static int64_t centred(struct modp m, uint64_t a) {
    return a > m.q / 2 ? -(int64_t)(m.q - a) : (int64_t)a;
}

/* Fills the terms from the residues y, y[0] = 1, if all become small over one denominator. What is
 * small by accident will not pass `verify`. */
static bool small_fractions(struct relation_finder *f, const uint32_t *order, const uint64_t *y,
                            size_t n) {
    const int64_t small = INT64_C(1) << 40;
    const uint64_t limit = UINT64_C(1) << 29;
    struct modp m = f->elim.m;
    uint64_t common = 1;
    for (size_t i = 0; i < n; i++) {
        uint64_t scaled = modp_mul(m, y[i], common), d;
        int64_t x = centred(m, scaled);
        if (-small <= x && x <= small) continue;
        d = modp_denominator(m, scaled, limit);
        if (d == 0 || d > (uint64_t)small / common) return false;
        common *= d;
    }
    for (size_t i = 0; i < n; i++) {
        int64_t x = centred(m, modp_mul(m, y[i], common));
        if (x < -small || x > small) return false;
        f->term[i].row = order[i];
        mpz_set_si(f->term[i].y, x);
    }
    return true;
}

/* ---- from several primes: determinants ---- */

/* b with |row|^2 < 2^b; rows have fewer than 2^32 entries. */
static size_t square_bits(const struct int_matrix *a, uint32_t r) {
    modp_wide sum = 0;
    size_t bits = 0;
    for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
        uint64_t x = a->value[i] < 0 ? -(uint64_t)a->value[i] : (uint64_t)a->value[i];
        if (__builtin_add_overflow(sum, (modp_wide)x * x, &sum)) return 2 * 63 + 32;
    }
    for (; sum > 0; sum >>= 1) bits++;
    return bits;
}

/* Hadamard's bound, one bit for the sign and one so that the top digit tells it. */
static size_t primes_needed(const struct int_matrix *a, const uint32_t *order, size_t n) {
    size_t total = 0, least = SIZE_MAX;
    for (size_t i = 0; i < n; i++) {
        size_t bits = square_bits(a, order[i]);
        total += bits;
        if (bits < least) least = bits;
    }
    return ((total - least + 1) / 2 + 2 + MODP_BITS - 1) / MODP_BITS;
}

/* Makes m the prime number k in use. */
static bool use_modulus(struct relation_finder *f, size_t k, struct modp m, struct err *err) {
    uint64_t product = 1;
    if (k < f->moduli && f->modulus[k].q == m.q) return true;
    if (!mem_grow(f->modulus, &f->modulus_cap, k + 1, err) ||
        !mem_grow(f->inverse, &f->inverse_cap, k + 1, err))
        return false;
    for (size_t j = 0; j < k; j++) product = modp_mul(m, product, f->modulus[j].q - m.q);
    f->modulus[k] = m;
    f->inverse[k] = modp_inverse(m, product);
    f->moduli = k + 1;
    return true;
}

/* Garner's digits of entry i of a task. The primes descend, so q_j mod q_k = q_j - q_k. */
static void find_digits(struct relation_finder *f, const struct relation_task *t, size_t i) {
    for (size_t k = 0; k < t->primes; k++) {
        struct modp m = f->modulus[k];
        uint64_t known = 0, digit;
        for (size_t j = k; j-- > 0;) {
            digit = f->digit[j] >= m.q ? f->digit[j] - m.q : f->digit[j];
            known = modp_add(m, modp_mul(m, known, f->modulus[j].q - m.q), digit);
        }
        known = modp_sub(m, f->residue[t->residue + k * t->n + i], known);
        f->digit[k] = modp_mul(m, known, f->inverse[k]);
    }
}

/* A negative y = x - q_0 q_1 ... is -1 minus the number whose digits are q_k - 1 - v_k. */
static void evaluate_digits(const struct relation_finder *f, size_t primes, mpz_t y) {
    bool negative = f->digit[primes - 1] > f->modulus[primes - 1].q / 2;
    mpz_set_ui(y, 0);
    for (size_t k = primes; k-- > 0;) {
        uint64_t digit = negative ? f->modulus[k].q - 1 - f->digit[k] : f->digit[k];
        mpz_mul_ui(y, y, f->modulus[k].q);
        mpz_add_ui(y, y, digit);
    }
    if (negative) mpz_com(y, y); /* -1 - y */
}

/* Stores the residues of the determinants of a task modulo the present prime, number k of the core.
 * False if the first prime had missed a row. */
static bool store_residues(struct relation_finder *f, const struct relation_task *t, size_t k) {
    uint64_t *y = f->residue + t->residue + k * t->n, det;
    if (!elim_combine(&f->elim, f->order + t->order, t->n, y, &det)) return false;
    for (size_t i = 0; i < t->n; i++) y[i] = modp_mul(f->elim.m, y[i], det);
    return true;
}

/* Residues of all tasks modulo primes base+1, base+2, ... as far as needed; those in which a pivot
 * vanishes are left out. */
static bool more_primes(struct relation_finder *f, const struct int_matrix *core, size_t base,
                        bool *sound, struct err *err) {
    size_t most = 1;
    for (size_t i = 0; i < f->tasks; i++)
        if (f->task[i].primes > most) most = f->task[i].primes;
    if (!mem_grow(f->digit, &f->digit_cap, most, err)) return false;
    if (!use_modulus(f, 0, f->elim.m, err)) return false;
    for (size_t k = 1, next = base + 1; k < most && *sound; next++) {
        struct modp m;
        bool good;
        if (!modp_prime(&f->primes, next, &m, err)) return false;
        if (!elim_replay(&f->elim, core, m, &good, err)) return false;
        if (!good) continue;
        if (!use_modulus(f, k, m, err)) return false;
        for (size_t i = 0; i < f->tasks && *sound; i++)
            if (f->task[i].primes > k) *sound = store_residues(f, &f->task[i], k);
        k++;
    }
    return true;
}

static bool finish_task(struct relation_finder *f, const struct int_matrix *core,
                        const struct relation_task *t, const uint32_t *name,
                        struct relation_list *list, bool *sound, struct err *err) {
    for (size_t i = 0; i < t->n; i++) {
        f->term[i].row = f->order[t->order + i];
        find_digits(f, t, i);
        evaluate_digits(f, t->primes, f->term[i].y);
    }
    make_primitive(f->term, t->n, f->sum[0]);
    *sound = verify(f, core, t->n);
    return !*sound || emit(f, t->n, name, list, err);
}

/* ---- a core ---- */

/* The relation of dependent row r at once, if small fractions will do, else a task. */
static bool begin_task(struct relation_finder *f, const struct int_matrix *core, uint32_t r,
                       const uint32_t *name, struct relation_list *list, struct err *err) {
    struct relation_task t = {.order = f->orders, .residue = f->residues};
    uint64_t det;
    if (!mem_grow(f->order, &f->order_cap, f->orders + f->elim.rank + 1, err)) return false;
    t.n = elim_reach(&f->elim, r, f->order + t.order);
    if (!mem_grow(f->residue, &f->residue_cap, t.residue + t.n, err) ||
        !room_for_terms(f, t.n, core->cols, err))
        return false;
    elim_combine(&f->elim, f->order + t.order, t.n, f->residue + t.residue, &det);
    if (small_fractions(f, f->order + t.order, f->residue + t.residue, t.n)) {
        make_primitive(f->term, t.n, f->sum[0]);
        if (verify(f, core, t.n)) return emit(f, t.n, name, list, err);
    }
    t.primes = primes_needed(core, f->order + t.order, t.n);
    if (!mem_grow(f->residue, &f->residue_cap, t.residue + t.n * t.primes, err) ||
        !mem_grow(f->task, &f->task_cap, f->tasks + 1, err))
        return false;
    for (size_t i = 0; i < t.n; i++)
        f->residue[t.residue + i] = modp_mul(f->elim.m, f->residue[t.residue + i], det);
    f->orders += t.n;
    f->residues += t.n * t.primes;
    f->task[f->tasks++] = t;
    return true;
}

/* All relations of the core by elimination modulo prime `base`; *sound = false if it was a bad
 * one. */
static bool try_prime(struct relation_finder *f, const struct int_matrix *core, size_t base,
                      const uint32_t *name, struct relation_list *list, bool *sound,
                      struct err *err) {
    struct modp m;
    *sound = true;
    f->tasks = f->orders = f->residues = 0;
    if (!modp_prime(&f->primes, base, &m, err) || !elim_run(&f->elim, core, m, err)) return false;
    for (size_t i = 0; i < f->elim.dependent_count; i++)
        if (!begin_task(f, core, f->elim.dependent[i], name, list, err)) return false;
    if (f->tasks > 0 && !more_primes(f, core, base, sound, err)) return false;
    for (size_t i = 0; i < f->tasks && *sound; i++)
        if (!finish_task(f, core, &f->task[i], name, list, sound, err)) return false;
    return true;
}

bool relation_find(struct relation_finder *finder, const struct int_matrix *core,
                   const uint32_t *name, struct relation_list *list, struct err *err) {
    size_t before = list->n;
    for (size_t base = 0;; base++) {
        bool sound;
        if (!try_prime(finder, core, base, name, list, &sound, err)) return false;
        if (sound) return true;
        relation_cut(list, before);
    }
}

void relation_finder_free(struct relation_finder *finder) {
    for (size_t i = 0; i < finder->terms; i++) mpz_clear(finder->term[i].y);
    for (size_t i = 0; i < finder->sums; i++) mpz_clear(finder->sum[i]);
    elim_free(&finder->elim);
    modp_primes_free(&finder->primes);
    free(finder->modulus);
    free(finder->inverse);
    free(finder->task);
    free(finder->term);
    free(finder->sum);
    free(finder->order);
    free(finder->residue);
    free(finder->digit);
    *finder = (struct relation_finder){0};
}
