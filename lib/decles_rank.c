/* SPDX-License-Identifier: GPL-3.0-or-later */
/* E reads A_D x + A_A a + A_F f = 0. It can be kept for any a exactly when every y with y.A_D = 0
 * has y.A_A = 0: then y.A_F f = 0 is what held before the edit. A relation y that meets anchors
 * takes more points, those free ones outside with y.A_p != 0: as derived points they end it. Where
 * there are none, y.A_A a + y.A_F f = 0 is a demand on the new positions that no D can lift; they
 * agree with it up to rounding, or the edit is refused. All tests for zero are exact. */
#include "decles_rank.h"

#include "dd.h"
#include "mem.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* y.A_p for the points p of `fixed`, of one relation at a time. */
struct sums {
    size_t columns; /* room */
    mpz_t *of;      /* of each column; 0 unless listed */
    uint32_t *list; /* columns that the relation's conditions contain */
    size_t n;
    bool *is_listed; /* of each column */
    mpz_t coefficient;
};

static bool sums_init(struct sums *s, size_t columns, struct err *err) {
    memset(s, 0, sizeof *s);
    mpz_init(s->coefficient);
    if (!mem_new(s->of, columns, err) || !mem_new(s->list, columns, err) ||
        !mem_new(s->is_listed, columns, err))
        return false;
    for (; s->columns < columns; s->columns++) mpz_init(s->of[s->columns]);
    return true;
}

static void sums_free(struct sums *s) {
    for (size_t i = 0; i < s->columns; i++) mpz_clear(s->of[i]);
    mpz_clear(s->coefficient);
    free(s->of);
    free(s->list);
    free(s->is_listed);
}

static void sums_fill(struct sums *s, const struct decles_sets *sets,
                      const struct exact_relation *y) {
    for (; s->n > 0; s->n--) {
        mpz_set_ui(s->of[s->list[s->n - 1]], 0);
        s->is_listed[s->list[s->n - 1]] = false;
    }
    for (size_t i = 0; i < y->n; i++) {
        const struct c1_condition *row = &sets->row[y->row[i]];
        for (int j = 0; j < 4; j++) {
            uint32_t column = decles_mark(sets, row->point[j])->column - 1;
            if (row->coefficient[j] == 0 || decles_mark(sets, row->point[j])->role == ROLE_DERIVED)
                continue;
            if (!s->is_listed[column]) s->list[s->n++] = column;
            s->is_listed[column] = true;
            mpz_set_d(s->coefficient, (double)row->coefficient[j]); /* exact: below 2^53 */
            mpz_addmul(s->of[column], y->y[i], s->coefficient);
        }
    }
}

/* z / 2^shift, rounded. */
static double scaled(const mpz_t z, size_t shift) {
    long exponent;
    double mantissa = mpz_get_d_2exp(&exponent, z);
    return ldexp(mantissa, (int)(exponent - (long)shift));
}

/* The largest component of a point of `fixed`. */
static double magnitude(const struct c1_field *fixed, uint32_t column) {
    double largest = 0;
    for (int c = 0; c < fixed->k; c++)
        largest = fmax(largest, fabs(fixed->q[fixed->stride * column + (size_t)c]));
    return largest;
}

/* |y.rhs| <= 64 u of its terms, for component c of the points outside D; terms as in c1_evaluate.
 */
static bool agrees(const struct sums *s, const struct decles_sets *sets,
                   const struct exact_relation *y, const struct c1_field *fixed, int c) {
    struct dd sum = {0, 0};
    double terms = 0;
    size_t shift = 0;
    for (size_t i = 0; i < y->n; i++) {
        size_t bits = mpz_sizeinbase(y->y[i], 2);
        if (bits > shift) shift = bits;
    }
    for (size_t i = 0; i < s->n; i++) {
        double q = fixed->q[fixed->stride * s->list[i] + (size_t)c];
        sum = dd_add(sum, dd_two_prod(scaled(s->of[s->list[i]], shift), q));
    }
    for (size_t i = 0; i < y->n; i++) {
        const struct c1_condition *row = &sets->row[y->row[i]];
        for (int j = 0; j < 4; j++) {
            uint32_t p = row->point[j];
            if (row->coefficient[j] == 0 || decles_mark(sets, p)->role == ROLE_DERIVED) continue;
            terms += fabs(scaled(y->y[i], shift) * (double)row->coefficient[j]) *
                     (fixed->extent + magnitude(fixed, decles_mark(sets, p)->column - 1));
        }
    }
    return c1_holds((struct c1_value){sum.hi, terms});
}

/* A message that is put together piece by piece, cut where the room ends. */
struct text {
    char buffer[sizeof((struct err *)0)->message];
    size_t length;
};

__attribute__((format(printf, 2, 3))) static void append(struct text *t, const char *format, ...) {
    size_t room = sizeof t->buffer - t->length;
    va_list args;
    int n;
    va_start(args, format);
    n = vsnprintf(t->buffer + t->length, room, format, args);
    va_end(args);
    if (n > 0) t->length += (size_t)n < room ? (size_t)n : room - 1;
}

enum { NAMED_MAX = 12 }; /* points or edges that a message names; the others are counted */

/* The points of the relation that are anchors, or pinned. Returns how many. */
static size_t append_points(struct text *t, const struct sums *s, const struct decles_sets *sets,
                            bool anchors, const char *title) {
    size_t n = 0;
    for (size_t i = 0; i < s->n; i++) {
        uint32_t p = sets->fixed[s->list[i]];
        if (mpz_sgn(s->of[s->list[i]]) == 0) continue;
        if (anchors ? decles_mark(sets, p)->role != ROLE_ANCHOR : !decles_sets_pinned(sets, p))
            continue;
        if (n < NAMED_MAX) append(t, "%s%u", n == 0 ? title : ", ", p);
        n++;
    }
    if (n > NAMED_MAX) append(t, " and %zu more", n - NAMED_MAX);
    return n;
}

static void append_edges(struct text *t, const struct decles_sets *sets,
                         const struct exact_relation *y) {
    uint64_t d = (uint64_t)sets->grid->degree, last = UINT64_MAX;
    size_t n = 0;
    for (size_t i = 0; i < y->n; i++) {
        uint64_t e = sets->condition[y->row[i]] / d;
        if (e == last) continue;
        if (n < NAMED_MAX)
            append(t, "%s%u-%u", n == 0 ? "" : ", ", sets->grid->edge[e][0],
                   sets->grid->edge[e][1]);
        last = e;
        n++;
    }
    if (n > NAMED_MAX) append(t, " and %zu more", n - NAMED_MAX);
}

static bool refuse(const struct sums *s, const struct decles_sets *sets,
                   const struct exact_relation *y, struct err *err) {
    struct text t = {.length = 0};
    append_points(&t, s, sets, true, "the positions wanted for the anchors ");
    append_points(&t, s, sets, false, ", with the pinned points ");
    append(&t, " break the C1 conditions across the edges ");
    append_edges(&t, sets, y);
    append(&t, ", whatever other points do");
    return err_set(err, ERR_REFUSAL, "%s", t.buffer);
}

/* False, with a refusal, if a point of the condition is so far away that it cannot be evaluated. */
static bool check_range(const struct c1_condition *row, const struct c1_field *values,
                        struct err *err) {
    for (int j = 0; j < 4; j++)
        for (int c = 0; c < values->k; c++)
            if (!(fabs(values->q[values->stride * row->point[j] + (size_t)c]) <= C1_RANGE))
                return err_set(err, ERR_REFUSAL,
                               "point %u lies beyond the range of numbers, %.2g either way",
                               row->point[j], C1_RANGE);
    return true;
}

bool decles_check(const struct decles_sets *sets, const struct c1_field *values, struct err *err) {
    for (size_t r = 0; r < sets->condition_count; r++)
        for (int c = 0; c < values->k; c++) {
            struct c1_value value = c1_evaluate(&sets->row[r], values, c);
            uint64_t e = sets->condition[r] / (uint64_t)sets->grid->degree;
            if (c1_holds(value)) continue;
            if (!check_range(&sets->row[r], values, err)) return false;
            return err_set(err, ERR_REFUSAL,
                           "the spline is not C1 across the edge %u-%u: a condition is off by %.2g "
                           "of its terms",
                           sets->grid->edge[e][0], sets->grid->edge[e][1], c1_relative(value));
        }
    return true;
}

struct growth {
    uint32_t *point;
    size_t n, cap;
};

/* Appends to `more` what relation y asks for; false if it is a conflict (or memory ran out). */
static bool ask(struct growth *more, const struct sums *s, const struct decles_sets *sets,
                const struct exact_relation *y, const struct c1_field *fixed, struct err *err) {
    size_t before = more->n;
    bool meets_anchor = false;
    for (size_t i = 0; i < s->n && !meets_anchor; i++)
        meets_anchor = mpz_sgn(s->of[s->list[i]]) != 0 &&
                       decles_mark(sets, sets->fixed[s->list[i]])->role == ROLE_ANCHOR;
    if (!meets_anchor) return true;
    if (!mem_grow(more->point, &more->cap, more->n + s->n, err)) return false;
    for (size_t i = 0; i < s->n; i++) {
        uint32_t p = sets->fixed[s->list[i]];
        if (mpz_sgn(s->of[s->list[i]]) == 0 || decles_mark(sets, p)->role == ROLE_ANCHOR ||
            decles_sets_pinned(sets, p))
            continue;
        more->point[more->n++] = p;
    }
    if (more->n > before) return true;
    for (int c = 0; c < fixed->k; c++)
        if (!agrees(s, sets, y, fixed, c)) return refuse(s, sets, y, err);
    return true;
}

/* One round: the relations of the present D that are tied to points outside, and the points they
 * ask for. */
static bool examine(const struct decles_sets *sets, const struct exact_rows *rows,
                    const struct c1_field *fixed, struct growth *more, struct err *err) {
    struct sums sums;
    bool ok = sums_init(&sums, sets->fixed_count, err);
    for (size_t i = 0; ok && i < rows->relation_count; i++) {
        sums_fill(&sums, sets, &rows->relation[i]);
        ok = ask(more, &sums, sets, &rows->relation[i], fixed, err);
    }
    sums_free(&sums);
    return ok;
}

bool decles_rows_init(struct exact_rows *rows, const struct decles_sets *sets, struct err *err) {
    struct int_matrix a;
    bool ok;
    memset(rows, 0, sizeof *rows);
    ok = decles_matrix_init(&a, sets, true, NULL, err) && exact_rows_init(rows, &a, err);
    decles_matrix_free(&a);
    return ok;
}

/* Examines E as it is now. */
static bool close_round(const struct decles_sets *sets, const struct decles_edit *edit,
                        const struct c1_field *values, struct exact_rows *rows, struct growth *more,
                        struct err *err) {
    struct c1_field fixed = {NULL, (size_t)values->k, values->k, values->extent};
    bool ok = decles_check(sets, values, err) && decles_rows_init(rows, sets, err) &&
              decles_fixed_values(sets, edit, values, &fixed.q, err) &&
              examine(sets, rows, &fixed, more, err);
    free(fixed.q);
    return ok;
}

bool decles_close(struct decles_sets *sets, const struct decles_edit *edit,
                  const struct c1_field *values, struct exact_rows *rows, size_t *added,
                  struct err *err) {
    struct growth more = {NULL, 0, 0};
    size_t start = sets->derived_count;
    bool ok;
    memset(rows, 0, sizeof *rows);
    do {
        more.n = 0;
        exact_rows_free(rows);
        ok = close_round(sets, edit, values, rows, &more, err) &&
             (more.n == 0 || decles_sets_add(sets, more.point, more.n, err));
    } while (ok && more.n > 0);
    *added = sets->derived_count - start;
    free(more.point);
    return ok;
}
