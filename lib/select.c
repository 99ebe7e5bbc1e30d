/* SPDX-License-Identifier: GPL-3.0-or-later */
/* reach: breadth-first search in the global Bezier net. A point on an edge or corner finds some
 * neighbours from several triangles; marks keep them from counting twice.
 *
 * within: for a few anchors the box around each is searched; for many, the box around all of them,
 * and each point there asks an index of the anchors for the nearest. So the cost is at most
 * FEW times the points found, or about that of the box. */
#include "select.h"

#include "mem.h"
#include "net.h"

#include <math.h>
#include <string.h>

enum { FEW = 8 };

bool point_set_add(struct point_set *set, uint32_t p, struct err *err) {
    if (!mem_grow(set->point, &set->cap, set->count + 1, err)) return false;
    set->point[set->count++] = p;
    return true;
}

static int compare_points(const void *a, const void *b) {
    uint32_t p = *(const uint32_t *)a, q = *(const uint32_t *)b;
    return (p > q) - (p < q);
}

void point_set_sort(struct point_set *set) {
    size_t sorted = 1, kept = 0;
    while (sorted < set->count && set->point[sorted - 1] < set->point[sorted]) sorted++;
    if (sorted >= set->count) return;
    qsort(set->point, set->count, sizeof *set->point, compare_points);
    for (size_t i = 0; i < set->count; i++)
        if (i == 0 || set->point[i] != set->point[kept - 1]) set->point[kept++] = set->point[i];
    set->count = kept;
}

bool point_set_has(const struct point_set *set, uint32_t p) {
    return set->count > 0 &&
           bsearch(&p, set->point, set->count, sizeof *set->point, compare_points) != NULL;
}

void select_init(struct select_space *space, const struct grid *grid, const double (*phi)[2]) {
    *space = (struct select_space){.grid = grid, .phi = phi};
}

void select_free(struct select_space *space) {
    for (int i = 0; i < 4; i++) nearest_free(&space->index[i]);
    free(space->nominal);
    blocks_free(&space->blocks);
    free(space->mark);
    *space = (struct select_space){0};
}

void select_moved(struct select_space *space, uint32_t p) {
    for (int corner = 0; corner < 2; corner++) {
        struct nearest *index = &space->index[2 * corner];
        if (p < index->count) nearest_moved(index, p);
    }
}

static bool need_nominal(struct select_space *space, struct err *err) {
    const struct grid *g = space->grid;
    if (space->nominal) return true;
    if (!mem_new(space->nominal, g->point_count, err)) return false;
    grid_nominals(g, space->nominal);
    return true;
}

/* The index of the kind asked for; NULL if there is no memory. Corners are the first points. */
static const struct nearest *need_index(struct select_space *space, bool nominal, bool corner,
                                        struct err *err) {
    struct nearest *index = &space->index[nominal + 2 * corner];
    uint32_t count = corner ? space->grid->vertex_count : space->grid->point_count;
    if (index->count > 0) return index;
    if (nominal && !need_nominal(space, err)) return NULL;
    return nearest_init(index, nominal ? (const double(*)[2])space->nominal : space->phi, count,
                        err)
               ? index
               : NULL;
}

static bool add_range(uint32_t first, uint32_t last, struct point_set *set, struct err *err) {
    if (!mem_grow(set->point, &set->cap, set->count + (last - first) + 1, err)) return false;
    for (uint32_t p = first; p < last; p++) set->point[set->count++] = p;
    set->point[set->count++] = last;
    return true;
}

static bool check_index(const char *what, uint32_t got, uint32_t count, struct err *err) {
    if (got < count) return true;
    return err_set(err, ERR_INPUT, "expected a %s in 0..%u, got %u", what, count - 1, got);
}

static bool select_range(const struct grid *g, const struct selector *s, struct point_set *set,
                         struct err *err) {
    if (!check_index("point", s->range.last, g->point_count, err)) return false;
    return add_range(s->range.first, s->range.last, set, err);
}

static bool select_place(const struct grid *g, const struct selector *s, struct point_set *set,
                         struct err *err) {
    const int64_t *w = s->place.weight;
    if (!check_index("triangle", s->place.triangle, g->triangle_count, err)) return false;
    if (w[0] > g->degree || w[1] > g->degree || w[2] > g->degree || w[0] + w[1] + w[2] != g->degree)
        return err_set(err, ERR_INPUT,
                       "expected Bezier indices whose sum is the degree, %d, got %lld,%lld,%lld",
                       g->degree, (long long)w[0], (long long)w[1], (long long)w[2]);
    return point_set_add(set, grid_point(g, s->place.triangle, (int)w[0], (int)w[1], (int)w[2]),
                         err);
}

static bool select_vertex(const struct grid *g, const struct selector *s, struct point_set *set,
                          struct err *err) {
    return check_index("vertex", s->vertex, g->vertex_count, err) &&
           point_set_add(set, s->vertex, err);
}

static bool select_nearest(struct select_space *space, const struct selector *s,
                           struct point_set *set, struct err *err) {
    const struct nearest *index = need_index(space, s->nearest.nominal, s->nearest.corner, err);
    return index && point_set_add(set, nearest_find(index, s->nearest.xy), err);
}

/* What a search of the nominal index collects: points inside `polygon`, or within `distance` of
 * the nearest point in `anchors`, or all. */
struct collection {
    const double (*nominal)[2];
    const struct polygon *polygon;
    const struct nearest *anchors;
    double distance;
    struct point_set *set;
    struct err *err;
    bool failed;
};

static bool is_near(const struct collection *c, const double xy[2]) {
    uint32_t a = nearest_find(c->anchors, xy);
    double dx = xy[0] - c->anchors->at[a][0], dy = xy[1] - c->anchors->at[a][1];
    return dx * dx + dy * dy <= c->distance * c->distance;
}

static void collect(void *context, uint32_t p) {
    struct collection *c = context;
    const double *xy = c->nominal[p];
    if (c->failed || (c->polygon && !polygon_has(c->polygon, xy)) ||
        (c->anchors && !is_near(c, xy)))
        return;
    c->failed = !point_set_add(c->set, p, c->err);
}

static bool collect_box(struct select_space *space, struct collection *c, const double lo[2],
                        const double hi[2]) {
    const struct nearest *index = need_index(space, true, false, c->err);
    if (!index) return false;
    c->nominal = (const double(*)[2])space->nominal;
    nearest_box(index, lo, hi, collect, c);
    return !c->failed;
}

static bool select_box(struct select_space *space, const struct selector *s, struct point_set *set,
                       struct err *err) {
    size_t before = set->count;
    struct collection c = {.set = set, .err = err};
    if (!collect_box(space, &c, s->box.lo, s->box.hi)) return false;
    if (set->count > before) return true;
    return err_set(err, ERR_INPUT, "expected a box with control points, got none in it");
}

static bool select_inside(struct select_space *space, const struct selector *s,
                          struct point_set *set, struct err *err) {
    size_t before = set->count;
    const struct polygon *polygon = s->inside.polygon;
    struct collection c = {.polygon = polygon, .set = set, .err = err};
    if (!collect_box(space, &c, polygon->lo, polygon->hi)) return false;
    if (set->count > before) return true;
    return err_set(err, ERR_INPUT, "expected a polygon with control points, got none inside %s",
                   s->inside.file);
}

bool select_points(struct select_space *space, const struct selector *s, struct point_set *set,
                   struct err *err) {
    INVARIANT(s->kind <= SELECT_INSIDE);
    switch (s->kind) {
    case SELECT_ALL:
        return add_range(0, space->grid->point_count - 1, set, err);
    case SELECT_RANGE:
        return select_range(space->grid, s, set, err);
    case SELECT_PLACE:
        return select_place(space->grid, s, set, err);
    case SELECT_VERTEX:
        return select_vertex(space->grid, s, set, err);
    case SELECT_NEAREST:
        return select_nearest(space, s, set, err);
    case SELECT_BOX:
        return select_box(space, s, set, err);
    case SELECT_INSIDE:
        return select_inside(space, s, set, err);
    }
    return false;
}

/* Forgets all marks. */
static bool begin_search(struct select_space *space, struct err *err) {
    uint32_t n = space->grid->point_count;
    if (!space->mark)
        return blocks_init(&space->blocks, n, err) && mem_new(space->mark, blocks_room(n), err);
    memset(space->mark, 0, space->blocks.count * BLOCK * sizeof *space->mark);
    blocks_clear(&space->blocks);
    return true;
}

static bool add_unmarked(struct select_space *space, uint32_t p, struct point_set *set,
                         struct err *err) {
    bool *mark = &space->mark[blocks_place(&space->blocks, p)];
    if (*mark) return true;
    *mark = true;
    return point_set_add(set, p, err);
}

/* Appends the unmarked neighbours of p within triangle t. */
static bool add_neighbours(struct select_space *space, uint32_t p, uint32_t t,
                           struct point_set *set, struct err *err) {
    uint32_t neighbour[6];
    int n = net_neighbours(space->grid, p, t, neighbour);
    for (int i = 0; i < n; i++)
        if (!add_unmarked(space, neighbour[i], set, err)) return false;
    return true;
}

bool select_reach(struct select_space *space, const struct point_set *anchors, uint32_t steps,
                  struct point_set *set, struct err *err) {
    size_t first = set->count, at, level_end, seeds;
    if (!begin_search(space, err)) return false;
    for (size_t i = 0; i < anchors->count; i++)
        if (!add_unmarked(space, anchors->point[i], set, err)) return false;
    seeds = set->count - first;
    at = first;
    for (; steps > 0 && at < set->count; steps--)
        for (level_end = set->count; at < level_end; at++) {
            uint32_t p = set->point[at], single, n;
            const uint32_t *t = grid_triangles_of(space->grid, p, &single, &n);
            for (uint32_t i = 0; i < n; i++)
                if (!add_neighbours(space, p, t[i], set, err)) return false;
        }
    /* the anchors began the search; they are not among its results */
    set->count -= seeds;
    memmove(set->point + first, set->point + first + seeds,
            (set->count - first) * sizeof *set->point);
    return true;
}

/* within for one group of anchors, whose nominal positions are at[0..count). */
static bool within_group(struct select_space *space, const double (*at)[2], uint32_t count,
                         double distance, struct point_set *set, struct err *err) {
    struct nearest anchors;
    struct collection c = {.anchors = &anchors, .distance = distance, .set = set, .err = err};
    double lo[2] = {at[0][0], at[0][1]}, hi[2] = {at[0][0], at[0][1]};
    bool ok;
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            if (at[i][k] < lo[k]) lo[k] = at[i][k];
            if (at[i][k] > hi[k]) hi[k] = at[i][k];
        }
    for (int k = 0; k < 2; k++) { /* a little too large: is_near decides */
        lo[k] = nextafter(lo[k] - distance * (1 + 0x1p-40), -INFINITY);
        hi[k] = nextafter(hi[k] + distance * (1 + 0x1p-40), INFINITY);
    }
    if (!nearest_init(&anchors, at, count, err)) return false;
    ok = collect_box(space, &c, lo, hi);
    nearest_free(&anchors);
    return ok;
}

bool select_within(struct select_space *space, const struct point_set *anchors, double distance,
                   struct point_set *set, struct err *err) {
    size_t n = anchors->count, step = n <= FEW ? 1 : n;
    double(*at)[2];
    bool ok = true;
    if (n == 0) return true;
    if (!need_nominal(space, err) || !mem_new(at, n, err)) return false;
    for (size_t i = 0; i < n; i++) memcpy(at[i], space->nominal[anchors->point[i]], sizeof *at);
    for (size_t i = 0; ok && i < n; i += step)
        ok = within_group(space, (const double(*)[2])at + i, (uint32_t)step, distance, set, err);
    free(at);
    return ok;
}
