/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cells are convex in both domains, so any fan of triangles will do; the roundest is taken. */
#include "overlay_map.h"

#include "mem.h"

#include <math.h>

static double largest(const double (*x)[2], size_t n) {
    double most = 0;
    for (size_t i = 0; i < n; i++) most = fmax(most, fmax(fabs(x[i][0]), fabs(x[i][1])));
    return most;
}

static void exact(const void *context, uint32_t v, int plane, mpq_t p[2]) {
    const struct overlay_map *m = context;
    overlay_place_exact(m->mesh, &m->overlay->vertex[v], plane, m->x[plane], p);
}

/* The roundness of the worst triangle of the fan from corner c of n, in the worse plane. */
static double judge(const struct plane_map *map, const uint32_t *corner, size_t n, size_t c) {
    double worst = INFINITY;
    for (int m = 0; m < 2; m++) {
        const double(*at)[2] = (const double(*)[2])map->at[m];
        for (size_t i = 1; i + 1 < n; i++)
            worst = fmin(worst, plane_map_roundness(at[corner[c]], at[corner[(c + i) % n]],
                                                    at[corner[(c + i + 1) % n]]));
    }
    return worst;
}

static void triangulate(struct plane_map *map, const uint32_t *corner, size_t n) {
    double best = -1;
    size_t from = 0;
    for (size_t c = 0; c < (n == 3 ? 1 : n); c++) {
        double worst = judge(map, corner, n, c);
        if (worst <= best) continue;
        best = worst;
        from = c;
    }
    for (size_t i = 1; i + 1 < n; i++) {
        uint32_t *t = map->triangle[map->triangle_count++];
        t[0] = corner[from];
        t[1] = corner[(from + i) % n];
        t[2] = corner[(from + i + 1) % n];
    }
}

bool overlay_map(struct overlay_map *m, struct plane_map *map, struct err *err) {
    const struct overlay *o = m->overlay;
    size_t triangles = o->cell_start[o->cell_count] - 2 * o->cell_count;
    *map = (struct plane_map){.vertex_count = o->vertex_count};
    m->meaning = (struct joint_meaning){.exact = exact, .context = m};
    for (int k = 0; k < 2; k++) {
        if (!mem_new(map->at[k], o->vertex_count, err)) return false;
        m->meaning.error[k] = OVERLAY_ERROR * largest(m->x[k], m->mesh[k].vertex_count);
        for (size_t v = 0; v < o->vertex_count; v++)
            overlay_place(m->mesh, &o->vertex[v], k, m->x[k], map->at[k][v]);
    }
    if (!mem_new(map->triangle, triangles, err)) return false;
    for (size_t c = 0; c < o->cell_count; c++)
        triangulate(map, o->corner + o->cell_start[c], o->cell_start[c + 1] - o->cell_start[c]);
    return true;
}
