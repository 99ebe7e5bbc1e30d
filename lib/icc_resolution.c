/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_resolution.h"

#include "mem.h"
#include "segment.h"

#include <stdio.h>

#define DETOUR      3      /* ways along the cage are longer by this, where it is narrow */
#define VERTEX_STEP 0x1p-6 /* of the limit: nearer vertices are passed over */

static void fail(struct icc_failures *failures, const struct icc_domain *d, const double grid[2],
                 uint32_t side) {
    if (failures->count++ > 0) return;
    icc_domain_to_world(d, grid, failures->at);
    failures->side = side;
}

static void fail_at_vertex(struct icc_failures *failures, const struct icc_domain *d, uint32_t v) {
    double grid[2];
    icc_domain_vertex_grid(d, v, grid);
    fail(failures, d, grid, 0);
}

static void test_vertices(const struct icc_field *f, struct icc_failures failures[ICC_TESTS]) {
    const struct icc_domain *d = f->domain;
    for (uint32_t v = 0; v + d->nx + 1 < icc_domain_size(d); v++) {
        bool a = d->inside[v], b = d->inside[v + 1];
        bool c = d->inside[v + d->nx], e = d->inside[v + d->nx + 1];
        if (a && !icc_function_has(f->function, v))
            fail_at_vertex(&failures[ICC_TEST_REACHED], d, v);
        if (a == e && b == c && a != b) fail_at_vertex(&failures[ICC_TEST_DIAGONAL], d, v);
    }
    if (d->cut_count > 0) fail_at_vertex(&failures[ICC_TEST_CUT], d, d->cut[0]);
    failures[ICC_TEST_CUT].count = d->cut_count;
}

/* The part of a side in the cell at (i,j): parameters from[0] < from[1]; false: none. */
static bool clip(const double a[2], const double b[2], const double low[2], double from[2]) {
    from[0] = 0;
    from[1] = 1;
    for (int c = 0; c < 2; c++) {
        double d = b[c] - a[c], x = (low[c] - a[c]) / d, y = (low[c] + 1 - a[c]) / d;
        if (d == 0) {
            if (a[c] < low[c] || a[c] > low[c] + 1) return false;
            continue;
        }
        from[0] = fmax(from[0], fmin(x, y));
        from[1] = fmin(from[1], fmax(x, y));
    }
    return from[0] < from[1];
}

static bool all_have(const struct icc_function *f, uint32_t a, uint32_t b, uint32_t c) {
    return icc_function_has(f, a) && icc_function_has(f, b) && icc_function_has(f, c);
}

static void test_piece(const struct icc_field *f, uint32_t cell, uint32_t side,
                       struct icc_failures *failures) {
    const struct icc_domain *d = f->domain;
    uint32_t i = cell % d->nx, j = cell / d->nx;
    const double *a = d->cage[side], *b = d->cage[side + 1 < d->count ? side + 1 : 0];
    double low[2] = {i, j}, from[2], end[2][2], below[2];
    if (!clip(a, b, low, from)) return;
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 2; c++) end[k][c] = a[c] + from[k] * (b[c] - a[c]);
        below[k] = (end[k][0] - i) - (end[k][1] - j);
    }
    int lowest = below[0] < below[1]; /* the end that is nearer to the lower triangle */
    if (below[lowest] > 0 && !all_have(f->function, cell, cell + 1, cell + d->nx + 1))
        fail(failures, d, end[lowest], side);
    else if (below[!lowest] < 0 && !all_have(f->function, cell, cell + d->nx + 1, cell + d->nx))
        fail(failures, d, end[!lowest], side);
}

void icc_resolution(const struct icc_field *f, struct icc_failures failures[ICC_TESTS]) {
    for (int t = 0; t < ICC_TESTS; t++) failures[t] = (struct icc_failures){0};
    test_vertices(f, failures);
    for (uint32_t cell = 0; cell < icc_domain_size(f->domain); cell++)
        for (size_t at = f->cells->start[cell]; at < f->cells->start[cell + 1]; at++)
            test_piece(f, cell, f->cells->side[at], &failures[ICC_TEST_BARE]);
}

void icc_failure_describe(enum icc_test test, const struct icc_failures *failures,
                          char text[ICC_FAILURE_TEXT_MAX]) {
    static const char *const what[ICC_TESTS] = {
        "grid vertices inside not connected with the maximum: %zu, the first at (%.9g, %.9g)",
        "grid cells with two opposite corners inside and two outside: %zu, the first at (%.9g, "
        "%.9g)",
        "grid edges between vertices inside that cross the cage: %zu, the first at (%.9g, %.9g)",
        "pieces of the cage too far from grid vertices inside: %zu, the first at (%.9g, %.9g) "
        "on side %u",
    };
    snprintf(text, ICC_FAILURE_TEXT_MAX, what[test], failures->count, failures->at[0],
             failures->at[1], failures->side);
}

/* ---- width ------------------------------------------------------------------------------------
 */

/* What is measured: way[k] is the way along the cage from vertex 0 to vertex k. */
struct measure {
    const struct icc_domain *d;
    const double *way;
};

/* The distance from a vertex to a side; infinite where the way along the cage is short. */
static double narrow(const struct measure *m, size_t vertex, uint32_t side) {
    const struct icc_domain *d = m->d;
    const double *p = d->cage[vertex], *a = d->cage[side];
    const double *b = d->cage[side + 1 < d->count ? side + 1 : 0];
    double q[2], lambda, way, distance = sqrt(segment_distance2(a, b, p, &lambda));
    segment_point(a, b, lambda, q);
    way = fabs(m->way[vertex] - (m->way[side] + segment_length(a, q)));
    way = fmin(way, m->way[d->count] - way);
    return distance > 0 && way > DETOUR * distance ? distance : INFINITY;
}

static double narrowest(const struct measure *m, const struct icc_cells *cells) {
    const struct icc_domain *d = m->d;
    double least = 1, before = -INFINITY;
    for (size_t k = 0; k < d->count; k++) {
        if (m->way[k] - before < VERTEX_STEP) continue;
        before = m->way[k];
        uint32_t i = (uint32_t)d->cage[k][0], j = (uint32_t)d->cage[k][1];
        for (uint32_t row = j - 1; row <= j + 1; row++)
            for (uint32_t cell = row * d->nx + i - 1; cell <= row * d->nx + i + 1; cell++)
                for (size_t at = cells->start[cell]; at < cells->start[cell + 1]; at++)
                    least = fmin(least, narrow(m, k, cells->side[at]));
    }
    return least;
}

/* With cells as large as the limit, what is nearer is in a cell beside. */
bool icc_width(const double (*vertex)[2], size_t count, double limit, double *width,
               struct err *err) {
    struct icc_domain d;
    struct icc_cells cells = {0};
    double *way = NULL;
    bool ok = icc_domain_init(&d, vertex, count, limit, err) && icc_cells_init(&cells, &d, err) &&
              mem_new(way, count + 1, err);
    if (ok) {
        for (size_t k = 0; k < count; k++)
            way[k + 1] = way[k] + segment_length(d.cage[k], d.cage[k + 1 < count ? k + 1 : 0]);
        *width = limit * narrowest(&(struct measure){&d, way}, &cells);
    }
    free(way);
    icc_cells_free(&cells);
    icc_domain_free(&d);
    return ok;
}
