/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planar.h"

#include "testing.h"

#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 4 * 8 + 200 };

static size_t border(double (*point)[2], const struct planar *p) {
    size_t n = 0;
    for (int i = 0; i < p->size; i++) {
        double at = i * p->step, end = p->size * p->step;
        const double side[4][2] = {{at, 0}, {end, at}, {end - at, end}, {0, end - at}};
        for (int s = 0; s < 4; s++, n++) memcpy(point[n], side[s], sizeof *point);
    }
    return n;
}

static bool has_point(double (*point)[2], size_t n, const double p[2]) {
    for (size_t i = 0; i < n; i++)
        if (point[i][0] == p[0] && point[i][1] == p[1]) return true;
    return false;
}

static double area2(const double *a, const double *b, const double *c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Turns the diagonal of two triangles that make a strictly convex quadrilateral. */
static void flip(struct shim_cgal_mesh *m, uint64_t *state) {
    int64_t last = (int64_t)m->triangle_count - 1;
    uint32_t *s = m->triangle[random_in(state, 0, last)];
    uint32_t *t = m->triangle[random_in(state, 0, last)];
    double(*at)[2] = m->vertex;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            uint32_t a = s[i], b = s[(i + 1) % 3], c = s[(i + 2) % 3], d = t[j];
            if (t[(j + 1) % 3] != c || t[(j + 2) % 3] != b) continue;
            if (!(area2(at[a], at[b], at[d]) > 0 && area2(at[d], at[c], at[a]) > 0)) return;
            s[(i + 2) % 3] = d;
            t[(j + 2) % 3] = a;
            return;
        }
}

void planar_make(struct shim_cgal_mesh *m, const struct planar *p, uint64_t *state) {
    double point[POINTS_MAX][2];
    struct shim_cgal_report report;
    size_t n = border(point, p);
    for (int i = 0; i < p->inner; i++) {
        double side = p->size * p->step;
        double q[2] = {side / 64 * (double)random_in(state, 1, 63),
                       side / 64 * (double)random_in(state, 1, 63)};
        if (random_in(state, 0, 3) == 0) q[0] = random_unit(state) * side;
        if (q[0] > 0 && !has_point(point, n, q)) memcpy(point[n++], q, sizeof *point);
    }
    assert_true(shim_cgal_delaunay((const double(*)[2])point, n, m, &report));
    for (int i = 0; i < p->flips; i++) flip(m, state);
}

void planar_shake(struct shim_cgal_mesh *m, const struct planar *p, int rounds, uint64_t *state) {
    size_t first = 4 * (size_t)p->size, n = m->vertex_count;
    for (size_t i = 0; n > first && i < (size_t)rounds * (n - first); i++) {
        size_t v = first + (size_t)random_in(state, 0, (int64_t)(n - first) - 1);
        double old[2], reach = p->step * random_unit(state);
        memcpy(old, m->vertex[v], sizeof old);
        for (int c = 0; c < 2; c++) m->vertex[v][c] += reach * (random_unit(state) - 0.5);
        for (size_t t = 0; t < m->triangle_count; t++) {
            const uint32_t *k = m->triangle[t];
            if (k[0] != v && k[1] != v && k[2] != v) continue;
            if (area2(m->vertex[k[0]], m->vertex[k[1]], m->vertex[k[2]]) > 1e-9 * p->step) continue;
            memcpy(m->vertex[v], old, sizeof old);
            break;
        }
    }
}

void planar_area2(mpq_t area, mpq_t a[2], mpq_t b[2], mpq_t c[2]) {
    mpq_t q[3];
    mpq_inits(q[0], q[1], q[2], NULL);
    mpq_sub(area, b[0], a[0]);
    mpq_sub(q[0], c[1], a[1]);
    mpq_sub(q[1], b[1], a[1]);
    mpq_sub(q[2], c[0], a[0]);
    mpq_mul(area, area, q[0]);
    mpq_mul(q[1], q[1], q[2]);
    mpq_sub(area, area, q[1]);
    mpq_clears(q[0], q[1], q[2], NULL);
}

bool planar_total(mpq_t area, const double (*at)[2], const uint32_t (*triangle)[3], size_t count) {
    mpq_t part, p[3][2];
    bool ok = true;
    mpq_init(part);
    mpq_set_ui(area, 0, 1);
    for (int i = 0; i < 3; i++) mpq_inits(p[i][0], p[i][1], NULL);
    for (size_t t = 0; t < count; t++) {
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 2; c++) mpq_set_d(p[i][c], at[triangle[t][i]][c]);
        planar_area2(part, p[0], p[1], p[2]);
        ok = ok && mpq_sgn(part) > 0;
        mpq_add(area, area, part);
    }
    for (int i = 0; i < 3; i++) mpq_clears(p[i][0], p[i][1], NULL);
    mpq_clear(part);
    return ok;
}
