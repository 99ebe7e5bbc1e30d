/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch holds the displacements of the control points of one triangle, q - nominal position and
 * sigma0 - a, sigma1 - b: n = 2 or 4 components. D being its Bernstein sum at b,
 *
 *     psi(x,y,z) = (x + D0, y + D1, z + a0 D2 + a1 D3),   since a0 a + a1 b = z,
 *
 * and, G_l = dD/db_l, the gradient of D in the plane is sum G_l grad b_l, where
 *
 *     grad b_l = (Y_m - Y_n, X_n - X_m) / (step * 2A),   l, m, n = the corners in their turn. */
#include "spline.h"

#include "bernstein.h"
#include "mem.h"
#include "place.h"

enum { COMPONENTS_MAX = 4 };

static int components(const struct spline *s) {
    return s->sigma ? 4 : 2;
}

/* The displacement of control point p. */
static void displacement(const struct spline *s, uint32_t p, double *shift) {
    double nominal[2];
    grid_nominal(&s->grid, p, nominal);
    for (int m = 0; m < 2; m++) {
        shift[m] = s->phi[p][m] - nominal[m];
        if (s->sigma) shift[2 + m] = s->sigma[p][m] - s->grid.depth[m];
    }
}

/* p + shift; p itself, even -0, where nothing moves. */
static double moved(double p, double shift) {
    return shift == 0 ? p : p + shift;
}

/* gradient[l] = grad b_l in world units. */
static void barycentric_gradients(const struct grid *g, uint32_t t, double gradient[3][2]) {
    const int32_t *v[3];
    double scale;
    for (int l = 0; l < 3; l++) v[l] = g->vertex[g->triangle[t][l]];
    scale = g->lattice.step * (double)predicate_area2(v[0], v[1], v[2]);
    for (int l = 0; l < 3; l++) {
        const int32_t *m = v[(l + 1) % 3], *n = v[(l + 2) % 3];
        gradient[l][0] = (m[1] - n[1]) / scale;
        gradient[l][1] = (n[0] - m[0]) / scale;
    }
}

/* The derivative from G; D and the weights a0, a1 as in the formula at the top. */
static void derivative(const struct spline *s, uint32_t t, const double *gradient, const double *d,
                       const double a[2], double jacobian[3][3]) {
    int n = components(s);
    double bary[3][2], plane[COMPONENTS_MAX][2] = {{0}};
    barycentric_gradients(&s->grid, t, bary);
    for (int m = 0; m < n; m++)
        for (int c = 0; c < 2; c++)
            for (int l = 0; l < 3; l++) plane[m][c] += gradient[n * l + m] * bary[l][c];
    for (int c = 0; c < 2; c++) {
        for (int r = 0; r < 2; r++) jacobian[r][c] = plane[r][c] + (r == c);
        jacobian[2][c] = s->sigma ? a[0] * plane[2][c] + a[1] * plane[3][c] : 0;
        jacobian[c][2] = 0;
    }
    jacobian[2][2] = 1;
    if (s->sigma) jacobian[2][2] += (d[3] - d[2]) / (s->grid.depth[1] - s->grid.depth[0]);
}

static void evaluate_patch(const struct spline *s, uint32_t t, const double *patch,
                           const double b[3], const double p[3], double value[3],
                           double jacobian[3][3]) {
    int degree = s->grid.degree, n = components(s);
    double d[COMPONENTS_MAX], gradient[3 * COMPONENTS_MAX], a[2] = {0, 0};
    if (jacobian)
        bernstein_gradient(degree, n, patch, b, d, gradient);
    else
        bernstein_value(degree, n, patch, b, d);
    value[0] = moved(p[0], d[0]);
    value[1] = moved(p[1], d[1]);
    value[2] = p[2];
    if (s->sigma) {
        depth_weights(s->grid.depth, p[2], a);
        value[2] = moved(p[2], a[0] * d[2] + a[1] * d[3]);
    }
    if (jacobian) derivative(s, t, gradient, d, a, jacobian);
}

void spline_evaluate(const struct spline *s, uint32_t t, const double b[3], const double p[3],
                     double value[3], double jacobian[3][3]) {
    uint32_t points[GRID_PATCH_MAX];
    double patch[GRID_PATCH_MAX * COMPONENTS_MAX];
    grid_patch(&s->grid, t, points);
    for (int i = 0; i < grid_patch_size(s->grid.degree); i++)
        displacement(s, points[i], patch + i * components(s));
    evaluate_patch(s, t, patch, b, p, value, jacobian);
}

bool spline_cursor_init(struct spline_cursor *c, const struct spline *s, struct err *err) {
    size_t n = (size_t)components(s);
    *c = (struct spline_cursor){.spline = s, .triangle = GRID_NONE};
    if (!mem_new(c->shift, n * s->grid.point_count, err) ||
        !mem_new(c->patch, n * GRID_PATCH_MAX, err)) {
        spline_cursor_free(c);
        return false;
    }
    for (uint32_t p = 0; p < s->grid.point_count; p++) displacement(s, p, c->shift + n * p);
    return true;
}

void spline_cursor_free(struct spline_cursor *c) {
    free(c->shift);
    free(c->patch);
    *c = (struct spline_cursor){0};
}

static void load(struct spline_cursor *c, uint32_t t) {
    const struct grid *g = &c->spline->grid;
    uint32_t points[GRID_PATCH_MAX];
    int n = components(c->spline);
    grid_patch(g, t, points);
    for (int i = 0; i < grid_patch_size(g->degree); i++)
        for (int m = 0; m < n; m++)
            c->patch[i * n + m] = c->shift[(size_t)points[i] * (size_t)n + (size_t)m];
    c->triangle = t;
}

void spline_cursor_evaluate(struct spline_cursor *c, uint32_t t, const double b[3],
                            const double p[3], double value[3], double jacobian[3][3]) {
    if (c->triangle != t) load(c, t);
    evaluate_patch(c->spline, t, c->patch, b, p, value, jacobian);
}

void spline_cursor_shift(struct spline_cursor *c, uint32_t t, const double b[3], double *shift) {
    const struct spline *s = c->spline;
    if (c->triangle != t) load(c, t);
    bernstein_value(s->grid.degree, components(s), c->patch, b, shift);
}
