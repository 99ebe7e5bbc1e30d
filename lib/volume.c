/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Let c and h be the Bernstein coefficients of det grad phi (degree n) and of the thickness
 * (degree d), M the multinomial coefficients, N = n + d. Their product has the coefficients
 *
 *     sum over a+b=g of M(a) M(b) / M(g) c_a h_b,     1 / M(g) = g! / N!,
 *
 * and its mean over the triangle is the mean of its (N+1)(N+2)/2 coefficients, so
 *
 *     mean = sum over all a, b of w_ab c_a h_b / (N! (N+1)(N+2)/2),    w_ab = M(a) M(b) (a+b)!
 *
 * with integers w, the same for all triangles. Means are summed with twice the areas, which are
 * integers of the lattice. */
#include "volume.h"

#include "jacobian.h"
#include "mem.h"
#include "rational.h"

struct integrator {
    const struct spline *s;
    int n, d;
    mpz_t *w;                   /* w_ab at [b * size(n) + a] */
    mpz_t *c, *h;               /* LEAST_SIZE_MAX each */
    mpz_t sum, part;            /* of a triangle */
    mpq_t factor, other, total; /* total: of mean * area2 * N! (N+1)(N+2)/2 */
    mpz_t area;                 /* area2 of all triangles */
};

/* (i, j, k) of index `at` in the order of grid_patch, degree n. */
static void indices(int n, int at, int ijk[3]) {
    int r = 0;
    while ((r + 1) * (r + 2) / 2 <= at) r++;
    ijk[2] = at - r * (r + 1) / 2;
    ijk[1] = r - ijk[2];
    ijk[0] = n - r;
}

static void multiply_factorial(mpz_t product, int n, bool divide) {
    mpz_t f;
    mpz_init(f);
    mpz_fac_ui(f, (unsigned long)n);
    if (divide)
        mpz_divexact(product, product, f);
    else
        mpz_mul(product, product, f);
    mpz_clear(f);
}

/* M(a) M(b) (a+b)! */
static void weight(mpz_t w, int n, int a, int d, int b) {
    int x[3], y[3];
    indices(n, a, x);
    indices(d, b, y);
    mpz_set_ui(w, 1);
    multiply_factorial(w, n, false);
    multiply_factorial(w, d, false);
    for (int l = 0; l < 3; l++) multiply_factorial(w, x[l] + y[l], false);
    for (int l = 0; l < 3; l++) {
        multiply_factorial(w, x[l], true);
        multiply_factorial(w, y[l], true);
    }
}

static bool integrator_init(struct integrator *v, const struct spline *s, struct err *err) {
    int size_n, size_d;
    *v = (struct integrator){.s = s};
    v->n = jacobian_degree(s, JACOBIAN_PLANE);
    v->d = jacobian_degree(s, JACOBIAN_THICKNESS);
    size_n = least_size(v->n);
    size_d = least_size(v->d);
    if (!mem_new(v->c, LEAST_SIZE_MAX, err) || !mem_new(v->h, LEAST_SIZE_MAX, err) ||
        !mem_new(v->w, (size_t)size_n * (size_t)size_d, err))
        return false;
    for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_inits(v->c[i], v->h[i], NULL);
    for (int i = 0; i < size_n * size_d; i++) {
        mpz_init(v->w[i]);
        weight(v->w[i], v->n, i % size_n, v->d, i / size_n);
    }
    mpz_inits(v->sum, v->part, v->area, NULL);
    mpq_inits(v->factor, v->other, v->total, NULL);
    return true;
}

static void integrator_free(struct integrator *v, bool whole) {
    int weights = least_size(v->n) * least_size(v->d);
    if (whole) {
        for (int i = 0; i < LEAST_SIZE_MAX; i++) mpz_clears(v->c[i], v->h[i], NULL);
        for (int i = 0; i < weights; i++) mpz_clear(v->w[i]);
        mpz_clears(v->sum, v->part, v->area, NULL);
        mpq_clears(v->factor, v->other, v->total, NULL);
    }
    free(v->c);
    free(v->h);
    free(v->w);
}

static void add_triangle(struct integrator *v, uint32_t t) {
    const struct grid *g = &v->s->grid;
    const uint32_t *corner = g->triangle[t];
    int64_t area2 =
        predicate_area2(g->vertex[corner[0]], g->vertex[corner[1]], g->vertex[corner[2]]);
    int size_n = least_size(v->n), size_d = least_size(v->d);
    jacobian_coefficients_exact(v->s, JACOBIAN_PLANE, t, v->c, v->factor);
    jacobian_coefficients_exact(v->s, JACOBIAN_THICKNESS, t, v->h, v->other);
    mpz_set_ui(v->sum, 0);
    for (int b = 0; b < size_d; b++) {
        const mpz_t *w = (const mpz_t *)v->w + (size_t)b * (size_t)size_n;
        mpz_set_ui(v->part, 0);
        for (int a = 0; a < size_n; a++) mpz_addmul(v->part, v->c[a], w[a]);
        mpz_addmul(v->sum, v->part, v->h[b]);
    }
    mpz_add_ui(v->area, v->area, (unsigned long)area2);
    mpz_mul_ui(v->sum, v->sum, (unsigned long)area2);
    mpq_mul(v->factor, v->factor, v->other);
    mpq_set_z(v->other, v->sum);
    mpq_mul(v->factor, v->factor, v->other);
    mpq_add(v->total, v->total, v->factor);
}

/* The mean over the domain from the total; then times its area and depth. */
static void conclude(struct integrator *v, double *volume, double *ratio) {
    const struct grid *g = &v->s->grid;
    int degree = v->n + v->d;
    mpz_fac_ui(v->sum, (unsigned long)degree);
    mpz_mul_ui(v->sum, v->sum, (unsigned long)((degree + 1) * (degree + 2) / 2));
    mpz_mul(v->sum, v->sum, v->area);
    mpq_set_z(v->factor, v->sum);
    mpq_div(v->total, v->total, v->factor);
    *ratio = rational_round(v->total);
    mpq_set_z(v->factor, v->area);
    mpq_mul(v->total, v->total, v->factor);
    mpq_div_2exp(v->total, v->total, 1);
    mpq_set_d(v->factor, g->lattice.step);
    mpq_mul(v->total, v->total, v->factor);
    mpq_mul(v->total, v->total, v->factor);
    mpq_set_d(v->factor, g->depth[1]);
    mpq_set_d(v->other, g->depth[0]);
    mpq_sub(v->factor, v->factor, v->other);
    mpq_mul(v->total, v->total, v->factor);
    *volume = rational_round(v->total);
}

bool volume_of_prisms(const struct spline *s, double *volume, double *ratio, struct err *err) {
    struct integrator v;
    bool ok = integrator_init(&v, s, err);
    if (ok) {
        for (uint32_t t = 0; t < s->grid.triangle_count; t++) add_triangle(&v, t);
        conclude(&v, volume, ratio);
    }
    integrator_free(&v, ok);
    return ok;
}
