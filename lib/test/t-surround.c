/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: random points of the dilation, sampled from the elements themselves, must lie in the
 * grid (found by locate, tested elsewhere); areas are counted on a fine raster. */
#include "surround.h"

#include "locate.h"
#include "obj_io.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A model of random elements: triangles, quadrilaterals, polylines, points, loose vertices. */
static void random_model(struct model *m, uint64_t *s) {
    size_t elements = (size_t)random_in(s, 0, 12), at = 0;
    double size = ldexp(1, (int)random_in(s, -20, 20)),
           offset = random_in(s, 0, 1) ? 1000 * size : 0;
    double small = random_in(s, 0, 2) ? 1 : 0.05;
    *m = (struct model){.vertex_count = 5 * elements + (size_t)random_in(s, 1, 4)};
    m->element_count = elements;
    m->vertex = calloc(m->vertex_count, sizeof *m->vertex);
    m->start = calloc(elements + 1, sizeof *m->start);
    m->index = calloc(5 * elements + 1, sizeof *m->index);
    m->kind = calloc(elements + 1, 1);
    assert_true(m->vertex && m->start && m->index && m->kind);
    for (size_t v = 0; v < m->vertex_count; v++)
        for (int c = 0; c < 3; c++)
            m->vertex[v][c] = v % 5 == 0 ? offset + size * random_unit(s)
                                         : m->vertex[v - v % 5][c] + size * small * random_unit(s);
    for (size_t e = 0; e < elements; e++) {
        m->kind[e] = "flp"[random_in(s, 0, 2)];
        size_t n = m->kind[e] == 'f'   ? (size_t)random_in(s, 3, 4)
                   : m->kind[e] == 'l' ? (size_t)random_in(s, 2, 5)
                                       : 1;
        for (size_t i = 0; i < n; i++) m->index[at++] = (uint32_t)(5 * e + i);
        m->start[e + 1] = at;
    }
}

/* A random point of an element's projection (of a face: of a triangle of it), moved by less than
 * the margin. */
static void sample(const struct model *m, const int axes[3], double margin, uint64_t *s,
                   double p[2]) {
    double weight[3] = {0}, sum = 0, angle = 6.28 * random_unit(s), r = margin * random_unit(s);
    size_t v[3];
    for (int k = 0; k < 3; k++) v[k] = (size_t)random_in(s, 0, (int64_t)m->vertex_count - 1);
    if (m->element_count > 0 && random_in(s, 0, 5)) {
        size_t e = (size_t)random_in(s, 0, (int64_t)m->element_count - 1);
        const uint32_t *index = m->index + m->start[e];
        size_t n = m->start[e + 1] - m->start[e];
        size_t first = n > 1 ? (size_t)random_in(s, 0, (int64_t)n - 2) : 0;
        v[0] = index[first];
        v[1] = index[n > 1 ? first + 1 : 0];
        v[2] = m->kind[e] == 'f' && n == 3 ? index[(first + 2) % 3] : v[1];
    } else {
        v[1] = v[2] = v[0];
    }
    for (int k = 0; k < 3; k++) sum += weight[k] = random_unit(s) + 1e-9;
    for (int c = 0; c < 2; c++) {
        p[c] = (c ? sin(angle) : cos(angle)) * r * 0.999999;
        for (int k = 0; k < 3; k++) p[c] += weight[k] / sum * m->vertex[v[k]][axes[c]];
    }
}

static void check_covered(const struct grid *g, const struct model *m, double margin,
                          uint64_t seed) {
    struct locator locator;
    struct err err = {0};
    uint64_t s = seed;
    uint32_t hint = 0, t;
    double p[2], b[3];
    check_seed(seed, locator_init(&locator, g, &err));
    for (size_t v = 0; v < m->vertex_count; v++) {
        p[0] = m->vertex[v][g->axes[0]];
        p[1] = m->vertex[v][g->axes[1]];
        check_seed(seed, locate(&locator, p, &hint, &t, b));
    }
    for (int i = 0; i < 500 && margin > 0; i++) {
        sample(m, g->axes, margin, &s, p);
        check_seed(seed, locate(&locator, p, &hint, &t, b));
    }
    locator_free(&locator);
}

static void test_random_models(void **state) {
    static const char planes[][3] = {"xy", "yx", "xz", "zx", "yz", "zy"};
    int count = test_count(400);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        uint64_t s = seed;
        struct surround how = {.kind = (enum pattern_kind)(seed % 3),
                               .margin = -1,
                               .cells = (uint32_t)random_in(&s, 1, 40),
                               .flat = random_in(&s, 0, 1),
                               .lattice = {0, (int)random_in(&s, 12, 24)}};
        struct grid g = {.degree = 2};
        struct surround_report report;
        struct model m;
        struct err err = {0};
        random_model(&m, &s);
        assert_true(grid_axes(planes[random_in(&s, 0, 5)], 2, g.axes));
        if (random_in(&s, 0, 3) == 0) how.margin = fabs(m.vertex[0][0]) * random_unit(&s);
        if (random_in(&s, 0, 9) == 0 && m.vertex_count > 1) how.margin = 0;
        if (surround_grid(&g, &m, &how, &report, &err)) {
            check_seed(seed, g.has_depth == !how.flat);
            for (size_t v = 0; v < m.vertex_count && g.has_depth; v++) {
                double z = m.vertex[v][g.axes[2]];
                check_seed(seed, g.depth[0] <= z - 0.9999 * report.margin);
                check_seed(seed, g.depth[1] >= z + 0.9999 * report.margin);
            }
            check_covered(&g, &m, report.margin, seed);
            for (uint32_t v = 0; v < g.vertex_count; v++) {
                check_seed(seed, g.vertex[v][0] >= 0 && g.vertex[v][0] < 1 << how.lattice.bits);
                check_seed(seed, g.vertex[v][1] >= 0 && g.vertex[v][1] < 1 << how.lattice.bits);
            }
            grid_free(&g);
        } else { /* a single point only */
            check_seed(seed, err.kind == ERR_REFUSAL && m.vertex_count == 1);
        }
        free(m.vertex);
        free(m.start);
        free(m.index);
        free(m.kind);
    }
}

enum { RASTER = 1200 };

struct raster {
    int width, height;
    double low[2], pixel;
    unsigned char *bit;
};

static void set_triangle(struct raster *r, const double p[3][2]) {
    int first[2], last[2];
    double area =
        (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    for (int c = 0; c < 2; c++) {
        double low = fmin(p[0][c], fmin(p[1][c], p[2][c]));
        double high = fmax(p[0][c], fmax(p[1][c], p[2][c]));
        first[c] = (int)fmax(0, floor((low - r->low[c]) / r->pixel) - 1);
        last[c] = (int)fmin((c ? r->height : r->width) - 1, (high - r->low[c]) / r->pixel + 1);
    }
    for (int y = first[1]; y <= last[1]; y++)
        for (int x = first[0]; x <= last[0]; x++) {
            double q[2] = {r->low[0] + (x + 0.5) * r->pixel, r->low[1] + (y + 0.5) * r->pixel};
            bool inside = true;
            for (int k = 0; k < 3; k++) {
                const double *a = p[k], *b = p[(k + 1) % 3];
                double side = (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
                inside = inside && side * area >= 0;
            }
            if (inside && area != 0) r->bit[y * r->width + x] = 1;
        }
}

static void set_point(struct raster *r, const double p[2]) {
    int x = (int)((p[0] - r->low[0]) / r->pixel), y = (int)((p[1] - r->low[1]) / r->pixel);
    r->bit[y * r->width + x] = 1;
}

/* Number of pixels within the distance (in pixels) of a set one: first along columns, then rows. */
static size_t dilated_count(const struct raster *r, double distance) {
    int w = r->width, h = r->height, reach = (int)distance + 1;
    int *up = malloc(sizeof *up * (size_t)w * (size_t)h);
    size_t count = 0;
    assert_non_null(up);
    for (int x = 0; x < w; x++) {
        for (int y = 0, d = h; y < h; y++) up[y * w + x] = d = r->bit[y * w + x] ? 0 : d + 1;
        for (int y = h - 1, d = h; y >= 0; y--) {
            d = r->bit[y * w + x] ? 0 : d + 1;
            if (d < up[y * w + x]) up[y * w + x] = d;
        }
    }
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            bool near = false;
            for (int k = -reach; k <= reach && !near; k++) {
                double dy = x + k >= 0 && x + k < w ? up[y * w + x + k] : h;
                near = dy * dy + (double)k * k <= distance * distance;
            }
            count += near;
        }
    free(up);
    return count;
}

static double grid_area(const struct grid *g) {
    double sum = 0;
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const uint32_t *c = g->triangle[t];
        sum += (double)predicate_area2(g->vertex[c[0]], g->vertex[c[1]], g->vertex[c[2]]) / 2;
    }
    return sum * g->lattice.step * g->lattice.step;
}

/* Area of the projection dilated by the margin, to about a pixel of its outline. */
static double dilated_area(const struct model *m, const int axes[3], double margin) {
    struct raster r = {0};
    double low[2], high[2], p[3][2];
    size_t count;
    for (int c = 0; c < 2; c++) {
        low[c] = HUGE_VAL;
        high[c] = -HUGE_VAL;
        for (size_t v = 0; v < m->vertex_count; v++) {
            low[c] = fmin(low[c], m->vertex[v][axes[c]]);
            high[c] = fmax(high[c], m->vertex[v][axes[c]]);
        }
        r.low[c] = low[c] - 1.1 * margin;
    }
    r.pixel = fmax(high[0] - low[0], high[1] - low[1]) / RASTER;
    r.width = (int)((high[0] - low[0] + 2.2 * margin) / r.pixel) + 1;
    r.height = (int)((high[1] - low[1] + 2.2 * margin) / r.pixel) + 1;
    r.bit = calloc((size_t)r.width * (size_t)r.height, 1);
    assert_non_null(r.bit);
    for (size_t e = 0; e < m->element_count; e++)
        for (size_t i = m->start[e] + 2; i < m->start[e + 1]; i++) {
            for (int c = 0; c < 2; c++) {
                p[0][c] = m->vertex[m->index[m->start[e]]][axes[c]];
                p[1][c] = m->vertex[m->index[i - 1]][axes[c]];
                p[2][c] = m->vertex[m->index[i]][axes[c]];
            }
            for (int k = 0; k < 3; k++) set_point(&r, p[k]);
            set_triangle(&r, (const double(*)[2])p);
        }
    count = dilated_count(&r, margin / r.pixel);
    free(r.bit);
    return (double)count * r.pixel * r.pixel;
}

static void test_worm(void **state) {
    const char *data = getenv("DATA");
    struct model m;
    struct err err = {0};
    char path[500];
    double area;
    (void)state;
    snprintf(path, sizeof path, "%s/models/virtual_worm_cuticle.obj", data ? data : "testdata");
    if (!model_read(&m, path, &err)) fail_msg("%s", err.message);
    area = dilated_area(&m, (int[3]){2, 1, 0}, 0.407937);
    for (int kind = 0; kind < 3; kind++) {
        struct surround how = {
            .kind = (enum pattern_kind)kind, .margin = -1, .cells = 40, .lattice = {0, 16}};
        struct grid g = {.degree = 5, .axes = {2, 1, 0}};
        struct surround_report report;
        assert_true(surround_grid(&g, &m, &how, &report, &err));
        assert_true(fabs(report.margin - 0.407937) < 1e-6);
        double ratio = grid_area(&g) / area;
        print_message("%s: area %.3f x the dilated projection\n", pattern_names[kind], ratio);
        assert_true(ratio > 1 && ratio <= 1.5);
        check_covered(&g, &m, report.margin, 1);
        grid_free(&g);
    }
    model_free(&m);
}

/* A square with a hole as one polygon that runs back through a slit, and a pentagram, whose middle
 * has winding number 2: insides are of non-zero winding. */
static void test_insides(void **state) {
    static double ring[10][3] = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                                 {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
    static double star[5][3] = {{0, 9, 0}, {-5, -8, 0}, {9, 3, 0}, {-9, 3, 0}, {5, -8, 0}};
    static size_t start[2] = {0, 10};
    static uint32_t index[10] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    static char kind[1] = "f";
    struct surround how = {.margin = 0.01, .cells = 90, .flat = true, .lattice = {0, 16}};
    struct model m = {10, 1, ring, start, index, kind};
    struct surround_report report;
    struct locator locator;
    struct err err = {0};
    double b[3];
    uint32_t hint = 0, t;
    (void)state;
    for (int k = 0; k < 3; k++) {
        struct grid g = {.degree = 1, .axes = {0, 1, 2}};
        how.kind = (enum pattern_kind)k;
        m.vertex = ring;
        m.vertex_count = start[1] = 10;
        assert_true(surround_grid(&g, &m, &how, &report, &err));
        assert_true(locator_init(&locator, &g, &err));
        assert_false(locate(&locator, (double[2]){4.5, 4.5}, &hint, &t, b));
        assert_true(locate(&locator, (double[2]){1.5, 4.5}, &hint, &t, b));
        assert_true(fabs(grid_area(&g) - 72) < 8);
        locator_free(&locator);
        grid_free(&g);
        m.vertex = star;
        m.vertex_count = start[1] = 5;
        hint = 0;
        g = (struct grid){.degree = 1, .axes = {0, 1, 2}};
        assert_true(surround_grid(&g, &m, &how, &report, &err));
        assert_true(locator_init(&locator, &g, &err));
        assert_true(locate(&locator, (double[2]){0, 0}, &hint, &t, b));
        assert_false(locate(&locator, (double[2]){0, -8}, &hint, &t, b));
        locator_free(&locator);
        grid_free(&g);
    }
}

static double point[1][3] = {{1, 2, 3}};
static double line[2][3] = {{0, 0, 0}, {10, 0, 0}};
static double far_apart[2][3] = {{-1.5e308, 0, 0}, {1.5e308, 0, 0}};

static const struct {
    double (*vertex)[3];
    size_t vertices;
    struct surround how;
    double depth[2];
    const char *message; /* NULL: a grid is made */
} cases[] = {
    {point,
     1,
     {.margin = -1, .cells = 16, .flat = true, .lattice = {0, 16}},
     {0, 0},
     "the model is a single point in this plane: it needs a margin"},
    {point, 1, {.margin = 0.5, .cells = 4, .lattice = {0, 16}}, {0, 0}, NULL},
    {line, 2, {.margin = 0, .cells = 16, .flat = true, .lattice = {0, 16}}, {0, 0}, NULL},
    {line,
     2,
     {.margin = 0, .cells = 16, .lattice = {0, 16}},
     {0, 0},
     "the model has no thickness along z and no margin: give a margin or a depth, or make a flat "
     "grid (--flat)"},
    {line, 2, {.margin = 0, .cells = 16, .lattice = {0, 16}}, {-1, 1}, NULL},
    {line,
     2,
     {.margin = 0, .cells = 16, .lattice = {0, 16}},
     {1, 2},
     "the depth 1..2 does not hold the model's z: 0..0"},
    {line,
     2,
     {.margin = 0, .cells = 16, .flat = true, .lattice = {1, 16}},
     {0, 0},
     "lattice too coarse: a cell of 0.625 is less than 1 steps of 1"},
    {line,
     2,
     {.kind = PATTERN_HEX, .cells = 8, .flat = true, .lattice = {1, 16}},
     {0, 0},
     "lattice too coarse: a cell of 1.25 is less than 2 steps of 1"},
    {line,
     2,
     {.margin = 0, .cells = 8, .flat = true, .lattice = {0.001, 12}},
     {0, 0},
     "lattice too fine: 15000 steps of 0.001 are not below 2^12"},
    {line,
     2,
     {.margin = 0, .cell = 0.001, .flat = true, .lattice = {0, 16}},
     {0, 0},
     "10000 cells along the longer side are more than 8000"},
    {far_apart,
     2,
     {.margin = 0, .cells = 8, .flat = true, .lattice = {0, 16}},
     {0, 0},
     "the model, its margin or its cells are too large"},
};

static void test_refusals(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct model m = {.vertex_count = cases[i].vertices, .vertex = cases[i].vertex};
        struct grid g = {.degree = 5, .axes = {0, 1, 2}};
        struct surround_report report;
        struct err err = {0};
        bool made;
        g.has_depth = cases[i].depth[0] < cases[i].depth[1];
        memcpy(g.depth, cases[i].depth, sizeof g.depth);
        made = surround_grid(&g, &m, &cases[i].how, &report, &err);
        assert_string_equal(made ? "" : err.message, cases[i].message ? cases[i].message : "");
        if (made)
            grid_free(&g);
        else
            assert_int_equal(err.kind, ERR_REFUSAL);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_models),
        cmocka_unit_test(test_worm),
        cmocka_unit_test(test_insides),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
