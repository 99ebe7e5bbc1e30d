/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is drawn is what it is called. */
#include "icc_show.h"

#include "balls.h"
#include "testing.h"

#include <stdlib.h>
#include <string.h>

struct scene {
    struct cage cage;
    struct icc_grid g;
};

static void scene_init(struct scene *s, uint64_t seed, enum icc_kind kind) {
    const struct icc_grid_rule rule = {.points = 300, .warn = true, .function = {.kind = kind}};
    double vertex[14][2];
    struct err err = {0};
    random_cage(vertex, 14, 0.5, &seed);
    assert_true(cage_init(&s->cage, (const double(*)[2])vertex, 14, &err));
    assert_true(icc_grid_init(&s->g, &s->cage, &rule, &err));
}

static void scene_free(struct scene *s) {
    icc_grid_free(&s->g);
    cage_free(&s->cage);
}

static void show(const struct scene *s, enum icc_show what, struct polylines *p) {
    struct err err = {0};
    assert_true(icc_show_grid(&s->g, what, p, &err));
    assert_int_equal(p->start[p->line_count], p->point_count);
}

static size_t named(const struct polylines *p, const char *name) {
    size_t n = 0;
    for (size_t l = 0; l < p->line_count; l++)
        n += p->name_of[l] != POLYLINES_NO_NAME && strcmp(p->name[p->name_of[l]], name) == 0;
    return n;
}

static double apart(const double p[2], const double q[2]) {
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
}

static void dots(void **state) {
    struct scene s;
    struct polylines p;
    (void)state;
    scene_init(&s, 1, ICC_COUSIN);
    show(&s, ICC_SHOW_GRID, &p);
    assert_int_equal(p.line_count, s.g.function.valued);
    assert_int_equal(p.point_count, s.g.function.valued);
    assert_int_equal(named(&p, "maximum"), 1);
    assert_int_equal(named(&p, "inside"), s.g.function.reached - 1);
    polylines_free(&p);
    show(&s, ICC_SHOW_VALUES, &p);
    assert_int_equal(p.line_count, s.g.function.valued);
    assert_true(p.range[1] == 10 && p.range[0] > 0);
    polylines_free(&p);
    show(&s, ICC_SHOW_GRASSFIRE, &p);
    assert_int_equal(p.line_count, s.g.domain.inside_count);
    assert_true(p.range[0] == 1 && p.range[1] >= 4);
    polylines_free(&p);
    scene_free(&s);
}

/* f falls by 0.95 along each line of the tree inside. */
static void values_and_tree(void **state) {
    struct scene s;
    struct polylines tree;
    double h;
    (void)state;
    scene_init(&s, 2, ICC_COUSIN);
    h = s.g.domain.h;
    show(&s, ICC_SHOW_TREE, &tree);
    assert_int_equal(tree.line_count, s.g.function.valued - 1);
    for (size_t l = 0; l < tree.line_count; l++) {
        assert_int_equal(tree.start[l + 1] - tree.start[l], 2);
        assert_true(apart(tree.point[2 * l], tree.point[2 * l + 1]) < 1.5 * h);
        assert_true(tree.value[l] >= 1);
    }
    polylines_free(&tree);
    scene_free(&s);
}

static void triangles(void **state) {
    struct scene s;
    struct polylines p;
    double area = 0, h;
    (void)state;
    scene_init(&s, 3, ICC_HARMONIC);
    h = s.g.domain.h;
    show(&s, ICC_SHOW_TRIANGLES, &p);
    assert_int_equal(p.point_count, 4 * p.line_count);
    for (size_t l = 0; l < p.line_count; l++) {
        const double *a = p.point[4 * l], *b = p.point[4 * l + 1], *c = p.point[4 * l + 2];
        double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        assert_true(fabs(twice - h * h) < 1e-12);
        assert_memory_equal(a, p.point[4 * l + 3], sizeof p.point[0]);
        area += twice / 2;
    }
    assert_true(area > s.cage.area);
    polylines_free(&p);
    scene_free(&s);
}

/* Where it says so, and nowhere else, a point does not come back along its line. */
static void unreached(void **state) {
    size_t dots = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= 12; seed++) {
        struct scene s;
        struct polylines p;
        struct icc_lines lines = {0};
        scene_init(&s, seed, seed % 2 ? ICC_BIHARMONIC : ICC_COUSIN);
        show(&s, ICC_SHOW_EDGES, &p);
        for (size_t l = 0; l < p.line_count; l++) {
            struct icc_place place;
            struct icc_tally tally = {0};
            struct err err = {0};
            double q[2];
            if (strcmp(p.name[p.name_of[l]], "unreached") != 0) continue;
            assert_true(icc_grid_locate(&s.g, p.point[p.start[l]], &lines, &place, &tally, &err));
            assert_true(icc_grid_place(&s.g, &place, &lines, q, &tally, &err));
            check_seed(seed, tally.merged > 0 && apart(p.point[p.start[l]], q) > 1e-6);
            dots++;
        }
        assert_true(named(&p, "compression") > 0);
        polylines_free(&p);
        icc_lines_free(&lines);
        scene_free(&s);
    }
    assert_true(dots > 0);
}

static void integral_lines(void **state) {
    struct scene s;
    struct polylines p;
    struct err err = {0};
    double top[2];
    (void)state;
    scene_init(&s, 5, ICC_COUSIN);
    icc_domain_vertex(&s.g.domain, s.g.function.maximum, top);
    assert_true(icc_show_grid_lines(&s.g, 40, &p, &err));
    assert_int_equal(p.line_count, 40);
    for (size_t l = 0; l < 40; l++) {
        const double *first = p.point[p.start[l]], *last = p.point[p.start[l + 1] - 1];
        struct icc_place place = icc_show_place(&s.cage, l, 40);
        double at[2];
        assert_true(p.value[l] == (double)l);
        cage_point(&s.cage, place.side, place.lambda, at);
        assert_true(apart(first, at) < 1e-12);
        assert_true(apart(last, top) < 1e-12);
    }
    polylines_free(&p);
    scene_free(&s);
}

/* ---- method ray -------------------------------------------------------------------------------
 */

struct ray_scene {
    struct cage cage;
    struct icc_ray r;
};

static void ray_scene_init(struct ray_scene *s, uint64_t seed) {
    double vertex[14][2];
    struct err err = {0};
    random_cage(vertex, 14, 0.7, &seed);
    assert_true(cage_init(&s->cage, (const double(*)[2])vertex, 14, &err));
    assert_true(icc_ray_init(&s->r, &s->cage, NULL, 300, &err));
    assert_true(icc_ray_prepare(&s->r, ICC_RAY_LOOK_UP, &err));
}

static void ray_scene_free(struct ray_scene *s) {
    icc_ray_free(&s->r);
    cage_free(&s->cage);
}

static double area_of(const struct polylines *p, const char *name) {
    double twice = 0;
    for (size_t l = 0; l < p->line_count; l++) {
        if (strcmp(p->name[p->name_of[l]], name) != 0) continue;
        for (size_t i = p->start[l]; i + 1 < p->start[l + 1]; i++)
            twice += p->point[i][0] * p->point[i + 1][1] - p->point[i][1] * p->point[i + 1][0];
    }
    return twice / 2;
}

/* Triangles cover the cage, and their images the disk. */
static void ray_triangles(void **state) {
    struct ray_scene s;
    struct polylines p;
    struct err err = {0};
    (void)state;
    ray_scene_init(&s, 7);
    assert_true(icc_show_ray(&s.r, ICC_SHOW_TRIANGLES, &p, &err));
    assert_int_equal(p.line_count, s.r.mesh.mesh.triangle_count);
    assert_true(fabs(area_of(&p, "triangle") / s.cage.area - 1) < 1e-12);
    polylines_free(&p);
    assert_true(icc_show_ray(&s.r, ICC_SHOW_IMAGE, &p, &err));
    assert_int_equal(named(&p, "maximum"), 1);
    assert_true(fabs(area_of(&p, "triangle") / area_of(&p, "disk") - 1) < 1e-9);
    polylines_free(&p);
    assert_true(icc_show_ray(&s.r, ICC_SHOW_VALUES, &p, &err));
    assert_int_equal(p.line_count, s.r.mesh.mesh.vertex_count);
    assert_true(p.range[0] >= -2 && p.range[0] < 0 && p.range[1] == 0);
    polylines_free(&p);
    assert_true(icc_show_ray(&s.r, ICC_SHOW_GRID, &p, &err));
    assert_int_equal(named(&p, "outside"), s.r.mesh.rim_count);
    assert_int_equal(named(&p, "maximum"), 1);
    polylines_free(&p);
    ray_scene_free(&s);
}

/* All points of a line have its place, and t falls from 1 to 0. */
static void ray_lines(void **state) {
    enum { LINES = 60 };
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(8); seed++) {
        struct ray_scene s;
        struct polylines p;
        struct err err = {0};
        struct icc_ray_cursor cursor = {0};
        ray_scene_init(&s, seed);
        assert_true(icc_show_ray_lines(&s.r, LINES, &p, &err));
        for (size_t l = 0; l < LINES; l++) {
            struct icc_place place = icc_show_place(&s.cage, l, LINES), at;
            double before = 1;
            check_seed(seed, p.start[l + 1] - p.start[l] >= 2);
            for (size_t i = p.start[l]; i < p.start[l + 1]; i++) {
                check_seed(seed, icc_ray_coordinates(&s.r, &cursor, p.point[i], &at));
                if (at.t > 1e-3 && place.lambda > 1e-9 && place.lambda < 1 - 1e-9)
                    check_seed(seed,
                               at.side == place.side && fabs(at.lambda - place.lambda) < 1e-9);
                check_seed(seed, at.t <= before + 1e-12);
                before = at.t;
            }
            check_seed(seed, before < 1e-9);
        }
        polylines_free(&p);
        ray_scene_free(&s);
    }
}

/* At equal distances along the cage. */
static void places(void **state) {
    const double square[4][2] = {{0, 0}, {4, 0}, {4, 1}, {0, 1}};
    struct cage cage;
    struct err err = {0};
    (void)state;
    assert_true(cage_init(&cage, square, 4, &err));
    for (size_t i = 0; i < 10; i++) {
        static const double x[10] = {0, 1, 2, 3, 4, 4, 3, 2, 1, 0};
        struct icc_place place = icc_show_place(&cage, i, 10);
        double p[2];
        cage_point(&cage, place.side, place.lambda, p);
        assert_true(fabs(p[0] - x[i]) < 1e-12 && fabs(p[1] - (i > 4)) < 1e-12);
    }
    cage_free(&cage);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dots),          cmocka_unit_test(values_and_tree),
        cmocka_unit_test(triangles),     cmocka_unit_test(unreached),
        cmocka_unit_test(places),        cmocka_unit_test(integral_lines),
        cmocka_unit_test(ray_triangles), cmocka_unit_test(ray_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
