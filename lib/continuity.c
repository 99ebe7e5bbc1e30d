/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The right side of a condition is the value at B of the polynomial of degree n whose coefficients
 * are the corner of u's net at (j,k): de Casteljau's triangle. The values at all (j,k) share it:
 * after n rounds over the n + 1 rows of u's net next to the edge, row 0 has the right sides.
 *
 *         u0          rows of u: weight i = 0..n against u0, i.e. d - i + 1 points from a to b
 *       . . .  i = 2
 *      . . . .  1     When row n joins in, row n - 1 takes its first round, row n - 2 its second,
 * ... a . . . . .  0 b  and row 0 its nth; so no row is looked at before its order is reached.
 */
#include "continuity.h"

#include "c1.h"
#include "exact.h"
#include "mem.h"

#include <math.h>

enum { COMPONENTS_MAX = 4, ROW = GRID_DEGREE_MAX + 1 };

/* An inner edge as triangle side sees it. */
struct side {
    uint32_t triangle;
    int opposite, a, b; /* corners 0..2 */
};

static struct side side_of(const struct grid *g, uint32_t e, int i) {
    struct side s = {.triangle = g->edge_triangle[e][i]};
    s.opposite = grid_opposite(g, s.triangle, e);
    s.a = (s.opposite + 1) % 3;
    s.b = (s.opposite + 2) % 3;
    if (g->triangle[s.triangle][s.a] != g->edge[e][0]) {
        int swap = s.a;
        s.a = s.b;
        s.b = swap;
    }
    return s;
}

static uint32_t point_of(const struct grid *g, const struct side *s, int n, int k) {
    int weight[3];
    weight[s->opposite] = n;
    weight[s->a] = g->degree - n - k;
    weight[s->b] = k;
    return grid_point(g, s->triangle, weight[0], weight[1], weight[2]);
}

/* Component c of 0..3: x, y, sigma0, sigma1. */
static double component(const struct spline *s, uint32_t p, int c) {
    return c < 2 ? s->phi[p][c] : s->sigma[p][c - 2];
}

/* A row of values and of what they are held against: sums of |B..| (extent + |q|). */
struct row {
    double value[ROW], terms[ROW];
};

static void load(const struct spline *s, const struct side *u, int c, double extent, int i,
                 struct row *row) {
    for (int k = 0; k <= s->grid.degree - i; k++) {
        uint32_t p = point_of(&s->grid, u, i, k);
        double x = fabs(component(s, p, c & ~1)), y = fabs(component(s, p, c | 1));
        row->value[k] = component(s, p, c);
        row->terms[k] = extent + (x > y ? x : y);
    }
}

/* One round: n points of row i from the rows i and i + 1. */
static void round_of(int n, const double b[3], struct row *row, const struct row *above) {
    for (int k = 0; k < n; k++) {
        row->value[k] = b[0] * above->value[k] + b[1] * row->value[k] + b[2] * row->value[k + 1];
        row->terms[k] = fabs(b[0]) * above->terms[k] + fabs(b[1]) * row->terms[k] +
                        fabs(b[2]) * row->terms[k + 1];
    }
}

static void coordinates(const struct grid *g, const struct side *u, const struct side *v,
                        double b[3]) {
    const uint32_t *t = g->triangle[u->triangle];
    const int32_t *u0 = g->vertex[t[u->opposite]], *p = g->vertex[t[u->a]], *q = g->vertex[t[u->b]];
    const int32_t *v0 = g->vertex[g->triangle[v->triangle][v->opposite]];
    double area = (double)predicate_area2(u0, p, q);
    b[0] = (double)predicate_area2(v0, p, q) / area;
    b[1] = (double)predicate_area2(u0, v0, q) / area;
    b[2] = (double)predicate_area2(u0, p, v0) / area;
}

/* Largest order <= most of component c. */
static int order_of(const struct spline *s, const struct side *u, const struct side *v, int c,
                    double extent, int most) {
    struct row rows[ROW];
    double b[3];
    int d = s->grid.degree;
    coordinates(&s->grid, u, v, b);
    load(s, u, c, extent, 0, &rows[0]);
    for (int n = 1; n <= most; n++) {
        load(s, u, c, extent, n, &rows[n]);
        for (int i = n - 1; i >= 0; i--) round_of(d - n + 1, b, &rows[i], &rows[i + 1]);
        for (int k = 0; n > 1 && k <= d - n; k++) {
            double own = component(s, point_of(&s->grid, v, n, k), c);
            double terms = rows[0].terms[k] + extent + fabs(own);
            if (!(fabs(own - rows[0].value[k]) <= 64 * n * 0x1p-53 * terms)) return n - 1;
        }
    }
    return most;
}

/* The largest residuals of phi and sigma, each, as c1_edge adds them up. */
struct residuals {
    struct c1_field field;
    double absolute, relative;
    uint32_t edge;
};

static int residuals_begin(const struct spline *s, double extent, struct residuals r[2]) {
    r[0] = (struct residuals){{&s->phi[0][0], 2, 2, extent}, 0, 0, GRID_NONE};
    if (!s->sigma) return 1;
    r[1] = (struct residuals){{&s->sigma[0][0], 2, 2, extent}, 0, 0, GRID_NONE};
    return 2;
}

static bool add_edge(const struct grid *g, uint32_t e, int fields, struct residuals r[2]) {
    bool holds = true;
    for (int i = 0; i < fields; i++)
        holds &= c1_edge(g, e, &r[i].field, &r[i].absolute, &r[i].relative, &r[i].edge);
    return holds;
}

/* Across an edge that is C1. */
static int order_beyond(const struct spline *s, uint32_t e, double extent) {
    struct side v = side_of(&s->grid, e, 1), u = side_of(&s->grid, e, 0);
    int order = s->grid.degree;
    for (int c = 0; c < (s->sigma ? 4 : 2) && order > 1; c++)
        order = order_of(s, &u, &v, c, extent, order);
    return order;
}

int continuity_order(const struct spline *s, uint32_t e, double extent) {
    struct residuals r[2];
    int fields = residuals_begin(s, extent, r);
    return add_edge(&s->grid, e, fields, r) ? order_beyond(s, e, extent) : 0;
}

/* All conditions of order 1 as rows over the control points; coefficients that are 0 left out. */
static void fill_rows(const struct grid *g, struct int_matrix *a) {
    size_t n = 0;
    a->rows = 0;
    for (uint32_t e = 0; e < g->edge_count; e++) {
        if (!grid_edge_is_inner(g, e)) continue;
        for (int m = 0; m < g->degree; m++) {
            struct c1_condition condition = c1_condition(g, e, m);
            a->start[a->rows++] = n;
            for (int i = 0; i < 4; i++) {
                if (condition.coefficient[i] == 0) continue;
                a->col[n] = condition.point[i];
                a->value[n++] = condition.coefficient[i];
            }
        }
    }
    a->start[a->rows] = n;
}

static bool count_rank(struct continuity *c, const struct grid *g, struct err *err) {
    struct int_matrix a = {.rows = c->conditions, .cols = g->point_count};
    struct exact_rows rows = {0};
    bool ok = mem_new(a.start, a.rows + 1, err) && mem_new(a.col, 4 * a.rows, err) &&
              mem_new(a.value, 4 * a.rows, err);
    if (ok) {
        fill_rows(g, &a);
        ok = exact_rows_init(&rows, &a, err);
        c->rank = rows.rank;
        exact_rows_free(&rows);
    }
    free(a.start);
    free(a.col);
    free(a.value);
    return ok;
}

bool continuity_survey(struct continuity *c, const struct spline *s, struct err *err) {
    const struct grid *g = &s->grid;
    double extent = c1_extent(g);
    struct residuals r[2];
    int fields = residuals_begin(s, extent, r);
    *c = (struct continuity){.worst = GRID_NONE};
    for (uint32_t e = 0; e < g->edge_count; e++) {
        if (!grid_edge_is_inner(g, e)) continue;
        c->conditions += (size_t)g->degree;
        c->edges[add_edge(g, e, fields, r) ? order_beyond(s, e, extent) : 0]++;
    }
    for (int i = 0; i < fields; i++) {
        if (r[i].absolute > c->absolute || isnan(r[i].absolute)) c->absolute = r[i].absolute;
        if (i > 0 && r[i].relative <= c->relative) continue;
        c->relative = r[i].relative;
        c->worst = r[i].edge;
    }
    return count_rank(c, g, err);
}
