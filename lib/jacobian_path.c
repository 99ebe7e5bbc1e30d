/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors in doubles. Each C comes with its own. With u = 2^-53, the weights of F, none negative,
 * are right within 4u, products and their sum add 3u, and subtracting the margin u: 8u of the sum
 * of weights times |C| to first order. The margin in the unit of C is off by 7u (the factor by 5u),
 * and subtracting it adds u: 8u of it. The code takes 16u of both, which covers terms of second
 * order.
 *
 * The exit is sought from s = 0 on, so that it is the first. A stack holds the ends of intervals
 * that are still to be proved, the next one on top:
 *
 *     0 ---- proved ---- held -------- top ---------------- ... ------- bottom
 *
 * If f > 0 is proved from `held` to the top, the top is the new `held`. Else the interval is
 * halved. If f > 0 does not even hold at the top itself, the exit is before it: what lies beyond is
 * forgotten, and the search ends when `held` is near enough. */
#include "jacobian_path.h"

#include "mem.h"
#include "rational.h"

#include <math.h>

/* Only the sign matters: bounds within a factor of 2. */
static const struct least_rule sign_rule = {0.99, 0x1p-100, 4096};

static const double near = 0x1p-9, tiny = 0x1p-20, narrow = 0x1p-44;
enum { STACK = 64 }; /* halves of 1 until they are narrow */

void jacobian_path_init(struct jacobian_path *p, const struct spline *from, const struct spline *to,
                        enum jacobian_kind kind, uint32_t triangle, double margin) {
    p->from = from;
    p->to = to;
    p->kind = kind;
    p->triangle = triangle;
    p->margin = margin;
    for (int k = 0; k < 3; k++) p->form[k].known = false;
}

static int degree(const struct jacobian_path *p) {
    return jacobian_degree(p->from, p->kind);
}

/* The two nets of C number k. */
static const struct spline *net(const struct jacobian_path *p, int k, int which) {
    return k + which < 2 ? p->from : p->to;
}

/* ---- in doubles ---- */

static const struct jacobian_form *find_form(struct jacobian_path *p, int k) {
    struct jacobian_form *f = &p->form[k];
    if (f->known) return f;
    f->known = true;
    f->usable = jacobian_polar(net(p, k, 0), net(p, k, 1), p->kind, p->triangle, f->c, &f->error,
                               &f->factor);
    f->largest = 0;
    for (int i = 0, n = least_size(degree(p)); i < n; i++) {
        double size = fabs(f->c[i]);
        f->largest = size > f->largest ? size : f->largest;
    }
    return f;
}

/* The coefficients of F(x,y), each within *error. False if doubles cannot do it. */
static bool blend(struct jacobian_path *p, double x, double y, double *c, double *error) {
    double weight[3] = {(1 - x) * (1 - y), x * (1 - y) + y * (1 - x), x * y}, margin;
    int size = least_size(degree(p));
    for (int i = 0; i < size; i++) c[i] = 0;
    *error = margin = 0;
    for (int k = 0; k < 3; k++) {
        const struct jacobian_form *f;
        if (weight[k] == 0) continue;
        f = find_form(p, k);
        if (!f->usable) return false;
        for (int i = 0; i < size; i++) c[i] += weight[k] * f->c[i];
        *error += weight[k] * (f->error + 0x1p-49 * f->largest);
        margin = p->margin / f->factor; /* the same for all k */
    }
    *error += 0x1p-49 * margin;
    for (int i = 0; i < size; i++) c[i] -= margin;
    return margin <= 0x1p400;
}

/* ---- exactly ---- */

struct exact_form {
    mpz_t sum[LEAST_SIZE_MAX], den; /* coefficients sum / den, den > 0 */
    mpz_t c[LEAST_SIZE_MAX];
    mpq_t factor, weight;
};

/* Adds x c; where c is NULL, x to all coefficients. */
static void add(struct exact_form *e, int size, const mpq_t x, const mpz_t *c) {
    mpz_t common, more;
    mpz_inits(common, more, NULL);
    mpz_lcm(common, e->den, mpq_denref(x));
    mpz_divexact(more, common, e->den);
    for (int i = 0; i < size; i++) mpz_mul(e->sum[i], e->sum[i], more);
    mpz_set(e->den, common);
    mpz_divexact(more, common, mpq_denref(x));
    mpz_mul(more, more, mpq_numref(x));
    for (int i = 0; i < size; i++)
        if (c)
            mpz_addmul(e->sum[i], more, c[i]);
        else
            mpz_add(e->sum[i], e->sum[i], more);
    mpz_clears(common, more, NULL);
}

/* The weights of C(q,q), C(q,r), C(r,r). */
static void weights(double x, double y, mpq_t w[3]) {
    mpq_t a, b, one;
    mpq_inits(a, b, one, NULL);
    mpq_set_ui(one, 1, 1);
    mpq_set_d(a, x);
    mpq_set_d(b, y);
    mpq_mul(w[2], a, b); /* xy */
    mpq_add(w[1], a, b);
    mpq_sub(w[1], w[1], w[2]);
    mpq_sub(w[0], one, w[1]); /* (1-x)(1-y) = 1 - (x + y - xy) */
    mpq_sub(w[1], w[1], w[2]);
    mpq_clears(a, b, one, NULL);
}

static struct exact_form *exact_new(const struct jacobian_path *p, double x, double y,
                                    double margin, struct err *err) {
    int size = least_size(degree(p));
    struct exact_form *e;
    mpq_t w[3];
    if (!mem_new(e, 1, err)) return NULL;
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_inits(e->sum[i], e->c[i], NULL);
    mpz_init_set_ui(e->den, 1);
    mpq_inits(e->factor, e->weight, w[0], w[1], w[2], NULL);
    weights(x, y, w);
    for (int k = 0; k < 3; k++) {
        if (mpq_sgn(w[k]) == 0) continue;
        jacobian_polar_exact(net(p, k, 0), net(p, k, 1), p->kind, p->triangle, e->c, e->factor);
        mpq_mul(e->weight, w[k], e->factor);
        add(e, size, e->weight, (const mpz_t *)e->c);
    }
    mpq_set_d(e->weight, -margin);
    add(e, size, e->weight, NULL);
    mpq_clears(w[0], w[1], w[2], NULL);
    return e;
}

static void exact_free(struct exact_form *e) {
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_clears(e->sum[i], e->c[i], NULL);
    mpz_clear(e->den);
    mpq_clears(e->factor, e->weight, NULL);
    free(e);
}

static bool exact_sign(const struct jacobian_path *p, double x, double y,
                       enum jacobian_verdict *verdict, struct least_place *place, struct err *err) {
    struct exact_form *e = exact_new(p, x, y, p->margin, err);
    struct least_exact f;
    bool ok;
    if (!e) return false;
    least_exact_init(&f);
    ok = least_exact(degree(p), (const mpz_t *)e->sum, &sign_rule, &f, err);
    if (ok) {
        *verdict = jacobian_verdict_of(mpq_sgn(f.low), mpq_sgn(f.high));
        for (int l = 0; l < 3; l++) mpz_swap(place->weight[l], f.place.weight[l]);
    }
    least_exact_free(&f);
    exact_free(e);
    return ok;
}

/* ---- signs and values ---- */

bool jacobian_path_sign(struct jacobian_path *p, struct least_room *room, double x, double y,
                        enum jacobian_verdict *verdict, struct least_place *place,
                        struct err *err) {
    double c[LEAST_SIZE_MAX], error;
    struct least f;
    if (!blend(p, x, y, c, &error) || !least_double(room, degree(p), c, error, &sign_rule, &f))
        return exact_sign(p, x, y, verdict, place, err);
    *verdict = f.low > 0 ? JACOBIAN_CERTIFIED : JACOBIAN_FOLDS;
    if (f.low <= 0) least_place_set(place, f.place);
    return true;
}

bool jacobian_path_value(const struct jacobian_path *p, double s, const struct least_place *place,
                         double *value, struct err *err) {
    struct exact_form *e = exact_new(p, s, s, 0, err);
    if (!e) return false;
    least_value(degree(p), (const mpz_t *)e->sum, place, e->factor);
    mpq_set_z(e->weight, e->den);
    mpq_div(e->factor, e->factor, e->weight);
    *value = rational_round(e->factor);
    exact_free(e);
    return true;
}

/* ---- the first exit ---- */

struct search {
    struct jacobian_path *p;
    struct least_room *room;
    double top[STACK];
    int count;
    bool found; /* at the bottom of the stack f > 0 does not hold, or is undecided */
    struct jacobian_exit *exit;
    struct least_place *place, *scratch;
};

static bool is_at_exit(const struct search *s) {
    return s->found && s->count == 1;
}

static bool sign(const struct search *s, double x, double y, enum jacobian_verdict *verdict,
                 struct err *err) {
    return jacobian_path_sign(s->p, s->room, x, y, verdict, s->scratch, err);
}

/* Looks at the top itself. */
static bool look(struct search *s, struct err *err) {
    double top = s->top[s->count - 1];
    enum jacobian_verdict verdict;
    if (!sign(s, top, top, &verdict, err)) return false;
    if (verdict == JACOBIAN_CERTIFIED) return true;
    for (int l = 0; l < 3; l++) mpz_swap(s->place->weight[l], s->scratch->weight[l]);
    s->exit->lost = s->top[0] = top;
    s->exit->verdict = verdict;
    s->found = true;
    s->count = 1;
    return true;
}

/* Is that as near as can be, if the interval before the top is not proved as a whole? */
static bool is_near(const struct search *s) {
    double held = s->exit->held, top = s->top[s->count - 1];
    if (held == 0) return top <= tiny;
    return top - held <= (is_at_exit(s) ? near * held : narrow);
}

/* One interval: proved, halved, or the end. */
static bool step(struct search *s, bool *done, struct err *err) {
    enum jacobian_verdict verdict = JACOBIAN_UNDECIDED;
    struct jacobian_exit *exit = s->exit;
    double top;
    if (!is_at_exit(s) && !look(s, err)) return false;
    top = s->top[s->count - 1];
    if (!is_at_exit(s) && !sign(s, exit->held, top, &verdict, err)) return false;
    *done = false;
    if (verdict == JACOBIAN_CERTIFIED) {
        exit->held = top;
        *done = --s->count == 0;
    } else if (is_near(s)) {
        if (!is_at_exit(s)) exit->verdict = JACOBIAN_UNDECIDED;
        exit->lost = top;
        *done = true;
    } else {
        INVARIANT(s->count < STACK);
        s->top[s->count++] = exit->held + 0.5 * (top - exit->held);
    }
    return true;
}

bool jacobian_path_exit(struct jacobian_path *p, struct least_room *room, double upto,
                        struct jacobian_exit *exit, struct least_place *place, struct err *err) {
    struct least_place scratch;
    struct search s = {p, room, {upto}, 1, false, exit, place, &scratch};
    bool ok, done = false;
    *exit = (struct jacobian_exit){0};
    ok = jacobian_path_sign(p, room, 0, 0, &exit->verdict, place, err);
    if (!ok || exit->verdict != JACOBIAN_CERTIFIED) return ok;
    least_place_init(&scratch);
    while (ok && !done) ok = step(&s, &done, err);
    least_place_free(&scratch);
    return ok;
}
