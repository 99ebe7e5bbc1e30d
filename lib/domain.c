/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The polygon is checked as given and once more on the lattice, since snapping may make sides
 * touch: the first fault is the polygon's, the second the lattice's. Sides are taken so that the
 * domain lies on their left, outline counter-clockwise and holes clockwise; then each side of a
 * sound polygon has covering number 1 on its left, and 0 there if
 *
 *     a hole lies outside the outline,    a hole lies in a hole,    a hole encloses the outline
 */
#include "domain.h"

#include "embed.h"
#include "mem.h"
#include "predicate.h"
#include "sides.h"
#include "snap.h"
#include "trig.h"

#include <math.h>
#include <string.h>

enum { LEAST_CELLS = 8 }; /* lattice squares in a triangle of the largest area, to leave a choice */

struct work {
    const struct polygon *polygon;
    const struct domain *domain;
    uint32_t (*side)[2]; /* side i begins or ends at point i */
    double (*at)[2];     /* lattice coordinates of the points */
    struct snap snap;
};

/* The sides between the polygon's points, which are here: the polygon's own, or snapped. */
static struct shim_cgal_sides sides_at(const struct work *w, const double (*point)[2]) {
    return (struct shim_cgal_sides){point, w->polygon->point_count, (const uint32_t(*)[2])w->side,
                                    w->polygon->point_count};
}

static void orient_sides(struct work *w) {
    const struct polygon *g = w->polygon;
    for (size_t l = 0; l < g->loop_count; l++) {
        bool reversed = polygon_sense(g, l) == (l == 0 ? -1 : 1);
        for (size_t i = g->loop_start[l]; i < g->loop_start[l + 1]; i++) {
            w->side[i][reversed] = (uint32_t)i;
            w->side[i][!reversed] = (uint32_t)g->next[i];
        }
    }
}

/* Is p, which lies on no side, inside that loop? By the crossings of a ray to the right. */
static bool is_inside(const struct polygon *g, size_t loop, const double p[2]) {
    bool inside = false;
    for (size_t i = g->loop_start[loop]; i < g->loop_start[loop + 1]; i++) {
        const double *a = g->point[i], *b = g->point[g->next[i]];
        if ((a[1] > p[1]) != (b[1] > p[1]) && (predicate_orient(a, b, p) > 0) == (b[1] > a[1]))
            inside = !inside;
    }
    return inside;
}

/* Refuses a loop that lies in the wrong place. */
static bool refuse_place(const struct polygon *g, size_t side, struct err *err) {
    size_t loop = 0, hole = 1;
    const double *p;
    while (side >= g->loop_start[loop + 1]) loop++;
    p = g->point[g->loop_start[loop]];
    while (hole < g->loop_count && (hole == loop || !is_inside(g, hole, p))) hole++;
    if (hole == g->loop_count)
        return err_set(err, ERR_REFUSAL, "hole %zu, at (%.9g, %.9g), lies outside the outline",
                       loop, p[0], p[1]);
    if (loop == 0)
        return err_set(err, ERR_REFUSAL, "hole %zu encloses the outline, at (%.9g, %.9g)", hole,
                       p[0], p[1]);
    return err_set(err, ERR_REFUSAL, "hole %zu, at (%.9g, %.9g), lies in hole %zu", loop, p[0],
                   p[1], hole);
}

static bool check_polygon(const struct work *w, struct err *err) {
    const struct polygon *g = w->polygon;
    struct shim_cgal_sides sides = sides_at(w, (const double(*)[2])g->point);
    struct sides_fault fault;
    char text[SIDES_TEXT_MAX];
    if (!sides_check(&sides, &fault, err)) return false;
    if (fault.trouble == SIDES_SOUND) return true;
    if (fault.trouble == SIDES_COVERED) return refuse_place(g, fault.a, err);
    sides_describe(&fault, &sides, sides.point, text);
    return err_set(err, ERR_REFUSAL, "the polygon is not simple: %s", text);
}

static bool check_snapped(const struct work *w, struct err *err) {
    struct shim_cgal_sides sides = sides_at(w, (const double(*)[2])w->at);
    struct sides_fault fault;
    char text[SIDES_TEXT_MAX];
    if (!sides_check(&sides, &fault, err)) return false;
    if (fault.trouble == SIDES_SOUND) return true;
    sides_describe(&fault, &sides, (const double(*)[2])w->polygon->point, text);
    return snap_refuse(&w->snap, err, "then %s", text);
}

static bool snap_polygon(struct work *w, struct err *err) {
    const struct polygon *g = w->polygon;
    const double(*point)[2] = (const double(*)[2])g->point;
    if (!snap_init(&w->snap, &w->domain->lattice, point, g->point_count, err) ||
        !snap_check_distinct(&w->snap, point, err) || !mem_new(w->at, g->point_count, err))
        return false;
    for (size_t i = 0; i < g->point_count; i++) {
        w->at[i][0] = w->snap.at[i][0];
        w->at[i][1] = w->snap.at[i][1];
    }
    return check_snapped(w, err);
}

/* What a refinement that failed says. */
static bool refuse_refinement(const struct work *w, const struct shim_cgal_report *report,
                              struct err *err) {
    struct sides_fault fault;
    if (report->status == SHIM_CGAL_LIMIT)
        return err_set(err, ERR_REFUSAL,
                       "more than %zu triangles are needed; allow more with --max-triangles, or a "
                       "larger --max-area or smaller --min-angle",
                       w->domain->max_triangles);
    if (report->status == SHIM_CGAL_PRECISION)
        return err_set(err, ERR_REFUSAL,
                       "the refinement does not end: a smaller --min-angle than %g is needed",
                       w->domain->min_angle);
    struct shim_cgal_sides sides = sides_at(w, (const double(*)[2])w->at);
    INVARIANT(!sides_fault(&sides, report, &fault, err));
    return false;
}

static bool refine(const struct work *w, struct shim_cgal_mesh *mesh, struct err *err) {
    const struct domain *d = w->domain;
    struct shim_cgal_sides sides = sides_at(w, (const double(*)[2])w->at);
    struct shim_cgal_report report;
    double step = w->snap.lattice.step, cosine, sine;
    struct shim_cgal_criteria criteria = {true, d->max_area / step / step, 0, d->max_triangles};
    if (criteria.max_area < LEAST_CELLS)
        return snap_refuse(&w->snap, err, "a triangle of area %.9g would cover %.3g of its squares",
                           d->max_area, criteria.max_area);
    trig_degrees(d->min_angle, &cosine, &sine);
    criteria.sine2 = sine * sine;
    return shim_cgal_domain(&sides, d->min_angle > 0 || isfinite(d->max_area) ? &criteria : NULL,
                            mesh, &report) ||
           refuse_refinement(w, &report, err);
}

/* Moves a mesh into the grid, with its vertices rounded as the area limit expects it. */
static bool take_mesh(struct grid *g, const struct work *w, struct shim_cgal_mesh *mesh,
                      struct err *err) {
    g->lattice = w->snap.lattice;
    g->vertex_count = (uint32_t)mesh->vertex_count;
    g->triangle_count = (uint32_t)mesh->triangle_count;
    g->triangle = mesh->triangle;
    mesh->triangle = NULL;
    if (!mem_new(g->vertex, mesh->vertex_count, err)) return false;
    for (size_t v = 0; v < mesh->vertex_count; v++)
        for (int c = 0; c < 2; c++) g->vertex[v][c] = (int32_t)floor(mesh->vertex[v][c] + 0.5);
    return true;
}

static bool run(struct work *w, struct grid *g, struct err *err) {
    struct shim_cgal_mesh mesh = {0};
    bool ok;
    if (!mem_new(w->side, w->polygon->point_count, err)) return false;
    orient_sides(w);
    ok = check_polygon(w, err) && snap_polygon(w, err) && refine(w, &mesh, err) &&
         take_mesh(g, w, &mesh, err) && embed_build(g, &w->snap, NULL, err);
    free(mesh.vertex);
    free(mesh.triangle);
    return ok;
}

bool domain_grid(struct grid *g, const struct polygon *outline, const struct domain *d,
                 struct err *err) {
    struct work w = {.polygon = outline, .domain = d};
    bool ok;
    if (outline->point_count >= GRID_NONE)
        return err_set(err, ERR_REFUSAL, "%zu points are too many", outline->point_count);
    ok = run(&w, g, err);
    free(w.side);
    free(w.at);
    snap_free(&w.snap);
    return ok;
}
