/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "colour_io.h"
#include "texture.h"

#include "testing.h"

#include <math.h>
#include <string.h>

static void colours(void **unused) {
    static const struct {
        const char *word;
        bool ok;
        uint32_t colour;
    } cases[] = {{"black", true, 0x000000ff},
                 {"none", true, 0},
                 {"12aBcD", true, 0x12abcdff},
                 {"#12aBcD80", true, 0x12abcd80},
                 {"#fff", false, 0},
                 {"12aBcG", false, 0},
                 {"", false, 0},
                 {"#", false, 0},
                 {"blackish", false, 0},
                 {"123456789", false, 0}};
    uint32_t colour, pair[2], list[3];
    double rgba[4];
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(colour_read(cases[i].word, strlen(cases[i].word), &colour), cases[i].ok);
        if (cases[i].ok) assert_int_equal(colour, cases[i].colour);
    }
    assert_true(colour_read_pair("red,#00000001", pair) && pair[0] == 0xff0000ff && pair[1] == 1);
    assert_false(colour_read_pair("red", pair) || colour_read_pair("red,", pair) ||
                 colour_read_pair(",red", pair) || colour_read_pair("red,red,red", pair));
    assert_int_equal(colour_read_list("red,none,00000002", 3, list), 3);
    assert_true(list[0] == 0xff0000ff && list[1] == 0 && list[2] == 2);
    assert_int_equal(colour_read_list("blue", 3, list), 1);
    assert_true(colour_read_list("", 3, list) == 0 && colour_read_list("red,,red", 3, list) == 0 &&
                colour_read_list("red,red,red,red", 3, list) == 0);
    texture_colour(0xff003380, rgba);
    assert_true(rgba[0] == 1 && rgba[1] == 0 && rgba[2] == 0.2 && rgba[3] == 128 / 255.0);
    (void)unused;
}

/* Colours come multiplied by alpha; squares begin at the origin. */
static void squares(void **unused) {
    const double lo[2] = {1, 2}, hi[2] = {9, 6}, none[2] = {0, 0};
    struct texture t = {.colour = {{1, 0.5, 0.25, 0.5}, {0, 1, 0, 1}}};
    double rgba[4];
    texture_squares(&t, lo, hi, 4); /* sides of 2 */
    texture_mean(&t, (const double[2]){1.5, 2.5}, none, none, rgba);
    assert_true(rgba[0] == 0.5 && rgba[1] == 0.25 && rgba[2] == 0.125 && rgba[3] == 0.5);
    texture_mean(&t, (const double[2]){3.5, 2.5}, none, none, rgba);
    assert_true(rgba[0] == 0 && rgba[1] == 1 && rgba[2] == 0 && rgba[3] == 1);
    texture_mean(&t, (const double[2]){0.5, 1.5}, none, none, rgba);
    assert_true(rgba[3] == 0.5);
    texture_mean(&t, (const double[2]){3, 3}, (const double[2]){1, 0}, (const double[2]){0, 1},
                 rgba);
    assert_true(fabs(rgba[0] - 0.25) < 1e-12 && fabs(rgba[3] - 0.75) < 1e-12);
    (void)unused;
}

static void check_near(const double got[4], double r, double g, double b, double a) {
    const double want[4] = {r, g, b, a};
    for (int k = 0; k < 4; k++) assert_true(fabs(got[k] - want[k]) < 1e-12);
}

/* A ramp, r = column, g = row, b = 0, seen through a frame with y upwards. */
static void images(void **unused) {
    struct image image = {
        .width = 40, .height = 30, .channels = 3, .alpha = -1, .sample = IMAGE_FLOAT};
    const double none[2] = {0, 0}, u[2] = {3, 1.5}, v[2] = {-1, 2}, wide[2] = {400, 0};
    struct texture t = {.image = &image};
    double rgba[4];
    assert_true(image_allocate(&image, &(struct err){0}));
    for (uint32_t i = 0; i < 1200; i++) {
        image.value[3 * i] = (float)(i % 40) + 0.5F;
        image.value[3 * i + 1] = (float)(i / 40) + 0.5F;
        image.value[3 * i + 2] = 0;
    }
    t.view = viewport_of_frame(40, 30, (const double[4]){0, 60, 80, 0}); /* two units a pixel */
    texture_mean(&t, (const double[2]){20, 20}, none, none, rgba);
    check_near(rgba, 10, 20, 0, 1);
    texture_mean(&t, (const double[2]){20, 20}, u, v, rgba); /* the mean of a ramp is its middle */
    check_near(rgba, 10, 20, 0, 1);
    texture_mean(&t, (const double[2]){-1, 20}, none, none, rgba);
    check_near(rgba, 0, 0, 0, 0);
    texture_mean(&t, (const double[2]){0, 20}, (const double[2]){8, 0}, none, rgba);
    assert_true(rgba[3] == 0.5); /* half of it lies outside */
    texture_mean(&t, (const double[2]){40, 20}, wide, none, rgba);
    assert_true(fabs(rgba[3] - 0.2) < 0.04);
    image_free(&image);
    (void)unused;
}

static void kinds_of_images(void **unused) {
    static const struct {
        int channels, alpha;
        bool straight;
        enum image_sample sample;
        float value[4];
        double want[4];
    } cases[] = {
        {1, -1, false, IMAGE_U8, {51}, {0.2, 0.2, 0.2, 1}},
        {2, 1, true, IMAGE_U16, {65535, 32767.5F}, {0.5, 0.5, 0.5, 0.5}},
        {2, -1, false, IMAGE_FLOAT, {0.25F, 9}, {0.25, 0.25, 0.25, 1}},
        {3, 2, false, IMAGE_FLOAT, {0.25F, 9, 0.5F}, {0.25, 0.25, 0.25, 0.5}},
        {4, 3, false, IMAGE_HALF, {0.25F, 0.5F, 0.125F, 0.5F}, {0.25, 0.5, 0.125, 0.5}},
        {4, 3, true, IMAGE_U8, {255, 0, 255, 0}, {0, 0, 0, 0}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double none[2] = {0, 0}, middle[2] = {0.5, 0.5};
        float value[4];
        struct image image = {.width = 1,
                              .height = 1,
                              .channels = cases[i].channels,
                              .alpha = cases[i].alpha,
                              .straight = cases[i].straight,
                              .sample = cases[i].sample,
                              .value = value};
        struct texture t = {.image = &image, .view = viewport_of_frame(1, 1, NULL)};
        double rgba[4];
        memcpy(value, cases[i].value, sizeof value);
        texture_mean(&t, middle, none, none, rgba);
        check_near(rgba, cases[i].want[0], cases[i].want[1], cases[i].want[2], cases[i].want[3]);
    }
    (void)unused;
}

/* Boxes in pictures. */
static void viewports(void **unused) {
    const double lo[2] = {-2, 1}, hi[2] = {6, 5};
    const uint32_t size[2] = {400, 100};
    struct viewport v = viewport_fit(lo, hi, size, false);
    assert_true(v.step[0] == 0.04 && v.step[1] == -0.04);
    assert_true(viewport_world(&v, 0, 200) == 2 && viewport_world(&v, 1, 0) == 5);
    assert_true(viewport_pixel(&v, 1, 1) == 100 && viewport_pixel(&v, 0, 2) == 200);
    assert_true(viewport_scale(&v, lo, hi, 0.7, 100, true)); /* 5.6 x 2.8 */
    assert_true(v.width == 6 && v.height == 3 && v.corner[0] == -2 && v.corner[1] == 1);
    assert_true(viewport_scale(&v, lo, lo, 0.7, 100, false) && v.width == 1 && v.height == 1);
    assert_false(viewport_scale(&v, lo, hi, 13, 100, false));
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours),         cmocka_unit_test(squares),   cmocka_unit_test(images),
        cmocka_unit_test(kinds_of_images), cmocka_unit_test(viewports),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
