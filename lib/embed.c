/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "embed.h"

#include "mem.h"

/* The boundary edges, domain on the left, over the vertices they use. */
struct boundary {
    struct shim_cgal_sides sides;
    double (*point)[2], (*world)[2]; /* of the points; where they are and what they are called */
    uint32_t (*side)[2];
};

static void boundary_free(struct boundary *b) {
    free(b->point);
    free(b->world);
    free(b->side);
}

static void edge_ends(const struct grid *g, uint32_t e, uint32_t ends[2]) {
    uint32_t t = g->edge_triangle[e][0];
    int l = grid_opposite(g, t, e);
    ends[0] = g->triangle[t][(l + 1) % 3];
    ends[1] = g->triangle[t][(l + 2) % 3];
}

/* Each boundary vertex begins one boundary edge and ends one, since its triangles form one fan. So
 * numbering the points by the edges that they begin finds all. */
static void collect(struct boundary *b, const struct grid *g, uint32_t *number,
                    const double (*at)[2], const double (*world)[2]) {
    uint32_t ends[2], n = 0;
    for (uint32_t e = 0; e < g->edge_count; e++) {
        if (grid_edge_is_inner(g, e)) continue;
        edge_ends(g, e, ends);
        number[ends[0]] = n;
        for (int c = 0; c < 2; c++) {
            b->point[n][c] = at[ends[0]][c];
            b->world[n][c] = world[ends[0]][c];
        }
        n++;
    }
    n = 0;
    for (uint32_t e = 0; e < g->edge_count; e++) {
        if (grid_edge_is_inner(g, e)) continue;
        edge_ends(g, e, ends);
        b->side[n][0] = n;
        b->side[n++][1] = number[ends[1]];
    }
    b->sides =
        (struct shim_cgal_sides){(const double(*)[2])b->point, n, (const uint32_t(*)[2])b->side, n};
}

static bool boundary_init(struct boundary *b, const struct grid *g, const double (*at)[2],
                          const double (*world)[2], struct err *err) {
    uint32_t n = 0, *number = NULL;
    *b = (struct boundary){0};
    for (uint32_t e = 0; e < g->edge_count; e++) n += !grid_edge_is_inner(g, e);
    if (!mem_new(b->point, n, err) || !mem_new(b->world, n, err) || !mem_new(b->side, n, err) ||
        !mem_new(number, g->vertex_count, err))
        return false;
    collect(b, g, number, at, world);
    free(number);
    return true;
}

bool embed_check(const struct grid *g, const double (*at)[2], const double (*world)[2],
                 char text[SIDES_TEXT_MAX], struct err *err) {
    struct boundary b;
    struct sides_fault fault = {SIDES_SOUND, 0, 0, 0};
    bool ok = boundary_init(&b, g, at, world, err) && sides_check(&b.sides, &fault, err);
    text[0] = '\0';
    if (ok && fault.trouble != SIDES_SOUND)
        sides_describe(&fault, &b.sides, (const double(*)[2])b.world, text);
    boundary_free(&b);
    return ok;
}

bool embed_check_grid(const struct grid *g, char text[SIDES_TEXT_MAX], struct err *err) {
    double(*at)[2] = NULL, (*world)[2] = NULL;
    bool ok = mem_new(at, g->vertex_count, err) && mem_new(world, g->vertex_count, err);
    for (uint32_t v = 0; ok && v < g->vertex_count; v++) {
        at[v][0] = g->vertex[v][0];
        at[v][1] = g->vertex[v][1];
        grid_vertex(g, v, world[v]);
    }
    ok = ok && embed_check(g, (const double(*)[2])at, (const double(*)[2])world, text, err);
    free(at);
    free(world);
    return ok;
}

static bool check_areas(const struct grid *g, const struct snap *s, struct err *err) {
    for (uint32_t t = 0; t < g->triangle_count; t++) {
        const uint32_t *c = g->triangle[t];
        double p[2];
        if (predicate_area2(g->vertex[c[0]], g->vertex[c[1]], g->vertex[c[2]]) > 0) continue;
        snap_world(s, g->vertex[c[0]], p);
        return snap_refuse(s, err,
                           "the triangle with a corner at (%.9g, %.9g) would turn over or vanish",
                           p[0], p[1]);
    }
    return true;
}

static bool check_boundary(const struct grid *g, const struct snap *s, struct err *err) {
    double(*at)[2] = NULL, (*world)[2] = NULL;
    char text[SIDES_TEXT_MAX] = "";
    bool ok = mem_new(at, g->vertex_count, err) && mem_new(world, g->vertex_count, err);
    for (uint32_t v = 0; ok && v < g->vertex_count; v++) {
        at[v][0] = g->vertex[v][0];
        at[v][1] = g->vertex[v][1];
        snap_world(s, g->vertex[v], world[v]);
    }
    ok = ok && embed_check(g, (const double(*)[2])at, (const double(*)[2])world, text, err);
    free(at);
    free(world);
    return ok && (text[0] == '\0' || snap_refuse(s, err, "then %s", text));
}

/* grid_build, with the place added to what it says. A grid that it refuses is gone. */
static bool build(struct grid *g, const struct shim_cgal_mesh *given, struct err *err) {
    struct grid_culprit culprit;
    const double *p;
    struct err e;
    if (grid_build_blaming(g, &culprit, &e)) return true;
    *err = e;
    err->kind = ERR_REFUSAL;
    if (!given || (culprit.kind != GRID_BAD_VERTEX && culprit.kind != GRID_BAD_TRIANGLE))
        return false;
    p = given->vertex[culprit.kind == GRID_BAD_VERTEX ? culprit.number
                                                      : given->triangle[culprit.number][0]];
    return err_set(err, ERR_REFUSAL, "near (%.9g, %.9g): %.500s", p[0], p[1], e.message);
}

static bool check_given(const struct grid *g, const struct shim_cgal_mesh *given, struct err *err) {
    const double(*at)[2] = (const double(*)[2])given->vertex;
    char text[SIDES_TEXT_MAX];
    if (!embed_check(g, at, at, text, err)) return false;
    return text[0] == '\0' || err_set(err, ERR_REFUSAL, "overlap or T-junction: %s", text);
}

bool embed_build(struct grid *g, const struct snap *s, const struct shim_cgal_mesh *given,
                 struct err *err) {
    return check_areas(g, s, err) && build(g, given, err) &&
           (!given || check_given(g, given, err)) && check_boundary(g, s, err);
}
