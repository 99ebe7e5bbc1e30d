/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All questions are asked in doubles first: a crossing ends the work, and what doubles leave open
 * is put aside and asked again in integers. */
#include "boundary.h"

#include "mem.h"
#include "rational.h"

enum { UNDECIDED_MAX = 16 }; /* as many give up the hope for a proof that they meet */

/* Arcs by the vertex where they begin: each boundary vertex begins one, since its triangles form
 * one fan. */
static void link_arcs(struct boundary *b, uint32_t *arc_of) {
    for (uint32_t i = 0; i < b->count; i++) arc_of[b->end[i][0]] = i;
    for (uint32_t i = 0; i < b->count; i++) b->next[i] = arc_of[b->end[i][1]];
}

static void collect(struct boundary *b) {
    const struct grid *g = &b->spline->grid;
    uint32_t n = 0;
    for (uint32_t e = 0; e < g->edge_count; e++) {
        uint32_t t = g->edge_triangle[e][0];
        int l;
        if (grid_edge_is_inner(g, e)) continue;
        l = grid_opposite(g, t, e);
        b->edge[n] = e;
        b->end[n][0] = g->triangle[t][(l + 1) % 3];
        b->end[n++][1] = g->triangle[t][(l + 2) % 3];
    }
}

void boundary_arc_of_edge(const struct spline *s, uint32_t t, int l, double (*q)[2]) {
    int d = s->grid.degree, weight[3] = {0};
    for (int k = 0; k <= d; k++) {
        const double *p;
        weight[(l + 1) % 3] = d - k;
        weight[(l + 2) % 3] = k;
        p = s->phi[grid_point(&s->grid, t, weight[0], weight[1], weight[2])];
        q[k][0] = p[0];
        q[k][1] = p[1];
    }
}

void boundary_arc(const struct boundary *b, uint32_t arc, double (*q)[2]) {
    const struct grid *g = &b->spline->grid;
    uint32_t e = b->edge[arc], t = g->edge_triangle[e][0];
    boundary_arc_of_edge(b->spline, t, grid_opposite(g, t, e), q);
}

static bool build_boxes(struct boundary *b, struct err *err) {
    double q[ARC_DEGREE_MAX + 1][2];
    struct box *box;
    bool ok;
    if (!mem_new(box, b->count, err)) return false;
    for (uint32_t i = 0; i < b->count; i++) {
        boundary_arc(b, i, q);
        box[i] = box_of_points((uint32_t)b->spline->grid.degree + 1, (const double(*)[2])q);
    }
    ok = boxes_init(&b->boxes, box, b->count, err);
    free(box);
    return ok;
}

bool boundary_init(struct boundary *b, const struct spline *s, struct err *err) {
    const struct grid *g = &s->grid;
    uint32_t *arc_of = NULL;
    bool ok;
    *b = (struct boundary){.spline = s};
    for (uint32_t e = 0; e < g->edge_count; e++) b->count += !grid_edge_is_inner(g, e);
    ok = mem_new(b->edge, b->count, err) && mem_new(b->end, b->count, err) &&
         mem_new(b->next, b->count, err) && mem_new(arc_of, g->vertex_count, err);
    if (ok) {
        collect(b);
        link_arcs(b, arc_of);
        ok = build_boxes(b, err);
    }
    free(arc_of);
    if (!ok) boundary_free(b);
    return ok;
}

void boundary_free(struct boundary *b) {
    free(b->edge);
    free(b->end);
    free(b->next);
    boxes_free(&b->boxes);
    *b = (struct boundary){0};
}

void boundary_meeting_init(struct boundary_meeting *m) {
    meet_init(&m->meet);
    m->place[0] = m->place[1] = (struct boundary_place){.triangle = GRID_NONE};
}

void boundary_meeting_free(struct boundary_meeting *m) {
    meet_free(&m->meet);
}

struct question {
    uint32_t arc[2];
    enum meet_pair pair;
};

struct survey {
    const struct boundary *b;
    struct meet *meet;
    uint32_t arc[2];       /* that it is about */
    struct question *open; /* undecided in doubles */
    size_t count, cap;
    struct err *err;
    bool failed;
};

static void ask(const struct survey *s, const struct question *question,
                const struct meet_rule *rule, struct meet *m) {
    double q[2][ARC_DEGREE_MAX + 1][2];
    for (int i = 0; i < 2; i++) boundary_arc(s->b, question->arc[i], q[i]);
    meet_arcs(s->b->spline->grid.degree, (const double(*)[2])q[0], (const double(*)[2])q[1],
              question->pair, rule, m);
}

/* In doubles; false ends it. */
static bool ask_first(struct survey *s, uint32_t i, uint32_t j, enum meet_pair pair) {
    static const struct meet_rule doubles = {0, 0};
    struct question question = {{i, j}, pair};
    ask(s, &question, &doubles, s->meet);
    if (s->meet->verdict == MEET_UNDECIDED) {
        s->failed = !mem_grow(s->open, &s->cap, s->count + 1, s->err);
        if (s->failed) return false;
        s->open[s->count++] = question;
    }
    s->arc[0] = i;
    s->arc[1] = j;
    return s->meet->verdict < MEET_CROSS;
}

static bool ask_pair(void *context, uint32_t i, uint32_t j) {
    struct survey *s = context;
    if (s->b->next[i] == j || s->b->next[j] == i) return true; /* asked already */
    return ask_first(s, i, j, MEET_APART);
}

static bool ask_all(struct survey *s) {
    for (uint32_t i = 0; i < s->b->count; i++)
        if (!ask_first(s, i, i, MEET_SELF) || !ask_first(s, i, s->b->next[i], MEET_JOINED))
            return false;
    return boxes_pairs(&s->b->boxes, ask_pair, s);
}

static void swap_meets(struct meet *a, struct meet *b) {
    struct meet swap = *a;
    *a = *b;
    *b = swap;
}

/* In integers. Of those that stay undecided, the nearest is kept. */
static void ask_open(struct survey *s, const struct meet_rule *rule) {
    struct meet m;
    int undecided = 0;
    meet_init(&m);
    s->meet->verdict = MEET_NOT;
    for (size_t i = 0; i < s->count && s->meet->verdict < MEET_CROSS; i++) {
        if (undecided == UNDECIDED_MAX) break;
        ask(s, &s->open[i], rule, &m);
        if (m.verdict == MEET_NOT) continue;
        undecided += m.verdict == MEET_UNDECIDED;
        if (m.verdict == MEET_UNDECIDED && s->meet->verdict == MEET_UNDECIDED &&
            m.distance >= s->meet->distance)
            continue;
        swap_meets(s->meet, &m);
        s->arc[0] = s->open[i].arc[0];
        s->arc[1] = s->open[i].arc[1];
    }
    meet_free(&m);
}

/* (lo + hi) / 2 */
static void set_middle(const struct meet *m, int i, mpq_t t) {
    mpq_add(t, m->lo[i], m->hi[i]);
    mpq_div_2exp(t, t, 1);
}

static double round_scaled(mpq_t x, int exponent) {
    if (exponent < 0)
        mpq_div_2exp(x, x, (mp_bitcnt_t)-exponent);
    else
        mpq_mul_2exp(x, x, (mp_bitcnt_t)exponent);
    return rational_round(x);
}

static void set_image(const struct survey *s, double image[2]) {
    double q[ARC_DEGREE_MAX + 1][2];
    struct arc_integers a, unused;
    mpq_t t, point[2];
    int d = s->b->spline->grid.degree, exponent;
    mpq_inits(t, point[0], point[1], NULL);
    arc_integers_init(&a);
    arc_integers_init(&unused);
    boundary_arc(s->b, s->arc[0], q);
    exponent = arc_integers_load(d, (const double(*)[2])q, (const double(*)[2])q, &a, &unused);
    set_middle(s->meet, 0, t);
    arc_exact_point(d, &a, t, point);
    for (int c = 0; c < 2; c++) image[c] = round_scaled(point[c], exponent);
    arc_integers_free(&a);
    arc_integers_free(&unused);
    mpq_clears(t, point[0], point[1], NULL);
}

/* origin + step (from + t (to - from)) */
static void set_position(const struct grid *g, mpq_t t, struct boundary_place *place) {
    const double origin[2] = {g->lattice.x0, g->lattice.y0};
    mpq_t x, term;
    mpq_inits(x, term, NULL);
    for (int c = 0; c < 2; c++) {
        int32_t from = g->vertex[place->from][c], to = g->vertex[place->to][c];
        mpq_set_si(x, (long)to - from, 1);
        mpq_mul(x, x, t);
        mpq_set_si(term, from, 1);
        mpq_add(x, x, term);
        mpq_set_d(term, g->lattice.step);
        mpq_mul(x, x, term);
        mpq_set_d(term, origin[c]);
        mpq_add(x, x, term);
        place->position[c] = rational_round(x);
    }
    mpq_clears(x, term, NULL);
}

static void describe(const struct survey *s, struct boundary_meeting *m) {
    const struct grid *g = &s->b->spline->grid;
    mpq_t t;
    if (m->meet.verdict == MEET_NOT) return;
    mpq_init(t);
    for (int i = 0; i < 2; i++) {
        uint32_t arc = s->arc[i], triangle = g->edge_triangle[s->b->edge[arc]][0];
        m->place[i] = (struct boundary_place){triangle, s->b->end[arc][0], s->b->end[arc][1], {0}};
        set_middle(s->meet, i, t);
        set_position(g, t, &m->place[i]);
    }
    set_image(s, m->image);
    mpq_clear(t);
}

bool boundary_meets(const struct boundary *b, const struct meet_rule *rule,
                    struct boundary_meeting *m, struct err *err) {
    struct survey s = {.b = b, .meet = &m->meet, .err = err};
    if (ask_all(&s)) ask_open(&s, rule);
    free(s.open);
    if (s.failed) return false;
    describe(&s, m);
    return true;
}
