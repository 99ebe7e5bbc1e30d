/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two breadth-first searches give the distances. `far` begins at the points of A and D that have a
 * neighbour outside (distance 1) and never leaves A and D: a shortest way out has all its other
 * points inside. `near` begins at the anchors, may pass anywhere, and ends when all of D is
 * reached.
 *
 * The nearest anchors of a point are those of its neighbours that are one step nearer, united. They
 * matter only if the anchors have different motions, and are kept as sorted lists. */
#include "decles_suggest.h"

#include "decles_motion.h"
#include "mem.h"
#include "net.h"

#include <string.h>

enum { TURNS = 4096 }; /* room of the cache; a power of two */

struct decles_visit {
    uint32_t point, distance;
    size_t first, count; /* its nearest anchors in decles_suggester.nearest */
};

/* The matrix for a share theta of a rotation or scaling takes long to find and is the same for many
 * points. A cache entry depends on its keys alone, so it outlives the edit. */
struct decles_known_turn {
    double parameter, theta; /* degrees or factor; theta = 0: empty */
    enum decles_kind kind;
    struct decles_turn turn;
};

bool decles_suggester_init(struct decles_suggester *s, struct err *err) {
    memset(s, 0, sizeof *s);
    return mem_new(s->turn, TURNS, err);
}

void decles_suggester_free(struct decles_suggester *s) {
    free(s->near.visit);
    free(s->far.visit);
    free(s->nearest);
    free(s->turn);
}

/* Adds p to a search; *mark is p's for this search, 0 unless it was visited. */
static bool search_push(struct decles_search *s, uint32_t *mark, uint32_t p, uint32_t distance,
                        struct err *err) {
    if (*mark != 0) return true;
    if (!mem_grow(s->visit, &s->cap, s->count + 1, err)) return false;
    s->visit[s->count++] = (struct decles_visit){p, distance, 0, 0};
    *mark = (uint32_t)s->count;
    return true;
}

static bool push_near(struct decles_suggester *s, struct decles_sets *sets, uint32_t p,
                      uint32_t distance, struct err *err) {
    return search_push(&s->near, &decles_mark_at(sets, p)->near, p, distance, err);
}

/* Only points in A and D. */
static bool push_far(struct decles_suggester *s, struct decles_sets *sets, uint32_t p,
                     uint32_t distance, struct err *err) {
    return decles_mark(sets, p)->role == ROLE_NONE ||
           search_push(&s->far, &decles_mark_at(sets, p)->far, p, distance, err);
}

static void clear_searches(struct decles_suggester *s, struct decles_sets *sets) {
    while (s->near.count > 0) decles_mark_at(sets, s->near.visit[--s->near.count].point)->near = 0;
    while (s->far.count > 0) decles_mark_at(sets, s->far.visit[--s->far.count].point)->far = 0;
}

typedef bool push(struct decles_suggester *s, struct decles_sets *sets, uint32_t p,
                  uint32_t distance, struct err *err);

/* Pushes the neighbours of a visit. */
static bool expand(struct decles_suggester *s, struct decles_sets *sets, struct decles_visit from,
                   push *to, struct err *err) {
    uint32_t single, n, neighbour[6];
    const uint32_t *triangle = grid_triangles_of(sets->grid, from.point, &single, &n);
    for (uint32_t t = 0; t < n; t++) {
        int count = net_neighbours(sets->grid, from.point, triangle[t], neighbour);
        for (int j = 0; j < count; j++)
            if (!to(s, sets, neighbour[j], from.distance + 1, err)) return false;
    }
    return true;
}

/* True if p has a neighbour outside A and D. */
static bool is_border(const struct decles_sets *sets, uint32_t p) {
    uint32_t single, n, neighbour[6];
    const uint32_t *triangle = grid_triangles_of(sets->grid, p, &single, &n);
    for (uint32_t t = 0; t < n; t++) {
        int count = net_neighbours(sets->grid, p, triangle[t], neighbour);
        for (int j = 0; j < count; j++)
            if (decles_mark(sets, neighbour[j])->role == ROLE_NONE) return true;
    }
    return false;
}

static bool begin_far(struct decles_suggester *s, struct decles_sets *sets, const uint32_t *point,
                      size_t n, struct err *err) {
    for (size_t i = 0; i < n; i++)
        if (is_border(sets, point[i]) && !push_far(s, sets, point[i], 1, err)) return false;
    return true;
}

static bool search_far(struct decles_suggester *s, struct decles_sets *sets, struct err *err) {
    if (!begin_far(s, sets, sets->anchor, sets->anchor_count, err) ||
        !begin_far(s, sets, sets->derived, sets->derived_count, err))
        return false;
    for (size_t i = 0; i < s->far.count; i++)
        if (!expand(s, sets, s->far.visit[i], push_far, err)) return false;
    return true;
}

/* Appends the nearest anchors of `of`, a neighbour one step nearer than the i-th visit. */
static bool copy_nearest(struct decles_suggester *s, const struct decles_sets *sets, size_t i,
                         uint32_t of, struct err *err) {
    uint32_t mark = decles_mark(sets, of)->near;
    const struct decles_visit *from;
    if (mark == 0) return true;
    from = &s->near.visit[mark - 1];
    if (from->distance + 1 != s->near.visit[i].distance) return true;
    if (!mem_grow(s->nearest, &s->nearest_cap, s->nearest_count + from->count, err)) return false;
    memcpy(s->nearest + s->nearest_count, s->nearest + from->first,
           from->count * sizeof *s->nearest);
    s->nearest_count += from->count;
    return true;
}

static int compare_indices(const void *a, const void *b) {
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* The nearest anchors of the i-th visit; all visits before it have theirs. */
static bool find_nearest(struct decles_suggester *s, const struct decles_sets *sets, size_t i,
                         struct err *err) {
    uint32_t p = s->near.visit[i].point, single, n, neighbour[6], *list;
    const uint32_t *triangle = grid_triangles_of(sets->grid, p, &single, &n);
    size_t first = s->nearest_count, count = 0;
    for (uint32_t t = 0; t < n; t++) {
        int neighbours = net_neighbours(sets->grid, p, triangle[t], neighbour);
        for (int j = 0; j < neighbours; j++)
            if (!copy_nearest(s, sets, i, neighbour[j], err)) return false;
    }
    list = s->nearest + first;
    if (s->nearest_count - first > 1)
        qsort(list, s->nearest_count - first, sizeof *list, compare_indices);
    for (size_t j = 0; j < s->nearest_count - first; j++)
        if (count == 0 || list[j] != list[count - 1]) list[count++] = list[j];
    s->nearest_count = first + count;
    s->near.visit[i].first = first;
    s->near.visit[i].count = count;
    return true;
}

/* The anchors are the first visits, in their order; each is its own nearest one. */
static bool begin_near(struct decles_suggester *s, struct decles_sets *sets, struct err *err) {
    size_t n = sets->anchor_count;
    if (!mem_grow(s->nearest, &s->nearest_cap, n, err)) return false;
    for (size_t i = 0; i < n; i++) {
        if (!push_near(s, sets, sets->anchor[i], 0, err)) return false;
        s->near.visit[i].first = i;
        s->near.visit[i].count = 1;
        s->nearest[i] = (uint32_t)i;
    }
    s->nearest_count = n;
    return true;
}

static bool search_near(struct decles_suggester *s, struct decles_sets *sets, bool several_motions,
                        struct err *err) {
    size_t reached = 0, before;
    if (!begin_near(s, sets, err)) return false;
    for (size_t i = 0; i < s->near.count; i++) {
        if (several_motions && i >= sets->anchor_count && !find_nearest(s, sets, i, err))
            return false;
        if (reached == sets->derived_count) continue;
        before = s->near.count;
        if (!expand(s, sets, s->near.visit[i], push_near, err)) return false;
        for (size_t j = before; j < s->near.count; j++)
            reached += decles_mark(sets, s->near.visit[j].point)->role == ROLE_DERIVED;
    }
    return true;
}

static struct decles_turn find_turn(struct decles_known_turn *cache,
                                    const struct decles_motion *motion, double theta) {
    double parameter = motion->kind == DECLES_ROTATE ? motion->degrees : motion->factor;
    uint64_t bits;
    struct decles_known_turn *entry;
    memcpy(&bits, &theta, sizeof bits);
    entry = &cache[(bits * 0x9e3779b97f4a7c15u) >> 52];
    if (entry->theta != theta || entry->parameter != parameter || entry->kind != motion->kind)
        *entry =
            (struct decles_known_turn){parameter, theta, motion->kind, decles_turn(motion, theta)};
    return entry->turn;
}

/* Where a motion takes the point at q, k components, by the share theta > 0. */
static void move(struct decles_known_turn *cache, const struct decles_motion *motion, double theta,
                 const double *q, int k, double to[2]) {
    struct decles_turn turn = {1, 0};
    if (motion->kind != DECLES_TRANSLATE) turn = find_turn(cache, motion, theta);
    decles_move(motion, theta, turn, q, k, to);
}

/* The mean of what the nearest anchors' motions suggest for the point at q. */
static void mean(const struct decles_suggester *s, const struct decles_edit *edit,
                 const struct decles_visit *visit, double theta, const double *q, int k,
                 double to[2]) {
    double sum[2] = {0, 0}, each[2];
    for (size_t i = 0; i < visit->count; i++) {
        uint32_t motion = edit->anchor[s->nearest[visit->first + i]].motion;
        move(s->turn, &edit->motion[motion], theta, q, k, each);
        for (int c = 0; c < k; c++) sum[c] += each[c];
    }
    for (int c = 0; c < k; c++) to[c] = sum[c] / (double)visit->count;
}

static void suggest(const struct decles_suggester *s, const struct decles_edit *edit,
                    bool several_motions, const struct decles_mark *mark, const double *q, int k,
                    double to[2]) {
    uint32_t near = mark->near, far = mark->far;
    const struct decles_visit *visit = near == 0 ? NULL : &s->near.visit[near - 1];
    double theta = 1;
    if (!visit) { /* no anchor can be reached: theta = 0 */
        memcpy(to, q, (size_t)k * sizeof *to);
        return;
    }
    if (far != 0) {
        double distance = s->far.visit[far - 1].distance;
        theta = distance / (visit->distance + distance);
    }
    if (several_motions)
        mean(s, edit, visit, theta, q, k, to);
    else
        move(s->turn, &edit->motion[edit->anchor[0].motion], theta, q, k, to);
}

bool decles_suggest(struct decles_suggester *s, struct decles_sets *sets,
                    const struct decles_edit *edit, const struct c1_field *values,
                    double *suggested, struct err *err) {
    size_t k = (size_t)values->k;
    bool several_motions = false, ok;
    for (size_t i = 1; i < edit->anchor_count; i++)
        several_motions = several_motions || edit->anchor[i].motion != edit->anchor[0].motion;
    ok = search_near(s, sets, several_motions, err) && search_far(s, sets, err);
    for (size_t i = 0; ok && i < sets->derived_count; i++) {
        uint32_t p = sets->derived[i];
        double to[2];
        suggest(s, edit, several_motions, decles_mark(sets, p), values->q + values->stride * p,
                values->k, to);
        memcpy(suggested + i * k, to, k * sizeof *to);
    }
    for (size_t i = 0; ok && i < edit->wish_count; i++) {
        uint32_t p = edit->wish[i].point;
        if (decles_mark(sets, p)->role != ROLE_DERIVED) continue;
        memcpy(suggested + (decles_mark(sets, p)->column - 1) * k, edit->wish[i].to,
               k * sizeof *suggested);
    }
    clear_searches(s, sets);
    return ok;
}
