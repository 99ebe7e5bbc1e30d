/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is found is judged by the defining sum in long double; maps are polynomials that are known
 * to be one-to-one, or have a closed inverse, edited C1 splines, or random nets that fold, where
 * dense subdivision tells which triangles have a preimage. An ulp is one of the largest coordinate
 * of control points or domain. */
#include "inverse.h"

#include "editing.h"
#include "injective.h"
#include "mem.h"
#include "polynomials.h"
#include "testing.h"
#include "triangulations.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct world {
    struct spline s;
    struct inverse v;
    struct inverse_cursor c;
    struct locator l;
    double ulp;
    uint64_t seed;
    long double residual, trip; /* the largest, in ulps and in ulps over singular values */
};

static double largest(const double (*x)[2], uint32_t n) {
    double most = 0;
    for (uint32_t i = 0; i < n; i++) most = fmax(most, fmax(fabs(x[i][0]), fabs(x[i][1])));
    return most;
}

/* Takes the spline over. */
static void open_world(struct world *w, struct spline *s, bool one_to_one, uint64_t seed) {
    struct err err = {0};
    int e;
    *w = (struct world){.s = *s, .seed = seed};
    check_seed(seed, inverse_init(&w->v, &w->s, one_to_one, &err));
    check_seed(seed, inverse_cursor_init(&w->c, &w->v, &err));
    check_seed(seed, locator_init(&w->l, &w->s.grid, &err));
    (void)frexp(fmax(largest((const double(*)[2])w->s.phi, w->s.grid.point_count),
                     largest((const double(*)[2])w->v.vertex, w->s.grid.vertex_count)),
                &e);
    w->ulp = ldexp(1, e - 53);
}

/* The polynomial map f on the grid, which is taken over; NULL: the identity. */
static void open_map(struct world *w, struct grid *g, const struct polynomial *f, bool one_to_one,
                     uint64_t seed) {
    struct spline s;
    polynomial_spline(&s, g, f);
    open_world(w, &s, one_to_one, seed);
}

static void close_world(struct world *w) {
    locator_free(&w->l);
    inverse_cursor_free(&w->c);
    inverse_free(&w->v);
    spline_free(&w->s);
}

/* A grid of the square [-2,2]^2 or part of it. */
static void small_grid(struct grid *g, int size, int degree, uint64_t seed) {
    random_grid(g, size, degree, seed);
    g->lattice = (struct lattice){0x1p-10, -1, -2};
}

/* The same with a straight lower edge, y = -2. */
static void straight_grid(struct grid *g, int degree, uint64_t seed) {
    uint64_t s = seed;
    struct recipe r = {.nx = (int)random_in(&s, 1, 3),
                       .ny = (int)random_in(&s, 1, 3),
                       .spacing = 1000,
                       .crossed = random_in(&s, 0, 1),
                       .flips = 1,
                       .shuffled = true};
    struct err err = {0};
    triangulate(g, &r, degree, seed);
    check_seed(seed, grid_build(g, &err));
    g->lattice = (struct lattice){0x1p-10, -1, -2};
}

static void sum_at_place(const struct spline *s, const struct place *place, long double f[2],
                         long double jacobian[2][2]) {
    long double b[3] = {0, place->b[1], place->b[2]};
    b[0] = 1 - b[1] - b[2];
    sum_at(s, place->triangle, b, f, jacobian);
}

/* What is found must be a place, and map to q, which is at most `off` ulps off the image. */
static void check_place(struct world *w, const double q[2], long double off,
                        const struct place *place) {
    const double *b = place->b;
    long double f[2], away;
    check_seed(w->seed, place->triangle < w->s.grid.triangle_count);
    check_seed(w->seed, b[0] + b[1] + b[2] == 1);
    for (int l = 0; l < 3; l++) check_seed(w->seed, b[l] >= 0 && b[l] <= 1);
    sum_at_place(&w->s, place, f, NULL);
    away = hypotl(f[0] - q[0], f[1] - q[1]) / w->ulp;
    check_seed(w->seed, away <= 4 || away <= 1 + 1.75L * off);
    if (away > w->residual) w->residual = away;
}

/* p in the world, and what it maps to as programs compute it; false: outside by rounding. */
static bool image(struct world *w, const double xy[2], double q[2], struct place *place) {
    double p[3] = {xy[0], xy[1], 0}, value[3];
    uint32_t hint = 0;
    if (!locate(&w->l, p, &hint, &place->triangle, place->b)) return false;
    spline_evaluate(&w->s, place->triangle, place->b, p, value, NULL);
    q[0] = value[0];
    q[1] = value[1];
    return true;
}

/* phi at a point of triangle t, by its coordinates. */
static void exact_image(const struct world *w, uint32_t t, const double p[2], long double f[2],
                        long double jacobian[2][2]) {
    const uint32_t *corner = w->s.grid.triangle[t];
    long double u[3][2], area, b[3];
    for (int l = 0; l < 3; l++) world_of(&w->s.grid, corner[l], u[l]);
    area = (u[1][0] - u[0][0]) * (u[2][1] - u[0][1]) - (u[1][1] - u[0][1]) * (u[2][0] - u[0][0]);
    b[1] = ((p[0] - u[0][0]) * (u[2][1] - u[0][1]) - (p[1] - u[0][1]) * (u[2][0] - u[0][0])) / area;
    b[2] = ((u[1][0] - u[0][0]) * (p[1] - u[0][1]) - (u[1][1] - u[0][1]) * (p[0] - u[0][0])) / area;
    b[0] = 1 - b[1] - b[2];
    sum_at(&w->s, t, b, f, jacobian);
}

/* Is the height of triangle t at least an eighth of its longest side? In needles, barycentric
 * coordinates of points, as rounded, are off by more ulps, and so are images. */
static bool is_well_shaped(const struct world *w, uint32_t t) {
    long double u[3][2], longest = 0, area;
    for (int l = 0; l < 3; l++) world_of(&w->s.grid, w->s.grid.triangle[t][l], u[l]);
    area = (u[1][0] - u[0][0]) * (u[2][1] - u[0][1]) - (u[1][1] - u[0][1]) * (u[2][0] - u[0][0]);
    for (int l = 0; l < 3; l++) {
        const long double *m = u[l], *n = u[(l + 1) % 3];
        longest = fmaxl(longest, hypotl(m[0] - n[0], m[1] - n[1]));
    }
    return area / longest >= longest / 8;
}

/* p -> phi(p) -> p, to within 8 ulp over the least singular value, and the rounding of p. */
static void round_trip(struct world *w, const double p[2]) {
    long double jacobian[2][2], least[2], most, f[2], away, off, rounding;
    double q[2], back[2];
    struct place place, found;
    if (!image(w, p, q, &place)) return;
    check_seed(w->seed, inverse_find(&w->c, q, NULL, NULL, &found));
    exact_image(w, place.triangle, p, f, jacobian);
    singular_values(jacobian, &least[0], &most);
    off = hypotl(f[0] - q[0], f[1] - q[1]) / w->ulp;
    check_place(w, q, off, &found);
    inverse_point(&w->v, q, &found, back);
    exact_image(w, found.triangle, back, f, jacobian);
    singular_values(jacobian, &least[1], &most);
    away = hypotl(back[0] - (long double)p[0], back[1] - (long double)p[1]);
    rounding = (fabs(p[0]) + fabs(p[1])) * 0x1p-53;
    away = (away - rounding) * fminl(least[0], least[1]) / w->ulp;
    check_seed(w->seed, away <= 8 || away <= 1 + 1.75L * off);
    if (!is_well_shaped(w, place.triangle)) return;
    check_seed(w->seed, away <= 8);
    w->trip = fmaxl(w->trip, away);
}

/* A point of a random triangle: inside, on an edge, or a corner, as rounded. */
static void random_point(const struct world *w, uint64_t *s, double p[2]) {
    const struct grid *g = &w->s.grid;
    const uint32_t *v = g->triangle[random_in(s, 0, g->triangle_count - 1)];
    double b[3] = {random_unit(s), random_unit(s), random_unit(s)};
    int kind = (int)random_in(s, 0, 5), l = (int)random_in(s, 0, 2);
    if (kind < 2) b[l] = 0;
    if (kind == 2) b[l] = b[(l + 1) % 3] = 0;
    if (kind == 3) b[l] *= 0x1p-48;
    for (int c = 0; c < 2; c++) {
        p[c] = 0;
        for (int k = 0; k < 3; k++) p[c] += b[k] / (b[0] + b[1] + b[2]) * w->v.vertex[v[k]][c];
    }
}

static void many_trips(struct world *w, int n) {
    uint64_t s = w->seed;
    for (int i = 0; i < n; i++) {
        double p[2];
        random_point(w, &s, p);
        round_trip(w, p);
    }
    for (uint32_t v = 0; v < w->s.grid.vertex_count && v < (uint32_t)n; v++)
        round_trip(w, w->v.vertex[v]);
}

/* ---- which triangles have a preimage, by subdivision */

enum { NET = (GRID_DEGREE_MAX + 1) * (GRID_DEGREE_MAX + 2) / 2 };

/* Halves the edge between the second and third corner: (first, second, middle), (first, middle,
 * third) turned so that another edge is next. */
static void split(int d, long double (*q)[2], long double (*a)[2], long double (*b)[2]) {
    for (int r = 0; r <= d; r++)
        for (int c = 0; c < 2; c++) {
            long double row[GRID_DEGREE_MAX + 1];
            for (int k = 0; k <= r; k++) row[k] = q[r * (r + 1) / 2 + k][c];
            for (int k = 0; k <= r; k++) { /* weights (d-r, r-k, k) on (first, second, middle) */
                int m = d - k; /* of the halves with the middle first: row is what is not on it */
                a[m * (m + 1) / 2 + r - k][c] = row[0];     /* (middle, first, second) */
                b[m * (m + 1) / 2 + d - r][c] = row[r - k]; /* (middle, third, first) */
                for (int n = 0; n < r - k; n++) row[n] = (row[n] + row[n + 1]) / 2;
            }
        }
}

/* Can the net take the value p, to within `tolerance`? Some 100 halvings answer that. */
static bool is_possible(int d, long double (*q)[2], const double p[2], double tolerance) {
    long double lo[2] = {HUGE_VALL, HUGE_VALL}, hi[2] = {-HUGE_VALL, -HUGE_VALL}, a[NET][2],
                b[NET][2];
    for (int i = 0; i < grid_patch_size(d); i++)
        for (int c = 0; c < 2; c++) {
            lo[c] = fminl(lo[c], q[i][c]);
            hi[c] = fmaxl(hi[c], q[i][c]);
        }
    for (int c = 0; c < 2; c++)
        if (p[c] < lo[c] - tolerance || p[c] > hi[c] + tolerance) return false;
    if (hi[0] - lo[0] < tolerance && hi[1] - lo[1] < tolerance) return true;
    split(d, q, a, b);
    return is_possible(d, a, p, tolerance) || is_possible(d, b, p, tolerance);
}

static bool may_hold(const struct spline *s, uint32_t t, const double p[2], double tolerance) {
    long double q[NET][2];
    uint32_t points[GRID_PATCH_MAX];
    grid_patch(&s->grid, t, points);
    for (int i = 0; i < grid_patch_size(s->grid.degree); i++)
        for (int c = 0; c < 2; c++) q[i][c] = s->phi[points[i]][c];
    return is_possible(s->grid.degree, q, p, tolerance);
}

/* The lowest triangle that has a preimage is found; none is found only if there is none. */
static void check_lowest(struct world *w, const double q[2]) {
    struct place found;
    bool inside = inverse_find(&w->c, q, NULL, NULL, &found);
    uint32_t end = inside ? found.triangle : w->s.grid.triangle_count;
    if (inside) check_place(w, q, 0, &found);
    for (uint32_t t = 0; t < end; t++) check_seed(w->seed, !may_hold(&w->s, t, q, 1e-12));
}

/* ---- maps that are one-to-one */

/* f as a linear map of two polynomials. */
static void combine(struct polynomial f[2], double m[2][2], double x, double y) {
    struct polynomial g[2] = {f[0], f[1]};
    for (int p = 0; p < TERMS; p++)
        for (int q = 0; q < TERMS; q++)
            for (int c = 0; c < 2; c++)
                f[c].c[p][q] = m[c][0] * g[0].c[p][q] + m[c][1] * g[1].c[p][q];
    f[0].c[0][0] += x;
    f[1].c[0][0] += y;
}

/* A map of [-2,2]^2 that is one-to-one: near the identity, then a linear one that may turn and
 * stretch. */
static void random_map(struct polynomial f[2], int degree, uint64_t *s) {
    double turn = random_unit(s) - 0.5, stretch = ldexp(1, (int)random_in(s, -4, 4));
    double m[2][2] = {{stretch, turn}, {-turn, 1}};
    for (int c = 0; c < 2; c++) {
        random_polynomial(&f[c], degree, s);
        f[c].c[c == 0][c == 1] += 1;
    }
    combine(f, m, random_unit(s), random_unit(s));
}

static void smooth_maps(void **unused) {
    long double residual = 0, trip = 0;
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        int degree = 1 + i % 9;
        struct polynomial f[2];
        struct world w;
        struct grid g;
        small_grid(&g, 4, degree, seed);
        random_map(f, (int)random_in(&s, 1, degree), &s);
        open_map(&w, &g, f, true, seed);
        many_trips(&w, 1000);
        for (int n = 0; n < 20; n++) {
            double q[2];
            for (int c = 0; c < 2; c++) {
                const struct cells_raster *r = &w.v.cells.raster;
                q[c] =
                    (r->lo[c] + (1.2 * random_unit(&s) - 0.1) * (r->hi[c] - r->lo[c])) / w.v.scale;
            }
            check_lowest(&w, q);
        }
        residual = fmaxl(residual, w.residual);
        trip = fmaxl(trip, w.trip);
        close_world(&w);
    }
    print_message("residual %.3Lg ulp, round trip %.3Lg ulp\n", residual, trip);
    (void)unused;
}

/* Images of n random points, by the defining sum and rounded once; `off` as in check_place. */
static void find_exact_images(struct world *w, uint64_t *s, int n, long double off) {
    for (int i = 0; i < n; i++) {
        double p[2], q[2];
        struct place place, found;
        long double exact[2];
        random_point(w, s, p);
        if (!image(w, p, q, &place)) continue;
        sum_at_place(&w->s, &place, exact, NULL);
        for (int c = 0; c < 2; c++) q[c] = (double)exact[c];
        check_seed(w->seed, inverse_find(&w->c, q, NULL, NULL, &found));
        check_place(w, q, off, &found);
    }
}

/* ---- needles: triangles whose height is 2^-24, or 2^-36, of their length */

static void needles(void **unused) {
    static const int32_t corner[][3][2] = {
        {{0, 0}, {1 << 24, 0}, {5, 1}},
        {{0, 0}, {1 << 24, 1 << 23}, {1 << 22, (1 << 21) + 1}},
        {{0, 0}, {1 << 24, 3}, {5591040, 1}},
        {{-(1 << 24), -(1 << 24)}, {1 << 24, (1 << 24) - 1}, {3, 4}},
    };
    int crude = 0;
    for (int i = 0; i < test_count(12); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct grid g = {.degree = 1 + i % 5,
                         .axes = {0, 1, 2},
                         .lattice = {0x1p-24, 0, 0},
                         .vertex_count = 3,
                         .triangle_count = 1};
        struct polynomial f[2];
        struct world w;
        struct err err;
        g.vertex = calloc(3, sizeof *g.vertex);
        g.triangle = calloc(1, sizeof *g.triangle);
        memcpy(g.vertex, corner[i % 4], sizeof corner[i % 4]);
        for (uint32_t l = 0; l < 3; l++) g.triangle[0][l] = l;
        assert_true(grid_build(&g, &err));
        random_map(f, g.degree, &s);
        open_map(&w, &g, f, true, seed);
        find_exact_images(&w, &s, 100, 8.5L);
        crude += w.residual > 4;
        close_world(&w);
    }
    assert_true(crude <= test_count(12) / 20);
    (void)unused;
}

/* ---- exact images: within 4 ulp of the control points, also where the domain is larger */

static void exact_images(void **unused) {
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        int degree = 1 + i % 15, e;
        double shrink[2][2] = {{0x1p-12, 0}, {0x1p-14, 0x1p-11}};
        struct polynomial f[2];
        struct world w;
        struct grid g;
        small_grid(&g, 3, degree, seed);
        random_map(f, degree < 6 ? degree : 6, &s);
        if (i % 2) combine(f, shrink, 0, 0);
        open_map(&w, &g, f, true, seed);
        (void)frexp(largest((const double(*)[2])w.s.phi, w.s.grid.point_count), &e);
        w.ulp = ldexp(1, e - 53);
        find_exact_images(&w, &s, 300, 0);
        close_world(&w);
    }
    (void)unused;
}

/* ---- closed forms */

/* Moves that are exact in doubles come back exactly, but for an ulp. */
static void affine_maps(void **unused) {
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        int degree = 1 + i % 6;
        long double m[2][2] = {{2, (long double)random_in(&s, -4, 4) / 4}, {-0.5L, 1.25L}}, det;
        struct polynomial f[2] = {{1, {{3, m[0][1]}, {m[0][0]}}}, {1, {{-1, m[1][1]}, {m[1][0]}}}};
        struct world w;
        struct grid g;
        small_grid(&g, 4, degree, seed);
        open_map(&w, &g, f, true, seed);
        det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        for (int n = 0; n < 300; n++) {
            double xy[2], q[2], p[2];
            struct place place;
            long double exact[2];
            random_point(&w, &s, xy);
            if (!image(&w, xy, q, &place)) continue;
            exact[0] = (m[1][1] * (q[0] - 3.0L) - m[0][1] * (q[1] + 1.0L)) / det;
            exact[1] = (m[0][0] * (q[1] + 1.0L) - m[1][0] * (q[0] - 3.0L)) / det;
            check_seed(seed, inverse_find(&w.c, q, NULL, NULL, &place));
            inverse_point(&w.v, q, &place, p);
            check_seed(seed, hypotl(p[0] - exact[0], p[1] - exact[1]) <= 8 * w.ulp);
        }
        close_world(&w);
    }
    (void)unused;
}

/* (x + c y^2, y) has the inverse (X - c Y^2, Y). */
static void quadratic_maps(void **unused) {
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        double c = random_unit(&s) * 4 - 2;
        struct polynomial f[2] = {{2, {{0, 0, c}, {1}}}, {1, {{0, 1}}}};
        struct world w;
        struct grid g;
        small_grid(&g, 4, 2 + i % 5, seed);
        open_map(&w, &g, f, true, seed);
        many_trips(&w, 200);
        for (int n = 0; n < 200; n++) {
            double xy[2], q[2], p[2];
            struct place place;
            random_point(&w, &s, xy);
            if (!image(&w, xy, q, &place)) continue;
            check_seed(seed, inverse_find(&w.c, q, NULL, NULL, &place));
            inverse_point(&w.v, q, &place, p);
            check_seed(seed, fabs(p[1] - q[1]) <= 2 * w.ulp);
            check_seed(seed, fabsl(p[0] - (q[0] - (long double)c * q[1] * q[1])) <= 32 * w.ulp);
        }
        close_world(&w);
    }
    (void)unused;
}

/* ---- maps that nearly fold: the least determinant is e, on a line inside, at a point, or on the
 * lower boundary */

static void fold(struct polynomial f[2], int kind, double e) {
    f[0] = (struct polynomial){1, {{0}, {1}}};
    if (kind == 0) f[1] = (struct polynomial){3, {{0, e, 0, 1 / 3.0L}}}; /* e + y^2 */
    if (kind == 1)                                                       /* e + x^2 + y^2 */
        f[1] = (struct polynomial){3, {{0, e, 0, 1 / 3.0L}, {0}, {0, 1}}};
    if (kind == 2) f[1] = (struct polynomial){2, {{2 * e + 2, e + 2, 0.5L}}}; /* e + (y + 2) */
}

static void near_folds(void **unused) {
    static const double least[] = {1e-3, 1e-6, 1e-9, 1e-12, 0};
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        double turn[2][2] = {{1, i % 3 - 1}, {-0.5, 1}};
        struct polynomial f[2];
        struct world w;
        struct grid g;
        straight_grid(&g, 3 + i % 4, seed);
        fold(f, i % 3, least[i % 5]);
        if (i % 2) combine(f, turn, 1, 0);
        open_map(&w, &g, f, least[i % 5] > 0, seed);
        many_trips(&w, 100);
        for (int n = 0; n < 100; n++) {
            double far[2], p[2];
            random_point(&w, &s, p);
            for (int c = 0; c < 2; c++)
                far[c] = ldexp(random_unit(&s) - 0.5, -(int)random_in(&s, 0, 60));
            if (i % 3 == 1) p[0] = far[0];
            p[1] = i % 3 == 2 ? -2 + fabs(far[1]) : far[1];
            round_trip(&w, p);
        }
        close_world(&w);
    }
    (void)unused;
}

/* ---- edited splines of degrees 5 to 8, with holes, of several components */

static void edited_splines(void **unused) {
    int proved = 0;
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct editing edit;
        struct spline spline = {0};
        struct world w;
        struct grid g;
        struct err err = {0};
        bool sound;
        small_grid(&g, 3, 5 + i % 4, seed);
        editing_begin(&edit, &g, 1, 100, seed);
        for (int n = 0; n < 6; n++) {
            uint32_t p = (uint32_t)random_in(&s, 0, edit.g.point_count - 1);
            (void)editing_move(&edit, p, 0.02 * (random_unit(&s) - 0.5), 0.02 * random_unit(&s));
        }
        g = edit.g;
        edit.g = (struct grid){0};
        check_seed(seed, spline_allocate(&spline, &g, &err));
        memcpy(spline.phi, edit.q, spline.grid.point_count * sizeof *spline.phi);
        editing_end(&edit);
        sound = injective_prove(&spline, &err);
        open_world(&w, &spline, sound, seed);
        if (sound) many_trips(&w, 400);
        proved += sound;
        close_world(&w);
    }
    assert_true(proved >= test_count(40) / 3);
    (void)unused;
}

/* ---- maps that fold */

static void noise(struct spline *s, double size, uint64_t *state) {
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int c = 0; c < 2; c++) s->phi[p][c] += size * (random_unit(state) - 0.5);
}

/* Onto the line y = 2x, exactly. */
static void collapse(struct spline *s) {
    for (uint32_t p = 0; p < s->grid.point_count; p++) s->phi[p][1] = 2 * s->phi[p][0];
}

static bool in_triangle(void *context, const struct place *place) {
    return place->triangle == *(const uint32_t *)context;
}

static void folded_maps(void **unused) {
    int searched = 0;
    for (int i = 0; i < test_count(24); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        bool flat = i % 4 == 3;
        struct world w;
        struct grid g;
        struct spline spline;
        small_grid(&g, 3, 1 + i % 6, seed);
        polynomial_spline(&spline, &g, NULL);
        noise(&spline, i % 2 ? 2 : 0.5, &s);
        if (flat) collapse(&spline);
        open_world(&w, &spline, false, seed);
        for (uint32_t n = 0; n < w.v.piece_count; n++) searched += !w.v.piece[n].piece.tame;
        for (int n = 0; n < 40; n++) {
            double xy[2], q[2];
            struct place place, found;
            long double exact[2];
            random_point(&w, &s, xy);
            if (!image(&w, xy, q, &place)) continue;
            sum_at_place(&w.s, &place, exact, NULL);
            for (int c = 0; c < 2; c++) q[c] = (double)exact[c];
            check_seed(seed, inverse_find(&w.c, q, NULL, NULL, &found));
            check_seed(seed, found.triangle <= place.triangle);
            check_place(&w, q, 0, &found);
            if (!flat) { /* else a curve of unwanted places may be all that is looked at */
                check_seed(seed, inverse_find(&w.c, q, in_triangle, &place.triangle, &found));
                check_seed(seed, found.triangle == place.triangle);
            }
            for (int c = 0; c < 2; c++) q[c] = 6 * random_unit(&s) - 3;
            check_lowest(&w, q);
        }
        close_world(&w);
    }
    assert_true(searched > 0);
    (void)unused;
}

/* Images that are a point, a segment, a curve, or doubled: det = 0 everywhere, or on a line. */
static void collapsed_maps(void **unused) {
    static const struct polynomial maps[][2] = {
        {{0, {{0.3L}}}, {0, {{-0.7L}}}},
        {{1, {{0, 1}, {1}}}, {0, {{0.1L}}}},
        {{1, {{0, 1}, {0.5L}}}, {1, {{0.2L, 0.1L}, {0.05L}}}},
        {{1, {{0}, {1}}}, {2, {{0}, {0}, {1}}}},
        {{1, {{0}, {1}}}, {2, {{0, 0, 0.5L}}}},
        {{2, {{0}, {1}, {0.25L}}}, {2, {{0, 0, 0.5L}, {0.5L}}}},
        {{2, {{0, 0, -1}, {0}, {1}}}, {2, {{0}, {0, 2}}}},
    };
    for (int i = 0; i < test_count(7); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct world w;
        struct grid g;
        small_grid(&g, 2, 2 + i % 4, seed);
        open_map(&w, &g, maps[i % 7], false, seed);
        for (int n = 0; n < 40; n++) {
            double xy[2], q[2], off;
            struct place place, found;
            long double exact[2];
            random_point(&w, &s, xy);
            if (!image(&w, xy, q, &place)) continue;
            sum_at_place(&w.s, &place, exact, NULL);
            for (int c = 0; c < 2; c++) q[c] = (double)exact[c];
            check_seed(seed, inverse_find(&w.c, q, NULL, NULL, &found));
            check_place(&w, q, 0, &found);
            off = ldexp(random_unit(&s) + 0.5, -(int)random_in(&s, 0, 50));
            q[1] += off;
            if (inverse_find(&w.c, q, NULL, NULL, &found)) check_place(&w, q, 16, &found);
            if (i % 7 < 3 && off > 20 * w.ulp) check_seed(seed, found.triangle == GRID_NONE);
        }
        close_world(&w);
    }
    (void)unused;
}

/* ---- the answer does not depend on what was asked before */

static void check_order(struct world *w, uint64_t *s) {
    enum { N = 400 };
    static double q[N][2];
    static struct place first[N], again;
    for (int i = 0; i < N; i++) {
        double p[2];
        random_point(w, s, p);
        if (!image(w, p, q[i], &again)) memcpy(q[i], p, sizeof p);
        if (i % 10 == 9) q[i][0] += 0.3;
        (void)inverse_find(&w->c, q[i], NULL, NULL, &first[i]);
    }
    for (int n = 0; n < 3 * N; n++) {
        int i = (int)random_in(s, 0, N - 1);
        if (n % 2)
            inverse_cursor_hint(&w->c, (uint32_t)random_in(s, 0, w->s.grid.triangle_count - 1));
        else if (n % 3 == 0)
            w->c.hint = (uint32_t)random_in(s, 0, w->v.piece_count - 1);
        (void)inverse_find(&w->c, q[i], NULL, NULL, &again);
        check_seed(w->seed, again.triangle == first[i].triangle &&
                                memcmp(again.b, first[i].b, sizeof again.b) == 0);
    }
}

static void order_does_not_matter(void **unused) {
    for (int i = 0; i < test_count(24); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct polynomial f[2];
        struct world w;
        struct grid g;
        struct spline spline;
        bool one_to_one = i % 4 != 0;
        small_grid(&g, 4, 3 + i % 4, seed);
        if (i % 2)
            random_map(f, 3, &s);
        else
            fold(f, i % 4 / 2, 1e-6);
        polynomial_spline(&spline, &g, f);
        if (!one_to_one) noise(&spline, 0.5, &s);
        open_world(&w, &spline, one_to_one, seed);
        check_order(&w, &s);
        close_world(&w);
    }
    (void)unused;
}

/* ---- the boundary */

static void check_boundary(struct world *w, uint32_t e, long double at) {
    const struct grid *g = &w->s.grid;
    uint32_t t = g->edge_triangle[e][0];
    int l = grid_opposite(g, t, e);
    double q[2];
    long double b[3], f[2], j[2][2], u[2], v[2], d[2], normal[2], size;
    struct place found;
    b[l] = 0;
    b[(l + 1) % 3] = at;
    b[(l + 2) % 3] = 1 - at;
    sum_at(&w->s, t, b, f, j);
    world_of(g, g->triangle[t][(l + 1) % 3], u);
    world_of(g, g->triangle[t][(l + 2) % 3], v);
    for (int c = 0; c < 2; c++) d[c] = j[c][0] * (v[0] - u[0]) + j[c][1] * (v[1] - u[1]);
    size = hypotl(d[0], d[1]);
    normal[0] = d[1] / size; /* to the right: outwards, as det > 0 */
    normal[1] = -d[0] / size;
    for (int k = -8; k <= 40; k += 8) {
        for (int c = 0; c < 2; c++) q[c] = (double)(f[c] + k * w->ulp * normal[c]);
        check_seed(w->seed, inverse_find(&w->c, q, NULL, NULL, &found) == (k < 12) || k == 16);
        if (k < 12) check_place(w, q, k < 0 ? 0 : k, &found);
    }
}

static void boundaries(void **unused) {
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct polynomial f[2];
        struct world w;
        struct grid g;
        small_grid(&g, 4, 1 + i % 7, seed);
        random_map(f, 1 + i % 7, &s);
        open_map(&w, &g, f, true, seed);
        for (uint32_t e = 0; e < w.s.grid.edge_count; e++)
            if (!grid_edge_is_inner(&w.s.grid, e))
                check_boundary(&w, e, 0.05 + 0.9 * random_unit(&s));
        close_world(&w);
    }
    (void)unused;
}

/* ---- what phi leaves alone */

static void unmoved_coordinates(void **unused) {
    int proved = 0;
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        struct err err = {0};
        struct world w;
        struct grid g;
        struct spline spline;
        uint32_t moved;
        small_grid(&g, 3, 2 + i % 5, seed);
        polynomial_spline(&spline, &g, NULL);
        moved = (uint32_t)random_in(&s, 0, spline.grid.point_count - 1);
        spline.phi[moved][1] += 0x1p-8;
        if (!injective_prove(&spline, &err)) { /* a small triangle may fold */
            spline_free(&spline);
            continue;
        }
        proved++;
        open_world(&w, &spline, true, seed);
        for (int n = 0; n < 200; n++) {
            double p[2], q[2], back[2];
            long double f[2], jacobian[2][2], least, most;
            struct place place;
            random_point(&w, &s, p);
            if (n == 0) p[0] = -0.0;
            if (!image(&w, p, q, &place)) continue;
            check_seed(seed, inverse_find(&w.c, q, NULL, NULL, &place));
            inverse_point(&w.v, q, &place, back);
            check_seed(seed, memcmp(&back[0], &p[0], sizeof *p) == 0);
            exact_image(&w, place.triangle, back, f, jacobian);
            singular_values(jacobian, &least, &most);
            if (q[1] == p[1]) check_seed(seed, fabsl(back[1] - p[1]) * least <= 4 * w.ulp);
            if (!w.v.moved[place.triangle][1]) check_seed(seed, back[1] == q[1]);
        }
        for (uint32_t v = 0; v < w.s.grid.vertex_count; v++) {
            struct place place;
            double back[2];
            if (v == moved) continue;
            check_seed(seed, inverse_find(&w.c, w.v.vertex[v], NULL, NULL, &place));
            inverse_point(&w.v, w.v.vertex[v], &place, back);
            check_seed(seed, back[0] == w.v.vertex[v][0]);
            check_seed(seed, fabs(back[1] - w.v.vertex[v][1]) <= w.ulp);
        }
        close_world(&w);
    }
    assert_true(proved > test_count(40) / 2);
    (void)unused;
}

/* ---- sizes that doubles only just hold */

static void extreme_sizes(void **unused) {
    static const int size[] = {1000, -1000, 300, -300};
    for (int i = 0; i < test_count(8); i++) {
        uint64_t seed = (uint64_t)i, s = seed;
        double p[2], back[2];
        struct polynomial f[2];
        struct world w;
        struct grid g;
        struct spline spline;
        struct place place;
        small_grid(&g, 3, 4, seed);
        random_map(f, 4, &s);
        polynomial_spline(&spline, &g, f);
        g = spline.grid;
        spline.grid.lattice =
            (struct lattice){ldexp(1, size[i % 4] - 10), -ldexp(1, size[i % 4]), 0};
        for (uint32_t q = 0; q < spline.grid.point_count; q++)
            for (int c = 0; c < 2; c++) spline.phi[q][c] = ldexp(spline.phi[q][c], size[i % 4]);
        open_world(&w, &spline, true, seed);
        for (int n = 0; n < 100; n++) {
            double q[2];
            random_point(&w, &s, p);
            if (!image(&w, p, q, &place)) continue;
            check_seed(seed, inverse_find(&w.c, q, NULL, NULL, &place));
            inverse_point(&w.v, q, &place, back);
            for (int c = 0; c < 2; c++)
                check_seed(seed, fabs(back[c] - p[c]) <= 0x1p-40 * ldexp(1, size[i % 4]));
        }
        p[0] = DBL_MAX;
        p[1] = -DBL_MAX;
        check_seed(seed, !inverse_find(&w.c, p, NULL, NULL, &place));
        close_world(&w);
    }
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(smooth_maps),    cmocka_unit_test(needles),
        cmocka_unit_test(exact_images),   cmocka_unit_test(affine_maps),
        cmocka_unit_test(quadratic_maps), cmocka_unit_test(near_folds),
        cmocka_unit_test(edited_splines), cmocka_unit_test(folded_maps),
        cmocka_unit_test(collapsed_maps), cmocka_unit_test(order_does_not_matter),
        cmocka_unit_test(boundaries),     cmocka_unit_test(unmoved_coordinates),
        cmocka_unit_test(extreme_sizes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
