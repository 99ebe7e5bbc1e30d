/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: colours and places that follow from the geometry by hand; which of two faces is nearer;
 * the sizes of things counted in pixels. */
#include "scene_model.h"
#include "scene_prisms.h"
#include "scene_render.h"

#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct scene_style plain = {.antialias = 1, .background = 0xffffffff};

static void add_square(struct scene *s, double lo, double hi, double depth, uint32_t colour) {
    struct err err;
    for (int half = 0; half < 2; half++) {
        struct scene_face face = {
            .colour = colour,
            .corner = {{lo, lo, depth}, {hi, half ? hi : lo, depth}, {half ? lo : hi, hi, depth}}};
        assert_true(scene_add_face(s, &face, &err));
    }
}

/* One pixel a unit, the world's 0,0 in the lower left corner. */
static void render(const struct scene *s, double azimuth, double elevation, uint32_t width,
                   uint32_t height, const struct scene_style *style, struct image *image) {
    const struct scene_camera camera = scene_camera(azimuth, elevation);
    const double frame[4] = {0, height, width, 0};
    const struct viewport view = viewport_of_frame(width, height, frame);
    struct err err;
    *image = (struct image){.width = width,
                            .height = height,
                            .channels = (style->background & 255) < 255 ? 4 : 3,
                            .alpha = (style->background & 255) < 255 ? 3 : -1,
                            .straight = (style->background & 255) < 255,
                            .sample = IMAGE_U8};
    assert_true(image_allocate(image, &err));
    assert_true(scene_render(s, &camera, &view, style, image, &err));
}

static void axes_are_a_right_handed_frame(void **unused) {
    (void)unused;
    for (int az = -400; az <= 400; az += 35)
        for (int el = -90; el <= 90; el += 15) {
            struct scene_camera c = scene_camera(az, el);
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++) {
                    double sum = 0;
                    for (int k = 0; k < 3; k++) sum += c.axis[i][k] * c.axis[j][k];
                    assert_true(fabs(sum - (i == j)) < 1e-15);
                }
            for (int k = 0; k < 3; k++) { /* right x up = towards */
                int i = (k + 1) % 3, j = (k + 2) % 3;
                double cross = c.axis[0][i] * c.axis[1][j] - c.axis[0][j] * c.axis[1][i];
                assert_true(fabs(cross - c.axis[2][k]) < 1e-15);
            }
        }
    struct scene_camera top = scene_camera(0, 90);
    assert_true(top.axis[0][0] == 1 && top.axis[1][1] == 1 && top.axis[2][2] == 1);
}

/* The nearer square hides the other, whichever is drawn first; outside is the background. */
static void the_nearer_is_seen(void **unused) {
    (void)unused;
    for (int order = 0; order < 2; order++) {
        struct scene s = {0};
        struct image image;
        for (int i = 0; i < 2; i++) {
            bool red = i == order;
            add_square(&s, red ? 2 : 4, red ? 8 : 12, red ? 1 : 0, red ? 0xff0000ff : 0x0000ffff);
        }
        render(&s, 0, 90, 16, 16, &plain, &image);
        for (uint32_t row = 0; row < 16; row++)
            for (uint32_t column = 0; column < 16; column++) {
                const float *p = image_pixel(&image, column, row);
                double x = column + 0.5, y = 15.5 - row;
                bool red = x > 2 && x < 8 && y > 2 && y < 8;
                bool blue = !red && x > 4 && x < 12 && y > 4 && y < 12;
                assert_true(red    ? p[0] > 150 && p[2] < 60
                            : blue ? p[2] > 150 && p[0] < 60
                                   : p[0] == 255 && p[2] == 255);
            }
        image_free(&image);
        scene_free(&s);
    }
}

/* A face has the same light whichever way its corners turn, and less when it looks away. */
static void faces_are_lit_from_both_sides(void **unused) {
    double light[3];
    (void)unused;
    for (int turn = 0; turn < 3; turn++) {
        struct scene s = {0};
        struct image image;
        struct err err;
        struct scene_face face = {.colour = 0x808080ff,
                                  .corner = {{1, 1, 0}, {15, 1, 0}, {1, 15, turn == 2 ? -40 : 0}}};
        if (turn == 1) {
            memcpy(face.corner[1], (double[3]){1, 15, 0}, sizeof face.corner[1]);
            memcpy(face.corner[2], (double[3]){15, 1, 0}, sizeof face.corner[2]);
        }
        assert_true(scene_add_face(&s, &face, &err));
        render(&s, 0, 90, 16, 16, &plain, &image);
        light[turn] = image_pixel(&image, 3, 12)[0];
        image_free(&image);
        scene_free(&s);
    }
    assert_true(light[0] == light[1]);
    assert_true(light[2] != light[0]);
}

/* Half-transparent glass over black shows half its own light; behind a face, nothing. */
static void glass_lets_through(void **unused) {
    const struct scene_style black = {.antialias = 1, .background = 0x000000ff};
    double own, pane;
    (void)unused;
    for (int behind = 0; behind < 2; behind++) {
        struct scene s = {0};
        struct image image;
        add_square(&s, 0, 8, 0, 0x808080ff);
        add_square(&s, 4, 16, behind ? -1 : 1, 0x80808080);
        render(&s, 0, 90, 16, 16, &black, &image);
        own = image_pixel(&image, 1, 14)[0];
        pane = image_pixel(&image, 14, 2)[0];
        assert_true(fabs(pane - own * 128 / 255) < 0.01);
        assert_true(fabs(image_pixel(&image, 6, 9)[0] - own) < 0.01); /* grey over the same grey */
        image_free(&image);
        scene_free(&s);
    }
}

/* A line of width w covers w pixels of each row that it crosses; a dot its area. */
static void lines_have_their_widths(void **unused) {
    const struct scene_style fine = {.antialias = 4, .background = 0xffffff00};
    struct scene s = {0};
    struct image image;
    struct err err;
    struct scene_line line = {.end = {{10.25, 2, 0}, {10.25, 30, 0}}, .width = 3, .colour = 0xff},
                      dot = {.end = {{24, 16, 0}, {24, 16, 0}}, .width = 9, .colour = 0xff};
    double covered = 0;
    (void)unused;
    assert_true(scene_add_line(&s, &line, &err) && scene_add_line(&s, &dot, &err));
    render(&s, 0, 90, 32, 32, &fine, &image);
    for (uint32_t column = 0; column < 16; column++) covered += image_pixel(&image, column, 9)[3];
    assert_true(fabs(covered / 255 - 3) < 0.01);
    covered = 0;
    for (uint32_t row = 0; row < 32; row++)
        for (uint32_t column = 16; column < 32; column++)
            covered += image_pixel(&image, column, row)[3];
    assert_true(fabs(covered / 255 - 3 * 4.5 * 4.5) < 1); /* a 12-gon: 3 r^2 */
    image_free(&image);
    scene_free(&s);
}

static void bounds_hold_everything(void **unused) {
    struct scene s = {0};
    struct scene_camera camera = scene_camera(30, 40);
    double lo[2], hi[2];
    struct err err = {0};
    (void)unused;
    assert_false(scene_bounds(&s, &camera, lo, hi, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    add_square(&s, -1, 2, 3, 0xff);
    assert_true(scene_bounds(&s, &camera, lo, hi, &err));
    for (size_t i = 0; i < s.face_count; i++)
        for (int l = 0; l < 3; l++)
            for (int c = 0; c < 2; c++) {
                double x = 0;
                for (int k = 0; k < 3; k++) x += camera.axis[c][k] * s.face[i].corner[l][k];
                assert_true(lo[c] < x && x < hi[c]);
            }
    scene_free(&s);
}

/* A pyramid: fans, smooth normals by area, permuted axes. */
static void models_become_faces(void **unused) {
    static double vertex[5][3] = {{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}, {3, 1, 1}};
    static size_t start[] = {0, 4, 7, 10, 13, 16, 18};
    static uint32_t index[] = {0, 3, 2, 1, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2};
    static char kind[] = "fffffl";
    static const int zy[3] = {2, 1, 0};
    struct model m = {5, 6, vertex, start, index, kind};
    struct scene s = {0};
    struct err err;
    (void)unused;
    assert_true(scene_add_model(&s, &m, zy, true, 0xff, &err));
    assert_int_equal(s.face_count, 6);
    assert_int_equal(s.line_count, 1);
    for (size_t i = 2; i < 6; i++) { /* the apex: (depth 3, y 1, x 1), its normal along the depth */
        assert_true(s.face[i].corner[2][2] == 3 && s.face[i].corner[2][0] == 1);
        assert_true(fabs(s.face[i].normal[2][0]) < 1e-15 && fabs(s.face[i].normal[2][1]) < 1e-15);
        assert_true(s.face[i].normal[2][2] > 0);
    }
    scene_free(&s);
}

/* The identity on a square of two triangles, with depth from -1 to 1 or without. */
static void two_triangles(struct spline *spline, int degree, bool depth) {
    struct recipe recipe = {.nx = 1, .ny = 1, .spacing = 2};
    struct grid g;
    struct err err;
    triangulate(&g, &recipe, degree, 0);
    g.has_depth = depth;
    g.depth[0] = -1;
    g.depth[1] = 1;
    assert_true(grid_build(&g, &err) && spline_identity(spline, &g, &err));
}

/* What two triangles with one inner edge have of each layer, on every sheet: 9 faces a triangle; 5
 * edges of 3 steps; 36 control points; 15 edges of the net in each of three directions; 5
 * conditions of two faces. Between two sheets: 4 walls of 3 steps of two faces, 4 uprights. */
static void layers_of_prisms_add_up(void **unused) {
    static const size_t faces[] = {18, 0, 0, 0, 10}, lines[] = {0, 15, 36, 90, 0};
    (void)unused;
    for (unsigned choice = 0; choice < 128; choice++)
        for (int depth = 0; depth < 2; depth++) {
            const unsigned layers = choice % 32, which = choice / 32;
            const struct scene_prisms_options options = {layers, which, 3};
            size_t face_count = 0, line_count = 0;
            struct spline spline;
            struct scene s = {0};
            struct err err;
            two_triangles(&spline, 5, depth);
            assert_true(scene_add_prisms(&s, &spline, &options, &err));
            for (unsigned i = 0; i < 5; i++) {
                size_t shown = !depth ? 1 : i < PRISMS_POINTS ? 2 : which % 2 + which / 2;
                face_count += layers >> i & 1 ? shown * faces[i] : 0;
                line_count += layers >> i & 1 ? shown * lines[i] : 0;
            }
            if (depth && layers >> PRISMS_GLASS & 1) face_count += 24;
            if (depth && layers >> PRISMS_TRIANGLES & 1) line_count += 4;
            assert_int_equal(s.face_count, face_count);
            assert_int_equal(s.line_count, line_count);
            scene_free(&s);
            spline_free(&spline);
        }
}

/* The net of the top of one triangle of degree 2 with coefficient 9 in the middle of an edge: a dot
 * there, four lines to it from points at height 1. */
static void nets_stand_at_their_coefficients(void **unused) {
    const struct scene_prisms_options options = {1u << PRISMS_NET | 1u << PRISMS_POINTS, 3, 1};
    size_t dots = 0, ends = 0;
    struct spline spline;
    struct scene s = {0};
    struct err err;
    (void)unused;
    two_triangles(&spline, 2, true);
    uint32_t middle = grid_point(&spline.grid, 0, 0, 1, 1);
    spline.sigma[middle][1] = 9;
    spline.phi[middle][0] = 0.75;
    assert_true(scene_add_prisms(&s, &spline, &options, &err));
    for (size_t i = 0; i < s.line_count; i++)
        for (int e = 0; e < 2; e++) {
            const double *end = s.line[i].end[e], *other = s.line[i].end[1 - e];
            if (end[2] != 9) continue;
            assert_true(end[0] == 0.75 && end[1] == spline.phi[middle][1]);
            assert_true(other[2] == 9 || other[2] == 1);
            dots += other[2] == 9;
            ends += other[2] == 1;
        }
    assert_int_equal(dots, 2);           /* both ends of one line */
    assert_true(ends == 4 || ends == 8); /* twice if two triangles share the edge */
    scene_free(&s);
    spline_free(&spline);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(axes_are_a_right_handed_frame),
        cmocka_unit_test(the_nearer_is_seen),
        cmocka_unit_test(faces_are_lit_from_both_sides),
        cmocka_unit_test(glass_lets_through),
        cmocka_unit_test(lines_have_their_widths),
        cmocka_unit_test(bounds_hold_everything),
        cmocka_unit_test(models_become_faces),
        cmocka_unit_test(layers_of_prisms_add_up),
        cmocka_unit_test(nets_stand_at_their_coefficients),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
