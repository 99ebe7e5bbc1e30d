/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of the cousin function against two others. One is exact: rationals, f = (19/20)^depth, and
 * one rule for all places, the steepest way that stays in a triangle or on an edge. The other knows
 * no rules at all: tiny steps along the gradient of whatever triangle it is in. */
#include "icc_trace.h"

#include "balls.h"
#include "icc_resolution.h"
#include "testing.h"

#include <gmp.h>
#include <stdlib.h>
#include <string.h>

struct scene {
    struct icc_domain domain;
    struct icc_function function;
    struct icc_cells cells;
    struct icc_field field;
};

static void scene_init(struct scene *s, const double (*vertex)[2], size_t n, double h,
                       const struct icc_function_rule *rule) {
    struct err err = {0};
    uint32_t *layer, layers;
    assert_true(icc_domain_init(&s->domain, vertex, n, h, &err));
    assert_true(s->domain.inside_count > 0);
    layer = calloc(icc_domain_size(&s->domain), sizeof *layer);
    assert_non_null(layer);
    layers = icc_domain_burn(&s->domain, layer);
    assert_true(icc_function_init(&s->function, &s->domain,
                                  icc_domain_last(&s->domain, layer, layers), rule, &err));
    assert_true(icc_cells_init(&s->cells, &s->domain, &err));
    s->field = (struct icc_field){&s->domain, &s->function, &s->cells};
    free(layer);
}

static void scene_free(struct scene *s) {
    icc_domain_free(&s->domain);
    icc_function_free(&s->function);
    icc_cells_free(&s->cells);
}

static bool passes(const struct scene *s, enum icc_test first) {
    struct icc_failures failures[ICC_TESTS];
    icc_resolution(&s->field, failures);
    for (int t = (int)first; t < ICC_TESTS; t++)
        if (failures[t].count) return false;
    return true;
}

static bool is_fine(const struct scene *s) {
    return passes(s, ICC_TEST_REACHED);
}

/* Winding by signs in double: for points that are not within rounding of the cage. */
static bool is_in_cage(const struct icc_domain *d, const double p[2]) {
    bool inside = false;
    for (size_t i = 0; i < d->count; i++) {
        const double *a = d->cage[i], *b = d->cage[i + 1 < d->count ? i + 1 : 0];
        if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
        if (p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1])) inside = !inside;
    }
    return inside;
}

static void random_inside(const struct icc_domain *d, double p[2], uint64_t *state) {
    do {
        p[0] = 1 + (d->nx - 3) * random_unit(state);
        p[1] = 1 + (d->ny - 3) * random_unit(state);
    } while (!is_in_cage(d, p));
}

/* ---- the edge rule ----------------------------------------------------------------------------
 */

/* [13] Table 5.1, on the triangle (0,0) (2,0) (1,2), entered at (1,0) through its lower edge. */
static void edge_rule(void **state) {
    static const struct {
        double g[2];
        bool tie;
        enum icc_exit exit;
    } table[] = {
        {{0, -1}, false, ICC_TO_A}, /* against the edge, without preference: the tie decides */
        {{0, -1}, true, ICC_TO_B},
        {{1, -1}, false, ICC_TO_B}, /* compression */
        {{-1, -1}, true, ICC_TO_A},
        {{1, 0}, false, ICC_TO_B}, /* along the edge is compression, too */
        {{-3, 0}, true, ICC_TO_A},
        {{0, 1}, false, ICC_TO_O}, /* passing through */
        {{1, 1}, false, ICC_THROUGH_BO},
        {{1, 100}, false, ICC_THROUGH_BO},
        {{100, 1}, false, ICC_THROUGH_BO},
        {{-1, 1}, true, ICC_THROUGH_OA},
        {{-1, 100}, true, ICC_THROUGH_OA},
    };
    const double a[2] = {0, 0}, b[2] = {2, 0}, o[2] = {1, 2}, p[2] = {1, 0};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        assert_int_equal(icc_exit(a, b, o, table[i].g, p, table[i].tie), table[i].exit);
}

/* Any triangle, any point of its edge, any direction, in integers. */
static void edge_rule_random(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(20000); seed++) {
        uint64_t random = seed;
        double v[3][2], g[2], p[2];
        int64_t e[2], po[2], pass, s;
        for (int k = 0; k < 3; k++)
            for (int c = 0; c < 2; c++) v[k][c] = (double)random_in(&random, -8, 8);
        if ((v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]) <=
            0)
            continue;
        for (int c = 0; c < 2; c++) {
            g[c] = (double)random_in(&random, -4, 4);
            p[c] = (v[0][c] + v[1][c]) / 2;
            e[c] = (int64_t)(v[1][c] - v[0][c]);
            po[c] = (int64_t)(2 * v[2][c] - v[0][c] - v[1][c]);
        }
        pass = (int64_t)g[0] * e[1] - (int64_t)g[1] * e[0];
        s = (int64_t)g[0] * po[1] - (int64_t)g[1] * po[0];
        enum icc_exit exit = icc_exit(v[0], v[1], v[2], g, p, seed % 2);
        int64_t along = (int64_t)g[0] * e[0] + (int64_t)g[1] * e[1];
        if (pass >= 0)
            check_seed(seed, exit == (along > 0 || (along == 0 && seed % 2) ? ICC_TO_B : ICC_TO_A));
        else
            check_seed(seed, exit == (s > 0 ? ICC_THROUGH_BO : s < 0 ? ICC_THROUGH_OA : ICC_TO_O));
    }
}

/* ---- exactly ----------------------------------------------------------------------------------
 */

struct point {
    mpq_t x[2];
};

static void point_init(struct point *p) {
    mpq_inits(p->x[0], p->x[1], NULL);
}

static void point_clear(struct point *p) {
    mpq_clears(p->x[0], p->x[1], NULL);
}

static void point_set(struct point *p, const double q[2]) {
    for (int c = 0; c < 2; c++) mpq_set_d(p->x[c], q[c]);
}

/* (b - a) x (q - p) */
static void exact_cross(mpq_t r, const struct point *a, const struct point *b,
                        const struct point *p, const struct point *q) {
    mpq_t u, v;
    mpq_inits(u, v, NULL);
    mpq_sub(u, b->x[0], a->x[0]);
    mpq_sub(v, q->x[1], p->x[1]);
    mpq_mul(r, u, v);
    mpq_sub(u, b->x[1], a->x[1]);
    mpq_sub(v, q->x[0], p->x[0]);
    mpq_mul(u, u, v);
    mpq_sub(r, r, u);
    mpq_clears(u, v, NULL);
}

/* p + t g */
static void move(struct point *r, const struct point *p, const mpq_t t, const struct point *g) {
    mpq_t step;
    mpq_init(step);
    for (int c = 0; c < 2; c++) {
        mpq_mul(step, t, g->x[c]);
        mpq_add(r->x[c], p->x[c], step);
    }
    mpq_clear(step);
}

struct exact {
    const struct scene *s;
    double sense, base; /* f in units of its value at this depth */
    struct point p, best, zero;
    mpq_t slope2;
    double angle;    /* of the best way, counter-clockwise from +x */
    int triangles;   /* ways through triangles that were offered */
    bool edges_only; /* they are refused */
};

static void exact_value(const struct exact *e, uint32_t v, mpq_t f) {
    double k = e->base - e->s->function.height[v];
    mpq_set_ui(f, 1, 1);
    assert_true(k >= 0 && k < 1000);
    mpz_ui_pow_ui(mpq_numref(f), 19, (unsigned long)k);
    mpz_ui_pow_ui(mpq_denref(f), 20, (unsigned long)k);
}

/* A way towards `to` of this slope; the steepest is kept, of equal ones the first around. */
static void offer(struct exact *e, const struct point *to, const mpq_t slope2) {
    double x = mpq_get_d(to->x[0]) - mpq_get_d(e->p.x[0]);
    double y = mpq_get_d(to->x[1]) - mpq_get_d(e->p.x[1]), angle = atan2(y, x);
    int order = mpq_cmp(slope2, e->slope2);
    if (angle < -1e-9) angle += 2 * 3.14159265358979323846;
    if (order < 0 || (order == 0 && angle >= e->angle)) return;
    mpq_set(e->slope2, slope2);
    e->angle = angle;
    for (int c = 0; c < 2; c++) mpq_set(e->best.x[c], to->x[c]);
}

/* Along the edge from p to its end b; a, b are the ends, f rises by df from a to b. */
static void offer_edge(struct exact *e, const struct point *a, const struct point *b,
                       const mpq_t df) {
    mpq_t slope2, length2, x;
    if (mpq_equal(e->p.x[0], b->x[0]) && mpq_equal(e->p.x[1], b->x[1])) return;
    if (mpq_sgn(df) * e->sense <= 0) return;
    mpq_inits(slope2, length2, x, NULL);
    mpq_mul(slope2, df, df);
    for (int c = 0; c < 2; c++) {
        mpq_sub(x, b->x[c], a->x[c]);
        mpq_mul(x, x, x);
        mpq_add(length2, length2, x);
    }
    mpq_div(slope2, slope2, length2);
    offer(e, b, slope2);
    mpq_clears(slope2, length2, x, NULL);
}

struct exact_triangle {
    struct point corner[3], g;
    mpq_t f[3];
};

/* Through the triangle along g, if that leads into it, to where it leaves. */
static void offer_triangle(struct exact *e, const struct exact_triangle *t) {
    mpq_t side, turn, first, slope2, x;
    bool into = true, any = false;
    struct point to;
    mpq_inits(side, turn, first, slope2, x, NULL);
    point_init(&to);
    for (int k = 0; k < 3; k++) {
        const struct point *a = &t->corner[k], *b = &t->corner[(k + 1) % 3];
        exact_cross(side, a, b, a, &e->p);
        exact_cross(turn, a, b, &e->zero, &t->g);
        if (mpq_sgn(side) == 0 && mpq_sgn(turn) <= 0) into = false;
        if (mpq_sgn(side) == 0 || mpq_sgn(turn) >= 0) continue;
        mpq_div(x, side, turn);
        mpq_neg(x, x);
        if (!any || mpq_cmp(x, first) < 0) mpq_set(first, x);
        any = true;
    }
    if (into && any) {
        for (int c = 0; c < 2; c++) {
            mpq_mul(x, t->g.x[c], t->g.x[c]);
            mpq_add(slope2, slope2, x);
        }
        move(&to, &e->p, first, &t->g);
        e->triangles++;
        if (!e->edges_only) offer(e, &to, slope2);
    }
    point_clear(&to);
    mpq_clears(side, turn, first, slope2, x, NULL);
}

static const int corner_at[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};

static bool has_values(const struct exact *e, long i, long j, bool upper) {
    for (int k = 0; k < 3; k++) {
        long x = i + corner_at[upper][k][0], y = j + corner_at[upper][k][1];
        if (isnan(e->s->function.height[y * e->s->domain.nx + x])) return false;
    }
    return true;
}

static void exact_triangle_init(struct exact *e, struct exact_triangle *t, long i, long j,
                                bool upper) {
    point_init(&t->g);
    for (int k = 0; k < 3; k++) {
        point_init(&t->corner[k]);
        mpq_init(t->f[k]);
        mpq_set_si(t->corner[k].x[0], i + corner_at[upper][k][0], 1);
        mpq_set_si(t->corner[k].x[1], j + corner_at[upper][k][1], 1);
        exact_value(
            e,
            (uint32_t)((j + corner_at[upper][k][1]) * e->s->domain.nx + i + corner_at[upper][k][0]),
            t->f[k]);
    }
    mpq_sub(t->g.x[0], t->f[1], upper ? t->f[2] : t->f[0]);
    mpq_sub(t->g.x[1], t->f[2], upper ? t->f[0] : t->f[1]);
    for (int c = 0; c < 2; c++)
        if (e->sense < 0) mpq_neg(t->g.x[c], t->g.x[c]);
}

static void exact_triangle_clear(struct exact_triangle *t) {
    point_clear(&t->g);
    for (int k = 0; k < 3; k++) {
        point_clear(&t->corner[k]);
        mpq_clear(t->f[k]);
    }
}

static bool holds(const struct exact *e, const struct exact_triangle *t) {
    bool ok = true;
    mpq_t side;
    mpq_init(side);
    for (int k = 0; k < 3 && ok; k++) {
        exact_cross(side, &t->corner[k], &t->corner[(k + 1) % 3], &t->corner[k], &e->p);
        ok = mpq_sgn(side) >= 0;
    }
    mpq_clear(side);
    return ok;
}

static void offer_all(struct exact *e, const struct exact_triangle *t) {
    mpq_t side, df;
    if (!holds(e, t)) return;
    mpq_inits(side, df, NULL);
    offer_triangle(e, t);
    for (int k = 0; k < 3; k++) {
        const struct point *a = &t->corner[k], *b = &t->corner[(k + 1) % 3];
        exact_cross(side, a, b, a, &e->p);
        if (mpq_sgn(side) != 0) continue;
        mpq_sub(df, t->f[(k + 1) % 3], t->f[k]);
        offer_edge(e, a, b, df);
        mpq_neg(df, df);
        offer_edge(e, b, a, df);
    }
    mpq_clears(side, df, NULL);
}

static bool is_at(const struct point *p, double x, double y) {
    return mpq_get_d(p->x[0]) == x && mpq_get_d(p->x[1]) == y &&
           mpz_cmp_ui(mpq_denref(p->x[0]), 1) == 0 && mpz_cmp_ui(mpq_denref(p->x[1]), 1) == 0;
}

static bool is_vertex(const struct point *p) {
    return is_at(p, mpq_get_d(p->x[0]), mpq_get_d(p->x[1]));
}

/* e->best becomes the next point; false: there is no way. */
static bool exact_step(struct exact *e) {
    long i = (long)floor(mpq_get_d(e->p.x[0])), j = (long)floor(mpq_get_d(e->p.x[1]));
    e->base = -INFINITY;
    for (long y = j - 1; y <= j + 2; y++)
        for (long x = i - 1; x <= i + 2; x++)
            e->base = fmax(e->base, e->s->function.height[y * e->s->domain.nx + x]);
    mpq_set_si(e->slope2, -1, 1);
    e->triangles = 0;
    for (long y = j - 1; y <= j + 1; y++)
        for (long x = i - 1; x <= i + 1; x++)
            for (int upper = 0; upper < 2; upper++) {
                struct exact_triangle t;
                if (!has_values(e, x, y, upper)) continue;
                exact_triangle_init(e, &t, x, y, upper);
                offer_all(e, &t);
                exact_triangle_clear(&t);
            }
    if (e->triangles == 2 && !e->edges_only && !is_vertex(&e->p)) { /* an expansion edge */
        e->edges_only = true;
        exact_step(e);
        e->edges_only = false;
    }
    return mpq_sgn(e->slope2) > 0;
}

/* The first side that the way to e->best crosses, by rationals; e->best becomes the crossing. */
static bool exact_cage(struct exact *e, uint32_t *which, double *lambda) {
    const struct icc_domain *d = &e->s->domain;
    struct point a, b;
    mpq_t pa, pb, qa, first, t, u;
    bool found = false;
    point_init(&a);
    point_init(&b);
    mpq_inits(pa, pb, qa, first, t, u, NULL);
    for (uint32_t side = 0; side < d->count; side++) {
        point_set(&a, d->cage[side]);
        point_set(&b, d->cage[side + 1 < d->count ? side + 1 : 0]);
        exact_cross(pa, &a, &b, &a, &e->p);
        exact_cross(pb, &a, &b, &a, &e->best);
        if (mpq_sgn(pa) < 0 || mpq_sgn(pb) >= 0) continue; /* from the left to the right */
        exact_cross(t, &e->p, &e->best, &e->p, &a);
        exact_cross(u, &e->p, &e->best, &e->p, &b);
        if ((mpq_sgn(t) > 0) == (mpq_sgn(u) > 0)) continue;
        mpq_sub(pb, pa, pb);
        mpq_div(pa, pa, pb); /* along the way */
        if (found && mpq_cmp(pa, first) >= 0) continue;
        found = true;
        mpq_set(first, pa);
        *which = side;
        mpq_sub(u, t, u);
        mpq_div(t, t, u);
        *lambda = mpq_get_d(t);
    }
    if (found) {
        point_set(&a, (const double[2]){0, 0});
        for (int c = 0; c < 2; c++) mpq_sub(a.x[c], e->best.x[c], e->p.x[c]);
        move(&e->best, &e->p, first, &a);
    }
    mpq_clears(pa, pb, qa, first, t, u, NULL);
    point_clear(&a);
    point_clear(&b);
    return found;
}

static void exact_init(struct exact *e, const double from[2]) {
    point_init(&e->p);
    point_init(&e->best);
    point_init(&e->zero);
    mpq_init(e->slope2);
    point_set(&e->p, from);
}

static void exact_clear(struct exact *e) {
    mpq_clear(e->slope2);
    point_clear(&e->p);
    point_clear(&e->best);
    point_clear(&e->zero);
}

/* Is p a vertex with values all around? */
static bool is_known(const struct exact *e) {
    long i = (long)mpq_get_d(e->p.x[0]), j = (long)mpq_get_d(e->p.x[1]);
    return is_vertex(&e->p) && has_values(e, i, j, 0) && has_values(e, i, j, 1) &&
           has_values(e, i - 1, j, 0) && has_values(e, i - 1, j - 1, 1) &&
           has_values(e, i - 1, j - 1, 0) && has_values(e, i, j - 1, 1);
}

/* Every point of the line is where the exact one is, and it ends where that does. */
static size_t check_line(const struct scene *s, const double from[2], enum icc_direction direction,
                         uint64_t seed) {
    struct exact e = {.s = s, .sense = direction};
    struct icc_line line = {0};
    struct err err = {0};
    uint32_t side = 0, nx = s->domain.nx, top = s->function.maximum;
    double lambda = 0;
    bool ended = false;
    size_t steps;
    exact_init(&e, from);
    assert_true(icc_trace(&s->field, from, direction, &line, &err));
    for (size_t i = 1; i < line.count; i++) {
        check_seed(seed, !ended && exact_step(&e));
        if (direction == ICC_DOWNHILL) ended = exact_cage(&e, &side, &lambda);
        for (int c = 0; c < 2; c++) {
            check_seed(seed, fabs(mpq_get_d(e.best.x[c]) - line.point[i][c]) < 1e-10);
            mpq_set(e.p.x[c], e.best.x[c]);
        }
        if (direction == ICC_UPHILL) ended = is_at(&e.p, top % nx, top / nx);
    }
    check_seed(seed, ended == (line.end != ICC_END_STUCK));
    if (!ended) check_seed(seed, !is_known(&e) || !exact_step(&e));
    if (line.end == ICC_END_CAGE) {
        check_seed(seed, line.side == side && fabs(line.lambda - lambda) < 1e-9);
        check_seed(seed, line.lambda >= 0 && line.lambda <= 1);
    }
    steps = line.count;
    exact_clear(&e);
    icc_line_free(&line);
    return steps;
}

static void check_lines(struct scene *s, bool up, int lines, uint64_t seed, uint64_t *random) {
    for (int k = 0; k < lines; k++) {
        double p[2];
        random_inside(&s->domain, p, random);
        if (up) check_line(s, p, ICC_UPHILL, seed);
        check_line(s, p, ICC_DOWNHILL, seed);
    }
}

static void against_rationals(void **state) {
    const struct icc_function_rule rule = {.kind = ICC_COUSIN};
    int scenes = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(60); seed++) {
        double vertex[20][2];
        uint64_t random = seed;
        size_t n = (size_t)random_in(&random, 3, 20);
        struct scene s;
        random_cage(vertex, n, 0.6, &random);
        scene_init(&s, (const double(*)[2])vertex, n, 0.13 - 0.05 * random_unit(&random), &rule);
        if (is_fine(&s)) check_lines(&s, true, 6, seed, &random), scenes++;
        scene_free(&s);
    }
    assert_true(scenes > 0);
}

/* Jagged cages with many sides in a cell: the first one that is crossed counts. */
static void jagged_cages(void **state) {
    const struct icc_function_rule rule = {.kind = ICC_COUSIN};
    int scenes = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(60); seed++) {
        double vertex[200][2];
        uint64_t random = seed;
        struct scene s;
        random_cage(vertex, 200, 0.15, &random);
        scene_init(&s, (const double(*)[2])vertex, 200, 0.3, &rule);
        if (passes(&s, ICC_TEST_BARE)) check_lines(&s, false, 10, seed, &random), scenes++;
        scene_free(&s);
    }
    assert_true(scenes > 0);
}

/* Any heights at all, but without equal ones on an edge: the rule at vertices in all its cases,
 * until the cage or until there is no way on. */
static void any_heights(void **state) {
    enum { SIZE = 11 };
    const double box[4][2] = {{0, 0}, {SIZE - 5, 0}, {SIZE - 5, SIZE - 5}, {0, SIZE - 5}};
    const struct icc_function_rule rule = {.kind = ICC_COUSIN};
    size_t steps = 0;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(300); seed++) {
        struct scene s;
        uint64_t random = seed;
        double from[2] = {SIZE / 2, SIZE / 2};
        scene_init(&s, box, 4, 1, &rule);
        assert_int_equal(s.domain.nx, SIZE);
        for (uint32_t j = 1; j < SIZE - 1; j++)
            for (uint32_t i = 1; i < SIZE - 1; i++)
                s.function.height[j * SIZE + i] =
                    -(double)(3 * random_in(&random, 0, 1 + (int64_t)(seed % 5)) + (i + j) % 3);
        s.function.maximum = 0;
        if (seed % 2) random_inside(&s.domain, from, &random);
        for (int c = 0; c < 2 && seed % 4 == 1; c++) from[c] = 5 + floor(4 * from[c] - 20) / 8;
        steps += check_line(&s, from, seed % 3 ? ICC_UPHILL : ICC_DOWNHILL, seed);
        scene_free(&s);
    }
    assert_true(steps > 2 * (size_t)test_count(300));
}

/* Equal ends of a compression edge: uphill to the lower number, downhill to the higher. A ridge and
 * a valley along the diagonal from (5,5) to (6,6), met from below. */
static void equal_ends(void **state) {
    enum { SIZE = 11 };
    const double box[4][2] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}}, from[2] = {5.75, 5.125};
    const struct icc_function_rule rule = {.kind = ICC_MANHATTAN};
    (void)state;
    for (int up = 0; up < 2; up++) {
        struct scene s;
        struct icc_line line = {0};
        struct err err = {0};
        scene_init(&s, box, 4, 1, &rule);
        for (uint32_t v = 0; v < SIZE * SIZE; v++)
            s.function.height[v] = (up ? -1 : 1) * fabs((double)(v % SIZE) - v / SIZE);
        s.function.maximum = 0;
        assert_true(icc_trace(&s.field, from, up ? ICC_UPHILL : ICC_DOWNHILL, &line, &err));
        assert_true(line.count == 3 && line.shared == 1 && line.end == ICC_END_STUCK);
        assert_true(line.point[2][0] == (up ? 5 : 6) && line.point[2][1] == (up ? 5 : 6));
        assert_int_equal(icc_edge_kind(&s.field, 5 * SIZE + 5, 1),
                         up ? ICC_EDGE_COMPRESSION : ICC_EDGE_EXPANSION);
        icc_line_free(&line);
        scene_free(&s);
    }
}

/* ---- without rules ----------------------------------------------------------------------------
 */

static double interpolated(const struct scene *s, const double p[2]) {
    uint32_t i = (uint32_t)p[0], j = (uint32_t)p[1], v = j * s->domain.nx + i;
    double x = p[0] - i, y = p[1] - j, f[4];
    const uint32_t corner[4] = {v, v + 1, v + s->domain.nx, v + s->domain.nx + 1};
    for (int k = 0; k < 4; k++) f[k] = exp(log(0.95) * -s->function.height[corner[k]]);
    return x >= y ? f[0] + x * (f[1] - f[0]) + y * (f[3] - f[1])
                  : f[0] + y * (f[2] - f[0]) + x * (f[3] - f[2]);
}

static double distance_to_line(const struct icc_line *line, const double p[2]) {
    double least = INFINITY;
    for (size_t i = 0; i + 1 < line->count; i++) {
        const double *a = line->point[i], *b = line->point[i + 1];
        double x = b[0] - a[0], y = b[1] - a[1], l = x * x + y * y;
        double t = l > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / l : 0;
        t = fmin(fmax(t, 0), 1);
        double dx = p[0] - a[0] - t * x, dy = p[1] - a[1] - t * y;
        least = fmin(least, sqrt(dx * dx + dy * dy));
    }
    return least;
}

/* Steps of 1/2000 cell along differences of f, uphill: never far from the line, and to its end. */
static void against_tiny_steps(void **state) {
    const struct icc_function_rule rule = {.kind = ICC_COUSIN};
    const double step = 1 / 2000.0, small = 1e-7;
    (void)state;
    for (uint64_t seed = 1; seed <= (uint64_t)test_count(10); seed++) {
        double vertex[12][2], p[2], g[2], top[2];
        uint64_t random = seed;
        struct scene s;
        struct icc_line line = {0};
        struct err err = {0};
        random_cage(vertex, 12, 0.5, &random);
        scene_init(&s, (const double(*)[2])vertex, 12, 0.1, &rule);
        random_inside(&s.domain, p, &random);
        assert_true(icc_trace(&s.field, p, ICC_UPHILL, &line, &err));
        top[0] = s.function.maximum % s.domain.nx, top[1] = s.function.maximum / s.domain.nx;
        for (int n = 0; n < 100000 && is_fine(&s); n++) {
            double f = interpolated(&s, p), size;
            if (fabs(p[0] - top[0]) + fabs(p[1] - top[1]) < 0.01) break;
            for (int c = 0; c < 2; c++) {
                double q[2] = {p[0] + (c == 0) * small, p[1] + (c == 1) * small};
                g[c] = interpolated(&s, q) - f;
            }
            size = sqrt(g[0] * g[0] + g[1] * g[1]);
            for (int c = 0; c < 2; c++) p[c] += step * g[c] / size;
            if (n % 500 == 0) check_seed(seed, distance_to_line(&line, p) < 0.01);
            check_seed(seed, n < 99999);
        }
        icc_line_free(&line);
        scene_free(&s);
    }
}

/* Slopes across each edge, from differences of f nearby. */
static void edge_kinds(void **state) {
    const struct icc_function_rule rule = {.kind = ICC_COUSIN};
    static const double along[3][2] = {{1, 0}, {1, 1}, {0, 1}};
    double vertex[30][2];
    uint64_t random = 1, count[4] = {0};
    struct scene s;
    (void)state;
    random_cage(vertex, 30, 0.5, &random);
    scene_init(&s, (const double(*)[2])vertex, 30, 0.05, &rule);
    for (uint32_t v = 0; v < icc_domain_size(&s.domain); v++)
        for (int k = 0; k < 3 && s.domain.inside[v]; k++) {
            double x = v % s.domain.nx, y = v / s.domain.nx, d = 1e-6;
            double m[2] = {x + along[k][0] / 2, y + along[k][1] / 2};
            double l[2] = {m[0] - d * along[k][1], m[1] + d * along[k][0]};
            double r[2] = {m[0] + d * along[k][1], m[1] - d * along[k][0]};
            double f = interpolated(&s, m), left = interpolated(&s, l) - f;
            double right = interpolated(&s, r) - f, zero = 1e-12;
            enum icc_edge kind = icc_edge_kind(&s.field, v, k);
            count[kind]++;
            if (left <= zero && right <= zero) assert_int_equal(kind, ICC_EDGE_COMPRESSION);
            if (left > zero && right > zero) assert_int_equal(kind, ICC_EDGE_EXPANSION);
            if ((left > zero) != (right > zero)) assert_int_equal(kind, ICC_EDGE_PASS);
        }
    assert_true(count[ICC_EDGE_COMPRESSION] > 0 && count[ICC_EDGE_PASS] > 0);
    scene_free(&s);
}

/* Lengths, points at distances, and that one struct serves for many lines. */
static void along_a_line(void **state) {
    double point[4][2] = {{0, 0}, {3, 4}, {3, 4}, {3, 5}}, p[2];
    struct icc_line line = {.point = point, .count = 4};
    (void)state;
    assert_true(icc_line_length(&line) == 6);
    assert_int_equal(icc_line_at(&line, 2.5, p), 0);
    assert_true(p[0] == 1.5 && p[1] == 2);
    assert_int_equal(icc_line_at(&line, 5.25, p), 2);
    assert_true(p[0] == 3 && p[1] == 4.25);
    assert_int_equal(icc_line_at(&line, 7, p), 3);
    assert_true(p[0] == 3 && p[1] == 5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edge_rule),          cmocka_unit_test(edge_rule_random),
        cmocka_unit_test(against_rationals),  cmocka_unit_test(jagged_cages),
        cmocka_unit_test(any_heights),        cmocka_unit_test(equal_ends),
        cmocka_unit_test(against_tiny_steps), cmocka_unit_test(edge_kinds),
        cmocka_unit_test(along_a_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
