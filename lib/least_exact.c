/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same halving as in least.c, with integers. Averages would need a bit for each of the n steps
 * of de Casteljau, so a generation multiplies all coefficients by 2^n and the corners' barycentric
 * coordinates by 2: everything that is compared, bounds included, is at the scale of the present
 * generation, `scale` = 2^(n g).
 *
 * All parts of a generation are halved before the next begins. A part is dropped when
 *
 *   its low >= high - |high| tolerance     it cannot improve the bounds, or
 *   its low >= -B and high <= B            B = undecided * mean |coefficient|: it is undecided.
 *
 * If min f > B, the second never happens and the first leaves low > 0: f is certified. In
 * the second case the zero, if it is one, may lie at a fraction whose denominator is no power of
 * two. The fractions with the least denominators within the part's bounds of b1 and b2 are tried: a
 * rational zero is among them once the part is small enough. */
#include "least.h"

#include "mem.h"
#include "rational.h"

#include <math.h>

enum { GENERATIONS_MAX = 1024 };

void least_place_init(struct least_place *p) {
    for (int l = 0; l < 3; l++) mpz_init_set_ui(p->weight[l], l == 0);
}

void least_place_free(struct least_place *p) {
    for (int l = 0; l < 3; l++) mpz_clear(p->weight[l]);
}

void least_place_set(struct least_place *p, const double b[3]) {
    mp_bitcnt_t common = 60;
    for (int l = 0; l < 3; l++) {
        mpz_set_d(p->weight[l], ldexp(b[l], 60));
        if (mpz_sgn(p->weight[l]) != 0 && mpz_scan1(p->weight[l], 0) < common)
            common = mpz_scan1(p->weight[l], 0);
    }
    for (int l = 0; l < 3; l++) mpz_fdiv_q_2exp(p->weight[l], p->weight[l], common);
}

void least_exact_init(struct least_exact *x) {
    mpq_init(x->low);
    mpq_init(x->high);
    least_place_init(&x->place);
}

void least_exact_free(struct least_exact *x) {
    mpq_clear(x->low);
    mpq_clear(x->high);
    least_place_free(&x->place);
}

/* Numbers of a part: its coefficients, then the corners' coordinates, 3 each. */
struct search {
    int n, size, stride;
    const mpz_t *c;
    const struct least_rule *rule;
    mpz_t *part[2]; /* this generation and the next */
    size_t cap[2], count, made;
    mpz_t low, high, limit, undecided; /* at this generation's scale */
    mpz_t tolerance, fraction;         /* times 2^-shift: the tolerance, B */
    mp_bitcnt_t tolerance_shift, fraction_shift;
    bool has_low; /* low is the bound of the parts that were dropped */
    int generation;
    struct least_exact *x;
};

/* Coefficients are at the scale 2^this. */
static mp_bitcnt_t scale_of(const struct search *s) {
    return (mp_bitcnt_t)s->n * (mp_bitcnt_t)s->generation;
}

static bool reserve(struct search *s, int which, size_t parts, struct err *err) {
    size_t old = s->cap[which], need = parts * (size_t)s->stride;
    if (!mem_grow(s->part[which], &s->cap[which], need, err)) return false;
    for (size_t i = old; i < s->cap[which]; i++) mpz_init(s->part[which][i]);
    return true;
}

/* x = m 2^-shift, x >= 0 */
static void split(double x, mpz_t m, mp_bitcnt_t *shift) {
    mpq_t q;
    mpq_init(q);
    mpq_set_d(q, x);
    *shift = mpz_scan1(mpq_denref(q), 0);
    mpz_set(m, mpq_numref(q));
    mpq_clear(q);
}

static bool search_init(struct search *s, struct err *err) {
    mpz_t sum;
    mpz_inits(s->low, s->high, s->limit, s->undecided, s->tolerance, s->fraction, NULL);
    if (!reserve(s, 0, 1, err)) return false;
    mpz_init(sum);
    for (int i = 0; i < s->size; i++) {
        mpz_set(s->part[0][i], s->c[i]);
        if (mpz_sgn(s->c[i]) < 0)
            mpz_sub(sum, sum, s->c[i]);
        else
            mpz_add(sum, sum, s->c[i]);
    }
    for (int i = 0; i < 9; i++) mpz_set_ui(s->part[0][s->size + i], i % 4 == 0);
    split(s->rule->undecided, s->fraction, &s->fraction_shift);
    s->fraction_shift += 64; /* for the division */
    mpz_mul(s->fraction, s->fraction, sum);
    mpz_mul_2exp(s->fraction, s->fraction, 64);
    mpz_fdiv_q_ui(s->fraction, s->fraction, (unsigned long)s->size);
    split(s->rule->tolerance, s->tolerance, &s->tolerance_shift);
    mpz_clear(sum);
    s->count = 1;
    return true;
}

static void search_free(struct search *s) {
    for (int which = 0; which < 2; which++) {
        for (size_t i = 0; i < s->cap[which]; i++) mpz_clear(s->part[which][i]);
        free(s->part[which]);
    }
    mpz_clears(s->low, s->high, s->limit, s->undecided, s->tolerance, s->fraction, NULL);
}

/* limit = high - |high| tolerance, which has the sign of high */
static void set_limit(struct search *s) {
    mpz_mul(s->limit, s->high, s->tolerance);
    mpz_abs(s->limit, s->limit);
    mpz_fdiv_q_2exp(s->limit, s->limit, s->tolerance_shift);
    mpz_sub(s->limit, s->high, s->limit);
}

static void set_place(struct least_place *p, const mpz_t *weight) {
    mpz_t common;
    mpz_init(common);
    mpz_gcd(common, weight[0], weight[1]);
    mpz_gcd(common, common, weight[2]);
    for (int l = 0; l < 3; l++) mpz_divexact(p->weight[l], weight[l], common);
    mpz_clear(common);
}

/* A corner whose value is below `high` is the new place. */
static void look_at_corners(struct search *s, const mpz_t *part) {
    int at[3] = {0, s->n * (s->n + 1) / 2, s->size - 1};
    for (int l = 0; l < 3; l++) {
        if (s->generation + l > 0 && mpz_cmp(part[at[l]], s->high) >= 0) continue;
        mpz_set(s->high, part[at[l]]);
        set_place(&s->x->place, part + s->size + 3 * l);
        set_limit(s);
    }
}

/* The coefficients of both halves of `from`, times 2^n. */
static void halve(const struct search *s, const mpz_t *from, mpz_t *left, mpz_t *right,
                  mpz_t *row) {
    int n = s->n;
    for (int r = 0; r <= n; r++) {
        for (int k = 0; k <= r; k++) mpz_set(row[k], from[r * (r + 1) / 2 + k]);
        for (int k = 0; k <= r; k++) {
            int base = (n - k) * (n - k + 1) / 2;
            mpz_mul_2exp(left[base + r - k], row[0], (mp_bitcnt_t)(n - k));
            mpz_mul_2exp(right[base + n - r], row[r - k], (mp_bitcnt_t)(n - k));
            for (int i = 0; i < r - k; i++) mpz_add(row[i], row[i], row[i + 1]);
        }
    }
    for (int l = 0; l < 3; l++) {
        const mpz_t *corner = from + s->size + l;
        mpz_t *a = left + s->size + l, *b = right + s->size + l;
        mpz_add(a[0], corner[3], corner[6]);
        mpz_set(b[0], a[0]);
        mpz_mul_2exp(a[3], corner[0], 1);
        mpz_set(b[6], a[3]);
        mpz_mul_2exp(a[6], corner[3], 1);
        mpz_mul_2exp(b[3], corner[6], 1);
    }
}

static const mpz_t *least_coefficient(const struct search *s, const mpz_t *part) {
    const mpz_t *low = part;
    for (int i = 1; i < s->size; i++)
        if (mpz_cmp(part[i], *low) < 0) low = part + i;
    return low;
}

void least_value(int n, const mpz_t *c, const struct least_place *place, mpq_t value) {
    mpz_t v[LEAST_SIZE_MAX], sum;
    for (int i = 0; i < least_size(n); i++) mpz_init_set(v[i], c[i]);
    for (int d = n; d > 0; d--) /* de Casteljau; row r of the result from rows r and r+1 */
        for (int r = 0; r < d; r++)
            for (int k = 0; k <= r; k++) {
                int to = r * (r + 1) / 2 + k, below = to + r + 1;
                mpz_mul(v[to], v[to], place->weight[0]);
                mpz_addmul(v[to], v[below], place->weight[1]);
                mpz_addmul(v[to], v[below + 1], place->weight[2]);
            }
    mpz_init(sum);
    for (int l = 0; l < 3; l++) mpz_add(sum, sum, place->weight[l]);
    mpz_pow_ui(sum, sum, (unsigned long)n);
    mpz_set(mpq_numref(value), v[0]);
    mpz_set(mpq_denref(value), sum);
    mpq_canonicalize(value);
    mpz_clear(sum);
    for (int i = 0; i < least_size(n); i++) mpz_clear(v[i]);
}

/* The simplest values of b1 and b2 within a part. */
static void simple_coordinates(const struct search *s, const mpz_t *part, mpq_t b[3]) {
    mpq_t lo, hi;
    mpq_inits(lo, hi, NULL);
    mpq_set_ui(b[0], 1, 1);
    for (int l = 1; l < 3; l++) {
        const mpz_t *x = part + s->size + l;
        int least = 0, most = 0;
        for (int corner = 3; corner < 9; corner += 3) {
            if (mpz_cmp(x[corner], x[least]) < 0) least = corner;
            if (mpz_cmp(x[corner], x[most]) > 0) most = corner;
        }
        mpq_set_z(lo, x[least]);
        mpq_set_z(hi, x[most]);
        mpq_div_2exp(lo, lo, (mp_bitcnt_t)s->generation);
        mpq_div_2exp(hi, hi, (mp_bitcnt_t)s->generation);
        rational_simplest(lo, hi, b[l]);
        mpq_sub(b[0], b[0], b[l]);
    }
    mpq_clears(lo, hi, NULL);
}

/* Tries that place; if the value there is 0 or less, takes it. */
static void try_fractions(struct search *s, const mpz_t *part) {
    struct least_place place;
    mpq_t b[3], value;
    mpz_t common;
    mpz_init(common);
    least_place_init(&place);
    mpq_inits(b[0], b[1], b[2], value, NULL);
    simple_coordinates(s, part, b);
    mpz_lcm(common, mpq_denref(b[1]), mpq_denref(b[2]));
    for (int l = 0; l < 3; l++) {
        mpz_divexact(place.weight[l], common, mpq_denref(b[l]));
        mpz_mul(place.weight[l], place.weight[l], mpq_numref(b[l]));
    }
    if (mpq_sgn(b[0]) >= 0) {
        least_value(s->n, s->c, &place, value);
        mpq_mul_2exp(value, value, scale_of(s));
        if (mpq_sgn(value) <= 0 && mpz_sgn(s->high) > 0) {
            mpz_cdiv_q(s->high, mpq_numref(value), mpq_denref(value));
            set_place(&s->x->place, (const mpz_t *)place.weight);
            set_limit(s);
        }
    }
    mpq_clears(b[0], b[1], b[2], value, NULL);
    least_place_free(&place);
    mpz_clear(common);
}

static bool is_undecided(const struct search *s, const mpz_t low) {
    return mpz_cmpabs(s->high, s->undecided) <= 0 &&
           (mpz_sgn(low) >= 0 || mpz_cmpabs(low, s->undecided) <= 0);
}

/* Is the part out of the search? */
static bool drop(struct search *s, const mpz_t *part) {
    const mpz_t *low = least_coefficient(s, part);
    if (mpz_cmp(*low, s->limit) < 0) {
        if (!is_undecided(s, *low)) return false;
        if (mpz_sgn(s->high) > 0) try_fractions(s, part);
    }
    if (!s->has_low || mpz_cmp(*low, s->low) < 0) mpz_set(s->low, *low);
    s->has_low = true;
    return true;
}

static void next_scale(struct search *s) {
    s->generation++;
    mpz_mul_2exp(s->low, s->low, (mp_bitcnt_t)s->n);
    mpz_mul_2exp(s->high, s->high, (mp_bitcnt_t)s->n);
    mpz_mul_2exp(s->undecided, s->fraction, scale_of(s));
    mpz_fdiv_q_2exp(s->undecided, s->undecided, s->fraction_shift);
    set_limit(s);
}

/* Halves all parts of this generation. */
static bool generation(struct search *s, mpz_t *row, struct err *err) {
    int which = s->generation & 1;
    size_t kept = 0;
    if (!reserve(s, 1 - which, 2 * s->count, err)) return false;
    next_scale(s);
    for (size_t i = 0; i < s->count; i++) {
        mpz_t *to = s->part[1 - which] + kept * (size_t)s->stride;
        halve(s, (const mpz_t *)s->part[which] + i * (size_t)s->stride, to, to + s->stride, row);
        look_at_corners(s, (const mpz_t *)to);
        look_at_corners(s, (const mpz_t *)to + s->stride);
        if (!drop(s, (const mpz_t *)to)) {
            kept++;
            to += s->stride;
        } else
            for (int k = 0; k < s->stride; k++) mpz_swap(to[k], to[s->stride + k]);
        if (!drop(s, (const mpz_t *)to)) kept++;
    }
    s->made += 2 * s->count;
    s->count = kept;
    return true;
}

/* What is proved, whether or not parts are left. */
static void conclude(struct search *s) {
    for (size_t i = 0; i < s->count; i++) {
        const mpz_t *part = (const mpz_t *)s->part[s->generation & 1] + i * (size_t)s->stride;
        const mpz_t *low = least_coefficient(s, part);
        if (!s->has_low || mpz_cmp(*low, s->low) < 0) mpz_set(s->low, *low);
        s->has_low = true;
    }
    mpq_set_z(s->x->low, s->low);
    mpq_div_2exp(s->x->low, s->x->low, scale_of(s));
    least_value(s->n, s->c, &s->x->place, s->x->high);
}

bool least_exact(int n, const mpz_t *c, const struct least_rule *rule, struct least_exact *x,
                 struct err *err) {
    struct search s = {.n = n, .size = least_size(n), .c = c, .rule = rule, .x = x};
    mpz_t row[LEAST_DEGREE_MAX + 1];
    bool ok;
    INVARIANT(n >= 0 && n <= LEAST_DEGREE_MAX);
    s.stride = s.size + 9;
    for (int k = 0; k <= n; k++) mpz_init(row[k]);
    ok = search_init(&s, err);
    if (ok) {
        look_at_corners(&s, (const mpz_t *)s.part[0]);
        if (drop(&s, (const mpz_t *)s.part[0])) s.count = 0;
        while (ok && s.count > 0 && s.made < rule->parts && s.generation < GENERATIONS_MAX)
            ok = generation(&s, row, err);
        if (ok) conclude(&s);
    }
    search_free(&s);
    for (int k = 0; k <= n; k++) mpz_clear(row[k]);
    return ok;
}
