/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: pixels at their centres bit for bit; polynomials that a filter reproduces; the filters'
 * definitions as sums over all pixels of an image that goes on beyond its edge. */
#include "sampler.h"

#include "testing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 9, HEIGHT = 7 };

static void make_image(struct image *image, int channels, int alpha, bool straight) {
    struct err err = {0};
    *image = (struct image){.width = WIDTH,
                            .height = HEIGHT,
                            .channels = channels,
                            .alpha = alpha,
                            .straight = straight,
                            .sample = IMAGE_FLOAT};
    assert_true(image_allocate(image, &err));
}

static size_t count(const struct image *image) {
    return (size_t)image->width * image->height * (size_t)image->channels;
}

static const float outside[4] = {-1, -2, -3, -4};

static void value_at(const struct image *image, enum sampler_filter filter, double x, double y,
                     float *value) {
    const double position[1][2] = {{x, y}};
    sampler_values(image, filter, 1, position, outside, value);
}

static void centres_are_exact(void **unused) {
    static const double off[] = {0, 0x1p-25, -0x1p-25, 0x1p-52};
    for (int filter = 0; filter < 3; filter++)
        for (int channels = 1; channels <= 4; channels++) {
            uint64_t state = 1;
            struct image image;
            make_image(&image, channels, channels - 1, channels % 2);
            for (size_t i = 0; i < count(&image); i++) { /* any bits: infinities, NaN */
                uint32_t bits = (uint32_t)random_bits(&state);
                memcpy(&image.value[i], &bits, sizeof bits);
            }
            for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) {
                uint32_t c = p % WIDTH, r = p / WIDTH;
                float value[4];
                value_at(&image, (enum sampler_filter)filter, c + 0.5 + off[p % 4],
                         r + 0.5 + off[p / 4 % 4], value);
                assert_memory_equal(value, image_pixel(&image, c, r),
                                    (size_t)channels * sizeof *value);
            }
            image_free(&image);
        }
    (void)unused;
}

/* The kernels as they are defined. */
static double kernel(enum sampler_filter filter, double t) {
    t = fabs(t);
    if (filter == SAMPLER_LINEAR) return t < 1 ? 1 - t : 0;
    if (t < 1) return 1.5 * t * t * t - 2.5 * t * t + 1;
    return t < 2 ? -0.5 * t * t * t + 2.5 * t * t - 4 * t + 2 : 0;
}

static int clamp(int at, int size) {
    return at < 0 ? 0 : at >= size ? size - 1 : at;
}

static void definitions(void **unused) {
    for (int i = 0; i < test_count(3000); i++) {
        uint64_t seed = 0x5a3b1e0000 + (uint64_t)i, state = seed;
        enum sampler_filter filter = i % 2 ? SAMPLER_LINEAR : SAMPLER_CUBIC;
        bool straight = random_in(&state, 0, 1);
        double x = random_unit(&state) * WIDTH, y = random_unit(&state) * HEIGHT;
        double sum[3] = {0}, weights = 0;
        struct image image;
        float value[3];
        make_image(&image, 3, straight ? 2 : -1, straight);
        for (size_t k = 0; k < count(&image); k++) image.value[k] = (float)random_unit(&state) + 1;
        for (int c = -3; c < WIDTH + 3; c++)
            for (int r = -3; r < HEIGHT + 3; r++) {
                const float *pixel =
                    image_pixel(&image, (uint32_t)clamp(c, WIDTH), (uint32_t)clamp(r, HEIGHT));
                double w = kernel(filter, x - c - 0.5) * kernel(filter, y - r - 0.5);
                double part = straight ? pixel[2] : 1;
                for (int k = 0; k < 3; k++) sum[k] += w * pixel[k] * (k < 2 ? part : 1);
                weights += w * part;
            }
        value_at(&image, filter, x, y, value);
        for (int k = 0; k < 3; k++)
            check_seed(seed, fabs(value[k] - sum[k] / (k < 2 ? weights : 1)) < 1e-5);
        image_free(&image);
    }
    (void)unused;
}

static void nearest(void **unused) {
    struct image image;
    make_image(&image, 1, -1, false);
    for (size_t i = 0; i < count(&image); i++) image.value[i] = (float)i;
    for (int i = 0; i < test_count(10000); i++) {
        uint64_t seed = 0x4ea0000 + (uint64_t)i, state = seed;
        double x = random_unit(&state) * WIDTH, y = random_unit(&state) * HEIGHT;
        float value;
        value_at(&image, SAMPLER_NEAREST, x, y, &value);
        check_seed(seed, value == (float)(floor(y) * WIDTH + floor(x)));
    }
    image_free(&image);
    (void)unused;
}

static void edges(void **unused) {
    for (int filter = 0; filter < 3; filter++) {
        enum sampler_filter f = (enum sampler_filter)filter;
        const double inside[][2] = {
            {0, 0}, {WIDTH, HEIGHT}, {0, HEIGHT}, {-0x1p-30, 3.25}, {WIDTH, 0}};
        const double beyond[][2] = {{-1e-6, 3},         {3, -1e-6}, {WIDTH + 1e-6, 3},
                                    {3, HEIGHT + 1e-6}, {NAN, 3},   {3, INFINITY},
                                    {-1e300, 3},        {1e300, 3}};
        struct image image;
        float value[2];
        make_image(&image, 2, -1, false);
        for (size_t i = 0; i < count(&image); i++) image.value[i] = i % 2 ? 7 : 5;
        for (int i = 0; i < 5; i++) {
            value_at(&image, f, inside[i][0], inside[i][1], value);
            assert_true(value[0] == 5 && value[1] == 7);
        }
        for (int i = 0; i < 8; i++) {
            value_at(&image, f, beyond[i][0], beyond[i][1], value);
            assert_true(value[0] == -1 && value[1] == -2);
        }
        image_free(&image);
    }
    (void)unused;
}

/* What is transparent has no colour to give. */
static void transparent_neighbours(void **unused) {
    struct image image;
    float value[2];
    make_image(&image, 2, 1, true);
    for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) {
        image.value[2 * p] = p % 2 ? 1000 : 3;
        image.value[2 * p + 1] = p % 2 ? 0 : 1;
    }
    value_at(&image, SAMPLER_LINEAR, 2.25, 2.75, value);
    assert_true(value[0] == 3);
    assert_true(value[1] > 0.2F && value[1] < 0.8F);
    for (uint32_t p = 0; p < WIDTH * HEIGHT; p++) image.value[2 * p + 1] = 0;
    value_at(&image, SAMPLER_LINEAR, 2.25, 2.75, value);
    assert_true(value[0] > 3 && value[0] < 1000 && value[1] == 0);
    image_free(&image);
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(centres_are_exact),
        cmocka_unit_test(definitions),
        cmocka_unit_test(nearest),
        cmocka_unit_test(edges),
        cmocka_unit_test(transparent_neighbours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
