/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: how many shapes and paths a layer must have, where the page has the corners of a
 * rectangle, edits whose effect is read off the spline. */
#include "figure.h"

#include "c1.h"
#include "edits_io.h"
#include "palette.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <string.h>

/* 4 x 2 squares of side 2, degree 5: [0,8] x [0,4]. */
static void set_up(struct spline *s) {
    struct recipe r = {.nx = 4, .ny = 2, .spacing = 2};
    struct grid g;
    struct err err;
    triangulate(&g, &r, 5, 0);
    assert_true(grid_build(&g, &err));
    assert_true(spline_identity(s, &g, &err));
}

static void parse(struct script *script, const char *text) {
    struct err err;
    assert_true(edits_parse(script, "t", text, strlen(text), &err));
}

static void draw(struct drawing *d, const struct figure_content *content, unsigned layers,
                 enum figure_side side) {
    struct figure_options options = {.side = side, .layers = layers, .width = 828};
    struct err err;
    assert_true(figure_draw(d, content, &options, &err));
}

static size_t count_ops(const struct drawing *d, enum drawing_op op) {
    size_t n = 0;
    for (size_t i = 0; i < d->op_count; i++) n += d->op[i] == op;
    return n;
}

/* ---- layers ---- */

static void layers_have_their_shapes(void **unused) {
    struct spline s;
    struct drawing d;
    size_t inner = 0, corners = 0;
    struct figure_content content = {.spline = &s};
    (void)unused;
    set_up(&s);
    for (uint32_t e = 0; e < s.grid.edge_count; e++) inner += grid_edge_is_inner(&s.grid, e);
    for (uint32_t p = 0; p < s.grid.point_count; p++) corners += c1_type(&s.grid, p) == TYPE_CORNER;

    draw(&d, &content, 1u << FIGURE_TRIANGLES, FIGURE_DEFORMED);
    assert_int_equal(d.shape_count, 1);
    assert_int_equal(count_ops(&d, DRAWING_MOVE), s.grid.edge_count);
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_OUTLINE, FIGURE_DOMAIN);
    assert_int_equal(count_ops(&d, DRAWING_MOVE), s.grid.edge_count - inner);
    assert_int_equal(count_ops(&d, DRAWING_CURVE), 0);
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_TYPES, FIGURE_BOTH);
    assert_int_equal(d.shape_count, 2 * s.grid.point_count + 2); /* and two titles */
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_POINTS, FIGURE_DOMAIN);
    assert_int_equal(d.shape_count, 1);
    assert_int_equal(count_ops(&d, DRAWING_MOVE), s.grid.point_count);
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_QUADS, FIGURE_DOMAIN);
    assert_int_equal(d.shape_count, 5 * inner);
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_NET, FIGURE_DOMAIN);
    assert_int_equal(count_ops(&d, DRAWING_LINE), s.grid.triangle_count * 3 * (5 + 4 + 3 + 2 + 1));
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_LABELS, FIGURE_DOMAIN);
    assert_int_equal(d.shape_count, 2 * (corners + s.grid.triangle_count)); /* each with a halo */
    drawing_free(&d);
    spline_free(&s);
}

/* The page has 28 units of margins, so 100 units for each of the 8 units of the rectangle. */
static void corners_are_where_the_page_has_them(void **unused) {
    struct spline s;
    (void)unused;
    set_up(&s);
    for (int down = 0; down < 2; down++) {
        struct figure_content content = {.spline = &s};
        struct figure_options options = {
            .layers = 1u << FIGURE_OUTLINE, .width = 828, .y_down = down};
        double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
        struct drawing d;
        struct err err;
        assert_true(figure_draw(&d, &content, &options, &err));
        for (size_t i = 0; i < d.point_count; i++)
            for (int c = 0; c < 2; c++) {
                lo[c] = fmin(lo[c], d.point[i][c]);
                hi[c] = fmax(hi[c], d.point[i][c]);
            }
        assert_true(lo[0] == 14 && hi[0] == 814 && lo[1] == 14 && hi[1] == 414);
        /* the first edge begins at vertex 0, which is (0, 0) */
        assert_true(d.point[0][1] == (down ? 14 : 414));
        drawing_free(&d);
    }
    spline_free(&s);
}

/* The cells of the layer of growth cover the domain, and their colours are those of det = 4. */
static void growth_covers_the_domain(void **unused) {
    struct spline s;
    struct drawing d;
    struct figure_content content = {.spline = &s};
    double area = 0;
    (void)unused;
    set_up(&s);
    for (uint32_t p = 0; p < s.grid.point_count; p++)
        for (int c = 0; c < 2; c++) s.phi[p][c] *= 2;
    draw(&d, &content, 1u << FIGURE_JACOBIAN, FIGURE_DEFORMED);
    assert_int_equal(d.shape_count, 1);
    assert_int_equal(d.shape[0].ink.fill, 0xb0182bff & 0xfcfcfcff);
    for (size_t i = 0; i < d.point_count; i += 3) {
        const double *a = d.point[i], *b = d.point[i + 1], *c = d.point[i + 2];
        double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        assert_true(twice < 0); /* counter-clockwise in a world whose y grows upwards */
        area -= twice / 2;
    }
    assert_true(fabs(area - 800 * 400) < 1e-6);
    drawing_free(&d);
    spline_free(&s);
}

/* Faces of both orientations, one over the other: nothing must cancel. */
static void silhouettes_turn_one_way(void **unused) {
    static double vertex[4][3] = {{0, 0, 0}, {8, 0, 1}, {8, 4, 2}, {0, 4, 3}};
    static size_t start[] = {0, 4, 8, 11};
    static uint32_t index[] = {0, 1, 2, 3, 3, 2, 1, 0, 0, 2, 1};
    static char kind[] = "fff";
    struct model m = {4, 3, vertex, start, index, kind};
    struct spline s;
    struct drawing d;
    struct figure_content content = {.spline = &s, .model = {&m, &m}};
    size_t at = 0;
    (void)unused;
    set_up(&s);
    draw(&d, &content, 1u << FIGURE_TYPES, FIGURE_DOMAIN);
    assert_int_equal(d.shape[0].op_count, 4 + 1 + 4 + 1 + 3 + 1);
    for (int e = 0; e < 3; e++) {
        size_t n = start[e + 1] - start[e];
        double area = 0;
        for (size_t i = 0; i < n; i++) {
            const double *a = d.point[at + i], *b = d.point[at + (i + 1) % n];
            area += a[0] * b[1] - a[1] * b[0];
        }
        assert_true(area < 0);
        at += n;
    }
    drawing_free(&d);
    spline_free(&s);
}

/* ---- polylines ---- */

/* The page has 100 units for each of the 8 of the world with its squares: from -0.5 to 7.5, and
 * -0.5 to 3.5. */
static void lines_have_their_style(void **unused) {
    static const double at[][2] = {{0, 0}, {7, 3}, {7, 0}, {3, 2}};
    struct polylines p = {0};
    struct polylines_maker maker = {.p = &p};
    struct figure_content content = {.lines = &p};
    struct figure_options options;
    struct drawing d;
    struct err err;
    (void)unused;
    assert_true(polylines_word(&maker, "path", 4, &err));
    for (int i = 0; i < 2; i++) assert_true(polylines_point(&maker, at[i], &err));
    assert_true(polylines_word(&maker, "dot", 3, &err) && polylines_point(&maker, at[2], &err));
    assert_true(polylines_number(&maker, 1, &err) && polylines_point(&maker, at[3], &err));
    assert_true(polylines_number(&maker, 2, &err) && polylines_point(&maker, at[0], &err));
    polylines_end(&maker);

    figure_options_init(&options);
    options.width = 828;
    options.legend = false;
    options.lines = (struct figure_lines_style){
        .width = 3, .square = 1, .colour = {0x11223344}, .colour_count = 1};
    assert_true(figure_draw(&d, &content, &options, &err));
    assert_int_equal(d.shape_count, 4); /* squares first */
    assert_int_equal(d.shape[0].ink.fill, palette_category(1));
    assert_int_equal(d.shape[1].ink.fill, palette_value(0));
    assert_int_equal(d.shape[2].ink.fill, palette_value(1));
    for (int c = 0; c < 2; c++) {
        double lo = INFINITY, hi = -INFINITY;
        for (size_t i = 0; i < 4; i++) {
            lo = fmin(lo, d.point[d.shape[1].point + i][c]);
            hi = fmax(hi, d.point[d.shape[1].point + i][c]);
        }
        assert_true(fabs(lo - (c ? 114 : 314)) < 1e-9 && fabs(hi - lo - 100) < 1e-9);
    }
    assert_true(d.shape[3].ink.stroke == 0x11223344 && d.shape[3].ink.width == 3);
    drawing_free(&d);
    options.lines = (struct figure_lines_style){.width = 1, .dot = 5, .labels = true};
    assert_true(figure_draw(&d, &content, &options, &err));
    assert_int_equal(d.shape_count, 4 + 3); /* three of them have a label, the path has none */
    assert_int_equal(d.shape[0].ink.stroke, palette_category(0));
    assert_int_equal(d.shape[1].ink.fill, palette_category(1));
    drawing_free(&d);
    polylines_free(&p);
}

/* ---- images ---- */

static uint32_t shown(int channels, int alpha, bool straight, enum image_sample sample,
                      const float *value, uint32_t which) {
    struct image image = {.width = 2,
                          .height = 1,
                          .channels = channels,
                          .alpha = alpha,
                          .straight = straight,
                          .sample = sample};
    struct figure_image to;
    struct err err;
    uint32_t pixel;
    assert_true(image_allocate(&image, &err));
    memcpy(image.value, value, 2 * (size_t)channels * sizeof *value);
    assert_true(figure_image(&to, &image, NULL, &err));
    assert_true(to.frame[2] == 2 && to.frame[3] == 1);
    pixel = to.pixel[which];
    image_free(&image);
    free(to.pixel);
    return pixel;
}

static void images_become_colours(void **unused) {
    (void)unused;
    assert_int_equal(shown(1, -1, true, IMAGE_U8, (float[]){10, 20}, 1), 0x141414ff);
    assert_int_equal(shown(3, -1, true, IMAGE_U8, (float[]){1, 2, 3, 255, 254, 253}, 1),
                     0xfffefdff);
    /* 16 bits, halves and floats are stretched; not-a-numbers are black */
    assert_int_equal(shown(1, -1, true, IMAGE_U16, (float[]){100, 300}, 0), 0x000000ff);
    assert_int_equal(shown(1, -1, true, IMAGE_U16, (float[]){100, 300}, 1), 0xffffffff);
    assert_int_equal(shown(1, -1, true, IMAGE_FLOAT, (float[]){NAN, 3}, 0), 0x000000ff);
    /* alpha last, straight or multiplied; alpha first */
    assert_int_equal(shown(2, 1, true, IMAGE_U8, (float[]){9, 255, 60, 51}, 1), 0x3c3c3c33);
    assert_int_equal(shown(2, 1, false, IMAGE_U8, (float[]){9, 255, 12, 51}, 1), 0x3c3c3c33);
    assert_int_equal(shown(2, 0, true, IMAGE_U8, (float[]){255, 9, 51, 60}, 1), 0x3c3c3c33);
}

/* ---- edits ---- */

static void a_trace_tells_what_moved(void **unused) {
    static const char text[] = "move v^4,2 by 1 0.5 reach 4\n"
                               "begin\n"
                               "move v^2,2 by 0 0.25\n"
                               "rotate v^6,2 about 6 2 by 10 reach 2\n"
                               "end\n"
                               "move all by 100 100\n";
    const struct decles_options options = {.continuity = 1, .max_gain = 100};
    (void)unused;
    for (size_t line = 1; line <= 4; line++) { /* 2, 3 and 4 are one block */
        struct spline s, before;
        struct script script;
        struct edit_trace trace;
        struct err err;
        size_t anchors = 0, moved = 0, differ = 0;
        set_up(&s);
        set_up(&before);
        parse(&script, text);
        if (line > 1) {
            assert_true(edit_trace(&trace, &script, 1, &before, &options, &err));
            edit_trace_free(&trace);
        }
        assert_true(edit_trace(&trace, &script, line, &s, &options, &err));
        for (size_t i = 0; i < trace.move_count; i++) {
            const struct edit_move *m = &trace.move[i];
            assert_memory_equal(m->from, before.phi[m->point], sizeof m->from);
            assert_memory_equal(m->to, s.phi[m->point], sizeof m->to);
            anchors += m->role == EDIT_ANCHOR;
            moved += memcmp(m->from, m->to, sizeof m->from) != 0;
        }
        for (uint32_t p = 0; p < s.grid.point_count; p++)
            differ += memcmp(before.phi[p], s.phi[p], sizeof *s.phi) != 0;
        assert_int_equal(anchors, line == 1 ? 1 : 2);
        assert_int_equal(moved, differ);
        assert_true(moved > 0 && trace.condition_count > 0);
        edit_trace_free(&trace);
        script_free(&script);
        spline_free(&before);
        spline_free(&s);
    }
}

static void traces_that_cannot_be(void **unused) {
    static const struct {
        const char *text;
        size_t line;
        enum err_kind kind;
    } bad[] = {{"move 0 by 1 1\n", 2, ERR_INPUT},
               {"# nothing\nmove 0 by 1 1\n", 1, ERR_INPUT},
               {"pin all\n", 1, ERR_REFUSAL},
               {"pin 0\nmove 0 by 1 1\n", 2, ERR_REFUSAL}};
    const struct decles_options options = {.continuity = 1, .max_gain = 100};
    (void)unused;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        struct spline s;
        struct script script;
        struct edit_trace trace;
        struct err err = {0};
        set_up(&s);
        parse(&script, bad[i].text);
        assert_false(edit_trace(&trace, &script, bad[i].line, &s, &options, &err));
        assert_int_equal(err.kind, bad[i].kind);
        edit_trace_free(&trace);
        script_free(&script);
        spline_free(&s);
    }
}

/* Arrows and marks: one mark for each point that moves, and one or two arrows. */
static void the_sets_of_an_edit_are_drawn(void **unused) {
    const struct decles_options options = {.continuity = 1, .max_gain = 100};
    struct spline s;
    struct script script;
    struct edit_trace trace;
    struct drawing d;
    struct figure_content content = {.spline = &s, .edit = &trace};
    struct err err;
    size_t marks, arrows = 0;
    (void)unused;
    set_up(&s);
    parse(&script, "move v^4,2 by 1 0.5 reach 4\n");
    assert_true(edit_trace(&trace, &script, 1, &s, &options, &err));
    draw(&d, &content, 1u << FIGURE_SETS, FIGURE_DOMAIN);
    marks = d.shape_count;
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_SETS, FIGURE_DEFORMED);
    for (size_t i = 0; i < trace.move_count; i++) {
        const struct edit_move *m = &trace.move[i];
        bool wished = memcmp(m->from, m->wish, sizeof m->from) != 0;
        bool solved = memcmp(m->wish, m->to, sizeof m->from) != 0;
        arrows += (size_t)wished + solved;
    }
    assert_int_equal(d.shape_count, marks + 2 * arrows);
    assert_true(marks >= trace.move_count);
    drawing_free(&d);
    draw(&d, &content, 1u << FIGURE_QUADS, FIGURE_DOMAIN);
    assert_int_equal(d.shape_count, trace.condition_count);
    drawing_free(&d);
    edit_trace_free(&trace);
    script_free(&script);
    spline_free(&s);
}

/* However narrow the page, its scale of colours and the title are on it. */
static void scales_stay_on_the_page(void **unused) {
    struct spline s;
    struct figure_content content = {.spline = &s};
    (void)unused;
    set_up(&s);
    for (int width = 200; width <= 400; width += 20) {
        const struct figure_options options = {.layers = 1u << FIGURE_JACOBIAN,
                                               .width = width,
                                               .legend = true,
                                               .side = FIGURE_DEFORMED};
        struct drawing d;
        struct err err;
        drawing_init(&d);
        assert_true(figure_draw(&d, &content, &options, &err));
        for (size_t i = 0; i < d.point_count; i++) {
            assert_true(d.point[i][0] >= 0 && d.point[i][0] <= width);
            assert_true(d.point[i][1] >= 0 && d.point[i][1] <= d.height);
        }
        drawing_free(&d);
    }
    spline_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_have_their_shapes),
        cmocka_unit_test(corners_are_where_the_page_has_them),
        cmocka_unit_test(growth_covers_the_domain),
        cmocka_unit_test(silhouettes_turn_one_way),
        cmocka_unit_test(lines_have_their_style),
        cmocka_unit_test(images_become_colours),
        cmocka_unit_test(a_trace_tells_what_moved),
        cmocka_unit_test(traces_that_cannot_be),
        cmocka_unit_test(the_sets_of_an_edit_are_drawn),
        cmocka_unit_test(scales_stay_on_the_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
