/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Deformations by method ray on triangles: hard pairs of cages and random ones; every map is
 * checked as it is printed, exactly: no triangle is turned over in source or target, and their
 * areas add up to those of the cages. Overlays are the deformation itself: the images of their
 * vertices and of points inside their triangles are those of icc_ray_map. */
#include "icc_plane.h"

#include "cages.h"
#include "num.h"
#include "planar.h"
#include "plane_map_io.h"
#include "testing.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bound {
    struct cage cage[2];
    struct icc_map map;
};

static bool bind(struct bound *b, const struct cage_pair *p, struct err *err) {
    const struct icc_rule rule = {.has_points = true, .points = 600};
    *b = (struct bound){0};
    return cage_init(&b->cage[0], (const double(*)[2])p->source, p->count, err) &&
           cage_init_like(&b->cage[1], (const double(*)[2])p->target, p->count, &b->cage[0], err) &&
           icc_map_init(&b->map, &b->cage[0], &rule, ICC_FORWARD, err) &&
           icc_map_target(&b->map, &b->cage[1], err);
}

static void unbind(struct bound *b) {
    icc_map_free(&b->map);
    for (int m = 0; m < 2; m++) cage_free(&b->cage[m]);
}

/* Twice the area of a triangle; its sign is exact. */
static long double area2(const double *a, const double *b, const double *c) {
    long double l = ((long double)b[0] - a[0]) * ((long double)c[1] - a[1]);
    long double r = ((long double)b[1] - a[1]) * ((long double)c[0] - a[0]);
    const double *corner[3] = {a, b, c};
    mpq_t area, p[3][2];
    int sign;
    if (fabsl(l - r) > 1e-17L * (fabsl(l) + fabsl(r))) return l - r;
    mpq_init(area);
    for (int i = 0; i < 3; i++) {
        mpq_inits(p[i][0], p[i][1], NULL);
        for (int k = 0; k < 2; k++) mpq_set_d(p[i][k], corner[i][k]);
    }
    planar_area2(area, p[0], p[1], p[2]);
    sign = mpq_sgn(area);
    for (int i = 0; i < 3; i++) mpq_clears(p[i][0], p[i][1], NULL);
    mpq_clear(area);
    return sign * 1e-300L;
}

static int compare_points(const void *a, const void *b) {
    const double *p = a, *q = b;
    if (p[0] != q[0]) return p[0] < q[0] ? -1 : 1;
    return (p[1] > q[1]) - (p[1] < q[1]);
}

/* Are all vertices of the cage, so rounded, among those of the map? */
static bool has_vertices(const struct plane_map *map, int plane, const struct cage *c, int digits) {
    double(*sorted)[2] = calloc(map->vertex_count, sizeof *sorted);
    bool ok = true;
    memcpy(sorted, map->at[plane], map->vertex_count * sizeof *sorted);
    qsort(sorted, map->vertex_count, sizeof *sorted, compare_points);
    for (size_t k = 0; k < c->count; k++) {
        double p[2] = {num_rounded(c->vertex[k][0], digits), num_rounded(c->vertex[k][1], digits)};
        ok = ok && bsearch(p, sorted, map->vertex_count, sizeof *sorted, compare_points);
    }
    free(sorted);
    return ok;
}

/* Sound, of the right area, with all vertices of the cages. */
static bool is_sound(const struct plane_map *map, const struct bound *b, int digits) {
    bool ok = true;
    for (int m = 0; ok && m < 2; m++) {
        const struct cage *c = &b->cage[m];
        const double(*v)[2] = (const double(*)[2])c->vertex;
        long double sum = 0, most = 0;
        int d = m == 1 ? digits : 0;
        for (size_t k = 0; k < c->count; k++) {
            most = fmaxl(most, fmaxl(fabsl(v[k][0]), fabsl(v[k][1])));
            if (k > 0 && k + 1 < c->count) sum -= area2(v[0], v[k], v[k + 1]);
        }
        for (size_t t = 0; t < map->triangle_count; t++) {
            const uint32_t *i = map->triangle[t];
            long double area = area2(map->at[m][i[0]], map->at[m][i[1]], map->at[m][i[2]]);
            if (!(area > 0)) return false;
            sum += area;
        }
        ok = ok && has_vertices(map, m, c, d) &&
             fabsl(sum) <= 2 * (d ? powl(10, 1 - d) : 1e-14L) * most * c->perimeter;
    }
    return ok;
}

/* ---- what is written ---- */

struct text {
    char *bytes;
    size_t length, cap;
};

static void append(void *context, const char *bytes, size_t length) {
    struct text *t = context;
    if (t->length + length + 1 > t->cap) {
        t->cap = 2 * (t->length + length + 1);
        t->bytes = realloc(t->bytes, t->cap);
    }
    memcpy(t->bytes + t->length, bytes, length);
    t->length += length;
    t->bytes[t->length] = '\0';
}

static void read_face(const char *at, uint32_t face[3]) {
    for (int c = 0; c < 3; c++) {
        char *end;
        face[c] = (uint32_t)strtoul(at, &end, 10) - 1;
        assert_int_equal(*end, '/');
        assert_int_equal(strtoul(end + 1, &end, 10) - 1, face[c]);
        at = end;
    }
}

/* The map as its OBJ says, read without lib/. */
static void read_map(struct plane_map *map, char *text) {
    char *save = NULL, *end;
    size_t seen = 0, n = 0;
    *map = (struct plane_map){0};
    for (char *at = text; *at; at++) n += *at == '\n';
    for (int m = 0; m < 2; m++) map->at[m] = calloc(n, sizeof *map->at[m]);
    map->triangle = calloc(n, sizeof *map->triangle);
    for (char *line = strtok_r(text, "\n", &save); line; line = strtok_r(NULL, "\n", &save)) {
        if (line[0] == 'f') {
            read_face(line + 1, map->triangle[map->triangle_count++]);
        } else if (line[1] == 't') {
            map->at[0][seen][0] = strtod(line + 2, &end);
            map->at[0][seen++][1] = strtod(end, NULL);
        } else {
            map->at[1][map->vertex_count][0] = strtod(line + 1, &end);
            map->at[1][map->vertex_count++][1] = strtod(end, &end);
            assert_string_equal(end, " 0");
        }
    }
    assert_int_equal(seen, map->vertex_count);
}

static bool prints_sound(const struct plane_map *map, const struct bound *b, int digits) {
    struct text text = {0};
    struct plane_map printed;
    struct out out;
    struct err err;
    assert_true(out_open_sink(&out, append, &text, &err));
    plane_map_write(&out, map, "", digits);
    assert_true(out_close(&out, &err));
    read_map(&printed, text.bytes);
    bool ok = is_sound(&printed, b, digits) && printed.triangle_count == map->triangle_count;
    plane_map_free(&printed);
    free(text.bytes);
    return ok;
}

/* The map's images of random points are those of the deformation. */
static double worst_error(const struct plane_map *map, struct bound *b, uint64_t *state) {
    struct icc_ray_cursor cursor = {0, 0};
    double worst = 0;
    for (int i = 0; i < 300; i++) {
        const uint32_t *t = map->triangle[random_in(state, 0, (int64_t)map->triangle_count - 1)];
        double w[3], sum = 0, p[2] = {0, 0}, q[2] = {0, 0}, r[2];
        for (int k = 0; k < 3; k++) sum += w[k] = random_unit(state) + 1e-3;
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 2; c++) {
                p[c] += w[k] / sum * map->at[0][t[k]][c];
                q[c] += w[k] / sum * map->at[1][t[k]][c];
            }
        if (!icc_ray_map(&b->map.ray[0], &b->map.ray[1], &cursor, p, r)) continue; /* by rounding */
        worst = fmax(worst, hypot(q[0] - r[0], q[1] - r[1]));
    }
    return worst / b->cage[1].diameter;
}

static double largest(const struct plane_map *map) {
    double most = 0;
    for (size_t t = 0; t < map->triangle_count; t++) {
        const double *a = map->at[0][map->triangle[t][0]], *b = map->at[0][map->triangle[t][1]],
                     *c = map->at[0][map->triangle[t][2]];
        most = fmax(most, (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    return most / 2;
}

static void check_overlay(uint64_t seed, struct bound *b, int digits, double stretch) {
    struct plane_map map;
    struct err err = {0};
    bool ok = icc_overlay(&map, &b->map.ray[0], &b->map.ray[1], 0, digits, &err);
    uint64_t state = seed;
    if (!ok) fprintf(stderr, "seed %d, %d digits: %s\n", (int)seed, digits, err.message);
    check_seed(seed, ok);
    check_seed(seed, prints_sound(&map, b, digits));
    if (digits == 0) check_seed(seed, worst_error(&map, b, &state) < 1e-11 * stretch);
    plane_map_free(&map);
}

static void check_plane(uint64_t seed, struct bound *b, double triangles, int digits) {
    struct icc_plane p = {&b->map, b->cage[0].area / triangles, digits};
    struct icc_plane_report report;
    struct plane_map map;
    struct err err = {0};
    bool ok = icc_plane(&map, &p, &report, &err);
    if (!ok) fprintf(stderr, "seed %d: %s\n", (int)seed, err.message);
    check_seed(seed, ok);
    check_seed(seed, prints_sound(&map, b, digits));
    check_seed(seed, report.overlay || report.sample.left == 0);
    if (digits == 0 && report.sample.flipped == 0) check_seed(seed, largest(&map) <= p.max_area);
    plane_map_free(&map);
}

static void test_hard_pairs(void **unused) {
    int last = CAGE_PAIRS - (test_count(100) < 1000); /* the last one takes seconds */
    (void)unused;
    for (int i = 0; i < last; i++) {
        struct cage_pair p;
        struct bound b;
        struct err err = {0};
        cage_pair_make(&p, i);
        if (!bind(&b, &p, &err)) fprintf(stderr, "%s: %s\n", p.name, err.message);
        check_seed((uint64_t)i, err.kind == ERR_NONE);
        check_overlay((uint64_t)i, &b, i % 2 ? 6 : 0, p.stretch);
        check_plane((uint64_t)i, &b, 100, 0);
        check_plane((uint64_t)i, &b, 2000, 5);
        unbind(&b);
        cage_pair_free(&p);
    }
}

static void test_random_pairs(void **unused) {
    (void)unused;
    for (int i = 0; i < test_count(6); i++) {
        struct cage_pair p;
        struct bound b;
        struct err err = {0};
        cage_pair_random(&p, 4, 60, (uint64_t)i);
        if (!bind(&b, &p, &err)) fprintf(stderr, "%s\n", err.message);
        check_seed((uint64_t)i, err.kind == ERR_NONE);
        check_overlay((uint64_t)i, &b, 0, p.stretch);
        check_overlay((uint64_t)i, &b, 6, p.stretch);
        check_plane((uint64_t)i, &b, 500, i % 2 ? 5 : 0);
        unbind(&b);
        cage_pair_free(&p);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hard_pairs),
        cmocka_unit_test(test_random_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
