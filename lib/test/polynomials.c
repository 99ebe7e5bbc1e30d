/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "polynomials.h"

#include <math.h>

long double polynomial_value(const struct polynomial *f, int dx, int dy, long double x,
                             long double y) {
    long double sum = 0;
    for (int p = dx; p <= f->degree; p++)
        for (int q = dy; p + q <= f->degree; q++) {
            long double term = f->c[p][q] * (dx ? p : 1) * (dy ? q : 1);
            for (int i = dx; i < p; i++) term *= x;
            for (int i = dy; i < q; i++) term *= y;
            sum += term;
        }
    return sum;
}

/* The blossom of f, as a polynomial of degree d, at d points: the coefficient of s^p t^q in
 * prod (1 + s x_m + t y_m), over the number of its terms, stands for x^p y^q. */
static long double blossom(const struct polynomial *f, int d, long double points[][2]) {
    long double e[TERMS][TERMS] = {{1}}, sum = 0, count[TERMS][TERMS];
    for (int m = 0; m < d; m++)
        for (int p = m + 1; p >= 0; p--)
            for (int q = m + 1 - p; q >= 0; q--)
                e[p][q] +=
                    (p ? points[m][0] * e[p - 1][q] : 0) + (q ? points[m][1] * e[p][q - 1] : 0);
    for (int p = 0; p <= d; p++) /* d! / (p! q! (d-p-q)!) */
        for (int q = 0; p + q <= d; q++) {
            count[p][q] = 1;
            for (int i = 0; i < p; i++) count[p][q] *= (long double)(d - i) / (i + 1);
            for (int i = 0; i < q; i++) count[p][q] *= (long double)(d - p - i) / (i + 1);
        }
    for (int p = 0; p <= f->degree; p++)
        for (int q = 0; p + q <= f->degree; q++) sum += f->c[p][q] * e[p][q] / count[p][q];
    return sum;
}

void world_of(const struct grid *g, uint32_t v, long double xy[2]) {
    xy[0] = g->lattice.x0 + (long double)g->lattice.step * g->vertex[v][0];
    xy[1] = g->lattice.y0 + (long double)g->lattice.step * g->vertex[v][1];
}

static long double coefficient(const struct polynomial *f, const struct grid *g, uint32_t p) {
    struct grid_place place = grid_place(g, p);
    long double points[GRID_DEGREE_MAX][2];
    int m = 0;
    for (int l = 0; l < 3; l++)
        for (int i = 0; i < place.weight[l]; i++)
            world_of(g, g->triangle[place.triangle][l], points[m++]);
    return blossom(f, g->degree, points);
}

void random_polynomial(struct polynomial *f, int degree, uint64_t *s) {
    *f = (struct polynomial){.degree = degree};
    for (int p = 0; p <= degree; p++)
        for (int q = 0; p + q <= degree; q++)
            f->c[p][q] = ldexp(random_unit(s) - 0.5, -3 * (p + q));
}

void polynomial_spline(struct spline *s, struct grid *g, const struct polynomial *f) {
    struct err err = {0};
    assert_true(spline_identity(s, g, &err));
    for (uint32_t p = 0; f && p < s->grid.point_count; p++)
        for (int m = 0; m < 2; m++) {
            s->phi[p][m] = (double)coefficient(&f[m], &s->grid, p);
            if (s->sigma) s->sigma[p][m] = (double)coefficient(&f[2 + m], &s->grid, p);
        }
}

static long double power(long double x, int n) {
    long double result = 1;
    while (n-- > 0) result *= x;
    return result;
}

/* d!/(i!j!k!) */
static long double multinomial(const int e[3]) {
    long double result = 1;
    int n = 0;
    for (int l = 0; l < 3; l++)
        for (int i = 1; i <= e[l]; i++) result *= (long double)++n / i;
    return result;
}

/* by[l][c] = d value_c / d b_l, b0, b1, b2 taken as independent, to the world's x and y */
static void to_world(const struct grid *g, uint32_t t, long double by[3][2],
                     long double jacobian[2][2]) {
    long double u[3][2], s[2][2], area;
    for (int l = 0; l < 3; l++) world_of(g, g->triangle[t][l], u[l]);
    for (int m = 0; m < 2; m++)
        for (int c = 0; c < 2; c++) s[m][c] = u[m + 1][c] - u[0][c];
    area = s[0][0] * s[1][1] - s[0][1] * s[1][0];
    for (int c = 0; c < 2; c++) {
        long double along[2] = {by[1][c] - by[0][c], by[2][c] - by[0][c]};
        jacobian[c][0] = (along[0] * s[1][1] - along[1] * s[0][1]) / area;
        jacobian[c][1] = (along[1] * s[0][0] - along[0] * s[1][0]) / area;
    }
}

void sum_at(const struct spline *s, uint32_t t, const long double b[3], long double value[2],
            long double jacobian[2][2]) {
    long double by[3][2] = {{0}};
    int d = s->grid.degree;
    value[0] = value[1] = 0;
    for (int i = 0; i <= d; i++)
        for (int j = 0; i + j <= d; j++) {
            int e[3] = {i, j, d - i - j};
            const double *q = s->phi[grid_point(&s->grid, t, e[0], e[1], e[2])];
            long double m = multinomial(e);
            for (int c = 0; c < 2; c++)
                value[c] += m * q[c] * power(b[0], i) * power(b[1], j) * power(b[2], e[2]);
            for (int l = 0; l < 3; l++) {
                long double term = m * e[l];
                for (int k = 0; k < 3; k++) term *= power(b[k], e[k] - (k == l));
                for (int c = 0; c < 2 && e[l] > 0; c++) by[l][c] += term * q[c];
            }
        }
    if (jacobian) to_world(&s->grid, t, by, jacobian);
}

void singular_values(long double j[2][2], long double *least, long double *largest) {
    long double a = sqrtl((j[0][0] + j[1][1]) * (j[0][0] + j[1][1]) +
                          (j[1][0] - j[0][1]) * (j[1][0] - j[0][1]));
    long double b = sqrtl((j[0][0] - j[1][1]) * (j[0][0] - j[1][1]) +
                          (j[1][0] + j[0][1]) * (j[1][0] + j[0][1]));
    *largest = (a + b) / 2;
    *least = *largest > 0 ? fabsl(j[0][0] * j[1][1] - j[0][1] * j[1][0]) / *largest : 0;
}
