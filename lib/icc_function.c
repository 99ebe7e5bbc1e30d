/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tree is made for every kind: it tells which vertices are connected with the maximum. A queue
 * holds the inside vertices in the order they are found, then the rings, one after the other; each
 * ring is found from the one before. */
#include "icc_function.h"

#include "icc_green.h"
#include "mem.h"

#include <string.h>

#define RATIO 0.95

struct growth {
    const struct icc_domain *d;
    struct icc_function *f;
    const struct icc_function_rule *rule;
    int32_t next[8]; /* the neighbours, as differences of numbers: along edges, then at corners */
    uint32_t *queue; /* all that has a value, in the order of finding */
    uint32_t count;  /* of the queue */
    double (*least)[2];  /* of each entry of the queue: see lowest_neighbour */
    double *scale;       /* nx ny: by how much f falls outside; NULL: 1, a step of depth */
    unsigned char *mark; /* nx ny: not 0 if a vertex outside is in the queue */
};

static bool growth_init(struct growth *g, struct err *err) {
    int32_t nx = (int32_t)g->d->nx;
    const int32_t xy[8] = {-1, 1, -nx, nx, -nx - 1, -nx + 1, nx - 1, nx + 1};
    const int32_t yx[8] = {-nx, nx, -1, 1, -nx - 1, -nx + 1, nx - 1, nx + 1};
    uint32_t n = icc_domain_size(g->d);
    memcpy(g->next, g->rule->axes == ICC_XY ? xy : yx, sizeof g->next);
    return mem_new(g->queue, n, err) && mem_new(g->least, n, err) && mem_new(g->mark, n, err);
}

static void growth_free(struct growth *g) {
    free(g->queue);
    free(g->least);
    free(g->scale);
    free(g->mark);
}

static uint32_t beside(const struct growth *g, uint32_t v, int k) {
    return (uint32_t)((int32_t)v + g->next[k]);
}

static void join(struct growth *g, uint32_t v, uint32_t parent, double height) {
    g->f->height[v] = height;
    g->f->parent[v] = parent;
    g->queue[g->count++] = v;
}

/* The cousin tree: each vertex is found by its first neighbour in the queue. */
static void grow_inside(struct growth *g) {
    struct icc_function *f = g->f;
    join(g, f->maximum, ICC_NO_VERTEX, 0);
    for (uint32_t at = 0; at < g->count; at++) {
        uint32_t v = g->queue[at];
        for (int k = 0; k < 4; k++) {
            uint32_t w = beside(g, v, k);
            if (g->d->inside[w] && !icc_function_has(f, w)) join(g, w, v, f->height[v] - 1);
        }
    }
    f->reached = g->count;
}

static bool on_border(const struct icc_domain *d, uint32_t v) {
    uint32_t i = v % d->nx, j = v / d->nx;
    return i == 0 || j == 0 || i == d->nx - 1 || j == d->ny - 1;
}

/* Algorithm 2: the tree goes on from what was queue[first..last - 1]. */
static void grow_literal(struct growth *g, uint32_t first, uint32_t last) {
    for (uint32_t at = first; at < last; at++) {
        uint32_t v = g->queue[at];
        for (int k = 0; k < 4; k++) {
            uint32_t w = beside(g, v, k);
            if (!g->d->inside[w] && !icc_function_has(g->f, w) && !on_border(g->d, w))
                join(g, w, v, g->f->height[v] - 1);
        }
    }
}

static double scale_of(const struct growth *g, uint32_t v) {
    return g->scale ? g->scale[v] : 1;
}

/* The least of the 8 neighbours that have values (for the first ring: inside); least[1] is the
 * least of their scales. */
static uint32_t lowest_neighbour(const struct growth *g, uint32_t v, double least[2]) {
    uint32_t lowest = ICC_NO_VERTEX;
    least[0] = least[1] = INFINITY;
    for (int k = 0; k < 8; k++) {
        uint32_t w = beside(g, v, k);
        if (!icc_function_has(g->f, w)) continue;
        least[1] = fmin(least[1], scale_of(g, w));
        if (g->f->height[w] < least[0] || (g->f->height[w] == least[0] && w < lowest)) {
            least[0] = g->f->height[w];
            lowest = w;
        }
    }
    return lowest;
}

/* Adds to the queue, without values yet, what lies around queue[first..last - 1]: along edges, or
 * (corners) at corners. */
static void find_ring(struct growth *g, uint32_t first, uint32_t last, bool corners) {
    for (uint32_t at = first; at < last; at++) {
        for (int k = corners ? 4 : 0; k < (corners ? 8 : 4); k++) {
            uint32_t w = beside(g, g->queue[at], k);
            if (g->mark[w] || g->d->inside[w] || on_border(g->d, w)) continue;
            g->mark[w] = 1;
            g->queue[g->count++] = w;
        }
    }
}

/* Gives queue[first..last - 1] their values, which do not depend on each other. In the first ring,
 * harmonic functions are 0. */
static void value_ring(struct growth *g, uint32_t first, uint32_t last, bool zero) {
    for (uint32_t at = first; at < last; at++)
        g->f->parent[g->queue[at]] = lowest_neighbour(g, g->queue[at], g->least[at]);
    for (uint32_t at = first; at < last; at++) {
        uint32_t v = g->queue[at];
        g->f->height[v] = zero ? 0 : g->least[at][0] - g->least[at][1];
        if (g->scale) g->scale[v] = g->least[at][1];
    }
}

/* Is v the corner with the greatest number of a triangle whose corners are equal? */
static bool is_last_of_flat(const struct growth *g, uint32_t v) {
    const double *height = g->f->height;
    uint32_t nx = g->d->nx;
    double h = height[v];
    return height[v - nx - 1] == h && (height[v - 1] == h || height[v - nx] == h);
}

/* Lowers one corner of each flat triangle until there is none; the order of the queue does not
 * matter. A vertex falls only from heights that vertices of lower numbers have or had, so this
 * ends. */
static void break_ties(struct growth *g, uint32_t first, uint32_t last) {
    bool again = true;
    while (again) {
        again = false;
        for (uint32_t at = first; at < last; at++)
            g->mark[g->queue[at]] = is_last_of_flat(g, g->queue[at]) ? 2 : 1;
        for (uint32_t at = first; at < last; at++) {
            uint32_t v = g->queue[at];
            if (g->mark[v] == 1 || !(scale_of(g, v) > 0)) continue;
            g->f->height[v] -= scale_of(g, v);
            again = true;
        }
    }
}

static void grow_inward(struct growth *g, uint32_t first, uint32_t last, int ring) {
    bool harmonic = g->f->kind == ICC_HARMONIC || g->f->kind == ICC_BIHARMONIC;
    find_ring(g, first, last, false);
    uint32_t edges = g->count;
    value_ring(g, last, edges, harmonic && ring == 0);
    break_ties(g, last, edges);
    if (ring == 0) return;
    find_ring(g, first, last, true);
    value_ring(g, edges, g->count, false);
    break_ties(g, edges, g->count);
}

static void grow_outside(struct growth *g) {
    uint32_t first = 0, last = g->count;
    for (int ring = 0; ring < ICC_RINGS; ring++) {
        if (g->rule->outside == ICC_LITERAL)
            grow_literal(g, first, last);
        else
            grow_inward(g, first, last, ring);
        first = last;
        last = g->count;
    }
    g->f->valued = g->count;
}

/* Replaces the depths of the inside by the solution of an equation. */
static bool solve_inside(struct growth *g, struct err *err) {
    struct icc_function *f = g->f;
    int times = f->kind == ICC_HARMONIC ? 1 : 2;
    if (!mem_new(g->scale, icc_domain_size(g->d), err) ||
        !icc_green(g->d, f->maximum, g->queue, g->count, times, g->scale, err))
        return false;
    for (uint32_t at = 0; at < g->count; at++) f->height[g->queue[at]] = g->scale[g->queue[at]];
    return true;
}

bool icc_function_init(struct icc_function *f, const struct icc_domain *d, uint32_t maximum,
                       const struct icc_function_rule *rule, struct err *err) {
    struct growth g = {.d = d, .f = f, .rule = rule};
    uint32_t n = icc_domain_size(d);
    bool ok;
    INVARIANT(d->inside[maximum]);
    *f = (struct icc_function){.kind = rule->kind, .maximum = maximum};
    ok = mem_new(f->height, n, err) && mem_new(f->parent, n, err) && growth_init(&g, err);
    if (ok) {
        for (uint32_t v = 0; v < n; v++) f->height[v] = NAN;
        f->power[0] = 1;
        for (int k = 1; k < ICC_POWERS; k++) f->power[k] = RATIO * f->power[k - 1];
        grow_inside(&g);
        ok = rule->kind == ICC_COUSIN || rule->kind == ICC_MANHATTAN || solve_inside(&g, err);
    }
    if (ok) grow_outside(&g);
    growth_free(&g);
    return ok;
}

void icc_function_free(struct icc_function *f) {
    free(f->height);
    free(f->parent);
    *f = (struct icc_function){0};
}
