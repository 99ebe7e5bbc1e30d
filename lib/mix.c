/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mix.h"

#include "exact_dot.h"
#include "mem.h"
#include "resample.h"

#include <math.h>
#include <string.h>

/* What of the domain differs between two grids, or NULL. */
static const char *difference(const struct grid *a, const struct grid *b) {
    if (a->degree != b->degree) return "degree";
    if (memcmp(a->axes, b->axes, sizeof a->axes) != 0) return "plane";
    if (a->lattice.step != b->lattice.step || a->lattice.x0 != b->lattice.x0 ||
        a->lattice.y0 != b->lattice.y0)
        return "lattice";
    if (a->has_depth != b->has_depth || a->depth[0] != b->depth[0] || a->depth[1] != b->depth[1])
        return "depth";
    if (a->vertex_count != b->vertex_count ||
        memcmp(a->vertex, b->vertex, a->vertex_count * sizeof *a->vertex) != 0)
        return "list of vertices";
    if (a->triangle_count != b->triangle_count ||
        memcmp(a->triangle, b->triangle, a->triangle_count * sizeof *a->triangle) != 0)
        return "list of triangles";
    return NULL;
}

static bool check_domains(size_t n, const struct spline *spline, size_t *culprit, struct err *err) {
    for (*culprit = 1; *culprit < n; ++*culprit) {
        const char *what = difference(&spline[0].grid, &spline[*culprit].grid);
        if (what)
            return err_set(err, ERR_INPUT,
                           "expected the domain of the first grid, got one with another %s", what);
    }
    *culprit = 0;
    return true;
}

/* Component c of point p: phi, then sigma. */
static double *component(const struct spline *s, uint32_t p, int c) {
    return c < 2 ? &s->phi[p][c] : &s->sigma[p][c - 2];
}

static bool mix_points(size_t n, const double *weight, const struct spline *spline,
                       struct spline *mix, struct err *err) {
    bool finite = true;
    double *x;
    if (!mem_new(x, n, err)) return false;
    for (uint32_t p = 0; p < mix->grid.point_count; p++)
        for (int c = 0; c < (mix->sigma ? 4 : 2); c++) {
            double *sum = component(mix, p, c);
            for (size_t i = 0; i < n; i++) x[i] = *component(&spline[i], p, c);
            *sum = exact_dot(n, weight, x, 1);
            finite = finite && isfinite(*sum);
        }
    free(x);
    return finite || err_set(err, ERR_REFUSAL, "the combination leaves the range of numbers");
}

bool mix_splines(size_t n, const double *weight, const struct spline *spline, struct spline *mix,
                 size_t *culprit, struct err *err) {
    struct grid g;
    INVARIANT(n >= 1);
    if (!check_domains(n, spline, culprit, err)) return false;
    if (!resample_copy_grid(&spline[0].grid, &g, err)) return false;
    if (!grid_build(&g, err) || !spline_allocate(mix, &g, err)) {
        grid_free(&g);
        return false;
    }
    if (mix_points(n, weight, spline, mix, err)) return true;
    spline_free(mix);
    return false;
}
