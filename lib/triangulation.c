/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Triangles are snapped when they are known; points and segments are snapped first and triangulated
 * on the lattice, where all is exact, so snapping cannot spoil the thin triangles of a hull. In
 * both cases what comes out is a mesh of lattice points, which embed_build verifies. */
#include "triangulation.h"

#include "embed.h"
#include "mem.h"
#include "predicate.h"
#include "sides.h"
#include "snap.h"

#include <string.h>

void triangulation_free(struct triangulation *t) {
    free(t->vertex);
    free(t->triangle);
    free(t->segment);
    free(t->seed);
    *t = (struct triangulation){0};
}

static void mesh_free(struct shim_cgal_mesh *m) {
    free(m->vertex);
    free(m->triangle);
}

/* Drops vertices without a triangle; the others keep their order. */
static bool drop_unused(struct shim_cgal_mesh *m, struct err *err) {
    uint32_t *number, n = 0;
    if (!mem_new(number, m->vertex_count, err)) return false;
    for (size_t t = 0; t < m->triangle_count; t++)
        for (int c = 0; c < 3; c++) number[m->triangle[t][c]] = 1;
    for (size_t v = 0; v < m->vertex_count; v++) {
        if (!number[v]) continue;
        memmove(m->vertex[n], m->vertex[v], sizeof m->vertex[n]);
        number[v] = n++;
    }
    for (size_t t = 0; t < m->triangle_count; t++)
        for (int c = 0; c < 3; c++) m->triangle[t][c] = number[m->triangle[t][c]];
    m->vertex_count = n;
    free(number);
    return true;
}

static bool orient(struct shim_cgal_mesh *m, struct err *err) {
    for (size_t t = 0; t < m->triangle_count; t++) {
        uint32_t *c = m->triangle[t], last = c[2];
        const double *a = m->vertex[c[0]];
        int sense = predicate_orient(a, m->vertex[c[1]], m->vertex[c[2]]);
        if (sense == 0)
            return err_set(err, ERR_REFUSAL,
                           "triangle %zu, with a corner at (%.9g, %.9g), has no area", t, a[0],
                           a[1]);
        if (sense > 0) continue;
        c[2] = c[1];
        c[1] = last;
    }
    return true;
}

/* Copies the triangles into the grid; its vertices are to be lattice coordinates. */
static bool take(struct grid *g, const struct snap *s, const struct shim_cgal_mesh *m,
                 struct err *err) {
    g->lattice = s->lattice;
    g->vertex_count = (uint32_t)m->vertex_count;
    g->triangle_count = (uint32_t)m->triangle_count;
    if (!mem_new(g->vertex, m->vertex_count, err) || !mem_new(g->triangle, m->triangle_count, err))
        return false;
    memcpy(g->triangle, m->triangle, m->triangle_count * sizeof *g->triangle);
    return true;
}

static bool copy_triangles(struct shim_cgal_mesh *m, const struct triangulation *t,
                           struct err *err) {
    *m = (struct shim_cgal_mesh){.vertex_count = t->vertex_count,
                                 .triangle_count = t->triangle_count};
    if (!mem_new(m->vertex, m->vertex_count, err) || !mem_new(m->triangle, m->triangle_count, err))
        return false;
    memcpy(m->vertex, t->vertex, m->vertex_count * sizeof *m->vertex);
    memcpy(m->triangle, t->triangle, m->triangle_count * sizeof *m->triangle);
    return true;
}

static bool grid_of_triangles(struct grid *g, const struct triangulation *t, struct snap *s,
                              const struct lattice_choice *choice, struct err *err) {
    struct shim_cgal_mesh m = {0};
    const double(*world)[2];
    bool ok = copy_triangles(&m, t, err) && drop_unused(&m, err) && orient(&m, err);
    world = (const double(*)[2])m.vertex;
    ok = ok && snap_init(s, choice, world, m.vertex_count, err) &&
         snap_check_distinct(s, world, err) && take(g, s, &m, err);
    if (ok) {
        memcpy(g->vertex, s->at, m.vertex_count * sizeof *g->vertex);
        ok = embed_build(g, s, &m, err);
    }
    mesh_free(&m);
    return ok;
}

/* Triangulates points, at the vertices' places or snapped, and segments. What is wrong with them is
 * *fault. */
static bool triangulate(const struct triangulation *t, const double (*point)[2],
                        const double (*seed)[2], struct shim_cgal_mesh *m,
                        struct sides_fault *fault, struct err *err) {
    struct shim_cgal_sides sides = {point, t->vertex_count, (const uint32_t(*)[2])t->segment,
                                    t->segment_count};
    struct shim_cgal_report report;
    if (t->segment_count == 0)
        shim_cgal_delaunay(point, t->vertex_count, m, &report);
    else
        shim_cgal_regions(&sides, seed, t->seed_count, m, &report);
    return sides_fault(&sides, &report, fault, err);
}

/* Only segments can be at fault: that points are distinct has been checked. */
static bool check_segments(const struct triangulation *t, struct err *err) {
    const double(*world)[2] = (const double(*)[2])t->vertex;
    struct shim_cgal_sides sides = {world, t->vertex_count, (const uint32_t(*)[2])t->segment,
                                    t->segment_count};
    struct shim_cgal_mesh m = {0};
    struct sides_fault fault = {SIDES_SOUND, 0, 0, 0};
    char text[SIDES_TEXT_MAX];
    bool ok;
    for (size_t i = 0; i < t->segment_count; i++)
        if (t->segment[i][0] == t->segment[i][1])
            return err_set(err, ERR_REFUSAL, "segment %zu joins a vertex to itself", i);
    if (t->segment_count == 0) return true;
    ok = triangulate(t, world, (const double(*)[2])t->seed, &m, &fault, err);
    mesh_free(&m);
    if (!ok || fault.trouble == SIDES_SOUND) return ok;
    sides_describe(&fault, &sides, world, text);
    return err_set(err, ERR_REFUSAL, "segments meet elsewhere than at their ends: %s", text);
}

static void to_lattice(const struct snap *s, const double world[2], double at[2]) {
    at[0] = (world[0] - s->lattice.x0) / s->lattice.step;
    at[1] = (world[1] - s->lattice.y0) / s->lattice.step;
}

static bool mesh_on_lattice(const struct triangulation *t, const struct snap *s,
                            struct shim_cgal_mesh *m, struct err *err) {
    struct shim_cgal_sides sides = {NULL, t->vertex_count, (const uint32_t(*)[2])t->segment,
                                    t->segment_count};
    struct sides_fault fault = {SIDES_SOUND, 0, 0, 0};
    double(*at)[2] = NULL, (*seed)[2] = NULL;
    char text[SIDES_TEXT_MAX];
    bool ok = mem_new(at, t->vertex_count, err) && mem_new(seed, t->seed_count, err);
    for (size_t i = 0; ok && i < t->vertex_count; i++)
        for (int c = 0; c < 2; c++) at[i][c] = s->at[i][c];
    for (size_t i = 0; ok && i < t->seed_count; i++) to_lattice(s, t->seed[i], seed[i]);
    ok = ok && triangulate(t, (const double(*)[2])at, (const double(*)[2])seed, m, &fault, err);
    if (ok && fault.trouble != SIDES_SOUND) {
        sides_describe(&fault, &sides, (const double(*)[2])t->vertex, text);
        ok = snap_refuse(s, err, "then %s", text);
    }
    free(at);
    free(seed);
    return ok;
}

static bool grid_of_points(struct grid *g, const struct triangulation *t, struct snap *s,
                           const struct lattice_choice *choice, struct err *err) {
    const double(*world)[2] = (const double(*)[2])t->vertex;
    struct shim_cgal_mesh m = {0};
    bool ok = snap_init(s, choice, world, t->vertex_count, err) &&
              snap_check_distinct(s, world, err) && check_segments(t, err) &&
              mesh_on_lattice(t, s, &m, err);
    if (ok && m.triangle_count == 0) ok = err_set(err, ERR_REFUSAL, "the segments enclose nothing");
    ok = ok && drop_unused(&m, err) && take(g, s, &m, err);
    for (size_t v = 0; ok && v < m.vertex_count; v++)
        for (int c = 0; c < 2; c++) g->vertex[v][c] = (int32_t)m.vertex[v][c];
    ok = ok && embed_build(g, s, NULL, err);
    mesh_free(&m);
    return ok;
}

bool triangulation_grid(struct grid *g, const struct triangulation *t,
                        const struct lattice_choice *choice, struct err *err) {
    struct snap s = {0};
    bool ok;
    if (t->vertex_count < 3)
        return err_set(err, ERR_REFUSAL, "there are fewer than three vertices");
    if (t->vertex_count >= GRID_NONE || t->triangle_count >= GRID_NONE ||
        t->segment_count >= GRID_NONE)
        return err_set(err, ERR_REFUSAL, "there are more than 2^32 - 2 vertices or triangles");
    ok = t->triangle_count > 0 ? grid_of_triangles(g, t, &s, choice, err)
                               : grid_of_points(g, t, &s, choice, err);
    snap_free(&s);
    return ok;
}
