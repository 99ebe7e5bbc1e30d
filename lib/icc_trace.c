/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line is a walk over places: at a vertex, or at an edge and about to enter the triangle on its
 * other side. Triangles have their corners counter-clockwise, edge e from corner e to corner e + 1:
 *
 *      lower: (0,0) (1,0) (1,1)       upper: (0,0) (1,1) (0,1)
 *
 * relative to the cell. f rises along a line, so in exact arithmetic there is an end; rounding has
 * a limit of steps. */
#include "icc_trace.h"

#include "mem.h"
#include "predicate.h"
#include "segment.h"

#define NEAR 0x1p-30 /* cells: a start as near to a side is on it */

struct triangle {
    uint32_t i, j; /* its cell */
    int upper;
};

struct place {
    bool at_vertex;
    uint32_t i, j;            /* the vertex */
    struct triangle triangle; /* to be entered through its edge */
    int edge;
};

struct walk {
    const struct icc_field *f;
    struct icc_line *line;
    double sense; /* 1 uphill, -1 downhill */
    double q[2];  /* how far it has come */
    bool ended;   /* line->end says how */
    struct err *err;
    bool failed; /* no memory */
};

static const uint32_t corner_at[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};

static const struct {
    int i, j, upper, edge;
} across[2][3] = {
    {{0, -1, 1, 1}, {1, 0, 1, 2}, {0, 0, 1, 0}},
    {{0, 0, 0, 2}, {0, 1, 0, 0}, {-1, 0, 0, 1}},
};

static double cross(const double a[2], const double b[2]) {
    return a[0] * b[1] - a[1] * b[0];
}

static void minus(const double a[2], const double b[2], double d[2]) {
    d[0] = a[0] - b[0];
    d[1] = a[1] - b[1];
}

static void corner(const struct triangle *t, int c, double p[2]) {
    p[0] = t->i + corner_at[t->upper][c % 3][0];
    p[1] = t->j + corner_at[t->upper][c % 3][1];
}

/* The edge from corner c to the next. */
static void edge_of(const struct triangle *t, int c, double a[2], double e[2]) {
    double b[2];
    corner(t, c, a);
    corner(t, c + 1, b);
    minus(b, a, e);
}

/* The triangle on the other side of edge c, and its number for the edge. */
static struct place beyond(const struct triangle *t, int c) {
    c %= 3;
    return (struct place){.triangle = {(uint32_t)((int)t->i + across[t->upper][c].i),
                                       (uint32_t)((int)t->j + across[t->upper][c].j),
                                       across[t->upper][c].upper},
                          .edge = across[t->upper][c].edge};
}

static uint32_t number(const struct icc_domain *d, uint32_t i, uint32_t j) {
    return j * d->nx + i;
}

static uint32_t corner_number(const struct icc_domain *d, const struct triangle *t, int c) {
    return number(d, t->i + corner_at[t->upper][c % 3][0], t->j + corner_at[t->upper][c % 3][1]);
}

/* ---- the function -----------------------------------------------------------------------------
 */

/* The gradient on a triangle, in units of the value of height `top`; false: no values. */
static bool gradient(const struct icc_field *f, const struct triangle *t, double top, double g[2]) {
    double value[3];
    for (int c = 0; c < 3; c++) {
        double height = f->function->height[corner_number(f->domain, t, c)];
        if (isnan(height)) return false;
        value[c] = icc_function_at(f->function, top, height);
    }
    g[0] = t->upper ? value[1] - value[2] : value[1] - value[0];
    g[1] = t->upper ? value[2] - value[0] : value[2] - value[1];
    return true;
}

static double top_of(const struct icc_field *f, const struct triangle *t) {
    double top = -INFINITY;
    for (int c = 0; c < 3; c++)
        top = fmax(top, f->function->height[corner_number(f->domain, t, c)]);
    return top;
}

/* The way on in a triangle. */
static bool way(const struct walk *w, const struct triangle *t, double g[2]) {
    if (!gradient(w->f, t, top_of(w->f, t), g)) return false;
    g[0] *= w->sense;
    g[1] *= w->sense;
    return true;
}

/* Of two ends of an edge: does the walk go to b? */
static bool goes_to(const struct walk *w, uint32_t a, uint32_t b) {
    return icc_function_higher(w->f->function, b, a) == (w->sense > 0);
}

/* ---- segments ---------------------------------------------------------------------------------
 */

static bool append(struct walk *w, const double p[2]) {
    struct icc_line *line = w->line;
    if (!mem_grow(line->point, &line->capacity, line->count + 1, w->err)) {
        w->failed = w->ended = true;
        return false;
    }
    line->point[line->count][0] = p[0];
    line->point[line->count++][1] = p[1];
    return true;
}

static void stop(struct walk *w, enum icc_end end) {
    w->line->end = end;
    w->ended = true;
}

/* Where a segment and a side cross: parameters along both. */
struct crossing {
    uint32_t side;
    double along, lambda;
};

static bool crosses(const struct icc_domain *d, uint32_t side, const double p[2], const double q[2],
                    struct crossing *x) {
    const double *a = d->cage[side], *b = d->cage[side + 1 < d->count ? side + 1 : 0];
    double pq[2], ab[2], pa[2], det;
    if ((predicate_orient(a, b, p) >= 0) == (predicate_orient(a, b, q) >= 0)) return false;
    if ((predicate_orient(p, q, a) > 0) == (predicate_orient(p, q, b) > 0)) return false;
    minus(q, p, pq);
    minus(b, a, ab);
    minus(a, p, pa);
    det = cross(pq, ab);
    x->side = side;
    x->along = fmin(fmax(cross(pa, ab) / det, 0), 1);
    x->lambda = fmin(fmax(cross(pa, pq) / det, 0), 1);
    return true;
}

static double distance_to_side(const struct icc_domain *d, uint32_t side, const double p[2],
                               double *lambda) {
    return sqrt(
        segment_distance2(d->cage[side], d->cage[side + 1 < d->count ? side + 1 : 0], p, lambda));
}

static bool starts_at(const struct walk *w, uint32_t side) {
    double lambda;
    return w->line->count == 1 && distance_to_side(w->f->domain, side, w->q, &lambda) < NEAR;
}

/* The segment to p lies in a cell. Downhill the first side crossed ends the walk. Where it begins
 * on sides, uphill, those are not crossed. */
static void advance(struct walk *w, uint32_t i, uint32_t j, const double p[2]) {
    const struct icc_cells *cells = w->f->cells;
    uint32_t cell = number(w->f->domain, i, j);
    struct crossing first = {.along = INFINITY}, x;
    for (size_t at = cells->start[cell]; at < cells->start[cell + 1]; at++)
        if (crosses(w->f->domain, cells->side[at], w->q, p, &x) && x.along < first.along &&
            !(w->sense > 0 && starts_at(w, x.side)))
            first = x;
    if (first.along <= 1 && w->sense > 0) w->line->crossed = true;
    if (first.along <= 1 && w->sense < 0) {
        w->line->side = first.side;
        w->line->lambda = first.lambda;
        for (int c = 0; c < 2; c++) w->q[c] += first.along * (p[c] - w->q[c]);
        stop(w, ICC_END_CAGE);
    } else {
        w->q[0] = p[0];
        w->q[1] = p[1];
    }
    append(w, w->q);
}

/* From the last point on. */
static void share(struct walk *w) {
    if (w->line->shared == SIZE_MAX) w->line->shared = w->line->count - 1;
}

static struct place reach_vertex(struct walk *w, uint32_t cell_i, uint32_t cell_j, uint32_t i,
                                 uint32_t j) {
    double p[2] = {i, j};
    advance(w, cell_i, cell_j, p);
    if (!w->ended) share(w);
    return (struct place){.at_vertex = true, .i = i, .j = j};
}

static struct place reach_corner(struct walk *w, const struct triangle *t, int c) {
    return reach_vertex(w, t->i, t->j, t->i + corner_at[t->upper][c % 3][0],
                        t->j + corner_at[t->upper][c % 3][1]);
}

/* Out of a triangle through the edge from corner c on, where the ray from p along g meets it: a
 * lies right of the ray and b left. */
static struct place leave(struct walk *w, const struct triangle *t, int c, const double p[2],
                          const double g[2]) {
    double a[2], b[2], pa[2], pb[2], q[2], x, y, mu;
    corner(t, c, a);
    corner(t, c + 1, b);
    minus(a, p, pa);
    minus(b, p, pb);
    x = -cross(g, pa);
    y = cross(g, pb);
    mu = x > 0 ? x / (x + y) : 0;
    for (int k = 0; k < 2; k++) q[k] = a[k] + mu * (b[k] - a[k]);
    if (mu <= 0 || (q[0] == a[0] && q[1] == a[1])) return reach_corner(w, t, c);
    if (mu >= 1 || (q[0] == b[0] && q[1] == b[1])) return reach_corner(w, t, c + 1);
    advance(w, t->i, t->j, q);
    return beyond(t, c);
}

/* ---- the rules --------------------------------------------------------------------------------
 */

enum icc_exit icc_exit(const double a[2], const double b[2], const double o[2], const double g[2],
                       const double p[2], bool tie) {
    double e[2], po[2], s;
    minus(b, a, e);
    minus(o, p, po);
    if (cross(g, e) >= 0) {
        double along = g[0] * e[0] + g[1] * e[1];
        return along > 0 || (along == 0 && tie) ? ICC_TO_B : ICC_TO_A;
    }
    s = cross(g, po);
    return s > 0 ? ICC_THROUGH_BO : s < 0 ? ICC_THROUGH_OA : ICC_TO_O;
}

static struct place edge_step(struct walk *w, const struct place *at) {
    const struct triangle *t = &at->triangle;
    const struct icc_domain *d = w->f->domain;
    double g[2], a[2], b[2], o[2], p[2] = {w->q[0], w->q[1]};
    if (!way(w, t, g)) {
        stop(w, ICC_END_STUCK);
        return *at;
    }
    corner(t, at->edge, a);
    corner(t, at->edge + 1, b);
    corner(t, at->edge + 2, o);
    switch (
        icc_exit(a, b, o, g, p,
                 goes_to(w, corner_number(d, t, at->edge), corner_number(d, t, at->edge + 1)))) {
    case ICC_TO_A:
        share(w);
        return reach_corner(w, t, at->edge);
    case ICC_TO_B:
        share(w);
        return reach_corner(w, t, at->edge + 1);
    case ICC_TO_O:
        return reach_corner(w, t, at->edge + 2);
    case ICC_THROUGH_BO:
        return leave(w, t, at->edge + 1, p, g);
    default:
        return leave(w, t, at->edge + 2, p, g);
    }
}

/* Around a vertex (i,j): its neighbours counter-clockwise from +x, and for each the triangle
 * between it and the next, where the vertex is corner c. */
static const struct {
    int i, j;
    struct {
        int i, j, upper, c;
    } wedge;
} star[6] = {
    {1, 0, {0, 0, 0, 0}},    {1, 1, {0, 0, 1, 0}},     {0, 1, {-1, 0, 0, 1}},
    {-1, 0, {-1, -1, 1, 1}}, {-1, -1, {-1, -1, 0, 2}}, {0, -1, {0, -1, 1, 2}},
};

struct surroundings {
    double slope2[6]; /* of the edges, squared; -1: not the walk's way, or no value */
    double g[6][2];   /* of the triangles, in the walk's sense */
    bool has[6];
    bool inside[6]; /* g lies strictly between its triangle's edges */
};

static struct triangle wedge(uint32_t i, uint32_t j, int k) {
    return (struct triangle){(uint32_t)((int)i + star[k].wedge.i),
                             (uint32_t)((int)j + star[k].wedge.j), star[k].wedge.upper};
}

static void direction(int k, double e[2]) {
    e[0] = star[k % 6].i;
    e[1] = star[k % 6].j;
}

static void look_around(const struct walk *w, uint32_t i, uint32_t j, struct surroundings *s) {
    const struct icc_domain *d = w->f->domain;
    const struct icc_function *f = w->f->function;
    double top = f->height[number(d, i, j)], height[6];
    for (int k = 0; k < 6; k++) {
        height[k] =
            f->height[number(d, (uint32_t)((int)i + star[k].i), (uint32_t)((int)j + star[k].j))];
        top = fmax(top, height[k]);
    }
    double here = icc_function_at(f, top, f->height[number(d, i, j)]);
    for (int k = 0; k < 6; k++) {
        struct triangle t = wedge(i, j, k);
        double e[2], next[2], rise = -1;
        direction(k, e);
        direction(k + 1, next);
        if (!isnan(height[k])) rise = w->sense * (icc_function_at(f, top, height[k]) - here);
        s->slope2[k] = rise > 0 ? rise * rise / (e[0] * e[0] + e[1] * e[1]) : -1;
        s->has[k] = gradient(w->f, &t, top, s->g[k]);
        s->g[k][0] *= w->sense;
        s->g[k][1] *= w->sense;
        s->inside[k] = s->has[k] && cross(e, s->g[k]) > 0 && cross(s->g[k], next) > 0;
    }
}

/* Do both triangles at edge k point away from it? */
static bool is_expansion(const struct surroundings *s, int k) {
    double e[2];
    int right = (k + 5) % 6;
    direction(k, e);
    return s->has[k] && s->has[right] && cross(e, s->g[k]) > 0 && cross(e, s->g[right]) < 0;
}

/* Along the edge to a neighbour. */
static struct place follow(struct walk *w, uint32_t i, uint32_t j, int k) {
    uint32_t to_i = (uint32_t)((int)i + star[k].i), to_j = (uint32_t)((int)j + star[k].j);
    return reach_vertex(w, to_i < i ? to_i : i, to_j < j ? to_j : j, to_i, to_j);
}

static struct place vertex_step(struct walk *w, const struct place *at) {
    struct surroundings s;
    double best = -1;
    int k_best = -1;
    bool through = false;
    if (w->sense > 0 && number(w->f->domain, at->i, at->j) == w->f->function->maximum) {
        stop(w, ICC_END_MAXIMUM);
        return *at;
    }
    look_around(w, at->i, at->j, &s);
    for (int k = 0; k < 6; k++) {
        double slope2 = s.g[k][0] * s.g[k][0] + s.g[k][1] * s.g[k][1];
        if (s.slope2[k] > best) best = s.slope2[k], k_best = k, through = false;
        if (s.inside[k] && slope2 > best) best = slope2, k_best = k, through = true;
    }
    if (k_best < 0) {
        stop(w, ICC_END_STUCK);
        return *at;
    }
    if (through) {
        struct triangle t = wedge(at->i, at->j, k_best);
        double p[2] = {at->i, at->j};
        return leave(w, &t, star[k_best].wedge.c + 1, p, s.g[k_best]);
    }
    if (is_expansion(&s, k_best)) w->line->expanded = true;
    return follow(w, at->i, at->j, k_best);
}

/* ---- the start --------------------------------------------------------------------------------
 */

/* From the inside of a triangle: through the edge that the ray meets first. */
static struct place start_inside(struct walk *w, const struct triangle *t) {
    double g[2], first = INFINITY, p[2] = {w->q[0], w->q[1]};
    int edge = -1;
    if (!way(w, t, g)) g[0] = g[1] = 0;
    for (int c = 0; c < 3; c++) {
        double a[2], e[2], ap[2], out, distance;
        edge_of(t, c, a, e);
        minus(p, a, ap);
        out = -cross(e, g);
        distance = cross(e, ap) / out;
        if (out > 0 && distance < first) first = distance, edge = c;
    }
    if (edge >= 0) return leave(w, t, edge, p, g);
    stop(w, ICC_END_STUCK);
    return (struct place){.triangle = *t};
}

/* On edge c of a triangle, not at an end of it. */
static struct place start_on_edge(struct walk *w, const struct triangle *t, int c) {
    const struct icc_domain *d = w->f->domain;
    struct place here = {.triangle = *t, .edge = c}, there = beyond(t, c);
    double g[2] = {0, 0}, a[2], e[2];
    bool in, out;
    edge_of(t, c, a, e);
    in = way(w, t, g) && cross(g, e) < 0;
    out = way(w, &there.triangle, g) && cross(g, e) > 0;
    if (in && !out) return here;
    if (out && !in) return there;
    if (!way(w, t, g) && !way(w, &there.triangle, g)) {
        stop(w, ICC_END_STUCK);
        return here;
    }
    if (in) w->line->expanded = true;
    share(w);
    return reach_corner(w, t,
                        goes_to(w, corner_number(d, t, c), corner_number(d, t, c + 1)) ? c + 1 : c);
}

static struct place start(struct walk *w) {
    double i = floor(w->q[0]), j = floor(w->q[1]), x = w->q[0] - i, y = w->q[1] - j;
    struct triangle t = {(uint32_t)i, (uint32_t)j, x < y};
    if (x == 0 && y == 0) {
        share(w);
        return (struct place){.at_vertex = true, .i = t.i, .j = t.j};
    }
    if (x == y) return start_on_edge(w, &t, 2); /* t is the lower triangle */
    if (y == 0) return start_on_edge(w, &t, 0);
    if (x == 0) return start_on_edge(w, &t, 2); /* the upper one */
    return start_inside(w, &t);
}

/* A start on a side, or as near to it as rounding may put one, is at its end. */
static void start_at_cage(struct walk *w) {
    const struct icc_cells *cells = w->f->cells;
    uint32_t cell = number(w->f->domain, (uint32_t)w->q[0], (uint32_t)w->q[1]);
    double nearest = NEAR, lambda;
    for (size_t at = cells->start[cell]; at < cells->start[cell + 1]; at++) {
        double distance = distance_to_side(w->f->domain, cells->side[at], w->q, &lambda);
        if (!(distance < nearest)) continue;
        nearest = distance;
        w->line->side = cells->side[at];
        w->line->lambda = lambda;
    }
    if (nearest < NEAR) stop(w, ICC_END_CAGE);
}

bool icc_trace(const struct icc_field *f, const double p[2], enum icc_direction direction,
               struct icc_line *line, struct err *err) {
    struct walk w = {.f = f, .line = line, .sense = direction, .q = {p[0], p[1]}, .err = err};
    size_t limit = 12 * (size_t)f->function->valued + 64;
    struct place at;
    line->count = 0;
    line->shared = SIZE_MAX;
    line->expanded = line->crossed = false;
    append(&w, p);
    if (direction == ICC_DOWNHILL && !w.ended) start_at_cage(&w);
    if (!w.ended) at = start(&w);
    while (!w.ended) {
        if (limit-- == 0)
            stop(&w, ICC_END_STUCK);
        else
            at = at.at_vertex ? vertex_step(&w, &at) : edge_step(&w, &at);
    }
    return !w.failed;
}

void icc_line_free(struct icc_line *line) {
    free(line->point);
    *line = (struct icc_line){0};
}

double icc_line_length(const struct icc_line *line) {
    double sum = 0;
    for (size_t i = 1; i < line->count; i++)
        sum += segment_length(line->point[i - 1], line->point[i]);
    return sum;
}

size_t icc_line_at(const struct icc_line *line, double distance, double p[2]) {
    size_t last = line->count - 1;
    for (size_t i = 0; i < last; i++) {
        double step = segment_length(line->point[i], line->point[i + 1]);
        if (distance < step) {
            segment_point(line->point[i], line->point[i + 1], distance / step, p);
            return i;
        }
        distance -= step;
    }
    p[0] = line->point[last][0];
    p[1] = line->point[last][1];
    return last;
}

enum icc_edge icc_edge_kind(const struct icc_field *f, uint32_t v, int which) {
    struct triangle t = {v % f->domain->nx, v / f->domain->nx, which > 0};
    int c = which == 2 ? 2 : 0; /* with the triangle on its left */
    struct place other = beyond(&t, c);
    double g[2], a[2], e[2], left, right;
    edge_of(&t, c, a, e);
    if (!gradient(f, &t, top_of(f, &t), g)) return ICC_EDGE_NONE;
    left = cross(e, g);
    if (!gradient(f, &other.triangle, top_of(f, &other.triangle), g)) return ICC_EDGE_NONE;
    right = cross(e, g);
    if (left <= 0 && right >= 0) return ICC_EDGE_COMPRESSION;
    return left > 0 && right < 0 ? ICC_EDGE_EXPANSION : ICC_EDGE_PASS;
}
