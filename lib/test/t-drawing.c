/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: counts, distances, and what letters must look like: within their box, none like another.
 */
#include "drawing.h"

#include "lettering.h"
#include "palette.h"
#include "testing.h"

#include <math.h>
#include <string.h>

static void shapes_own_their_paths(void **unused) {
    struct drawing d;
    struct err err;
    const struct drawing_ink ink = {.fill = 0xff0000ff};
    (void)unused;
    drawing_init(&d);
    drawing_paint(&d, &ink); /* nothing: no shape */
    drawing_move(&d, 1, 2);
    drawing_line(&d, 3, 4);
    drawing_paint(&d, &ink);
    drawing_disc(&d, 5, 6, 2);
    drawing_close(&d);
    drawing_paint(&d, &ink);
    assert_true(drawing_ok(&d, &err));
    assert_int_equal(d.shape_count, 2);
    assert_int_equal(d.shape[0].op_count, 2);
    assert_int_equal(d.shape[1].op, 2);
    assert_int_equal(d.shape[1].point, 2);
    drawing_free(&d);
}

/* Every point of the four arcs has the right distance from the centre. */
static void discs_are_round(void **unused) {
    struct drawing d;
    (void)unused;
    drawing_init(&d);
    drawing_disc(&d, 5, -6, 2);
    assert_int_equal(d.point_count, 13);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k <= 20; k++) {
            const double(*q)[2] = (const double(*)[2])(d.point + 3 * i);
            double x = k / 20.0, y = 1 - x, at[2];
            for (int c = 0; c < 2; c++)
                at[c] = y * y * y * q[0][c] + 3 * x * y * y * q[1][c] + 3 * x * x * y * q[2][c] +
                        x * x * x * q[3][c];
            assert_true(fabs(hypot(at[0] - 5, at[1] + 6) - 2) < 0.001);
        }
    drawing_free(&d);
}

static void arrows_end_where_they_should(void **unused) {
    static const double to[][2] = {{10, 0}, {3, 4}, {0, -2}, {-1, 0.5}};
    const struct drawing_ink ink = {.stroke = PALETTE_INK, .width = 1};
    (void)unused;
    for (size_t i = 0; i < sizeof to / sizeof *to; i++) {
        struct drawing d;
        double from[2] = {1, 2}, end[2] = {1 + to[i][0], 2 + to[i][1]};
        drawing_init(&d);
        drawing_arrow(&d, from, end, 5, &ink);
        assert_int_equal(d.shape_count, 2);
        assert_true(d.point[d.shape[1].point][0] == end[0]);
        assert_true(d.point[d.shape[1].point][1] == end[1]);
        drawing_arrow(&d, from, from, 5, &ink); /* nothing */
        assert_int_equal(d.shape_count, 2);
        drawing_free(&d);
    }
}

/* The points of one letter at size 6: raster units, y down, baseline 0. */
static void write_letter(struct drawing *d, char c) {
    char text[2] = {c};
    drawing_init(d);
    lettering(d, 0, 0, 6, LETTERING_LEFT, PALETTE_INK, text);
}

static void letters_fit_their_boxes(void **unused) {
    (void)unused;
    for (char c = '!'; c < 127; c++) {
        char text[2] = {c};
        struct drawing d;
        double width = lettering_width(text, 6);
        write_letter(&d, c);
        assert_int_equal(d.shape_count, 1);
        assert_true(width >= 1 && width <= 4);
        for (size_t i = 0; i < d.point_count; i++) {
            assert_true(d.point[i][0] >= 0 && d.point[i][0] <= width);
            assert_true(d.point[i][1] >= -6 && d.point[i][1] <= 2);
        }
        for (size_t i = 0; i < d.op_count; i++) /* every stroke goes somewhere, or is a dot */
            assert_true(d.op[i] != DRAWING_MOVE || d.op[i + 1] == DRAWING_LINE);
        drawing_free(&d);
    }
}

static bool same(const struct drawing *a, const struct drawing *b) {
    return a->op_count == b->op_count && memcmp(a->op, b->op, a->op_count) == 0 &&
           memcmp(a->point, b->point, a->point_count * sizeof *a->point) == 0;
}

static void letters_differ(void **unused) {
    static const char unknown[] = "\"#$&;?@\\^`~";
    (void)unused;
    for (char a = '!'; a < 127; a++)
        for (char b = (char)(a + 1); b < 127; b++) {
            struct drawing left, right;
            bool alike = (a == '0' && b == 'O') || (strchr(unknown, a) && strchr(unknown, b));
            write_letter(&left, a);
            write_letter(&right, b);
            if (same(&left, &right) != alike) fail_msg("'%c' and '%c'", a, b);
            drawing_free(&left);
            drawing_free(&right);
        }
}

static void text_is_aligned(void **unused) {
    static const enum lettering_align align[] = {LETTERING_LEFT, LETTERING_CENTRE, LETTERING_RIGHT};
    (void)unused;
    for (int i = 0; i < 3; i++) {
        struct drawing d;
        double width = lettering_width("H H", 12), lo = INFINITY, hi = -INFINITY;
        drawing_init(&d);
        lettering(&d, 100, 50, 12, align[i], PALETTE_INK, "H H");
        for (size_t k = 0; k < d.point_count; k++) {
            lo = fmin(lo, d.point[k][0]);
            hi = fmax(hi, d.point[k][0]);
        }
        assert_true(fabs(hi - lo - width) < 1e-12);
        assert_true(fabs(lo - (100 - width * i / 2)) < 1e-12);
        drawing_free(&d);
    }
    assert_true(lettering_width("", 12) == 0);
}

static double lightness(uint32_t colour) {
    return 0.3 * (colour >> 24) + 0.59 * (colour >> 16 & 255) + 0.11 * (colour >> 8 & 255);
}

static void colours_tell_what_they_should(void **unused) {
    (void)unused;
    assert_int_equal(palette_growth(1), 0xf7f7f7ff);
    assert_int_equal(palette_growth(-1), PALETTE_FOLD);
    assert_int_equal(palette_growth(0), PALETTE_FOLD);
    assert_int_equal(palette_growth(NAN), PALETTE_FOLD);
    assert_int_equal(palette_growth(INFINITY), palette_growth(1e9));
    for (double det = 0.01; det < 100; det *= 1.05) { /* darker and darker away from 1 */
        double a = lightness(palette_growth(det)), b = lightness(palette_growth(det * 1.05));
        assert_true(det * 1.05 < 1 ? a <= b : det > 1 ? a >= b : true);
        assert_true(palette_growth(det) != PALETTE_FOLD);
    }
    for (int i = 0; i < 100; i++)
        assert_true(lightness(palette_value(i / 100.0)) <=
                    lightness(palette_value((i + 1) / 100.0)));
    for (uint32_t a = 0; a < 8; a++)
        for (uint32_t b = 0; b < a; b++) assert_true(palette_category(a) != palette_category(b));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_own_their_paths),
        cmocka_unit_test(discs_are_round),
        cmocka_unit_test(arrows_end_where_they_should),
        cmocka_unit_test(letters_fit_their_boxes),
        cmocka_unit_test(letters_differ),
        cmocka_unit_test(text_is_aligned),
        cmocka_unit_test(colours_tell_what_they_should),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
