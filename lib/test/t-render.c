/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: every sample looked at by itself, all faces tried for it in long doubles, or the
 * preimage found by inverse.h and what is there by the defining sum; and for an affine map, the
 * areas of the colours by the integral. */
#include "render.h"

#include "injective.h"
#include "inverse.h"

#include "polynomials.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 21, HEIGHT = 16, FACES_MAX = 8 };

struct scene {
    struct textured surface;
    double vertex[3 * FACES_MAX][3], place[3 * FACES_MAX][2];
    struct textured_face face[FACES_MAX];
    struct viewport view;
    struct render_style style;
    struct image texture;
};

static const int axes[3] = {0, 1, 2};

static void make_style(struct scene *s, uint64_t *state) {
    struct render_style *style = &s->style;
    style->antialias = (int)random_in(state, 1, 3);
    style->lines = random_in(state, 0, 1);
    style->folds = random_in(state, 0, 1);
    for (int k = 0; k < 4; k++) {
        style->background[k] = random_unit(state);
        for (int i = 0; i < 2; i++) style->texture.colour[i][k] = random_unit(state);
    }
    style->texture.square = ldexp(1, (int)random_in(state, -3, 1));
    style->texture.origin[0] = random_unit(state);
    if (random_in(state, 0, 2)) return;
    s->texture = (struct image){.width = 5,
                                .height = 4,
                                .channels = 4,
                                .alpha = 3,
                                .straight = true,
                                .sample = IMAGE_FLOAT};
    assert_true(image_allocate(&s->texture, &(struct err){0}));
    for (int i = 0; i < 80; i++) s->texture.value[i] = (float)random_unit(state);
    style->texture.image = &s->texture;
    style->texture.view = viewport_of_frame(5, 4, (const double[4]){-0.5, 2, 2.5, -0.5});
}

static void make_scene(struct scene *s, uint64_t *state) {
    uint32_t n = (uint32_t)random_in(state, 1, FACES_MAX);
    *s = (struct scene){
        .view = {WIDTH, HEIGHT, {-1, 8}, {0.5, random_in(state, 0, 1) ? -0.5 : 0.5}}};
    if (s->view.step[1] > 0) s->view.corner[1] = 0;
    for (uint32_t f = 0; f < n; f++) {
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t v = 3 * f + c;
            for (int k = 0; k < 3; k++) s->vertex[v][k] = 12 * random_unit(state) - 2;
            for (int k = 0; k < 2; k++) s->place[v][k] = 3 * random_unit(state);
            s->face[f].vertex[c] = s->face[f].place[c] = v;
        }
        s->face[f].sides = (uint8_t)random_in(state, 0, 7);
    }
    s->surface = (struct textured){.vertex_count = 3 * n,
                                   .place_count = 3 * n,
                                   .face_count = n,
                                   .vertex = s->vertex,
                                   .place = s->place,
                                   .face = s->face};
    make_style(s, state);
}

static long double cross(const double a[], const double b[], const long double p[2]) {
    return ((long double)b[0] - a[0]) * (p[1] - a[1]) - ((long double)b[1] - a[1]) * (p[0] - a[0]);
}

/* Barycentric coordinates of a world point in a face; false: outside. */
static bool find(const struct scene *s, uint32_t f, const long double p[2], long double b[3],
                 long double *area) {
    const double(*v)[3] = (const double(*)[3]) & s->vertex[3 * (size_t)f];
    const long double third[2] = {v[2][0], v[2][1]};
    *area = cross(v[0], v[1], third);
    for (int l = 0; l < 3; l++) b[l] = cross(v[(l + 1) % 3], v[(l + 2) % 3], p) / *area;
    return b[0] > 0 && b[1] > 0 && b[2] > 0;
}

static double interpolate(const long double b[3], double x, double y, double z) {
    return (double)(b[0] * x + b[1] * y + b[2] * z);
}

/* What is seen at a world point, a pixel wide. */
static bool look(const struct scene *s, const long double p[2], struct render_sight *sight) {
    double nearest = -INFINITY;
    bool fold = false;
    for (uint32_t f = 0; f < s->surface.face_count; f++) {
        const double(*v)[3] = (const double(*)[3]) & s->vertex[3 * (size_t)f];
        const double(*t)[2] = (const double(*)[2]) & s->place[3 * (size_t)f];
        const long double third[2] = {t[2][0], t[2][1]};
        long double b[3], next[2][3], area, away;
        double z;
        if (!find(s, f, p, b, &area)) continue;
        fold = fold || area * cross(t[0], t[1], third) < 0;
        z = interpolate(b, v[0][2], v[1][2], v[2][2]);
        if (z <= nearest) continue;
        nearest = z;
        for (int k = 0; k < 2; k++) {
            long double q[2] = {p[0], p[1]};
            q[k] += s->view.step[k];
            find(s, f, q, next[k], &area);
        }
        for (int k = 0; k < 2; k++) {
            sight->at[k] = interpolate(b, t[0][k], t[1][k], t[2][k]);
            sight->u[k] = interpolate(next[0], t[0][k], t[1][k], t[2][k]) - sight->at[k];
            sight->v[k] = interpolate(next[1], t[0][k], t[1][k], t[2][k]) - sight->at[k];
        }
        sight->line = INFINITY;
        for (int l = 0; l < 3; l++) {
            const double *from = v[l], *to = v[(l + 1) % 3];
            away = fabsl(cross(from, to, p)) / hypotl(to[0] - from[0], to[1] - from[1]) / 0.5L;
            if (s->face[f].sides >> l & 1) sight->line = fmin(sight->line, (double)away);
        }
    }
    sight->fold = fold;
    return nearest > -INFINITY;
}

static void brute_force(const struct scene *s, uint32_t column, uint32_t row,
                        const struct image *image) {
    uint32_t n = (uint32_t)s->style.antialias;
    double sum[4] = {0};
    for (uint32_t i = 0; i < n * n; i++) {
        long double p[2] = {column + (i % n + 0.5L) / n, row + (i / n + 0.5L) / n};
        struct render_sight sight;
        for (int k = 0; k < 2; k++) p[k] = s->view.corner[k] + s->view.step[k] * p[k];
        if (look(s, p, &sight)) render_add(&s->style, &sight, sum);
    }
    render_set(&s->style, sum, image, column, row);
}

static void all_samples(void **unused) {
    for (int i = 0; i < test_count(300); i++) {
        uint64_t seed = 0x5ce9e0000 + (uint64_t)i, state = seed;
        struct scene s;
        struct image got = {.width = WIDTH, .height = HEIGHT, .sample = IMAGE_FLOAT}, want;
        struct err err = {0};
        double worst = 0;
        make_scene(&s, &state);
        got.channels = i % 2 ? 3 : 4;
        got.alpha = i % 2 ? -1 : 3;
        got.straight = i % 4 == 0;
        assert_true(image_allocate(&got, &err));
        assert_true(image_allocate_like(&want, &got, WIDTH, HEIGHT, &err));
        check_seed(seed, render_surface(&s.style, &s.surface, axes, &s.view, &got, &err));
        for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) brute_force(&s, p % WIDTH, p / WIDTH, &want);
        for (size_t k = 0; k < (size_t)WIDTH * HEIGHT * (size_t)got.channels; k++)
            worst = fmax(worst, fabs((double)got.value[k] - want.value[k]));
        check_seed(seed, worst < 1e-5);
        image_free(&got);
        image_free(&want);
        image_free(&s.texture);
    }
    (void)unused;
}

/* A square of the plane, turned and sheared into the picture, whose pixels tile it: with one sample
 * a pixel the picture's mean is that of the pattern, whatever the size of its squares. */
static void areas(void **unused) {
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = 0xa3ea0000 + (uint64_t)i, state = seed;
        double vertex[4][3] = {{0, 0, 0}, {40, 0, 0}, {40, 30, 0}, {0, 30, 0}}, place[4][2];
        double squares = (double)random_in(&state, 1, 90), mean = 0;
        struct textured_face face[2] = {{{0, 1, 2}, {0, 1, 2}, 3}, {{0, 2, 3}, {0, 2, 3}, 6}};
        struct textured surface = {4, 4, 2, vertex, place, face};
        struct viewport view = {40, 30, {0, 30}, {1, -1}};
        struct render_style style = {.antialias = 1, .texture = {.square = 1 / squares}};
        struct image image = {
            .width = 40, .height = 30, .channels = 3, .alpha = -1, .sample = IMAGE_FLOAT};
        struct err err = {0};
        for (int k = 0; k < 4; k++) style.texture.colour[0][k] = style.texture.colour[1][3] = 1;
        for (int c = 0; c < 4; c++) { /* an even number of squares: half of each colour */
            place[c][0] = (c == 1 || c == 2) + 3 * (c / 2);
            place[c][1] = c / 2 * 2 - (c == 1 || c == 2);
        }
        assert_true(image_allocate(&image, &err));
        check_seed(seed, render_surface(&style, &surface, axes, &view, &image, &err));
        for (size_t k = 0; k < 40 * 30 * 3; k += 3) mean += image.value[k] / 1200.0;
        check_seed(seed, squares > 40 || fabs(mean - 0.5) < 1e-6);
        check_seed(seed, fabs(mean - 0.5) < 0.01);
        image_free(&image);
    }
    (void)unused;
}

/* --- Maps ----------------------------------------------------------------------------------- */

struct map {
    struct spline s;
    struct inverse v;
    struct inverse_cursor c;
    struct viewport view;
    struct render_style style;
};

static void derivative_at(const struct spline *s, const struct place *place, long double j[2][2]) {
    long double f[2], b[3] = {place->b[0], place->b[1], place->b[2]};
    sum_at(s, place->triangle, b, f, j);
}

static bool turned(void *context, const struct place *place) {
    long double j[2][2];
    derivative_at(context, place, j);
    return j[0][0] * j[1][1] - j[0][1] * j[1][0] < 0;
}

/* Edges of the triangle, seen in the picture through the derivative. */
static double nearest_line(const struct map *m, const struct place *place, long double j[2][2]) {
    long double u[3][2], side[2], height[2], normal, away = INFINITY;
    for (int l = 0; l < 3; l++) world_of(&m->s.grid, m->s.grid.triangle[place->triangle][l], u[l]);
    for (int l = 0; l < 3; l++) {
        const long double *a = u[(l + 1) % 3], *b = u[(l + 2) % 3];
        for (int k = 0; k < 2; k++) { /* both to the picture */
            side[k] = (j[k][0] * (b[0] - a[0]) + j[k][1] * (b[1] - a[1])) / m->view.step[k];
            height[k] = (j[k][0] * (u[l][0] - a[0]) + j[k][1] * (u[l][1] - a[1])) / m->view.step[k];
        }
        normal = (side[0] * height[1] - side[1] * height[0]) / hypotl(side[0], side[1]);
        away = fminl(away, fabsl(place->b[l] * normal));
    }
    return (double)away;
}

static bool look_at_map(struct map *m, const double q[2], struct render_sight *sight) {
    struct place place;
    long double j[2][2], det;
    if (!inverse_find(&m->c, q, NULL, NULL, &place)) return false;
    inverse_point(&m->v, q, &place, sight->at);
    derivative_at(&m->s, &place, j);
    det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    sight->u[0] = (double)(j[1][1] / det * m->view.step[0]);
    sight->u[1] = (double)(-j[1][0] / det * m->view.step[0]);
    sight->v[0] = (double)(-j[0][1] / det * m->view.step[1]);
    sight->v[1] = (double)(j[0][0] / det * m->view.step[1]);
    sight->line = nearest_line(m, &place, j);
    sight->fold = inverse_find(&m->c, q, turned, &m->s, &place);
    return true;
}

static void make_map(struct map *m, uint64_t seed, uint64_t *state) {
    double amount = seed % 4 ? 0.35 : 1.6, lo[2], hi[2];
    const uint32_t size[2] = {WIDTH, HEIGHT};
    struct err err = {0};
    struct grid g;
    random_grid(&g, 2, 1 + (int)(seed % 6), seed);
    g.lattice = (struct lattice){0x1p-10, -1, -2};
    assert_true(spline_identity(&m->s, &g, &err));
    for (uint32_t p = 0; p < m->s.grid.point_count; p++)
        for (int k = 0; k < 2; k++)
            m->s.phi[p][k] += amount / m->s.grid.degree * (random_unit(state) - 0.5);
    assert_true(inverse_init(&m->v, &m->s, injective_prove(&m->s, &err), &err));
    assert_true(inverse_cursor_init(&m->c, &m->v, &err));
    assert_true(render_map_box(&m->s, lo, hi, &err));
    m->view = viewport_fit(lo, hi, size, seed % 2);
    m->style = (struct render_style){.antialias = (int)random_in(state, 1, 3)};
    m->style.lines = random_in(state, 0, 1);
    m->style.folds = random_in(state, 0, 1);
    m->style.texture = (struct texture){.square = ldexp(1, (int)random_in(state, -5, 0)),
                                        .colour = {{1, 0, 0.5, 1}, {0, 1, 0.25, 0.5}}};
}

static void brute_force_map(struct map *m, uint32_t column, uint32_t row,
                            const struct image *image) {
    uint32_t n = (uint32_t)m->style.antialias;
    double sum[4] = {0};
    for (uint32_t i = 0; i < n * n; i++) {
        double x = column + (i % n + 0.5) / n, y = row + (i / n + 0.5) / n;
        const double q[2] = {viewport_world(&m->view, 0, x), viewport_world(&m->view, 1, y)};
        struct render_sight sight;
        if (look_at_map(m, q, &sight)) render_add(&m->style, &sight, sum);
    }
    render_set(&m->style, sum, image, column, row);
}

/* How many pixels differ. */
static int differences(const struct image *a, const struct image *b) {
    int differ = 0;
    for (size_t p = 0; p < WIDTH * HEIGHT; p++) {
        double worst = 0;
        for (size_t k = 4 * p; k < 4 * p + 4; k++)
            worst = fmax(worst, fabs((double)a->value[k] - b->value[k]));
        differ += !(worst < 1e-3);
    }
    return differ;
}

/* A sample on the boundary may be told outside; of maps that are not one-to-one, layers narrower
 * than a pixel may be overlooked. */
static void maps(void **unused) {
    int proved = 0;
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = 0x3a950000 + (uint64_t)i, state = seed;
        struct image got = {.width = WIDTH,
                            .height = HEIGHT,
                            .channels = 4,
                            .alpha = 3,
                            .sample = IMAGE_FLOAT},
                     want;
        struct err err = {0};
        struct map m;
        make_map(&m, seed, &state);
        proved += m.v.one_to_one;
        assert_true(image_allocate(&got, &err));
        assert_true(image_allocate_like(&want, &got, WIDTH, HEIGHT, &err));
        check_seed(seed, render_map(&m.style, &m.s, &m.view, &got, &err));
        for (uint32_t p = 0; p < WIDTH * HEIGHT; p++)
            brute_force_map(&m, p % WIDTH, p / WIDTH, &want);
        check_seed(seed, differences(&got, &want) <= (m.v.one_to_one ? 1 : WIDTH * HEIGHT / 10));
        image_free(&got);
        image_free(&want);
        inverse_cursor_free(&m.c);
        inverse_free(&m.v);
        spline_free(&m.s);
    }
    assert_true(proved > test_count(60) / 4 && proved < test_count(60));
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_samples), cmocka_unit_test(areas),
                                       cmocka_unit_test(maps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
