/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Overlays of random triangulations against exact rationals: each cell is a strictly convex polygon
 * in both of its triangles, and their areas add up to the whole. That leaves no room for a cell
 * that is missing, too large or there twice. Coordinates are small integers, so that vertices
 * coincide, lie on edges, and edges run together all the time. */
#include "overlay_place.h"

#include "planar.h"
#include "testing.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct mesh {
    struct shim_cgal_mesh cgal;
    struct overlay_mesh view;
};

static void make(struct mesh *m, const struct planar *p, uint64_t *state) {
    planar_make(&m->cgal, p, state);
    m->view = (struct overlay_mesh){m->cgal.vertex_count, m->cgal.triangle_count,
                                    (const double(*)[2])m->cgal.vertex,
                                    (const uint32_t(*)[3])m->cgal.triangle};
}

static void mesh_free(struct mesh *m) {
    free(m->cgal.vertex);
    free(m->cgal.triangle);
}

/* ---- exact rationals ---- */

typedef mpq_t exact_point[2];

static int exact_sign(exact_point a, exact_point b, exact_point c) {
    mpq_t area;
    int sign;
    mpq_init(area);
    planar_area2(area, a, b, c);
    sign = mpq_sgn(area);
    mpq_clear(area);
    return sign;
}

static exact_point *exact_points(size_t n) {
    exact_point *p = calloc(n ? n : 1, sizeof *p);
    for (size_t i = 0; i < n; i++) mpq_inits(p[i][0], p[i][1], NULL);
    return p;
}

static void exact_free(exact_point *p, size_t n) {
    for (size_t i = 0; i < n; i++) mpq_clears(p[i][0], p[i][1], NULL);
    free(p);
}

static exact_point *exact_copy(const double (*x)[2], size_t n) {
    exact_point *p = exact_points(n);
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) mpq_set_d(p[i][c], x[i][c]);
    return p;
}

/* All about one overlay: `at` are the vertices of the meshes in C. */
struct checker {
    const struct overlay *o;
    const struct overlay_mesh *mesh;
    exact_point *vertex, *at[2];
};

static bool cell_is_sound(const struct checker *k, size_t cell, mpq_t area) {
    const uint32_t *corner = k->o->corner + k->o->cell_start[cell];
    size_t n = k->o->cell_start[cell + 1] - k->o->cell_start[cell];
    bool ok = n >= 3 && n <= 6;
    mpq_t part;
    mpq_init(part);
    for (size_t i = 0; ok && i < n; i++) {
        mpq_t *a = k->vertex[corner[i]], *b = k->vertex[corner[(i + 1) % n]],
              *c = k->vertex[corner[(i + 2) % n]];
        ok = exact_sign(a, b, c) > 0;
        if (i > 0 && i + 1 < n) {
            planar_area2(part, k->vertex[corner[0]], a, b);
            ok = ok && mpq_sgn(part) > 0; /* turns once */
            mpq_add(area, area, part);
        }
        for (int m = 0; ok && m < 2; m++)
            for (int e = 0; e < 3; e++) {
                const uint32_t *t = k->mesh[m].triangle[k->o->cell[cell][m]];
                ok = ok && exact_sign(k->at[m][t[e]], k->at[m][t[(e + 1) % 3]], a) >= 0;
            }
    }
    mpq_clear(part);
    return ok;
}

static int compare_pairs(const void *a, const void *b) {
    return memcmp(a, b, 2 * sizeof(uint32_t));
}

static bool pairs_differ(const struct overlay *o) {
    uint32_t(*pair)[2] = calloc(o->cell_count, sizeof *pair);
    bool ok = true;
    memcpy(pair, o->cell, o->cell_count * sizeof *pair);
    qsort(pair, o->cell_count, sizeof *pair, compare_pairs);
    for (size_t i = 1; i < o->cell_count; i++) ok = ok && compare_pairs(pair[i - 1], pair[i]) != 0;
    free(pair);
    return ok;
}

static bool vertices_differ(exact_point *p, size_t n) {
    bool ok = true;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < i; j++)
            ok = ok && !(mpq_equal(p[i][0], p[j][0]) && mpq_equal(p[i][1], p[j][1]));
    return ok;
}

static bool overlay_is_sound(const struct overlay *o, const struct overlay_mesh mesh[2],
                             bool all_pairs) {
    struct checker k = {o, mesh, exact_points(o->vertex_count), {NULL, NULL}};
    mpq_t area, total;
    bool ok = pairs_differ(o);
    mpq_inits(area, total, NULL);
    for (int m = 0; m < 2; m++) k.at[m] = exact_copy(mesh[m].at, mesh[m].vertex_count);
    ok = ok && planar_total(total, mesh[0].at, mesh[0].triangle, mesh[0].triangle_count);
    for (size_t v = 0; v < o->vertex_count; v++) /* in the domain C itself */
        overlay_place_exact(mesh, &o->vertex[v], 0, mesh[0].at, k.vertex[v]);
    for (size_t c = 0; ok && c < o->cell_count; c++) ok = cell_is_sound(&k, c, area);
    ok = ok && mpq_equal(area, total) && (!all_pairs || vertices_differ(k.vertex, o->vertex_count));
    for (int m = 0; m < 2; m++) exact_free(k.at[m], mesh[m].vertex_count);
    exact_free(k.vertex, o->vertex_count);
    mpq_clears(area, total, NULL);
    return ok;
}

/* Both meshes give the same place in C, and the rounded place is near it. */
static bool places_agree(const struct overlay *o, const struct overlay_mesh mesh[2],
                         double largest) {
    exact_point *p = exact_points(3);
    mpq_t error, limit;
    bool ok = true;
    mpq_inits(error, limit, NULL);
    mpq_set_d(limit, OVERLAY_ERROR * largest);
    for (size_t v = 0; v < o->vertex_count; v++)
        for (int m = 0; m < 2; m++) {
            double rounded[2];
            overlay_place_exact(mesh, &o->vertex[v], m, mesh[m].at, p[m]);
            overlay_place(mesh, &o->vertex[v], m, mesh[m].at, rounded);
            for (int c = 0; c < 2; c++) {
                mpq_set_d(p[2][c], rounded[c]);
                mpq_sub(error, p[2][c], p[m][c]);
                mpq_abs(error, error);
                ok = ok && mpq_cmp(error, limit) <= 0;
                ok = ok && (m == 0 || mpq_equal(p[0][c], p[1][c]));
            }
        }
    mpq_clears(error, limit, NULL);
    exact_free(p, 3);
    return ok;
}

static void check_pair(uint64_t seed, const struct mesh *a, const struct mesh *b, double side) {
    const struct overlay_mesh mesh[2] = {a->view, b->view};
    struct overlay o;
    struct err err = {0};
    check_seed(seed, overlay_build(&o, mesh, &err));
    check_seed(seed, overlay_is_sound(&o, mesh, o.vertex_count < 100));
    check_seed(seed, places_agree(&o, mesh, side));
    overlay_free(&o);
}

static void test_random(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(100); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct planar p = {.size = (int)random_in(&state, 1, 8)};
        struct mesh mesh[2];
        p.step = random_in(&state, 0, 1) ? 1 : 0.1; /* 3 * 0.1 is no multiple of 0.1 */
        for (int m = 0; m < 2; m++) {
            p.inner = (int)random_in(&state, 0, 60);
            p.flips = (int)random_in(&state, 0, 2000);
            make(&mesh[m], &p, &state);
        }
        check_pair(seed, &mesh[0], &mesh[1], p.size * p.step);
        for (int m = 0; m < 2; m++) mesh_free(&mesh[m]);
    }
}

/* The overlay of a mesh with itself is the mesh; with flipped diagonals, each costs a crossing. */
static void test_itself(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(40); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct mesh a;
        make(&a, &(struct planar){4, 1, 80, 1000}, &state);
        const struct overlay_mesh mesh[2] = {a.view, a.view};
        struct overlay o;
        struct err err = {0};
        check_seed(seed, overlay_build(&o, mesh, &err));
        check_seed(seed, o.cell_count == a.view.triangle_count);
        check_seed(seed, o.vertex_count == a.view.vertex_count);
        for (size_t v = 0; v < o.vertex_count; v++)
            check_seed(seed, o.vertex[v].kind == OVERLAY_BOTH && o.vertex[v].in[0] == v &&
                                 o.vertex[v].in[1] == v);
        overlay_free(&o);
        mesh_free(&a);
    }
}

/* Points moved by an ulp: edges that nearly run together. */
static void test_near(void **unused) {
    (void)unused;
    for (int n = 0; n < test_count(40); n++) {
        uint64_t seed = (uint64_t)n, state = seed;
        struct mesh a, b;
        make(&a, &(struct planar){3, 1, 60, 0}, &state);
        b = a;
        b.cgal.vertex = calloc(b.cgal.vertex_count, sizeof *b.cgal.vertex);
        memcpy(b.cgal.vertex, a.cgal.vertex, b.cgal.vertex_count * sizeof *b.cgal.vertex);
        for (size_t v = 12; v < b.cgal.vertex_count; v++)
            b.cgal.vertex[v][random_in(&state, 0, 1)] *= 1 + 0x1p-52;
        b.view.at = (const double(*)[2])b.cgal.vertex;
        check_pair(seed, &a, &b, 3);
        free(b.cgal.vertex);
        mesh_free(&a);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_itself),
        cmocka_unit_test(test_near),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
