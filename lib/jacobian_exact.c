/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch's coordinates are doubles, that is integers times 2^e for a common e. With those
 * integers, and n = 2(d-1),
 *
 *     n! c_g = d^2 2^2e / (2 area)  g! sum over a+b=g of M(a) M(b) P1_a x P2_b
 *
 * where g! = i! j! k!, so that the factor is d^2 2^2e / (n! 2 area). */
#include "jacobian.h"
#include "rational.h"

static void scale_factor(mpq_t factor, int exponent) {
    if (exponent >= 0)
        mpq_mul_2exp(factor, factor, (mp_bitcnt_t)exponent);
    else
        mpq_div_2exp(factor, factor, (mp_bitcnt_t)-exponent);
}

/* d^2 / (n! 2 area) */
static void plane_factor(const struct spline *s, uint32_t t, mpq_t factor) {
    const struct grid *g = &s->grid;
    const uint32_t *v = g->triangle[t];
    unsigned long d = (unsigned long)g->degree;
    mpz_t n_factorial;
    mpq_t x;
    mpz_init(n_factorial);
    mpq_init(x);
    mpz_fac_ui(n_factorial, 2 * (d - 1));
    mpq_set_ui(factor, d * d, 1);
    mpq_set_z(x, n_factorial);
    mpq_div(factor, factor, x);
    mpq_set_d(x, (double)predicate_area2(g->vertex[v[0]], g->vertex[v[1]], g->vertex[v[2]]));
    mpq_div(factor, factor, x);
    mpq_set_d(x, g->lattice.step);
    mpq_div(factor, factor, x);
    mpq_div(factor, factor, x);
    mpz_clear(n_factorial);
    mpq_clear(x);
}

/* i! j! k! for row r = j + k */
static void factorials(mpz_t product, int n, int r, int k) {
    mpz_t f;
    mpz_init(f);
    mpz_fac_ui(product, (unsigned long)(n - r));
    mpz_fac_ui(f, (unsigned long)(r - k));
    mpz_mul(product, product, f);
    mpz_fac_ui(f, (unsigned long)k);
    mpz_mul(product, product, f);
    mpz_clear(f);
}

/* P1 and P2 times M: p[a] is x1, y1, x2, y2. z holds x and y of the patch. */
static void weighted_differences(int e, mpz_t *z, mpz_t (*p)[4]) {
    mpz_t weight, f;
    mpz_inits(weight, f, NULL);
    for (int r = 0, a = 0; r <= e; r++)
        for (int k = 0; k <= r; k++, a++) {
            mpz_fac_ui(weight, (unsigned long)e);
            factorials(f, e, r, k);
            mpz_divexact(weight, weight, f);
            for (int m = 0; m < 4; m++) {
                int to = a + r + 1 + m / 2;
                mpz_sub(p[a][m], z[2 * to + m % 2], z[2 * a + m % 2]);
                mpz_mul(p[a][m], p[a][m], weight);
            }
        }
    mpz_clears(weight, f, NULL);
}

/* sum += P1_a x P2_b, P1 of one net, P2 of the other. */
static void convolve(int e, mpz_t (*one)[4], mpz_t (*other)[4], mpz_t *sum) {
    for (int r = 0, a = 0; r <= e; r++)
        for (int k = 0; k <= r; k++, a++)
            for (int row = 0, b = 0; row <= e; row++)
                for (int i = 0; i <= row; i++, b++) {
                    mpz_t *c = sum + (r + row) * (r + row + 1) / 2 + k + i;
                    mpz_addmul(*c, one[a][0], other[b][3]);
                    mpz_submul(*c, one[a][1], other[b][2]);
                }
}

static void multiply_factorials(int n, mpz_t *c) {
    mpz_t f;
    mpz_init(f);
    for (int r = 0, i = 0; r <= n; r++)
        for (int k = 0; k <= r; k++, i++) {
            factorials(f, n, r, k);
            mpz_mul(c[i], c[i], f);
        }
    mpz_clear(f);
}

/* One net or two: the components of its points as integers, 2 a point. */
struct nets {
    int count, points, exponent; /* common to both */
    mpz_t z[2][2 * GRID_PATCH_MAX];
};

static void nets_init(struct nets *nets, const struct grid *g, uint32_t t, const double (*one)[2],
                      const double (*other)[2]) {
    uint32_t q[GRID_PATCH_MAX];
    double x[2 * GRID_PATCH_MAX];
    int exponent[2] = {0};
    nets->count = one == other ? 1 : 2;
    nets->points = grid_patch_size(g->degree);
    grid_patch(g, t, q);
    for (int h = 0; h < nets->count; h++) {
        for (int i = 0; i < 2 * nets->points; i++) {
            x[i] = (h ? other : one)[q[i / 2]][i % 2];
            mpz_init(nets->z[h][i]);
        }
        exponent[h] = rational_integers(2 * nets->points, x, nets->z[h]);
    }
    nets->exponent = exponent[0];
    if (nets->count == 2 && exponent[1] < exponent[0]) nets->exponent = exponent[1];
    for (int h = 0; h < nets->count; h++)
        for (int i = 0; i < 2 * nets->points; i++)
            mpz_mul_2exp(nets->z[h][i], nets->z[h][i], (mp_bitcnt_t)(exponent[h] - nets->exponent));
}

static void nets_free(struct nets *nets) {
    for (int h = 0; h < nets->count; h++)
        for (int i = 0; i < 2 * nets->points; i++) mpz_clear(nets->z[h][i]);
}

static void plane_polar(const struct spline *s, const struct spline *r, uint32_t t, mpz_t *c,
                        mpq_t factor) {
    struct nets nets;
    mpz_t p[2][GRID_PATCH_MAX][4];
    int e = s->grid.degree - 1, parts = grid_patch_size(e);
    nets_init(&nets, &s->grid, t, (const double(*)[2])s->phi, (const double(*)[2])r->phi);
    for (int h = 0; h < nets.count; h++) {
        for (int i = 0; i < parts; i++)
            mpz_inits(p[h][i][0], p[h][i][1], p[h][i][2], p[h][i][3], NULL);
        weighted_differences(e, nets.z[h], p[h]);
    }
    for (int i = 0; i < least_size(2 * e); i++) mpz_set_ui(c[i], 0);
    for (int h = 0; h < nets.count; h++) convolve(e, p[h], p[nets.count - 1 - h], c);
    multiply_factorials(2 * e, c);
    plane_factor(s, t, factor);
    scale_factor(factor, 2 * nets.exponent - (nets.count - 1));
    for (int h = 0; h < nets.count; h++)
        for (int i = 0; i < parts; i++)
            mpz_clears(p[h][i][0], p[h][i][1], p[h][i][2], p[h][i][3], NULL);
    nets_free(&nets);
}

static void thickness_polar(const struct spline *s, const struct spline *r, uint32_t t, mpz_t *c,
                            mpq_t factor) {
    struct nets nets;
    mpq_t end;
    nets_init(&nets, &s->grid, t, (const double(*)[2])s->sigma, (const double(*)[2])r->sigma);
    mpq_init(end);
    mpq_set_d(factor, s->grid.depth[1]);
    mpq_set_d(end, s->grid.depth[0]);
    mpq_sub(factor, factor, end);
    mpq_inv(factor, factor);
    mpq_clear(end);
    scale_factor(factor, nets.exponent - (nets.count - 1));
    for (int i = 0; i < nets.points; i++) {
        mpz_set_ui(c[i], 0);
        for (int h = 0; h < nets.count; h++) {
            mpz_add(c[i], c[i], nets.z[h][2 * i + 1]);
            mpz_sub(c[i], c[i], nets.z[h][2 * i]);
        }
    }
    nets_free(&nets);
}

void jacobian_polar_exact(const struct spline *s, const struct spline *r, enum jacobian_kind kind,
                          uint32_t t, mpz_t *c, mpq_t factor) {
    if (kind == JACOBIAN_PLANE)
        plane_polar(s, r, t, c, factor);
    else
        thickness_polar(s, r, t, c, factor);
}

void jacobian_coefficients_exact(const struct spline *s, enum jacobian_kind kind, uint32_t t,
                                 mpz_t *c, mpq_t factor) {
    jacobian_polar_exact(s, s, kind, t, c, factor);
}
