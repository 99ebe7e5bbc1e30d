/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: pixels that must come out bit for bit; and for any map an image whose pixels tell their
 * own places, so that the warped one tells where each of its pixels comes from: phi, by its
 * defining sum in long double, must take that place to the pixel. */
#include "warp.h"

#include "injective.h"
#include "polynomials.h"
#include "rectangle.h"
#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 37, HEIGHT = 29 };

static void make_image(struct image *image, enum image_sample sample, int channels,
                       uint64_t *state) {
    *image = (struct image){.width = WIDTH,
                            .height = HEIGHT,
                            .channels = channels,
                            .alpha = channels % 2 ? -1 : channels - 1,
                            .straight = channels == 4,
                            .sample = sample};
    assert_true(image_allocate(image, &(struct err){0}));
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT * (size_t)channels; i++) {
        uint32_t bits = (uint32_t)random_bits(state);
        if (sample == IMAGE_FLOAT)
            memcpy(&image->value[i], &bits, sizeof bits);
        else
            image->value[i] = (float)(bits & (sample == IMAGE_U8 ? 255 : 65535));
    }
}

/* The identity on the frame's rectangle. */
static void make_spline(struct spline *s, const double frame[4], int degree, uint32_t cells) {
    struct rectangle r = {.cells = {cells, cells}, .kind = PATTERN_DIAGONAL};
    struct grid g = {.degree = degree, .axes = {0, 1, 2}};
    struct err err = {0};
    for (int k = 0; k < 2; k++) {
        r.low[k] = fmin(frame[k], frame[k + 2]);
        r.high[k] = fmax(frame[k], frame[k + 2]);
    }
    r.lattice.bits = 20;
    assert_true(rectangle_grid(&g, &r, &err) && grid_build(&g, &err));
    assert_true(spline_identity(s, &g, &err));
}

static const float outside[4] = {7, 8, 9, 10};

static struct warp make_warp(const struct image *image, const struct spline *s,
                             const double frame[4]) {
    struct viewport view = viewport_of_frame(image->width, image->height, frame);
    return (struct warp){.image = image,
                         .from = view,
                         .to = view,
                         .spline = s,
                         .antialias = 1,
                         .filter = SAMPLER_LINEAR,
                         .outside = outside};
}

static void run(const struct warp *w, struct image *picture) {
    struct err err = {0};
    assert_true(image_allocate_like(picture, w->image, w->to.width, w->to.height, &err));
    assert_true(warp(w, picture, &err));
}

static bool same_pixel(const struct image *a, int column, int row, const struct image *b, int x,
                       int y) {
    size_t n = (size_t)a->channels * sizeof *a->value;
    const float *from = outside;
    if (x >= 0 && y >= 0 && x < (int)b->width && y < (int)b->height)
        from = image_pixel(b, (uint32_t)x, (uint32_t)y);
    return memcmp(image_pixel(a, (uint32_t)column, (uint32_t)row), from, n) == 0;
}

static void identity(void **unused) {
    static const double frames[][4] = {{0, 0, WIDTH, HEIGHT},
                                       {-3, 7, 12, -5},
                                       {0.1, 0.2, 0.9, 0.7},
                                       {1e-9, 1e-9, 0, 0},
                                       {5e6, 1e6, 5e6 + WIDTH, 1e6 + HEIGHT}};
    for (int i = 0; i < 90; i++) {
        uint64_t seed = 0x1de0000 + (uint64_t)i, state = seed;
        const double *frame = frames[i % 5];
        struct image image, picture;
        struct spline s;
        struct warp w;
        make_image(&image,
                   i % 3 == 0   ? IMAGE_U8
                   : i % 3 == 1 ? IMAGE_U16
                                : IMAGE_FLOAT,
                   i / 5 % 4 + 1, &state);
        make_spline(&s, frame, 1 + i % 7, 3);
        w = make_warp(&image, &s, frame);
        w.filter = (enum sampler_filter)(i / 5 % 3);
        w.inverse = i % 2;
        run(&w, &picture);
        for (int p = 0; p < WIDTH * HEIGHT; p++) /* grids end on their lattice: edges may be cut */
            if (i % 5 == 0 || (p % WIDTH % (WIDTH - 1) && p / WIDTH % (HEIGHT - 1)))
                check_seed(
                    seed, same_pixel(&picture, p % WIDTH, p / WIDTH, &image, p % WIDTH, p / WIDTH));
        image_free(&picture);
        image_free(&image);
        spline_free(&s);
    }
    (void)unused;
}

/* phi = a quarter turn `turns` times about the middle, then a shift by whole pixels. */
static void turn_and_shift(struct spline *s, int turns, const int shift[2]) {
    for (uint32_t p = 0; p < s->grid.point_count; p++) {
        double x = s->phi[p][0] - WIDTH / 2.0, y = s->phi[p][1] - HEIGHT / 2.0;
        for (int i = 0; i < turns; i++) {
            double old = x;
            x = -y;
            y = old;
        }
        s->phi[p][0] = x + WIDTH / 2.0 + shift[0];
        s->phi[p][1] = y + HEIGHT / 2.0 + shift[1];
    }
}

static void quarters_and_shifts(void **unused) {
    static const double frame[4] = {0, 0, WIDTH, HEIGHT};
    for (int i = 0; i < test_count(60); i++) {
        uint64_t seed = 0x904e0000 + (uint64_t)i, state = seed;
        int turns = i % 4, shift[2];
        struct image image, picture;
        struct spline s;
        struct warp w;
        for (int k = 0; k < 2; k++) shift[k] = (int)random_in(&state, -30, 30);
        make_image(&image, IMAGE_FLOAT, i % 3 + 1, &state);
        make_spline(&s, frame, 1 + i / 4 % 6, 4);
        turn_and_shift(&s, turns, shift);
        w = make_warp(&image, &s, frame);
        w.filter = (enum sampler_filter)(i / 4 % 3);
        w.inverse = i / 12 % 2;
        run(&w, &picture);
        for (int p = 0; p < WIDTH * HEIGHT; p++) { /* in half pixels from the middle */
            int x = 2 * (p % WIDTH) + 1 - WIDTH, y = 2 * (p / WIDTH) + 1 - HEIGHT;
            if (!w.inverse) x -= 2 * shift[0];
            if (!w.inverse) y -= 2 * shift[1];
            for (int k = 0; k < (w.inverse ? turns : 4 - turns); k++) {
                int old = x;
                x = -y;
                y = old;
            }
            if (w.inverse) x += 2 * shift[0];
            if (w.inverse) y += 2 * shift[1];
            check_seed(seed, same_pixel(&picture, p % WIDTH, p / WIDTH, &image,
                                        (x + WIDTH) / 2 - (x < -WIDTH),
                                        (y + HEIGHT) / 2 - (y < -HEIGHT)));
        }
        image_free(&picture);
        image_free(&image);
        spline_free(&s);
    }
    (void)unused;
}

/* Pixels tell the coordinates of their centres. */
static void make_places(struct image *image) {
    *image = (struct image){
        .width = WIDTH, .height = HEIGHT, .channels = 2, .alpha = -1, .sample = IMAGE_FLOAT};
    assert_true(image_allocate(image, &(struct err){0}));
    for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) {
        image->value[2 * p] = (float)(p % WIDTH) + 0.5F;
        image->value[2 * p + 1] = (float)(p / WIDTH) + 0.5F;
    }
}

/* phi at a point, by the first triangle that has it; false: outside. */
static bool image_of(const struct spline *s, const double p[2], long double q[2]) {
    for (uint32_t t = 0; t < s->grid.triangle_count; t++) {
        long double u[3][2], b[3], area;
        for (int l = 0; l < 3; l++) world_of(&s->grid, s->grid.triangle[t][l], u[l]);
        area =
            (u[1][0] - u[0][0]) * (u[2][1] - u[0][1]) - (u[1][1] - u[0][1]) * (u[2][0] - u[0][0]);
        for (int l = 0; l < 3; l++) {
            const long double *m = u[(l + 1) % 3], *n = u[(l + 2) % 3];
            b[l] = ((m[0] - p[0]) * (n[1] - p[1]) - (m[1] - p[1]) * (n[0] - p[0])) / area;
        }
        if (b[0] < -1e-6L || b[1] < -1e-6L || b[2] < -1e-6L) continue;
        sum_at(s, t, b, q, NULL);
        return true;
    }
    return false;
}

static bool is_inner(const float *value) {
    return value[0] > 0.51F && value[0] < WIDTH - 0.51F && value[1] > 0.51F &&
           value[1] < HEIGHT - 0.51F;
}

static void bend(struct spline *s, double amount, uint64_t *state) {
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int k = 0; k < 2; k++) s->phi[p][k] += amount * (random_unit(state) - 0.5);
}

static int check_places(uint64_t seed, const struct warp *w, const struct image *picture) {
    int checked = 0;
    for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) {
        const float *value = picture->value + (size_t)2 * p;
        double from[2] = {value[0], value[1]}, at[2] = {p % WIDTH + 0.5, p / WIDTH + 0.5};
        const double *preimage = w->inverse ? at : from, *image = w->inverse ? from : at;
        long double q[2];
        if (value[0] == outside[0] || !is_inner(value)) continue;
        checked++;
        check_seed(seed, image_of(w->spline, preimage, q));
        check_seed(seed, hypotl(q[0] - image[0], q[1] - image[1]) < 3e-5L); /* floats */
    }
    return checked;
}

/* Also maps that are not one-to-one: any of the preimages is right. */
static void each_pixel(void **unused) {
    static const double frame[4] = {0, 0, WIDTH, HEIGHT};
    int checked = 0, proved = 0;
    for (int i = 0; i < test_count(40); i++) {
        uint64_t seed = 0xeac40000 + (uint64_t)i, state = seed;
        struct image image, picture;
        struct spline s;
        struct warp w;
        struct err err = {0};
        make_places(&image);
        make_spline(&s, frame, 1 + i % 9, 3);
        bend(&s, i % 5 == 0 ? 20 : 4 / (1.0 + i % 9), &state);
        proved += injective_prove(&s, &err);
        w = make_warp(&image, &s, frame);
        w.inverse = i % 4 == 3;
        run(&w, &picture);
        checked += check_places(seed, &w, &picture);
        image_free(&picture);
        image_free(&image);
        spline_free(&s);
    }
    assert_true(checked > test_count(40) * WIDTH * HEIGHT / 2);
    assert_true(proved > test_count(40) / 2 && proved < test_count(40));
    (void)unused;
}

/* N x N samples: the means of a picture of N times the size. */
static void antialias(void **unused) {
    static const double frame[4] = {0, 0, WIDTH, HEIGHT};
    for (int i = 0; i < test_count(24); i++) {
        uint64_t seed = 0xaa0000 + (uint64_t)i, state = seed;
        uint32_t n = (uint32_t)random_in(&state, 2, 4);
        struct image image, picture, large;
        struct spline s;
        struct warp w;
        make_image(&image, IMAGE_U8, i % 4 + 1, &state);
        make_spline(&s, frame, 5, 3);
        bend(&s, 0.7, &state);
        w = make_warp(&image, &s, frame);
        w.antialias = (int)n;
        run(&w, &picture);
        w.antialias = 1;
        w.to = viewport_of_frame(n * WIDTH, n * HEIGHT, frame);
        run(&w, &large);
        for (uint32_t p = 0; p < WIDTH * HEIGHT; p++)
            for (int k = 0; k < image.channels; k++) {
                double sum = 0, weights = 0;
                for (uint32_t j = 0; j < n * n; j++) {
                    const float *value =
                        image_pixel(&large, p % WIDTH * n + j % n, p / WIDTH * n + j / n);
                    double weight = image.straight && k != image.alpha ? value[image.alpha] : 1;
                    sum += weight * value[k];
                    weights += weight;
                }
                check_seed(seed, fabs(image_pixel(&picture, p % WIDTH, p / WIDTH)[k] -
                                      sum / weights) < 1e-3);
            }
        image_free(&picture);
        image_free(&large);
        image_free(&image);
        spline_free(&s);
    }
    (void)unused;
}

struct listener {
    struct progress progress;
    int told;
};

static void listen(struct progress *progress, double fraction) {
    struct listener *l = (struct listener *)(void *)progress; /* its first member */
    assert_true(fraction == (double)l->told++ / HEIGHT);
}

static void each_row_is_told(void **unused) {
    static const double frame[4] = {0, 0, WIDTH, HEIGHT};
    struct listener l = {{listen}, 0};
    struct image image, picture;
    struct spline s;
    struct warp w;
    make_places(&image);
    make_spline(&s, frame, 1, 1);
    w = make_warp(&image, &s, frame);
    w.progress = &l.progress;
    run(&w, &picture);
    assert_int_equal(l.told, HEIGHT);
    image_free(&picture);
    image_free(&image);
    spline_free(&s);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(identity),         cmocka_unit_test(quarters_and_shifts),
        cmocka_unit_test(each_pixel),       cmocka_unit_test(antialias),
        cmocka_unit_test(each_row_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
