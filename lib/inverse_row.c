/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A patch is kept as the polynomial of its displacement in powers of u and v, local coordinates
 * with |u|, |v| <= 1 on the triangle:
 *
 *   phi(p) = p + D(u, v),    D = sum c_ij u^i v^j,    i + j <= degree
 *
 * That loses 4^degree ulp of D at most, so it is done up to degree 7 only. */
#include "inverse_row.h"

#include "mem.h"

#include <math.h>
#include <string.h>

enum {
    DEGREE_MAX = 7,
    SIZE_MAX_ = (DEGREE_MAX + 1) * (DEGREE_MAX + 2) / 2,
    SLOTS_MAX = 4096,
    STEPS_MAX = 4,   /* of Newton's method, and */
    CROSSED_MAX = 4, /* triangles gone through, for one point */
    ALIKE = 4,       /* points in a triangle that make it worth while to prepare it */
};

/* Local coordinates for which `lipschitz` holds, and how far from its end a step may begin. */
#define REACH    1.25
#define STEP_MAX (1.0 / 64)

/* Both components at once; what compilers make of it is the same as of each by itself. */
typedef double pair __attribute__((vector_size(16)));

static inline pair both(double x) {
    return (pair){x, x};
}

struct inverse_patch {
    uint32_t triangle;
    bool still[2];          /* coordinates that the whole patch does not move */
    double centre[2], unit; /* (u, v) = (p - centre) * unit */
    double lipschitz;       /* of the derivative of phi; world units */
    double bary[3][3];      /* b_l = bary[l][0] + bary[l][1] u + bary[l][2] v */
    pair power[SIZE_MAX_];  /* c_ij, i ascending, then j */
};

/* ---- patches */

static void place_patch(struct inverse_patch *patch, const struct inverse *v) {
    const uint32_t *corner = v->spline->grid.triangle[patch->triangle];
    double local[3][2], most = 0, area;
    for (int k = 0; k < 2; k++)
        patch->centre[k] =
            (v->vertex[corner[0]][k] + v->vertex[corner[1]][k] + v->vertex[corner[2]][k]) / 3;
    for (int l = 0; l < 3; l++)
        for (int k = 0; k < 2; k++) {
            local[l][k] = v->vertex[corner[l]][k] - patch->centre[k];
            most = fmax(most, fabs(local[l][k]));
        }
    patch->unit = 1 / most;
    for (int i = 0; i < 6; i++) local[i / 2][i % 2] *= patch->unit;
    area = (local[1][0] - local[0][0]) * (local[2][1] - local[0][1]) -
           (local[1][1] - local[0][1]) * (local[2][0] - local[0][0]);
    for (int l = 0; l < 3; l++) {
        const double *m = local[(l + 1) % 3], *n = local[(l + 2) % 3];
        patch->bary[l][0] = (m[0] * n[1] - m[1] * n[0]) / area;
        patch->bary[l][1] = (m[1] - n[1]) / area;
        patch->bary[l][2] = (n[0] - m[0]) / area;
    }
}

/* A polynomial in u and v, and in how many terms u^i v^j, i + j <= order, it may be. */
typedef double polynomial[SIZE_MAX_][2];

static int term(int degree, int i, int j) {
    return j * (degree + 1) - j * (j - 1) / 2 + i;
}

/* to += b * from, for b = bary[0] + bary[1] u + bary[2] v. */
static void add_product(polynomial to, const double bary[3], polynomial from, int order,
                        int degree) {
    for (int j = 0; j <= order; j++)
        for (int i = 0; i + j <= order; i++)
            for (int k = 0; k < 2; k++) {
                double c = from[term(degree, i, j)][k];
                to[term(degree, i, j)][k] += bary[0] * c;
                to[term(degree, i + 1, j)][k] += bary[1] * c;
                to[term(degree, i, j + 1)][k] += bary[2] * c;
            }
}

/* De Casteljau's scheme, in which b0, b1, b2 are polynomials instead of numbers. */
static void expand(struct inverse_patch *patch, int degree, polynomial *net) {
    for (int order = 0; order < degree; order++)
        for (int t = 0; t < degree - order; t++)
            for (int k = 0; k <= t; k++) {
                int here = t * (t + 1) / 2 + k, next = here + t + 1;
                polynomial sum = {{0}};
                add_product(sum, patch->bary[0], net[here], order, degree);
                add_product(sum, patch->bary[1], net[next], order, degree);
                add_product(sum, patch->bary[2], net[next + 1], order, degree);
                memcpy(net[here], sum, sizeof sum);
            }
    memcpy(patch->power, net[0], sizeof patch->power);
}

/* A bound of the norm of D's second derivative for |u|, |v| <= REACH. */
static void bound_derivative(struct inverse_patch *patch, int degree) {
    double sum = 0;
    for (int j = 0; j <= degree; j++)
        for (int i = 0; i + j <= degree; i++) {
            pair c = patch->power[term(degree, i, j)];
            double size = fabs(c[0]) + fabs(c[1]);
            for (int n = 2; n < i + j; n++) size *= REACH;
            sum += size * (i * (i - 1) + 2 * i * j + j * (j - 1));
        }
    patch->lipschitz = sum * patch->unit * patch->unit * (1 + 0x1p-20);
}

static void make_patch(struct inverse_patch *patch, const struct inverse_row *r, uint32_t t) {
    const struct spline *s = r->spline.spline;
    size_t components = s->sigma ? 4 : 2;
    int degree = s->grid.degree, n = grid_patch_size(degree);
    uint32_t points[GRID_PATCH_MAX];
    polynomial net[SIZE_MAX_] = {{{0}}};
    patch->triangle = t;
    place_patch(patch, r->cursor.inverse);
    grid_patch(&s->grid, t, points);
    for (int k = 0; k < 2; k++) {
        patch->still[k] = true;
        for (int i = 0; i < n; i++) {
            net[i][0][k] = r->spline.shift[components * points[i] + (size_t)k];
            patch->still[k] = patch->still[k] && net[i][0][k] == 0;
        }
    }
    expand(patch, degree, net);
    bound_derivative(patch, degree);
}

/* The patch of triangle t; NULL: it is not worth while. */
static const struct inverse_patch *patch_of(struct inverse_row *r, uint32_t t) {
    struct inverse_patch *patch = &r->patch[t & (r->slots - 1)];
    if (patch->triangle == t) return patch;
    if (r->last != t || r->alike < ALIKE) return NULL;
    make_patch(patch, r, t);
    return patch;
}

/* D and its derivatives by u and v. A constant degree lets the compiler unroll all loops. */
static inline __attribute__((always_inline)) void evaluate(const pair *power, int degree, double u,
                                                           double v, pair d[3]) {
    const pair uu = both(u), vv = both(v);
    const pair *row = power + term(degree, 0, degree);
    d[0] = *row;
    d[1] = d[2] = both(0);
#pragma GCC unroll 8
    for (int j = degree - 1; j >= 0; j--) {
        pair x, dx;
        int n = degree - j;
        row -= n + 1;
        dx = row[n];
        x = row[n] * uu + row[n - 1];
#pragma GCC unroll 8
        for (int i = n - 2; i >= 0; i--) {
            dx = dx * uu + x;
            x = x * uu + row[i];
        }
        d[2] = d[2] * vv + d[0];
        d[1] = d[1] * vv + dx;
        d[0] = d[0] * vv + x;
    }
}

static inline void evaluate_patch(const struct inverse_patch *patch, int degree, double u, double v,
                                  pair d[3]) {
    if (degree == 5)
        evaluate(patch->power, 5, u, v, d);
    else if (degree == 6)
        evaluate(patch->power, 6, u, v, d);
    else
        evaluate(patch->power, degree, u, v, d);
}

/* ---- Newton's method */

enum outcome { FAILED, FOUND, NOT_YET };

/* One step from spot->p; sets the derivative of the inverse there. */
static enum outcome step(const struct inverse_row *r, const struct inverse_patch *patch, int degree,
                         const double q[2], struct inverse_spot *spot) {
    double *p = spot->p, (*g)[2] = spot->derivative;
    double u = (p[0] - patch->centre[0]) * patch->unit, v = (p[1] - patch->centre[1]) * patch->unit;
    double a, b, c, e, det, x, y, dx, dy, inverse2, length2, h2;
    pair d[3];
    if (!(fabs(u) < REACH - STEP_MAX && fabs(v) < REACH - STEP_MAX)) return FAILED;
    evaluate_patch(patch, degree, u, v, d);
    a = 1 + d[1][0] * patch->unit;
    b = d[2][0] * patch->unit;
    c = d[1][1] * patch->unit;
    e = 1 + d[2][1] * patch->unit;
    det = a * e - b * c;
    if (!(det > 0)) return FAILED;
    det = 1 / det;
    g[0][0] = e * det;
    g[0][1] = -b * det;
    g[1][0] = -c * det;
    g[1][1] = a * det;
    x = (p[0] - q[0]) + d[0][0];
    y = (p[1] - q[1]) + d[0][1];
    dx = g[0][0] * x + g[0][1] * y;
    dy = g[1][0] * x + g[1][1] * y;
    p[0] -= dx;
    p[1] -= dy;
    inverse2 = g[0][0] * g[0][0] + g[0][1] * g[0][1] + g[1][0] * g[1][0] + g[1][1] * g[1][1];
    length2 = dx * dx + dy * dy;
    h2 = inverse2 * patch->lipschitz * patch->lipschitz * length2;
    if (!(h2 <= 1.0 / 16 && length2 * patch->unit * patch->unit <= STEP_MAX * STEP_MAX / 4))
        return FAILED;
    return 4 * h2 * length2 <= r->tolerance * r->tolerance ? FOUND : NOT_YET;
}

/* The edge that has p on its other side; 3: none. */
static int edge_crossed(const struct inverse_patch *patch, const double p[2]) {
    double u = (p[0] - patch->centre[0]) * patch->unit, v = (p[1] - patch->centre[1]) * patch->unit;
    double least = 0;
    int edge = 3;
    for (int l = 0; l < 3; l++) {
        double b = patch->bary[l][0] + patch->bary[l][1] * u + patch->bary[l][2] * v;
        if (b < least) {
            least = b;
            edge = l;
        }
    }
    return edge;
}

static bool solve_patch(const struct inverse_row *r, const struct inverse_patch *patch, int degree,
                        const double q[2], struct inverse_spot *spot) {
    for (int i = 0; i < STEPS_MAX; i++) {
        enum outcome outcome = step(r, patch, degree, q, spot);
        if (outcome == FOUND) return true;
        if (outcome == FAILED) return false;
    }
    return false;
}

/* Goes from spot->p, in spot->triangle, to the preimage of q, through a few triangles. */
static bool follow(struct inverse_row *r, const double q[2], struct inverse_spot *spot) {
    const struct grid *g = &r->spline.spline->grid;
    for (int i = 0; i < CROSSED_MAX; i++) {
        const struct inverse_patch *patch = patch_of(r, spot->triangle);
        const uint32_t *sides;
        int edge;
        if (!patch || !solve_patch(r, patch, g->degree, q, spot)) return false;
        edge = edge_crossed(patch, spot->p);
        if (edge == 3) {
            for (int k = 0; k < 2; k++)
                if (patch->still[k]) spot->p[k] = q[k];
            return true;
        }
        sides = g->edge_triangle[g->triangle_edge[spot->triangle][edge]];
        spot->triangle = sides[0] == spot->triangle ? sides[1] : sides[0];
        if (spot->triangle == GRID_NONE) return false;
    }
    return false;
}

/* Where the `known` points before let the preimage be expected. Of four, the last one is not used,
 * so that the processor can begin with a point before it has ended with the last. */
static void expect(const double q[2][2], int known, struct inverse_spot *spot) {
    const struct inverse_spot *past = spot - 1;
    *spot = *past;
    for (int k = 0; k < 2; k++) {
        double x1 = past[0].p[k];
        if (known >= 4)
            spot->p[k] = 6 * past[-1].p[k] - 8 * past[-2].p[k] + 3 * past[-3].p[k];
        else if (known == 3)
            spot->p[k] = 3 * (x1 - past[-1].p[k]) + past[-2].p[k];
        else if (known == 2)
            spot->p[k] = 2 * x1 - past[-1].p[k];
        else
            spot->p[k] += past->derivative[k][0] * (q[1][0] - q[0][0]) +
                          past->derivative[k][1] * (q[1][1] - q[0][1]);
    }
}

/* ---- all points */

/* By inverse_find. */
static void look_up(struct inverse_row *r, const double q[2], struct inverse_spot *spot) {
    struct place place;
    double value[3], jacobian[3][3], det;
    if (!inverse_find(&r->cursor, q, NULL, NULL, &place)) {
        *spot = (struct inverse_spot){.triangle = GRID_NONE};
        return;
    }
    spot->triangle = place.triangle;
    inverse_point(r->cursor.inverse, q, &place, spot->p);
    spline_cursor_evaluate(&r->spline, place.triangle, place.b,
                           (const double[3]){spot->p[0], spot->p[1], 0}, value, jacobian);
    det = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
    spot->derivative[0][0] = jacobian[1][1] / det;
    spot->derivative[0][1] = -jacobian[0][1] / det;
    spot->derivative[1][0] = -jacobian[1][0] / det;
    spot->derivative[1][1] = jacobian[0][0] / det;
}

void inverse_row_find(struct inverse_row *r, size_t n, const double (*q)[2],
                      struct inverse_spot *spot) {
    int known = 0; /* points before this one that have preimages, without a gap */
    for (size_t i = 0; i < n; i++) {
        bool found = false;
        if (r->patch && known > 0) {
            expect(q + i - 1, known, &spot[i]);
            found = follow(r, q[i], &spot[i]);
        }
        if (!found) look_up(r, q[i], &spot[i]);
        known = spot[i].triangle == GRID_NONE ? 0 : known + (known < 4);
        r->alike = spot[i].triangle == r->last ? r->alike + (r->alike < ALIKE) : 1;
        r->last = spot[i].triangle;
    }
}

bool inverse_row_init(struct inverse_row *r, const struct inverse *v, double tolerance,
                      struct err *err) {
    *r = (struct inverse_row){.tolerance = tolerance, .slots = 1};
    while (r->slots < v->spline->grid.triangle_count && r->slots < SLOTS_MAX) r->slots *= 2;
    if (!inverse_cursor_init(&r->cursor, v, err) ||
        !spline_cursor_init(&r->spline, v->spline, err) ||
        (v->one_to_one && v->spline->grid.degree <= DEGREE_MAX &&
         !mem_new(r->patch, r->slots, err))) {
        inverse_row_free(r);
        return false;
    }
    for (uint32_t i = 0; r->patch && i < r->slots; i++) r->patch[i].triangle = GRID_NONE;
    return true;
}

void inverse_row_free(struct inverse_row *r) {
    inverse_cursor_free(&r->cursor);
    spline_cursor_free(&r->spline);
    free(r->patch);
    *r = (struct inverse_row){0};
}
