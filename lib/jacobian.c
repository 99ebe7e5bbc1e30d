/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors of the coefficients. With u = 2^-53 and N = d(d+1)/2 the number of differences P1, each
 * difference, each product with its weight M, each product and the difference of two of them
 * rounds by a relative u, their sum over at most N pairs by N u, the division by M(g) by u. Since
 * sum M(a) M(b) = M(g) over a+b=g (Vandermonde), the error of a coefficient is to first order at
 * most
 *
 *     (N + 7) u (max |P1x| max |P2y| + max |P1y| max |P2x|);
 *
 * the code takes (2N + 16) u, which covers terms of second order and the bound's own roundings.
 * That maximum is to lie within 2^-400 .. 2^400, far from underflow and overflow, as is `factor`.
 * The polar form is the mean of two such sums, with P1 of one net and P2 of the other: 2N pairs,
 * and halving rounds nothing. */
#include "jacobian.h"

#include "mem.h"
#include "rational.h"

#include <math.h>

const char *const jacobian_verdict_names[] = {"certified", "undecided", "degenerate", "folds"};

const struct least_rule jacobian_default_rule = {0.01, 0x1p-100, 4096};

int jacobian_degree(const struct spline *s, enum jacobian_kind kind) {
    return kind == JACOBIAN_PLANE ? 2 * (s->grid.degree - 1) : s->grid.degree;
}

static bool in_range(double x) {
    return x >= 0x1p-400 && x <= 0x1p400;
}

/* m[i]: the multinomial coefficients n!/(i!j!k!) = C(n,r) C(r,k), r = j + k, in the order of
 * grid_patch, exact: < 2^53. Row r is first that of Pascal's triangle; the last row has all C(n,r).
 */
static void multinomials(int n, double *m) {
    const double *last = m + n * (n + 1) / 2;
    for (int r = 0; r <= n; r++) {
        double *row = m + r * (r + 1) / 2;
        const double *above = row - r;
        row[0] = row[r] = 1;
        for (int k = 1; k < r; k++) row[k] = above[k - 1] + above[k];
    }
    for (int r = 1; r < n; r++)
        for (int k = 0; k <= r; k++) m[r * (r + 1) / 2 + k] *= last[r];
}

/* P1 and P2 of a net times their weights, and the largest of each before that; [m]: x1, y1, x2, y2.
 */
struct differences {
    double p[4][GRID_PATCH_MAX], most[4];
};

static void find_differences(const struct spline *s, uint32_t t, struct differences *of) {
    uint32_t q[GRID_PATCH_MAX];
    double weight[GRID_PATCH_MAX];
    int e = s->grid.degree - 1;
    grid_patch(&s->grid, t, q);
    multinomials(e, weight);
    for (int m = 0; m < 4; m++) of->most[m] = 0;
    for (int r = 0, a = 0; r <= e; r++)
        for (int k = 0; k <= r; k++, a++) {
            const double *from = s->phi[q[a]];
            const double *to[2] = {s->phi[q[a + r + 1]], s->phi[q[a + r + 2]]};
            for (int m = 0; m < 4; m++) {
                double difference = to[m / 2][m % 2] - from[m % 2], size = fabs(difference);
                of->most[m] = size > of->most[m] ? size : of->most[m];
                of->p[m][a] = weight[a] * difference;
            }
        }
}

/* c_g += sum over a+b=g of P1_a x P2_b, P1 of one net, P2 of the other: rows add, and places k
 * within rows. Returns the maximum that bounds the products. */
static double convolve(int e, const struct differences *one, const struct differences *other,
                       double *c) {
    for (int r = 0, a = 0; r <= e; r++)
        for (int k = 0; k <= r; k++, a++) {
            double x = one->p[0][a], y = one->p[1][a];
            for (int row = 0; row <= e; row++) {
                int first = row * (row + 1) / 2;
                const double *x2 = other->p[2] + first, *y2 = other->p[3] + first;
                double *sum = c + (r + row) * (r + row + 1) / 2 + k;
                for (int i = 0; i <= row; i++) sum[i] += x * y2[i] - y * x2[i];
            }
        }
    return one->most[0] * other->most[3] + one->most[1] * other->most[2];
}

static double area2(const struct grid *g, uint32_t t) {
    const uint32_t *v = g->triangle[t];
    return (double)predicate_area2(g->vertex[v[0]], g->vertex[v[1]], g->vertex[v[2]]);
}

static bool plane_polar(const struct spline *s, const struct spline *r, uint32_t t, double *c,
                        double *error, double *factor) {
    struct differences p[2];
    double multinomial[LEAST_SIZE_MAX], most;
    int d = s->grid.degree, n = 2 * (d - 1), sums = r == s ? 1 : 2;
    for (int i = 0; i < least_size(n); i++) c[i] = 0;
    find_differences(s, t, &p[0]);
    if (sums == 2) find_differences(r, t, &p[1]);
    most = convolve(d - 1, &p[0], &p[sums - 1], c);
    if (sums == 2) most = 0.5 * (most + convolve(d - 1, &p[1], &p[0], c));
    *error = (2 * sums * least_size(d - 1) + 16) * 0x1p-53 * most;
    *factor = d * d / (area2(&s->grid, t) * s->grid.lattice.step * s->grid.lattice.step);
    multinomials(n, multinomial);
    for (int i = 0; i < least_size(n); i++) c[i] /= sums * multinomial[i];
    return in_range(most) && in_range(*factor);
}

static bool thickness_polar(const struct spline *s, const struct spline *r, uint32_t t, double *c,
                            double *error, double *factor) {
    uint32_t q[GRID_PATCH_MAX];
    double most = 0;
    grid_patch(&s->grid, t, q);
    for (int i = 0; i < grid_patch_size(s->grid.degree); i++) {
        double one = s->sigma[q[i]][1] - s->sigma[q[i]][0];
        double other = r->sigma[q[i]][1] - r->sigma[q[i]][0];
        c[i] = 0.5 * (one + other);
        most = fmax(most, fmax(fabs(one), fabs(other)));
    }
    *error = (r == s ? 0x1p-52 : 0x1p-51) * most;
    *factor = 1 / (s->grid.depth[1] - s->grid.depth[0]);
    return in_range(most) && in_range(*factor);
}

bool jacobian_polar(const struct spline *s, const struct spline *r, enum jacobian_kind kind,
                    uint32_t t, double *c, double *error, double *factor) {
    return kind == JACOBIAN_PLANE ? plane_polar(s, r, t, c, error, factor)
                                  : thickness_polar(s, r, t, c, error, factor);
}

bool jacobian_coefficients(const struct spline *s, enum jacobian_kind kind, uint32_t t, double *c,
                           double *error, double *factor) {
    return jacobian_polar(s, s, kind, t, c, error, factor);
}

enum jacobian_verdict jacobian_verdict_of(int low_sign, int high_sign) {
    return low_sign > 0     ? JACOBIAN_CERTIFIED
           : high_sign < 0  ? JACOBIAN_FOLDS
           : high_sign == 0 ? JACOBIAN_DEGENERATE
                            : JACOBIAN_UNDECIDED;
}

/* `factor` has a relative error of 5u at most; 2^-49 covers it and these roundings. */
static void scale(const struct least *f, double factor, struct jacobian_bounds *b) {
    b->low = f->low * factor - fabs(f->low * factor) * 0x1p-49;
    b->high = f->high * factor + fabs(f->high * factor) * 0x1p-49;
    b->verdict = jacobian_verdict_of((f->low > 0) - (f->low < 0), (f->high > 0) - (f->high < 0));
}

/* The double next to x in the direction of `up`, unless x is a double. */
static double round_towards(const mpq_t x, bool up) {
    double nearest = rational_round(x);
    mpq_t q;
    int side;
    if (!isfinite(nearest)) return (nearest > 0) == up ? nearest : nextafter(nearest, 0);
    mpq_init(q);
    mpq_set_d(q, nearest);
    side = mpq_cmp(q, x);
    mpq_clear(q);
    if (side == 0 || (side > 0) == up) return nearest;
    return nextafter(nearest, up ? INFINITY : -INFINITY);
}

struct exact_polynomial {
    mpz_t c[LEAST_SIZE_MAX];
    mpq_t factor;
};

static struct exact_polynomial *exact_new(const struct spline *s, enum jacobian_kind kind,
                                          uint32_t t, struct err *err) {
    struct exact_polynomial *p;
    if (!mem_new(p, 1, err)) return NULL;
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_init(p->c[i]);
    mpq_init(p->factor);
    jacobian_coefficients_exact(s, kind, t, p->c, p->factor);
    return p;
}

static void exact_free(struct exact_polynomial *p) {
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_clear(p->c[i]);
    mpq_clear(p->factor);
    free(p);
}

static bool triangle_exact(const struct spline *s, enum jacobian_kind kind, uint32_t t,
                           const struct least_rule *rule, struct jacobian_bounds *b,
                           struct least_place *place, struct err *err) {
    struct exact_polynomial *p = exact_new(s, kind, t, err);
    struct least_exact x;
    bool ok;
    if (!p) return false;
    least_exact_init(&x);
    ok = least_exact(jacobian_degree(s, kind), (const mpz_t *)p->c, rule, &x, err);
    if (ok) {
        mpq_mul(x.low, x.low, p->factor);
        mpq_mul(x.high, x.high, p->factor);
        b->low = round_towards(x.low, false);
        b->high = round_towards(x.high, true);
        b->verdict = jacobian_verdict_of(mpq_sgn(x.low), mpq_sgn(x.high));
        for (int l = 0; l < 3; l++) mpz_swap(place->weight[l], x.place.weight[l]);
    }
    least_exact_free(&x);
    exact_free(p);
    return ok;
}

bool jacobian_triangle(struct least_room *room, const struct spline *s, enum jacobian_kind kind,
                       uint32_t t, const struct least_rule *rule, struct jacobian_bounds *bounds,
                       struct least_place *place, struct err *err) {
    double c[LEAST_SIZE_MAX], error, factor;
    struct least f;
    if (jacobian_coefficients(s, kind, t, c, &error, &factor) &&
        least_double(room, jacobian_degree(s, kind), c, error, rule, &f)) {
        scale(&f, factor, bounds);
        least_place_set(place, f.place);
        return true;
    }
    return triangle_exact(s, kind, t, rule, bounds, place, err);
}

/* The value at the place, in triangle t. */
static bool value_at(const struct spline *s, enum jacobian_kind kind, uint32_t t,
                     const struct least_place *place, double *value, struct err *err) {
    struct exact_polynomial *p = exact_new(s, kind, t, err);
    mpq_t v;
    if (!p) return false;
    mpq_init(v);
    least_value(jacobian_degree(s, kind), (const mpz_t *)p->c, place, v);
    mpq_mul(v, v, p->factor);
    *value = rational_round(v);
    mpq_clear(v);
    exact_free(p);
    return true;
}

struct survey {
    const struct spline *s;
    enum jacobian_kind kind;
    const struct least_rule *rule;
    struct least_room *room;
    struct jacobian_report *r;
    bool *refined; /* by triangle */
};

/* Is it what triangle t shows that is to be told? Bounds of numbers below the range of doubles are
 * alike, their verdicts are not. */
static bool is_worst(const struct jacobian_report *r, uint32_t t) {
    const struct jacobian_bounds *b = &r->bounds_of[t];
    return b->high < r->least.high ||
           (b->high == r->least.high && b->verdict > r->bounds_of[r->triangle].verdict);
}

static bool refine(const struct survey *v, uint32_t t, struct err *err) {
    struct jacobian_report *r = v->r;
    struct least_place place;
    bool ok;
    if (v->refined[t]) return true;
    least_place_init(&place);
    ok = jacobian_triangle(v->room, v->s, v->kind, t, v->rule, &r->bounds_of[t], &place, err);
    if (ok && is_worst(r, t)) {
        r->least.high = r->bounds_of[t].high;
        r->triangle = t;
        for (int l = 0; l < 3; l++) mpz_swap(r->place.weight[l], place.weight[l]);
    }
    least_place_free(&place);
    return v->refined[t] = ok;
}

/* The bounds that coefficients give at once: enough for most triangles. */
static bool look(const struct survey *v, uint32_t t, struct err *err) {
    double c[LEAST_SIZE_MAX], error, factor;
    struct jacobian_report *r = v->r;
    struct jacobian_bounds *b = &r->bounds_of[t];
    struct least f;
    if (!jacobian_coefficients(v->s, v->kind, t, c, &error, &factor)) return refine(v, t, err);
    least_quick(jacobian_degree(v->s, v->kind), c, error, &f);
    scale(&f, factor, b);
    if (!(b->low > 0)) return refine(v, t, err);
    if (b->high >= r->least.high) return true;
    r->least.high = b->high;
    r->triangle = t;
    least_place_set(&r->place, f.place);
    return true;
}

/* Refines every triangle whose lower bound is too far below the least upper bound. */
static bool survey_run(const struct survey *v, bool all, struct err *err) {
    struct jacobian_report *r = v->r;
    uint32_t n = v->s->grid.triangle_count;
    for (uint32_t t = 0; t < n; t++)
        if (!look(v, t, err)) return false;
    for (uint32_t t = 0; t < n; t++) {
        double limit = r->least.high - fabs(r->least.high) * v->rule->tolerance;
        if ((all || r->bounds_of[t].low < limit) && !refine(v, t, err)) return false;
    }
    r->least.low = INFINITY;
    for (uint32_t t = 0; t < n; t++) {
        const struct jacobian_bounds *b = &r->bounds_of[t];
        r->least.low = fmin(r->least.low, b->low);
        r->count[b->verdict]++;
        if (b->verdict > r->least.verdict) r->least.verdict = b->verdict;
    }
    return value_at(v->s, v->kind, r->triangle, &r->place, &r->value, err);
}

bool jacobian_report_init(struct jacobian_report *r, const struct spline *s,
                          enum jacobian_kind kind, const struct least_rule *rule, bool all,
                          struct err *err) {
    struct survey v = {.s = s, .kind = kind, .rule = rule, .r = r};
    bool ok;
    *r = (struct jacobian_report){.least = {.high = INFINITY}};
    if (!mem_new(r->bounds_of, s->grid.triangle_count, err)) return false;
    least_place_init(&r->place);
    ok = mem_new(v.refined, s->grid.triangle_count, err) && (v.room = least_room_new(err)) &&
         survey_run(&v, all, err);
    least_room_free(v.room);
    free(v.refined);
    if (!ok) jacobian_report_free(r);
    return ok;
}

void jacobian_report_free(struct jacobian_report *r) {
    if (r->bounds_of) least_place_free(&r->place);
    free(r->bounds_of);
    r->bounds_of = NULL;
}
