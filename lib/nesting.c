/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "nesting.h"

#include "mem.h"
#include "ray.h"
#include "topology.h"

#include <float.h>
#include <math.h>

/* The ray from the image of vertex v across the boundaries of the other components. It is needed
 * only if the box of one of them holds the image. */
struct shot {
    const struct boundary *b;
    uint32_t *component; /* by vertex */
    uint32_t count;
    struct boxes boxes; /* of the images of components */
    uint32_t v;
    int winding;
    bool known;
};

static bool visit(void *context, uint32_t arc) {
    struct shot *s = context;
    double q[ARC_DEGREE_MAX + 1][2];
    if (s->component[s->b->end[arc][0]] == s->component[s->v]) return true;
    boundary_arc(s->b, arc, q);
    s->known = ray_winding(s->b->spline->grid.degree, (const double(*)[2])q,
                           s->b->spline->phi[s->v], &s->winding);
    return s->known;
}

static bool is_own(void *context, uint32_t component) {
    const struct shot *s = context;
    return component == s->component[s->v];
}

static void shoot(struct shot *s, uint32_t v) {
    const double *p = s->b->spline->phi[v];
    struct box point = {{p[0], p[1]}, {p[0], p[1]}}, ray = {{-DBL_MAX, p[1]}, {p[0], p[1]}};
    s->v = v;
    s->winding = 0;
    s->known = true;
    if (!boxes_query(&s->boxes, &point, is_own, s)) (void)boxes_query(&s->b->boxes, &ray, visit, s);
}

/* Does the image of triangle t hold that of v? If it runs through it, as far as can be seen, yes.
 */
static bool covers(const struct spline *s, uint32_t t, uint32_t v) {
    double q[ARC_DEGREE_MAX + 1][2];
    int winding = 0;
    for (int l = 0; l < 3; l++) {
        boundary_arc_of_edge(s, t, l, q);
        if (!ray_winding(s->grid.degree, (const double(*)[2])q, s->phi[v], &winding)) return true;
    }
    return winding != 0;
}

/* The boundaries of triangles add up to those of their components, so there is one. */
static uint32_t find_triangle(const struct shot *s) {
    const struct grid *g = &s->b->spline->grid;
    uint32_t t = 0;
    while (s->component[g->triangle[t][0]] == s->component[s->v] || !covers(s->b->spline, t, s->v))
        INVARIANT(++t < g->triangle_count);
    return t;
}

/* One vertex of each component. */
static void shoot_all(struct nesting *n, struct shot *s, bool *done) {
    for (uint32_t i = 0; i < s->b->count; i++) {
        uint32_t v = s->b->end[i][0];
        if (done[s->component[v]]) continue;
        done[s->component[v]] = true;
        shoot(s, v);
        if (!s->known) n->verdict = NESTING_UNDECIDED;
        if (!s->known || s->winding == 0) continue;
        *n = (struct nesting){NESTING_INSIDE, v, find_triangle(s)};
        return;
    }
}

static bool measure(struct shot *s, struct err *err) {
    struct box *box;
    bool ok;
    if (!mem_new(box, s->count, err)) return false;
    for (uint32_t c = 0; c < s->count; c++)
        box[c] = (struct box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t i = 0; i < s->b->count; i++) {
        double q[ARC_DEGREE_MAX + 1][2];
        struct box arc;
        boundary_arc(s->b, i, q);
        arc = box_of_points((uint32_t)s->b->spline->grid.degree + 1, (const double(*)[2])q);
        box_enlarge(&box[s->component[s->b->end[i][0]]], &arc);
    }
    ok = boxes_init(&s->boxes, box, s->count, err);
    free(box);
    return ok;
}

static bool shot_init(struct shot *s, struct err *err) {
    const struct grid *g = &s->b->spline->grid;
    return mem_new(s->component, g->vertex_count, err) &&
           topology_components(g, s->component, &s->count, err) && measure(s, err);
}

bool nesting_survey(struct nesting *n, const struct boundary *b, struct err *err) {
    struct shot s = {.b = b};
    bool *done = NULL, ok;
    *n = (struct nesting){NESTING_NONE, GRID_NONE, GRID_NONE};
    ok = shot_init(&s, err) && mem_new(done, s.count, err);
    if (ok) shoot_all(n, &s, done);
    free(s.component);
    boxes_free(&s.boxes);
    free(done);
    return ok;
}
