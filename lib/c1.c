/* SPDX-License-Identifier: GPL-3.0-or-later */
/* With A(x,y,z) twice the signed area of a triangle, the barycentric coordinates of v0 in (u0,a,b)
 * are B0 = A(v0,a,b)/A(u0,a,b), B1 = A(u0,v0,b)/A(u0,a,b), B2 = A(u0,a,v0)/A(u0,a,b), so that the
 * integer form of a condition is
 *
 *     -A(u0,a,b) q^v_1jk + A(v0,a,b) q^u_1jk + A(u0,v0,b) q_0,j+1,k + A(u0,a,v0) q_0,j,k+1 = 0
 *
 * and, where a->b runs clockwise in u, minus that, to make twice the area of u the factor.
 *
 * Which conditions contain a point follows from its weights in the triangles it belongs to: weight
 * 1 against an edge makes it an extreme there, weight 0 puts it on the edge, where it is the
 * end towards b of one condition and the end towards a of the next. */
#include "c1.h"

#include "dd.h"

#include <math.h>

const char *const c1_type_names[] = {"corner",     "edge-corner", "edge", "inner-corner",
                                     "inner-edge", "interior",    NULL};

enum point_type c1_type(const struct grid *g, uint32_t p) {
    struct grid_place place;
    int zeros = 0, ones = 0;
    if (p < g->vertex_count) return TYPE_CORNER;
    place = grid_place(g, p);
    for (int l = 0; l < 3; l++) {
        zeros += place.weight[l] == 0;
        ones += place.weight[l] == 1;
    }
    if (zeros == 1) return ones > 0 ? TYPE_EDGE_CORNER : TYPE_EDGE;
    return ones > 1 ? TYPE_INNER_CORNER : ones == 1 ? TYPE_INNER_EDGE : TYPE_INTERIOR;
}

/* An inner edge as its two triangles see it: [0] is v, [1] is u. */
struct sides {
    uint32_t triangle[2];
    int opposite[2], a[2], b[2]; /* corners 0..2 */
};

static struct sides sides_of(const struct grid *g, uint32_t e) {
    struct sides s;
    INVARIANT(grid_edge_is_inner(g, e));
    for (int i = 0; i < 2; i++) {
        uint32_t t = g->edge_triangle[e][1 - i];
        int l = grid_opposite(g, t, e), next = (l + 1) % 3;
        bool forward = g->triangle[t][next] == g->edge[e][0];
        s.triangle[i] = t;
        s.opposite[i] = l;
        s.a[i] = forward ? next : (l + 2) % 3;
        s.b[i] = forward ? (l + 2) % 3 : next;
    }
    return s;
}

static void coefficients(const struct grid *g, uint32_t e, const struct sides *s, int64_t c[4]) {
    const int32_t *v0 = g->vertex[g->triangle[s->triangle[0]][s->opposite[0]]];
    const int32_t *u0 = g->vertex[g->triangle[s->triangle[1]][s->opposite[1]]];
    const int32_t *a = g->vertex[g->edge[e][0]], *b = g->vertex[g->edge[e][1]];
    c[0] = -predicate_area2(u0, a, b);
    c[1] = predicate_area2(v0, a, b);
    c[2] = predicate_area2(u0, v0, b);
    c[3] = predicate_area2(u0, a, v0);
    if (c[0] > 0)
        for (int i = 0; i < 4; i++) c[i] = -c[i];
}

/* The point of side i with the given weights against u0 or v0, a and b. */
static uint32_t side_point(const struct grid *g, const struct sides *s, int i, int opposite, int a,
                           int b) {
    int weight[3];
    weight[s->opposite[i]] = opposite;
    weight[s->a[i]] = a;
    weight[s->b[i]] = b;
    return grid_point(g, s->triangle[i], weight[0], weight[1], weight[2]);
}

struct c1_condition c1_condition(const struct grid *g, uint32_t e, int m) {
    struct c1_condition condition;
    struct sides s = sides_of(g, e);
    int j = g->degree - 1 - m;
    INVARIANT(m >= 0 && j >= 0);
    condition.point[0] = side_point(g, &s, 0, 1, j, m);
    condition.point[1] = side_point(g, &s, 1, 1, j, m);
    condition.point[2] = side_point(g, &s, 1, 0, j + 1, m);
    condition.point[3] = side_point(g, &s, 1, 0, j, m + 1);
    coefficients(g, e, &s, condition.coefficient);
    return condition;
}

struct visitor {
    void (*visit)(void *context, uint32_t e, int m);
    void *context;
};

/* The point with weight `towards_b` against b on edge e. */
static void visit_along(const struct grid *g, uint32_t e, int towards_b, const struct visitor *to) {
    struct sides s = sides_of(g, e);
    int64_t c[4];
    coefficients(g, e, &s, c);
    if (towards_b > 0 && c[3] != 0) to->visit(to->context, e, towards_b - 1);
    if (towards_b < g->degree && c[2] != 0) to->visit(to->context, e, towards_b);
}

void c1_conditions_of(const struct grid *g, uint32_t p,
                      void (*visit)(void *context, uint32_t e, int m), void *context) {
    struct visitor to = {visit, context};
    uint32_t single, n;
    const uint32_t *triangle = grid_triangles_of(g, p, &single, &n);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t t = triangle[i];
        int weight[3];
        grid_weights(g, p, t, weight);
        for (int l = 0; l < 3; l++) {
            uint32_t e = g->triangle_edge[t][l];
            int next = (l + 1) % 3, b = g->triangle[t][next] == g->edge[e][1] ? next : (l + 2) % 3;
            if (!grid_edge_is_inner(g, e)) continue;
            if (weight[l] == 1) visit(context, e, weight[b]);
            if (weight[l] == 0 && g->edge_triangle[e][0] == t) visit_along(g, e, weight[b], &to);
        }
    }
}

struct c1_value c1_evaluate(const struct c1_condition *condition, const struct c1_field *field,
                            int c) {
    struct dd sum = {0, 0};
    double weight = 0, largest = 0;
    for (int i = 0; i < 4; i++) {
        double a = (double)condition->coefficient[i];
        const double *q = field->q + field->stride * condition->point[i];
        sum = dd_add(sum, dd_two_prod(a, q[c]));
        weight += fabs(a);
        if (a == 0) continue;
        for (int other = 0; other < field->k; other++) largest = fmax(largest, fabs(q[other]));
    }
    return (struct c1_value){sum.hi, weight * (field->extent + largest)};
}

double c1_extent(const struct grid *g) {
    double largest = g->has_depth ? fmax(fabs(g->depth[0]), fabs(g->depth[1])) : 0;
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        double xy[2];
        grid_vertex(g, v, xy);
        largest = fmax(largest, fmax(fabs(xy[0]), fabs(xy[1])));
    }
    return largest;
}

bool c1_holds(struct c1_value value) {
    return fabs(value.sum) <= 64 * 0x1p-53 * value.terms;
}

double c1_relative(struct c1_value value) {
    return value.sum == 0 ? 0 : fabs(value.sum) / value.terms;
}

/* The neighbour of v that begins (last = false) or ends triangle t of its fan. */
static const int32_t *fan_neighbour(const struct grid *g, uint32_t v, uint32_t t, bool last) {
    int l = grid_corner(g, t, v);
    return g->vertex[g->triangle[t][(l + (last ? 2 : 1)) % 3]];
}

static bool is_inner(const struct grid *g, uint32_t v) {
    const uint32_t *first = g->fan + g->fan_start[v], *last = g->fan + g->fan_start[v + 1] - 1;
    return first != last && fan_neighbour(g, v, *first, false) == fan_neighbour(g, v, *last, true);
}

/* v is inner, so its edges are the first ones of its triangles, and lie on two lines at least. */
static bool is_singular(const struct grid *g, uint32_t v) {
    const int32_t *centre = g->vertex[v], *line[2] = {NULL, NULL};
    for (uint32_t i = g->fan_start[v]; i < g->fan_start[v + 1]; i++) {
        const int32_t *end = fan_neighbour(g, v, g->fan[i], false);
        if (!line[0] || predicate_area2(centre, line[0], end) == 0)
            line[0] = end;
        else if (!line[1] || predicate_area2(centre, line[1], end) == 0)
            line[1] = end;
        else
            return false;
    }
    return true;
}

void c1_vertices(const struct grid *g, uint32_t *inner, uint32_t *singular) {
    *inner = *singular = 0;
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        if (!is_inner(g, v)) continue;
        ++*inner;
        *singular += is_singular(g, v);
    }
}

size_t c1_rank_formula(const struct grid *g) {
    uint32_t inner, singular;
    size_t inner_edges = 0;
    INVARIANT(g->degree >= 5);
    for (uint32_t e = 0; e < g->edge_count; e++) inner_edges += grid_edge_is_inner(g, e);
    c1_vertices(g, &inner, &singular);
    return (size_t)g->degree * inner_edges - 2 * (size_t)inner - singular;
}

/* a > b, nan above all numbers. */
static bool exceeds(double a, double b) {
    return isnan(a) ? !isnan(b) : a > b;
}

/* One condition's part in the largest residuals. */
static void add_residual(const struct c1_condition *condition, struct c1_value value, uint32_t e,
                         double *absolute, double *relative, uint32_t *edge) {
    double largest = 0, off;
    for (int i = 0; i < 4; i++) largest = fmax(largest, fabs((double)condition->coefficient[i]));
    off = fabs(value.sum) / largest;
    if (exceeds(off, *absolute)) *absolute = off;
    if (!exceeds(c1_relative(value), *relative)) return;
    *relative = c1_relative(value);
    *edge = e;
}

bool c1_edge(const struct grid *g, uint32_t e, const struct c1_field *field, double *absolute,
             double *relative, uint32_t *edge) {
    bool holds = true;
    if (*edge == GRID_NONE) *edge = e;
    for (int m = 0; m < g->degree; m++) {
        struct c1_condition condition = c1_condition(g, e, m);
        for (int c = 0; c < field->k; c++) {
            struct c1_value value = c1_evaluate(&condition, field, c);
            holds = holds && c1_holds(value);
            add_residual(&condition, value, e, absolute, relative, edge);
        }
    }
    return holds;
}

void c1_residual(const struct grid *g, const struct c1_field *field, double *absolute,
                 double *relative, uint32_t *edge) {
    *absolute = *relative = 0;
    *edge = GRID_NONE;
    for (uint32_t e = 0; e < g->edge_count; e++)
        if (grid_edge_is_inner(g, e)) (void)c1_edge(g, e, field, absolute, relative, edge);
}
