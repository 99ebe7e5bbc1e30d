/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights of the vertices, twice an area in C each, [abc] = (b - a) x (c - a):
 *
 *     w in triangle abc               crossing of ab with cd
 *         a: [bcw]                        a: [cdb]
 *         b: [caw]                        b: [dca]
 *         c: [abw]
 *
 * The signs of all are the same. They are computed in double-double: with M the sum of the products
 * that are subtracted, the error is below 2^-100 M. Where that is not below 2^-56 of the weights'
 * sum, rationals take over. A quotient of weights then carries an error of less than 2^-52, a place
 * x_a + q_b (x_b - x_a) + q_c (x_c - x_a), rounded, one of less than 2^-50 of the largest |x|. */
#include "overlay_place.h"

#include "dd.h"
#include "halfedge.h"
#include "rational.h"

#include <math.h>
#include <string.h>

struct term {
    uint32_t vertex;
    const double *area[3]; /* the weight: twice the area of these */
};

/* The combination that v is in mesh m; returns the number of terms. */
static int terms_of(const struct overlay_mesh mesh[2], const struct overlay_vertex *v, int m,
                    struct term term[3]) {
    const struct overlay_mesh *own = &mesh[m], *other = &mesh[!m];
    if (v->kind == OVERLAY_CROSSING) {
        uint32_t a = halfedge_from(own->triangle, v->in[m]);
        uint32_t b = halfedge_to(own->triangle, v->in[m]);
        const double *c = other->at[halfedge_from(other->triangle, v->in[!m])];
        const double *d = other->at[halfedge_to(other->triangle, v->in[!m])];
        term[0] = (struct term){a, {c, d, own->at[b]}};
        term[1] = (struct term){b, {d, c, own->at[a]}};
        return 2;
    }
    if (v->kind == (m == 0 ? OVERLAY_SECOND : OVERLAY_FIRST)) {
        const uint32_t *corner = own->triangle[v->in[m]];
        for (int c = 0; c < 3; c++)
            term[c] = (struct term){
                corner[c],
                {own->at[corner[(c + 1) % 3]], own->at[corner[(c + 2) % 3]], other->at[v->in[!m]]}};
        return 3;
    }
    term[0] = (struct term){.vertex = v->in[m]};
    return 1;
}

static void exact_difference(mpq_t q, double a, double b) {
    mpq_t minus;
    mpq_init(minus);
    mpq_set_d(q, a);
    mpq_set_d(minus, b);
    mpq_sub(q, q, minus);
    mpq_clear(minus);
}

static void exact_area2(mpq_t area, const double *const p[3]) {
    mpq_t q[3];
    mpq_inits(q[0], q[1], q[2], NULL);
    exact_difference(area, p[1][0], p[0][0]);
    exact_difference(q[0], p[2][1], p[0][1]);
    exact_difference(q[1], p[1][1], p[0][1]);
    exact_difference(q[2], p[2][0], p[0][0]);
    mpq_mul(area, area, q[0]);
    mpq_mul(q[1], q[1], q[2]);
    mpq_sub(area, area, q[1]);
    mpq_clears(q[0], q[1], q[2], NULL);
}

void overlay_place_exact(const struct overlay_mesh mesh[2], const struct overlay_vertex *v, int m,
                         const double (*x)[2], mpq_t p[2]) {
    struct term term[3];
    int n = terms_of(mesh, v, m, term);
    mpq_t weight, sum, product;
    if (n == 1) {
        for (int c = 0; c < 2; c++) mpq_set_d(p[c], x[term[0].vertex][c]);
        return;
    }
    mpq_inits(weight, sum, product, NULL);
    for (int c = 0; c < 2; c++) mpq_set_ui(p[c], 0, 1);
    for (int i = 0; i < n; i++) {
        exact_area2(weight, term[i].area);
        mpq_add(sum, sum, weight);
        for (int c = 0; c < 2; c++) {
            mpq_set_d(product, x[term[i].vertex][c]);
            mpq_mul(product, product, weight);
            mpq_add(p[c], p[c], product);
        }
    }
    for (int c = 0; c < 2; c++) mpq_div(p[c], p[c], sum);
    mpq_clears(weight, sum, product, NULL);
}

static struct dd difference(const double *a, const double *b, int c) {
    return dd_two_sum(a[c], -b[c]);
}

/* Twice the area; adds the products' magnitudes to *size. */
static struct dd area2(const double *const p[3], double *size) {
    struct dd l = dd_mul(difference(p[1], p[0], 0), difference(p[2], p[0], 1));
    struct dd r = dd_mul(difference(p[1], p[0], 1), difference(p[2], p[0], 0));
    *size += fabs(l.hi) + fabs(r.hi);
    return dd_add(l, dd_negate(r));
}

void overlay_place(const struct overlay_mesh mesh[2], const struct overlay_vertex *v, int m,
                   const double (*x)[2], double p[2]) {
    struct term term[3];
    int n = terms_of(mesh, v, m, term);
    struct dd weight[3], sum = {0, 0};
    double size = 0;
    const double *origin = x[term[0].vertex];
    memcpy(p, origin, 2 * sizeof *p);
    if (n == 1) return;
    for (int i = 0; i < n; i++) {
        weight[i] = area2(term[i].area, &size);
        sum = dd_add(sum, weight[i]);
    }
    if (!(0x1p-44 * size < fabs(sum.hi) && fabs(sum.hi) > 0x1p-900)) {
        mpq_t exact[2];
        mpq_inits(exact[0], exact[1], NULL);
        overlay_place_exact(mesh, v, m, x, exact);
        for (int c = 0; c < 2; c++) p[c] = rational_round(exact[c]);
        mpq_clears(exact[0], exact[1], NULL);
        return;
    }
    for (int i = 1; i < n; i++)
        for (int c = 0; c < 2; c++)
            p[c] += weight[i].hi / sum.hi * (x[term[i].vertex][c] - origin[c]);
}
