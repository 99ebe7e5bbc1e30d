/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oracles: all triangles in turn, in integers, for places; long double for weights; CRC-32 bit by
 * bit for checksums; the map without known places for the map with them. */
#include "bary_io.h"

#include "deform.h"
#include "grid_io.h"
#include "mem.h"
#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { POINTS = 60 };

static const int planes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

/* Twice a point's coordinates, as integers: a vertex, the middle of an edge, or anything. */
static void choose_point(const struct grid *g, uint64_t *s, int64_t twice[2]) {
    const uint32_t *corner = g->triangle[random_in(s, 0, g->triangle_count - 1)];
    const int32_t *u = g->vertex[corner[random_in(s, 0, 2)]];
    const int32_t *v = g->vertex[corner[random_in(s, 0, 2)]];
    bool anywhere = random_in(s, 0, 2) == 0;
    for (int k = 0; k < 2; k++) twice[k] = anywhere ? u[k] + random_in(s, -40, 40) : u[k] + v[k];
}

/* Four times the signed area of u, v and the point. */
static int64_t side(const int32_t *u, const int32_t *v, const int64_t twice[2]) {
    return (v[0] - u[0]) * (twice[1] - 2 * u[1]) - (v[1] - u[1]) * (twice[0] - 2 * u[0]);
}

/* The lowest triangle that holds the point; area[l]: of the point and the edge opposite corner l.
 */
static uint32_t search(const struct grid *g, const int64_t twice[2], int64_t area[3]) {
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        for (int l = 0; l < 3; l++)
            area[l] = side(g->vertex[g->triangle[t][(l + 1) % 3]],
                           g->vertex[g->triangle[t][(l + 2) % 3]], twice);
        if (area[0] >= 0 && area[1] >= 0 && area[2] >= 0) return t;
    }
    return GRID_NONE;
}

static void check_inside(const struct bary *bary, size_t i, const struct grid *g,
                         const int64_t area[3], double z, uint64_t seed) {
    const double *b = bary->place[i].b;
    int64_t sum = area[0] + area[1] + area[2];
    check_seed(seed, b[0] + b[1] + b[2] == 1);
    for (int l = 0; l < 3; l++) {
        check_seed(seed, fabsl(b[l] - (long double)area[l] / sum) < 1e-13L);
        check_seed(seed, (area[l] == 0) == (b[l] == 0));
    }
    check_seed(seed, (bary->weight != NULL) == bary->key.has_depth);
    if (!bary->weight) return;
    long double length = (long double)g->depth[1] - g->depth[0];
    check_seed(seed, fabsl(bary->weight[i][0] - (g->depth[1] - (long double)z) / length) < 1e-15L);
    check_seed(seed, fabsl(bary->weight[i][1] - ((long double)z - g->depth[0]) / length) < 1e-15L);
}

/* Locates points of all kinds, which become those of *bary and of `model`. */
static void locate_points(struct bary *bary, struct grid *g, double (*model)[3],
                          int64_t (*twice)[2], bool plane, uint64_t seed) {
    struct projection by;
    struct err err = {0};
    uint64_t s = seed;
    memcpy(g->axes, planes[random_in(&s, 0, 5)], sizeof g->axes);
    g->has_depth = random_in(&s, 0, 1);
    g->depth[0] = -2.5;
    g->depth[1] = 7;
    by = plane ? projection_of_plane() : projection_of_model(g);
    for (int i = 0; i < POINTS; i++) {
        double z = plane ? 0 : (double)random_in(&s, -3, 8);
        if (random_in(&s, 0, 4) == 0 && !plane) z = g->depth[random_in(&s, 0, 1)];
        choose_point(g, &s, twice[i]);
        model[i][by.axes[0]] = 0.5 * (double)twice[i][0];
        model[i][by.axes[1]] = 0.5 * (double)twice[i][1];
        model[i][by.axes[2]] = z;
    }
    struct bary_key key = {.domain = (uint32_t)random_bits(&s),
                           .model = (uint32_t)random_bits(&s),
                           .count = POINTS,
                           .triangle_count = g->triangle_count,
                           .has_depth = by.has_depth};
    assert_true(bary_locate(bary, &key, g, &by, model, &err));
}

static void places(void **unused) {
    for (int i = 0; i < test_count(300); i++) {
        struct grid g;
        struct bary bary;
        double model[POINTS][3];
        int64_t twice[POINTS][2], area[3];
        uint64_t seed = (uint64_t)i;
        size_t outside = 0, first = 0;
        random_grid(&g, 3, 1, seed);
        locate_points(&bary, &g, model, twice, i % 4 == 0, seed);
        for (size_t p = 0; p < POINTS; p++) {
            uint32_t t = search(&g, twice[p], area);
            double z = model[p][bary.key.has_depth ? g.axes[2] : 2];
            if (bary.key.has_depth && (z < g.depth[0] || z > g.depth[1])) t = GRID_NONE;
            check_seed(seed, bary.place[p].triangle == t);
            if (t != GRID_NONE)
                check_inside(&bary, p, &g, area, z, seed);
            else {
                if (outside++ == 0) first = p;
                check_seed(seed, memcmp(bary.place[p].b, model[p], sizeof model[p]) == 0);
            }
        }
        check_seed(seed, bary.outside == outside && (outside == 0 || bary.first == first));
        bary_free(&bary);
        grid_free(&g);
    }
    (void)unused;
}

/* A deformation of *g, whose ownership moves, by random displacements; of the heights too. */
static void random_spline(struct spline *s, struct grid *g, uint64_t seed) {
    struct err err = {0};
    uint64_t state = seed;
    assert_true(spline_identity(s, g, &err));
    for (uint32_t p = 0; p < s->grid.point_count; p++)
        for (int k = 0; k < 2; k++) {
            s->phi[p][k] += random_unit(&state) - 0.5;
            if (s->sigma) s->sigma[p][k] += random_unit(&state) - 0.5;
        }
}

struct results {
    double image[POINTS][3], gradient[POINTS][5];
};

/* The points of *bary under s, with places that are known or not. */
static void map_points(struct deform *d, const struct spline *s, const struct projection *by,
                       const struct bary *bary, bool known, double (*model)[3],
                       struct results *results, uint64_t seed) {
    struct deform_batch batch = {
        .count = POINTS, .points = model, .images = results->image, .gradient = results->gradient};
    struct err err = {0};
    assert_true(deform_init(d, s, by, known ? bary->place : NULL, &err));
    check_seed(seed, deform_points(d, &batch));
    check_seed(seed, batch.outside == bary->outside);
    check_seed(seed, batch.outside == 0 || batch.first == bary->first);
}

/* What a batch says about point i is what deform_point says, or that it does not move. */
static void check_single(struct deform *d, size_t i, const double point[3],
                         const struct results *results, uint64_t seed) {
    const double *gradient = results->gradient[i];
    const int *axes = d->projection.axes;
    double value[3], other[3], j[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (!deform_point(d, i, point, value, NULL)) memcpy(value, point, sizeof value);
    check_seed(seed, memcmp(results->image[i], value, sizeof value) == 0);
    if (deform_point(d, i, point, other, j))
        for (int k = 0; k < 3; k++) check_seed(seed, fabs(value[k] - other[k]) < 1e-13);
    for (int k = 0; k < 4; k++) check_seed(seed, gradient[k] == j[axes[k / 2]][axes[k % 2]]);
    check_seed(seed, gradient[4] == gradient[0] * gradient[3] - gradient[1] * gradient[2]);
}

/* Known places change neither images nor derivatives, by a single bit. */
static void known_places(void **unused) {
    for (int i = 0; i < test_count(200); i++) {
        struct grid g;
        struct spline s;
        struct bary bary;
        struct deform deform[2];
        struct results results[2];
        double model[POINTS][3];
        int64_t twice[POINTS][2];
        uint64_t seed = (uint64_t)i;
        bool plane = i % 4 == 0;
        random_grid(&g, 3, 1 + i % 6, seed);
        locate_points(&bary, &g, model, twice, plane, seed);
        random_spline(&s, &g, seed);
        struct projection by = plane ? projection_of_plane() : projection_of_model(&s.grid);
        for (int k = 0; k < 2; k++)
            map_points(&deform[k], &s, &by, &bary, k, model, &results[k], seed);
        check_seed(seed, memcmp(&results[0], &results[1], sizeof *results) == 0);
        for (size_t p = 0; p < POINTS; p++) {
            check_single(&deform[0], p, model[p], results, seed);
            check_seed(seed, !plane || results[0].image[p][2] == model[p][2]);
        }
        for (int k = 0; k < 2; k++) deform_free(&deform[k]);
        bary_free(&bary);
        spline_free(&s);
    }
    (void)unused;
}

/* Depths whose difference no double holds. */
static void wide_depths(void **unused) {
    const double depth[2] = {-1.5e308, 1.7e308};
    double a[2];
    depth_weights(depth, depth[0], a);
    assert_true(a[0] == 1 && a[1] == 0);
    depth_weights(depth, depth[1], a);
    assert_true(a[0] == 0 && a[1] == 1);
    depth_weights(depth, 1e307, a);
    assert_true(fabs(a[0] - 0.5) < 1e-15 && fabs(a[0] + a[1] - 1) < 1e-15);
    (void)unused;
}

/* ---- files ---- */

struct text {
    char path[40];
    char *bytes;
    size_t length;
};

static void load(struct text *text) {
    FILE *in = fopen(text->path, "rb");
    assert_non_null(in);
    assert_int_equal(fseek(in, 0, SEEK_END), 0);
    text->length = (size_t)ftell(in);
    rewind(in);
    text->bytes = calloc(text->length + 1, 1);
    assert_non_null(text->bytes);
    assert_int_equal(fread(text->bytes, 1, text->length, in), text->length);
    fclose(in);
}

static void open_text(struct text *text, struct out *out) {
    struct err err = {0};
    strcpy(text->path, "/tmp/t-bary.XXXXXX");
    int fd = mkstemp(text->path);
    assert_true(fd >= 0);
    close(fd);
    assert_true(out_open(out, text->path, &err));
}

static void close_text(struct text *text, struct out *out) {
    struct err err = {0};
    assert_true(out_close(out, &err));
    load(text);
}

static void write_text(struct text *text, const struct bary *bary, const char *added) {
    struct out out;
    open_text(text, &out);
    bary_write(&out, bary, added);
    close_text(text, &out);
}

static void free_text(struct text *text) {
    unlink(text->path);
    free(text->bytes);
}

static void check_same(const struct bary *a, const struct bary *b, uint64_t seed) {
    check_seed(seed, a->key.domain == b->key.domain && a->key.model == b->key.model);
    check_seed(seed, a->key.count == b->key.count);
    for (size_t i = 0; i < a->key.count; i++) {
        check_seed(seed, a->place[i].triangle == b->place[i].triangle);
        check_seed(seed, memcmp(a->place[i].b, b->place[i].b, sizeof a->place[i].b) == 0);
        if (a->weight && a->place[i].triangle != GRID_NONE)
            check_seed(seed, memcmp(a->weight[i], b->weight[i], sizeof a->weight[i]) == 0);
    }
}

/* Reading gives what was written, writing that the same bytes; so does reading without a key. */
static void round_trips(void **unused) {
    for (int i = 0; i < test_count(200); i++) {
        struct grid g;
        struct bary bary, with, without;
        struct err err = {0};
        double model[POINTS][3];
        int64_t twice[POINTS][2];
        uint64_t seed = (uint64_t)i;
        struct text once, twice_text;
        random_grid(&g, 3, 1, seed);
        locate_points(&bary, &g, model, twice, false, seed);
        write_text(&once, &bary, "bary a b");
        assert_true(bary_read(&with, once.path, &bary.key, &err));
        assert_string_equal(with.history, "# bary a b\n");
        check_seed(seed, with.outside == bary.outside && with.key.has_depth == bary.key.has_depth);
        check_seed(seed, bary.outside == 0 || with.first == bary.first);
        check_same(&bary, &with, seed);
        write_text(&twice_text, &with, NULL);
        check_seed(seed, once.length == twice_text.length &&
                             memcmp(once.bytes, twice_text.bytes, once.length) == 0);
        assert_true(bary_read(&without, once.path, NULL, &err));
        check_same(&bary, &without, seed);
        free_text(&once);
        free_text(&twice_text);
        bary_free(&bary);
        bary_free(&with);
        bary_free(&without);
        grid_free(&g);
    }
    (void)unused;
}

/* Every part of the key is verified. */
static void other_keys(void **unused) {
    struct grid g;
    struct bary bary, none;
    double model[POINTS][3];
    int64_t twice[POINTS][2];
    struct text text;
    uint32_t largest = 0;
    for (uint64_t seed = 0;; seed++) { /* one with depth */
        random_grid(&g, 3, 1, seed);
        locate_points(&bary, &g, model, twice, false, seed);
        grid_free(&g);
        if (bary.key.has_depth && bary.outside < POINTS) break;
        bary_free(&bary);
    }
    for (size_t i = 0; i < POINTS; i++)
        if (bary.place[i].triangle != GRID_NONE && bary.place[i].triangle > largest)
            largest = bary.place[i].triangle;
    write_text(&text, &bary, NULL);
    for (int part = 0; part < 5; part++) {
        struct bary_key key = bary.key;
        struct err err = {0};
        if (part == 0) key.domain ^= 0x80000000;
        if (part == 1) key.model ^= 1;
        if (part == 2) key.count++;
        if (part == 3) key.triangle_count = largest;
        if (part == 4) key.has_depth = false;
        assert_false(bary_read(&none, text.path, &key, &err));
        assert_true(err.kind == ERR_INPUT && err.line > 0 && err.col > 0);
        assert_non_null(strstr(err.message, part == 0   ? "the grid's domain"
                                            : part == 1 ? "the model's vertices"
                                            : part == 2 ? "the number of vertices"
                                            : part == 3 ? "a triangle in 0.."
                                                        : "the end of the line"));
        assert_null(none.place);
    }
    free_text(&text);
    bary_free(&bary);
    (void)unused;
}

static uint32_t crc(const void *bytes, size_t length) {
    const unsigned char *at = bytes;
    uint32_t sum = 0xffffffff;
    for (size_t i = 0; i < 8 * length; i++) {
        uint32_t bit = (sum ^ at[i / 8] >> i % 8) & 1;
        sum = sum >> 1 ^ (bit ? 0xedb88320 : 0);
    }
    return ~sum;
}

/* The lines that count, picked out of what grid_write prints. */
static void domain_checksums(void **unused) {
    for (int i = 0; i < test_count(100); i++) {
        struct grid_file file = {.history = NULL};
        struct err err = {0};
        uint64_t seed = (uint64_t)i, s = seed;
        struct grid g;
        struct text text;
        struct out out;
        uint32_t sum;
        random_grid(&g, 3, 1 + i % 5, seed);
        if (i & 1) g.lattice.x0 = random_unit(&s);
        if (i & 2) memcpy(g.axes, planes[random_in(&s, 0, 5)], sizeof g.axes);
        if (i & 4) g.depth[1] = g.has_depth = true;
        assert_true(spline_identity(&file.spline, &g, &err));
        open_text(&text, &out);
        grid_write(&out, &file, "mkgrid", 0);
        close_text(&text, &out);
        char *begin = strchr(strstr(text.bytes, "\ndegree ") + 1, '\n') + 1;
        char *end = strstr(begin, "points ");
        assert_true(grid_checksum(&file.spline.grid, &sum, &err));
        check_seed(seed, sum == crc(begin, (size_t)(end - begin)));
        free_text(&text);
        grid_file_free(&file);
    }
    (void)unused;
}

static void model_checksums(void **unused) {
    static const unsigned char bytes[48] =
        {
            0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0x80,
            0, 0, 0, 0, 0, 0, 0,    0,    1, 0, 0, 0, 0, 0, 0, 0,
            0, 0, 0, 0, 0, 0, 0xe0, 0xbf, 0, 0, 0, 0, 0, 0, 0, 0x40}; /* 1 -0 0 2^-1074 -0.5 2 */
    double model[2][3] = {{1, -0.0, 0}, {0x1p-1074, -0.5, 2}};
    struct vertices v = {.points = {.vertex_count = 2, .vertex = model}};
    assert_int_equal(crc("123456789", 9), 0xcbf43926);
    assert_int_equal(vertices_checksum(&v), crc(bytes, sizeof bytes));
    (void)unused;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places),          cmocka_unit_test(known_places),
        cmocka_unit_test(wide_depths),     cmocka_unit_test(round_trips),
        cmocka_unit_test(other_keys),      cmocka_unit_test(domain_checksums),
        cmocka_unit_test(model_checksums),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
