/* SPDX-License-Identifier: GPL-3.0-or-later */
/* At a fixed place, det is a quadratic in the share: three values give it, and its first root is
 * the first loss there. */
#include "folding.h"

#include "testing.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The components that matter: x and y, or the thickness. */
static double component(const struct spline *s, bool thickness, uint32_t p, int c) {
    return thickness ? s->sigma[p][1 - c] : s->phi[p][c];
}

/* ---- exactly ---- */

/* (1-s) from + s to */
static void blend(const struct folding *f, uint32_t p, int c, const mpq_t s, mpq_t to) {
    mpq_t from;
    mpq_init(from);
    mpq_set_d(from, component(f->from, f->thickness, p, c));
    mpq_set_d(to, component(f->to, f->thickness, p, c));
    mpq_sub(to, to, from);
    mpq_mul(to, to, s);
    mpq_add(to, to, from);
    mpq_clear(from);
}

/* One step of de Casteljau, from rows 0..d to rows 0..d-1. */
static void reduce(mpq_t *v, int d, const mpq_t b[3]) {
    mpq_t sum, term;
    mpq_inits(sum, term, NULL);
    for (int r = 0; r < d; r++)
        for (int k = 0; k <= r; k++) {
            int i = r * (r + 1) / 2 + k, of[3] = {i, i + r + 1, i + r + 2};
            mpq_set_ui(sum, 0, 1);
            for (int l = 0; l < 3; l++) {
                mpq_mul(term, v[of[l]], b[l]);
                mpq_add(sum, sum, term);
            }
            mpq_set(v[i], sum);
        }
    mpq_clears(sum, term, NULL);
}

static void value_of_plane(const struct folding *f, mpq_t (*v)[GRID_PATCH_MAX], mpq_t value) {
    const struct grid *g = &f->from->grid;
    const uint32_t *t = g->triangle[f->triangle];
    mpq_t x;
    mpq_init(x);
    for (int c = 0; c < 2; c++)
        for (int l = 1; l < 3; l++) mpq_sub(v[c][l], v[c][l], v[c][0]);
    mpq_mul(value, v[0][1], v[1][2]);
    mpq_mul(x, v[1][1], v[0][2]);
    mpq_sub(value, value, x);
    mpq_set_ui(x, (unsigned long)(g->degree * g->degree), 1);
    mpq_mul(value, value, x);
    mpq_set_d(x, (double)predicate_area2(g->vertex[t[0]], g->vertex[t[1]], g->vertex[t[2]]));
    mpq_div(value, value, x);
    mpq_set_d(x, g->lattice.step);
    mpq_div(value, value, x);
    mpq_div(value, value, x);
    mpq_clear(x);
}

static void value_of_thickness(const struct folding *f, mpq_t (*v)[GRID_PATCH_MAX], mpq_t value) {
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    mpq_set_d(a, f->from->grid.depth[0]);
    mpq_set_d(b, f->from->grid.depth[1]);
    mpq_sub(b, b, a);
    mpq_sub(value, v[0][0], v[1][0]); /* top, bottom */
    mpq_div(value, value, b);
    mpq_clears(a, b, NULL);
}

void folding_value(const struct folding *f, const mpq_t s, const mpq_t b[3], mpq_t value) {
    const struct grid *g = &f->from->grid;
    mpq_t v[2][GRID_PATCH_MAX];
    uint32_t q[GRID_PATCH_MAX];
    int n = grid_patch_size(g->degree);
    grid_patch(g, f->triangle, q);
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i < n; i++) {
            mpq_init(v[c][i]);
            blend(f, q[i], c, s, v[c][i]);
        }
        for (int d = g->degree; d > (f->thickness ? 0 : 1); d--) reduce(v[c], d, b);
    }
    if (f->thickness)
        value_of_thickness(f, v, value);
    else
        value_of_plane(f, v, value);
    for (int c = 0; c < 2; c++)
        for (int i = 0; i < n; i++) mpq_clear(v[c][i]);
}

int folding_sign_of_text(const struct spline *from, const struct spline *to, const char *text,
                         double s, double margin) {
    const char *triangle = strstr(text, "triangle "), *place = strstr(text, " at (");
    struct folding f = {from, to, strstr(text, "sigma") != NULL, 0};
    mpq_t b[3], share, value, least;
    mpz_t sum;
    int sign;
    mpz_init(sum);
    mpq_inits(b[0], b[1], b[2], share, value, least, NULL);
    if (!triangle || !place || sscanf(triangle, "triangle %" SCNu32, &f.triangle) != 1 ||
        gmp_sscanf(place, " at (%Zd %Zd %Zd)/%Zd = ", mpq_numref(b[0]), mpq_numref(b[1]),
                   mpq_numref(b[2]), sum) != 4)
        fail_msg("no place in: %s", text);
    for (int l = 0; l < 3; l++) {
        assert_true(mpz_sgn(mpq_numref(b[l])) >= 0);
        mpz_set(mpq_denref(b[l]), sum);
        mpq_canonicalize(b[l]);
    }
    mpq_add(value, b[0], b[1]);
    mpq_add(value, value, b[2]);
    assert_true(mpq_cmp_ui(value, 1, 1) == 0);
    mpq_set_d(share, s);
    mpq_set_d(least, margin);
    folding_value(&f, share, (const mpq_t *)b, value);
    sign = mpq_cmp(value, least);
    mpz_clear(sum);
    mpq_clears(b[0], b[1], b[2], share, value, least, NULL);
    return sign;
}

/* ---- samples ---- */

struct net {
    int degree;
    bool thickness;
    long double scale;
    long double v[2][3][GRID_PATCH_MAX]; /* components at shares 0, 1/2, 1 */
};

static void fill_net(struct net *net, const struct folding *f) {
    const struct grid *g = &f->from->grid;
    const uint32_t *t = g->triangle[f->triangle];
    long double d = g->degree, step = (long double)g->lattice.step;
    uint32_t q[GRID_PATCH_MAX];
    grid_patch(g, f->triangle, q);
    net->degree = g->degree;
    net->thickness = f->thickness;
    net->scale =
        f->thickness
            ? 1 / ((long double)g->depth[1] - (long double)g->depth[0])
            : d * d /
                  ((long double)predicate_area2(g->vertex[t[0]], g->vertex[t[1]], g->vertex[t[2]]) *
                   step * step);
    for (int c = 0; c < 2; c++)
        for (int i = 0; i < grid_patch_size(g->degree); i++) {
            long double from = (long double)component(f->from, f->thickness, q[i], c);
            long double to = (long double)component(f->to, f->thickness, q[i], c);
            net->v[c][0][i] = from;
            net->v[c][1][i] = (from + to) / 2;
            net->v[c][2][i] = to;
        }
}

/* Reduces to degree `left` at b; the first values of v are the result. */
static void casteljau(int degree, int left, const long double *from, const double b[3],
                      long double *v) {
    memcpy(v, from, (size_t)grid_patch_size(degree) * sizeof *v);
    for (int d = degree; d > left; d--)
        for (int r = 0; r < d; r++)
            for (int k = 0; k <= r; k++) {
                int i = r * (r + 1) / 2 + k;
                v[i] = (long double)b[0] * v[i] + (long double)b[1] * v[i + r + 1] +
                       (long double)b[2] * v[i + r + 2];
            }
}

static long double value_at(const struct net *net, int h, const double b[3]) {
    long double x[GRID_PATCH_MAX], y[GRID_PATCH_MAX];
    int left = net->thickness ? 0 : 1;
    casteljau(net->degree, left, net->v[0][h], b, x);
    casteljau(net->degree, left, net->v[1][h], b, y);
    if (net->thickness) return net->scale * (x[0] - y[0]);
    return net->scale * ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));
}

/* The first share at which the value at b is the margin or less. */
static double loss_at(const struct net *net, double margin, const double b[3]) {
    long double f[3], linear, square, root;
    for (int h = 0; h < 3; h++) f[h] = value_at(net, h, b) - (long double)margin;
    if (f[0] <= 0) return 0;
    square = 2 * f[0] - 4 * f[1] + 2 * f[2];
    linear = f[2] - f[0] - square;
    root = linear * linear - 4 * square * f[0];
    if (root < 0) return INFINITY;
    root = -linear + sqrtl(root);
    if (root <= 0 || 2 * f[0] > root) return INFINITY;
    return (double)(2 * f[0] / root);
}

/* Walks downhill from b, with steps that shrink. */
static double refine(const struct net *net, double margin, double b[3], double loss, double step) {
    for (; step > 1e-7; step /= 2)
        for (bool moved = true; moved;) {
            moved = false;
            for (int way = 0; way < 6; way++) {
                double near[3] = {b[0], b[1], b[2]}, own;
                near[way % 3] += step;
                near[(way + 1 + way / 3) % 3] -= step;
                if (near[0] < 0 || near[1] < 0 || near[2] < 0) continue;
                own = loss_at(net, margin, near);
                if (!(own < loss)) continue;
                loss = own;
                memcpy(b, near, sizeof near);
                moved = true;
            }
        }
    return loss;
}

double folding_first_loss(const struct folding *f, double margin, int n) {
    struct net net;
    double best = INFINITY, at[3] = {1, 0, 0};
    fill_net(&net, f);
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++) {
            double b[3] = {(double)i / n, (double)j / n, (double)(n - i - j) / n};
            double loss = loss_at(&net, margin, b);
            if (!(loss < best)) continue;
            best = loss;
            memcpy(at, b, sizeof at);
        }
    return best < INFINITY ? refine(&net, margin, at, best, 0.5 / n) : best;
}
