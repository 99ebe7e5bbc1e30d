/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: the sample points of each triangle as integers over `steps`, sorted; maps whose images
 * have a closed form; areas and centroids in integers. */
#include "tessellate.h"

#include "mem.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_MAX = 20 };

struct sample {
    int64_t at[2]; /* steps times the lattice point */
};

static int by_place(const void *a, const void *b) {
    return memcmp(a, b, sizeof(struct sample)); /* equality is all that matters */
}

/* steps times the point with these weights. */
static struct sample sample_at(const struct grid *g, uint32_t t, int i, int j, int k) {
    const uint32_t *c = g->triangle[t];
    struct sample s;
    for (int m = 0; m < 2; m++)
        s.at[m] = (int64_t)i * g->vertex[c[0]][m] + (int64_t)j * g->vertex[c[1]][m] +
                  (int64_t)k * g->vertex[c[2]][m];
    return s;
}

/* How many different sample points the triangles have. */
static size_t count_samples(const struct grid *g, int steps) {
    size_t n = 0, count = 0;
    struct sample *all;
    struct err err;
    assert_true(mem_new(all, g->triangle_count * (size_t)((steps + 1) * (steps + 2) / 2), &err));
    for (uint32_t t = 0; t < g->triangle_count; t++)
        for (int i = 0; i <= steps; i++)
            for (int j = 0; i + j <= steps; j++) all[n++] = sample_at(g, t, i, j, steps - i - j);
    qsort(all, n, sizeof *all, by_place);
    for (size_t i = 0; i < n; i++) count += i == 0 || by_place(&all[i - 1], &all[i]) != 0;
    free(all);
    return count;
}

static const int planes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};

/* A shear and its heights: polynomials of degree 1, so their control points are their values. */
static void shear(const double xy[2], double *image, double *heights) {
    image[0] = xy[0] + 0.5 * xy[1] + 3;
    image[1] = xy[1] - 0.25 * xy[0];
    heights[0] = -2 + 0.125 * xy[0];
    heights[1] = 5 - 0.125 * xy[1];
}

static void sheared(struct spline *s, int degree, bool depth, const int axes[3], uint64_t seed) {
    struct grid g;
    struct err err;
    random_grid(&g, 3, degree, seed);
    memcpy(g.axes, axes, sizeof g.axes);
    g.has_depth = depth;
    g.depth[0] = -2;
    g.depth[1] = 5;
    assert_true(spline_identity(s, &g, &err));
    for (uint32_t p = 0; p < s->grid.point_count; p++) {
        double xy[2], heights[2];
        memcpy(xy, s->phi[p], sizeof xy);
        shear(xy, s->phi[p], depth ? s->sigma[p] : heights);
    }
}

static void check_images(uint64_t seed, const struct tessellation *t, bool depth,
                         const int axes[3]) {
    for (uint32_t p = 0; p < t->net.point_count; p++) {
        double image[3], heights[2] = {0, 0}, nominal[2];
        grid_nominal(&t->net, p, nominal);
        check_seed(seed, memcmp(nominal, t->source[p], sizeof nominal) == 0);
        shear(nominal, image, heights);
        for (int sheet = 0; sheet < t->sheets; sheet++) {
            image[2] = depth ? heights[sheet] : 0;
            for (int c = 0; c < 3; c++)
                check_seed(seed, fabs(t->sheet[sheet][p][axes[c]] - image[c]) <=
                                     1e-14 * (10 + fabs(image[0]) + fabs(image[1])));
        }
    }
}

/* Twice the area of a face times steps^2, and three times steps times its centroid. */
static int64_t face_area(const struct tessellation *t, const uint32_t face[3], struct sample *sum) {
    int64_t at[3][2];
    *sum = (struct sample){{0, 0}};
    for (int m = 0; m < 3; m++) {
        struct grid_place place = grid_place(&t->net, face[m]);
        struct sample s =
            sample_at(&t->net, place.triangle, place.weight[0], place.weight[1], place.weight[2]);
        memcpy(at[m], s.at, sizeof s.at);
        for (int c = 0; c < 2; c++) sum->at[c] += s.at[c];
    }
    return (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
           (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
}

/* All faces have the area of a step^2-th of their triangle and no two have one centroid. */
static void check_faces(uint64_t seed, const struct tessellation *t) {
    const struct grid *g = &t->net;
    for (uint32_t e = 0; e < g->triangle_count; e++) {
        const uint32_t *c = g->triangle[e];
        int64_t area = predicate_area2(g->vertex[c[0]], g->vertex[c[1]], g->vertex[c[2]]);
        struct sample centroid[STEPS_MAX * STEPS_MAX];
        size_t n = 0;
        for (int row = 0; row < g->degree; row++)
            for (int place = 0; place <= 2 * row; place++) {
                uint32_t face[3];
                tessellation_face(t, e, row, place, face);
                check_seed(seed, face_area(t, face, &centroid[n++]) == area);
            }
        check_seed(seed, n == (size_t)(g->degree * g->degree));
        qsort(centroid, n, sizeof *centroid, by_place);
        for (size_t i = 1; i < n; i++)
            check_seed(seed, by_place(&centroid[i - 1], &centroid[i]) != 0);
    }
}

/* The steps of an edge go from corner l + 1 to l + 2 without a gap. */
static void check_steps(uint64_t seed, const struct tessellation *t) {
    const struct grid *g = &t->net;
    for (uint32_t e = 0; e < g->triangle_count; e++)
        for (int l = 0; l < 3; l++) {
            uint32_t at = g->triangle[e][(l + 1) % 3];
            for (int step = 0; step < g->degree; step++) {
                uint32_t end[2];
                tessellation_step(t, e, l, step, end);
                check_seed(seed, end[0] == at && end[1] != at);
                at = end[1];
            }
            check_seed(seed, at == g->triangle[e][(l + 2) % 3]);
        }
}

static void random_tessellations(void **state) {
    (void)state;
    for (int n = 0; n < test_count(200); n++) {
        uint64_t seed = UINT64_C(0x7e55e11a7e) + (uint64_t)n, random = seed;
        int degree = (int)random_in(&random, 1, 9), steps = (int)random_in(&random, 1, STEPS_MAX);
        bool depth = random_in(&random, 0, 1);
        const int *axes = planes[random_in(&random, 0, 5)];
        struct spline s;
        struct tessellation t;
        struct err err;
        sheared(&s, degree, depth, axes, seed);
        check_seed(seed, tessellate(&t, &s, steps, &err));
        check_seed(seed, t.sheets == (depth ? 2 : 1));
        check_seed(seed, t.net.point_count == count_samples(&s.grid, steps));
        check_images(seed, &t, depth, axes);
        check_faces(seed, &t);
        check_steps(seed, &t);
        tessellation_free(&t);
        spline_free(&s);
    }
}

/* What nothing moves is there to the last bit. */
static void identity(void **state) {
    struct grid g;
    struct spline s;
    struct tessellation t;
    struct err err;
    (void)state;
    random_grid(&g, 4, 5, 77);
    g.lattice = (struct lattice){0.1, 0.3, -0.7};
    assert_true(spline_identity(&s, &g, &err));
    assert_true(tessellate(&t, &s, 7, &err));
    for (uint32_t p = 0; p < t.net.point_count; p++) {
        assert_memory_equal(t.sheet[0][p], t.source[p], sizeof t.source[p]);
        assert_true(t.sheet[0][p][2] == 0);
    }
    tessellation_free(&t);
    spline_free(&s);
}

static void refusals(void **state) {
    const int axes[3] = {0, 1, 2};
    struct spline s;
    struct tessellation t;
    struct err err = {0};
    (void)state;
    sheared(&s, 2, false, axes, 5);
    for (uint32_t p = 0; p < s.grid.point_count; p++) s.phi[p][0] = p % 2 ? 1.7e308 : -1.7e308;
    s.phi[s.grid.vertex_count][0] = 1e308;
    s.grid.lattice.x0 = -1.7e308;
    assert_false(tessellate(&t, &s, 4, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "exceeds the range of numbers"));
    assert_null(t.source);

    s.grid.triangle_count = 9000; /* counts alone: 1000 steps make some 4.5e9 points */
    assert_false(tessellate(&t, &s, TESSELLATE_STEPS_MAX, &err));
    assert_int_equal(err.kind, ERR_REFUSAL);
    assert_non_null(strstr(err.message, "more points than 32 bits can number"));
    spline_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_tessellations),
        cmocka_unit_test(identity),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
