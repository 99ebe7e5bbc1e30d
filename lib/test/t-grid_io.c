/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grid_io.h"

#include "testing.h"
#include "triangulations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct text {
    char *bytes;
    size_t length;
};

/* What grid_write makes of a file, by way of a temporary. */
static struct text written(const struct grid_file *file, const char *added, int digits) {
    char path[] = "/tmp/t-grid_io.XXXXXX";
    struct err err = {0};
    struct text text;
    struct out out;
    int fd = mkstemp(path);
    FILE *in;
    assert_true(fd >= 0);
    close(fd);
    assert_true(out_open(&out, path, &err));
    grid_write(&out, file, added, digits);
    assert_true(out_close(&out, &err));
    in = fopen(path, "rb");
    assert_non_null(in);
    assert_int_equal(fseek(in, 0, SEEK_END), 0);
    text.length = (size_t)ftell(in);
    rewind(in);
    text.bytes = malloc(text.length + 1);
    assert_non_null(text.bytes);
    assert_int_equal(fread(text.bytes, 1, text.length, in), text.length);
    text.bytes[text.length] = '\0';
    fclose(in);
    unlink(path);
    return text;
}

/* Reads a text by way of a temporary. */
static bool read_text(struct grid_file *file, const char *bytes, size_t length, struct err *err) {
    char path[] = "/tmp/t-grid_io.XXXXXX";
    int fd = mkstemp(path);
    bool ok;
    assert_true(fd >= 0);
    assert_int_equal(write(fd, bytes, length), (ssize_t)length);
    close(fd);
    ok = grid_read(file, path, err);
    unlink(path);
    return ok;
}

static double random_double(uint64_t *s) {
    double x = ldexp(random_unit(s) - 0.5, (int)random_in(s, -300, 300));
    return random_in(s, 0, 9) == 0 ? (double)random_in(s, -9, 9) : x;
}

static void random_file(struct grid_file *file, uint64_t seed) {
    struct err err = {0};
    uint64_t s = seed;
    struct grid g;
    random_grid(&g, 3, (int)random_in(&s, 1, 15), seed);
    if (random_in(&s, 0, 1)) {
        g.lattice.step = ldexp(1 + random_unit(&s), (int)random_in(&s, -100, 100));
        g.lattice.x0 = random_double(&s);
        g.lattice.y0 = random_in(&s, 0, 1) ? 0 : random_double(&s);
    }
    if (random_in(&s, 0, 1)) assert_true(grid_axes(&"zyzxyxz"[random_in(&s, 0, 5)], 2, g.axes));
    g.has_depth = random_in(&s, 0, 1);
    g.depth[0] = random_double(&s);
    g.depth[1] = g.depth[0] + fabs(g.depth[0]) + 1;
    *file = (struct grid_file){0};
    assert_true(spline_allocate(&file->spline, &g, &err));
    for (uint32_t p = 0; p < file->spline.grid.point_count; p++)
        for (int c = 0; c < 2; c++) {
            file->spline.phi[p][c] = random_double(&s);
            if (file->spline.sigma) file->spline.sigma[p][c] = random_double(&s);
        }
    if (random_in(&s, 0, 1))
        file->history = strdup("# mkgrid --rect 0,0,1,1\n#tight\n# \xc3\xa9 #\n");
}

static void test_round_trip(void **state) {
    int count = test_count(100);
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)count; seed++) {
        struct grid_file file, again;
        struct err err = {0};
        random_file(&file, seed);
        struct text first = written(&file, NULL, 0);
        check_seed(seed, read_text(&again, first.bytes, first.length, &err));
        const struct grid *g = &file.spline.grid, *h = &again.spline.grid;
        check_seed(seed, g->degree == h->degree && g->point_count == h->point_count);
        check_seed(seed, memcmp(g->axes, h->axes, sizeof g->axes) == 0);
        check_seed(seed, g->has_depth == h->has_depth);
        check_seed(seed, memcmp(file.spline.phi, again.spline.phi,
                                g->point_count * sizeof *file.spline.phi) == 0);
        check_seed(seed, strcmp(file.history ? file.history : "", again.history) == 0);
        struct text second = written(&again, NULL, 0);
        check_seed(seed, first.length == second.length);
        check_seed(seed, memcmp(first.bytes, second.bytes, first.length) == 0);
        free(first.bytes);
        free(second.bytes);
        grid_file_free(&file);
        grid_file_free(&again);
    }
}

static const char good[] = "grid 1\n# by hand\ndegree 2\nplane zy\nlattice 0.5 1 2\ndepth -1 1\n"
                           "vertices 4\n0 0\n4 0\n4 4\n0 4\ntriangles 2\n0 1 2\n0 2 3\n"
                           "points 9\n1 2 -1 1\n3 2 -1 1\n3 4 -1 1\n1 4 -1 1\n2 2 -1 1\n"
                           "2 3 -1 1\n1 3 -1 1\n3 3 -1 1\n2 4 -1 1\nend\n";

static void test_cuts(void **state) {
    struct grid_file file;
    (void)state;
    for (size_t n = 0; n + 1 < strlen(good); n++) {
        struct err err = {0};
        assert_false(read_text(&file, good, n, &err));
        assert_int_equal(err.kind, ERR_INPUT);
        assert_true(err.line > 0);
        assert_null(file.spline.phi);
    }
    struct err err = {0};
    assert_true(read_text(&file, good, strlen(good) - 1, &err)); /* no final newline */
    grid_file_free(&file);
}

/* Blanks, comments, empty lines, CRLF change nothing; added history and digits do what they say. */
static void test_tolerance(void **state) {
    char loose[2000], *to = loose;
    struct grid_file file;
    struct err err = {0};
    (void)state;
    for (const char *s = good; *s; s++) { /* from the second line on, which is history */
        if (strncmp(s, "\n0 1 2", 6) == 0) to = stpcpy(to, " # here");
        if (*s == ' ' && s > strstr(good, "degree"))
            to = stpcpy(to, " \t ");
        else if (*s == '\n')
            to = stpcpy(to, "\r\n\r\n  ");
        else
            *to++ = *s;
    }
    *to = '\0';
    assert_true(read_text(&file, loose, (size_t)(to - loose), &err));
    struct text text = written(&file, NULL, 0);
    assert_string_equal(text.bytes + 7, strchr(good, '\n') + 1);
    free(text.bytes);
    file.spline.phi[0][0] = 1. / 3;
    text = written(&file, "next --tool", 4);
    assert_non_null(strstr(text.bytes, "grid 1\n# by hand\n# next --tool\ndegree 2\n"));
    assert_non_null(strstr(text.bytes, "points 9\n0.3333 2 -1 1\n"));
    assert_non_null(strstr(text.bytes, "lattice 0.5 1 2\n"));
    free(text.bytes);
    grid_file_free(&file);
}

/* The first occurrence of `old` in the good grid becomes `new`; the message and its place. */
static const struct {
    const char *old, *new, *message;
    size_t line, col;
} bad[] = {
    {"grid 1", "v 0 0 0", "expected 'grid', got 'v'", 1, 1},
    {"grid 1", "grid 2", "expected version 1, got '2'", 1, 6},
    {"grid 1", "grid 1 x", "expected the end of the line, got 'x'", 1, 8},
    {"degree 2", "plane zy", "expected 'degree', got 'plane'", 3, 1},
    {"degree 2", "degree 16", "expected a degree in 1..15, got '16'", 3, 8},
    {"degree 2", "degree 2.5", "expected a degree in 1..15, got '2.5'", 3, 8},
    {"plane zy", "plane zz", "expected two different letters of xyz, got 'zz'", 4, 7},
    {"plane zy", "plane zyx", "expected two different letters of xyz, got 'zyx'", 4, 7},
    {"plane zy", "plane zy\nplane zy", "expected 'lattice', 'depth' or 'vertices', got 'plane'", 5,
     1},
    {"plane zy", "depth 0 1\nplane zy", "expected 'vertices', got 'plane'", 5, 1},
    {"plane zy", "planes zy", "expected 'plane', 'lattice', 'depth' or 'vertices', got 'planes'", 4,
     1},
    {"lattice 0.5", "lattice 0", "expected a step > 0, got '0'", 5, 9},
    {"lattice 0.5", "lattice -1", "expected a step > 0, got '-1'", 5, 9},
    {"lattice 0.5", "lattice nan", "expected the step of the lattice, got 'nan'", 5, 9},
    {"lattice 0.5", "lattice 1e305",
     "the lattice (step 9.9999999999999994e+304, origin 1 2) is not finite with step > 0", 5, 1},
    {"0.5 1 2", "0.5 1", "expected y0 of the lattice, got end of line", 5, 14},
    {"0.5 1 2", "0.5 0x1 2", "expected x0 of the lattice, got '0x1'", 5, 13},
    {"depth -1 1", "depth 1 1", "expected an upper end above the lower end, got '1'", 6, 9},
    {"depth -1 1", "depth -1 inf", "expected the upper end of the depth, got 'inf'", 6, 10},
    {"depth -1 1", "depth -1e999 1",
     "expected the lower end of the depth, got a number that is too large", 6, 7},
    {"vertices 4", "vertices 2", "expected a number of vertices in 3..4294967293, got '2'", 7, 10},
    {"vertices 4", "vertices 5", "expected X of a vertex in -16777216..16777216, got 'triangles'",
     12, 1},
    {"vertices 4", "vertices 3", "expected 'triangles' after 3 vertices, got '0'", 11, 1},
    {"vertices 4", "vertices 4000000000",
     "expected X of a vertex in -16777216..16777216, got 'triangles'", 12, 1},
    {"4 0\n", "4 16777217\n", "expected Y of a vertex in -16777216..16777216, got '16777217'", 9,
     3},
    {"4 0\n", "4 0 0\n", "expected the end of the line, got '0'", 9, 5},
    {"4 0\n", "0 0\n", "vertices 0 and 1 are both at (0 0)", 9, 1},
    {"4 0\n", "2 2\n", "triangle 0 (0 1 2) has no area", 13, 1},
    {"triangles 2", "triangles 0", "expected a number of triangles in 1..1431655765, got '0'", 12,
     11},
    {"triangles 2", "triangles 3", "expected a vertex number in 0..3, got 'points'", 15, 1},
    {"triangles 2", "triangles 1", "expected 'points' after 1 triangles, got '0'", 14, 1},
    {"0 1 2", "0 1 4", "expected a vertex number in 0..3, got '4'", 13, 5},
    {"0 1 2", "0 1 -1", "expected a vertex number in 0..3, got '-1'", 13, 5},
    {"0 1 2", "0 2 1", "triangle 0 (0 2 1) is clockwise", 13, 1},
    {"0 2 3", "0 1 2", "triangles 0 and 1 lie on the same side of their edge {0,1}", 14, 1},
    {"0 2 3\n", "# so\n0 1 3\n", "triangles 0 and 1 lie on the same side of their edge {0,1}", 15,
     1},
    {"points 9", "points 8", "expected 9, the number of control points of this grid, got '8'", 15,
     8},
    {"points 9", "points", "expected a number of points, got end of line", 15, 7},
    {"1 2 -1 1", "1 2 -1", "expected z1 of a control point, got end of line", 16, 7},
    {"1 2 -1 1", "1 2 -1 1 1", "expected the end of the line, got '1'", 16, 10},
    {"2 4 -1 1\n", "", "expected x of a control point, got 'end'", 24, 1},
    {"2 4 -1 1\n", "2 4 -1 1\n0 0 0 0\n", "expected 'end' after 9 points, got '0'", 25, 1},
    {"end\n", "", "expected 'end' after 9 points, got end of file", 25, 1},
    {"end", "end end", "expected the end of the line, got 'end'", 25, 5},
    {"end", "end\n\n#\ngrid 1", "expected nothing after 'end', got 'grid'", 28, 1},
};

static void test_bad(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[1000];
        const char *at = strstr(good, bad[i].old);
        struct grid_file file;
        struct err err = {0};
        assert_non_null(at);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(at - good), good, bad[i].new,
                 at + strlen(bad[i].old));
        assert_false(read_text(&file, text, strlen(text), &err));
        assert_string_equal(err.message, bad[i].message);
        assert_int_equal(err.kind, ERR_INPUT);
        assert_int_equal(err.line, bad[i].line);
        assert_int_equal(err.col, bad[i].col);
    }
}

static void test_nul_in_history(void **state) {
    static const char text[] = "grid 1\n# a\0b\ndegree 2\n";
    struct grid_file file;
    struct err err = {0};
    (void)state;
    assert_false(read_text(&file, text, sizeof text - 1, &err));
    assert_string_equal(err.message, "expected text, got a NUL byte");
    assert_int_equal(err.col, 4);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),     cmocka_unit_test(test_cuts),
        cmocka_unit_test(test_tolerance),      cmocka_unit_test(test_bad),
        cmocka_unit_test(test_nul_in_history),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
