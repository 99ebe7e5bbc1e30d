/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two cages are merged arc by arc, from an anchor to the next. In an arc each vertex has a
 * fraction, its distance from the beginning over the length of the arc, which grows from 0 to 1:
 *
 *      source  0       s1      s2               1
 *      target  0    t1         t2      t3       1
 *
 * The lesser of the next two fractions is the next vertex of both; the cage that it does not belong
 * to gets it on the side that leads to its own next vertex. */
#include "match.h"

#include "mem.h"
#include "segment.h"

#include <math.h>
#include <string.h>

#define TOLERANCE 0x1p-44 /* of perimeter and coordinates: fractions this near are the same */

/* One cage while it is merged. */
struct walk {
    const double (*vertex)[2];
    size_t count;
    double tolerance; /* a length */
    /* the arc */
    size_t from, steps; /* its first vertex, its number of sides */
    double length;
    /* the next vertex */
    size_t step;
    double walked, before, at; /* length so far, fractions of the last vertex and of this one */
};

static const double *vertex_at(const struct walk *w, size_t step) {
    return w->vertex[(w->from + step) % w->count];
}

static double side_length(const struct walk *w, size_t step) {
    return segment_length(vertex_at(w, step), vertex_at(w, step + 1));
}

static void measure(struct walk *w) {
    double perimeter = 0, most = 0;
    w->from = 0;
    for (size_t i = 0; i < w->count; i++) {
        perimeter += side_length(w, i);
        most = fmax(most, fmax(fabs(w->vertex[i][0]), fabs(w->vertex[i][1])));
    }
    w->tolerance = TOLERANCE * (perimeter + most);
}

/* The next vertex. The last one is at 1 exactly. */
static void advance(struct walk *w) {
    w->before = w->at;
    w->walked += side_length(w, w->step);
    w->at = ++w->step == w->steps ? 1 : fmin(w->walked / w->length, 1);
}

static void begin_arc(struct walk *w, size_t from, size_t to) {
    w->from = from;
    w->steps = to > from ? to - from : to + w->count - from;
    w->length = 0;
    for (size_t i = 0; i < w->steps; i++) w->length += side_length(w, i);
    w->step = 0;
    w->walked = w->at = 0;
    advance(w);
}

/* Appends a vertex of w that is given, or inserted at that fraction. */
static void put(struct match *m, int k, const struct walk *w, bool given, double fraction) {
    double *p = m->vertex[k][m->count];
    m->given[m->count][k] = MATCH_INSERTED;
    if (given) {
        memcpy(p, vertex_at(w, w->step), sizeof m->vertex[k][0]);
        m->given[m->count][k] = (uint32_t)((w->from + w->step) % w->count);
    } else
        segment_point(vertex_at(w, w->step - 1), vertex_at(w, w->step),
                      (fraction - w->before) / (w->at - w->before), p);
}

/* Merges two arcs, without the vertices where they end. */
static void merge(struct match *m, struct walk w[2]) {
    double near = fmax(w[0].tolerance / w[0].length, w[1].tolerance / w[1].length);
    for (int k = 0; k < 2; k++)
        put(m, k, &(struct walk){w[k].vertex, w[k].count, .from = w[k].from}, true, 0);
    m->count++;
    while (w[0].step < w[0].steps || w[1].step < w[1].steps) {
        bool ended[2] = {w[0].step == w[0].steps, w[1].step == w[1].steps};
        bool both = !ended[0] && !ended[1] && fabs(w[0].at - w[1].at) <= near;
        int first = ended[0] || (!ended[1] && w[0].at > w[1].at);
        double at = w[first].at;
        for (int k = 0; k < 2; k++) put(m, k, &w[k], both || k == first, at);
        m->count++;
        for (int k = 0; k < 2; k++)
            if (both || k == first) advance(&w[k]);
    }
}

static int compare_anchors(const void *a, const void *b) {
    const struct match_anchor *p = a, *q = b;
    return (p->vertex[0] > q->vertex[0]) - (p->vertex[0] < q->vertex[0]);
}

/* Do the anchors exist, and do they follow each other in the same order on both cages? */
static bool check_anchors(const struct match_anchor *a, size_t n, const size_t count[2],
                          struct err *err) {
    size_t turns = 0;
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            if (a[i].vertex[k] >= count[k])
                return err_set(err, ERR_INPUT, "anchor %zu:%zu: the %s has vertices 0 to %zu only",
                               a[i].vertex[0], a[i].vertex[1], k == 0 ? "source" : "target",
                               count[k] - 1);
    for (size_t i = 0; i < n; i++) {
        const struct match_anchor *p = &a[i], *q = &a[i + 1 < n ? i + 1 : 0];
        turns += q->vertex[1] <= p->vertex[1];
        if (n == 1 || (turns <= 1 && p->vertex[0] != q->vertex[0] && p->vertex[1] != q->vertex[1]))
            continue;
        return err_set(err, ERR_REFUSAL,
                       "anchors %zu:%zu and %zu:%zu do not go together: their vertices must follow "
                       "each other in the same order on both cages",
                       p->vertex[0], p->vertex[1], q->vertex[0], q->vertex[1]);
    }
    return true;
}

static bool allocate(struct match *m, size_t n, struct err *err) {
    if (n >= UINT32_MAX) return err_set(err, ERR_REFUSAL, "more than 2^32 - 2 vertices");
    return mem_new(m->vertex[0], n, err) && mem_new(m->vertex[1], n, err) &&
           mem_new(m->given, n, err);
}

static void *rotated(const void *from, void *to, size_t count, size_t first, size_t size) {
    memcpy(to, (const char *)from + first * size, (count - first) * size);
    memcpy((char *)to + (count - first) * size, from, first * size);
    return to;
}

/* Numbers the pairs from vertex 0 of the source. */
static bool rotate(struct match *m, struct err *err) {
    struct match turned = {.count = m->count};
    size_t first = 0;
    while (m->given[first][0] != 0) first++;
    bool ok = allocate(&turned, m->count, err);
    if (ok) {
        for (int k = 0; k < 2; k++)
            rotated(m->vertex[k], turned.vertex[k], m->count, first, sizeof *m->vertex[k]);
        rotated(m->given, turned.given, m->count, first, sizeof *m->given);
        match_free(m);
        *m = turned;
    } else
        match_free(&turned);
    return ok;
}

bool match_init(struct match *m, const double (*const vertex[2])[2], const size_t count[2],
                const struct match_anchor *anchor, size_t anchor_count, struct err *err) {
    static const struct match_anchor zero;
    struct walk w[2] = {{.vertex = vertex[0], .count = count[0]},
                        {.vertex = vertex[1], .count = count[1]}};
    struct match_anchor *sorted = NULL;
    size_t n = anchor_count > 0 ? anchor_count : 1;
    *m = (struct match){0};
    bool ok = mem_new(sorted, n, err) && allocate(m, count[0] + count[1], err);
    if (ok) {
        memcpy(sorted, anchor_count > 0 ? anchor : &zero, n * sizeof *sorted);
        qsort(sorted, n, sizeof *sorted, compare_anchors);
        ok = check_anchors(sorted, n, count, err);
    }
    for (int k = 0; ok && k < 2; k++) measure(&w[k]);
    for (size_t i = 0; ok && i < n; i++) {
        for (int k = 0; k < 2; k++)
            begin_arc(&w[k], sorted[i].vertex[k], sorted[i + 1 < n ? i + 1 : 0].vertex[k]);
        merge(m, w);
    }
    free(sorted);
    return ok && rotate(m, err);
}

void match_free(struct match *m) {
    for (int k = 0; k < 2; k++) free(m->vertex[k]);
    free(m->given);
    *m = (struct match){0};
}

/* The vertices in the order in which they were given. */
static bool given_vertices(const struct cage *c, double (**vertex)[2], struct err *err) {
    if (!mem_new(*vertex, c->count, err)) return false;
    for (uint32_t i = 0; i < c->count; i++) {
        uint32_t at = i;
        double lambda = 0;
        cage_to_given(c, &at, &lambda);
        memcpy((*vertex)[at], c->vertex[i], sizeof **vertex);
    }
    return true;
}

bool match_cages(struct cage *source, struct cage *target, const struct match_anchor *anchor,
                 size_t anchor_count, struct err *err) {
    double(*vertex[2])[2] = {NULL, NULL};
    const size_t count[2] = {source->count, target->count};
    struct cage new_source = {0}, new_target = {0};
    struct match m = {0};
    bool ok =
        given_vertices(source, &vertex[0], err) && given_vertices(target, &vertex[1], err) &&
        match_init(&m,
                   (const double(*const[2])[2]){(const double(*)[2])vertex[0],
                                                (const double(*)[2])vertex[1]},
                   count, anchor, anchor_count, err) &&
        cage_init(&new_source, (const double(*)[2])m.vertex[0], m.count, err) &&
        cage_init_like(&new_target, (const double(*)[2])m.vertex[1], m.count, &new_source, err);
    if (ok) {
        cage_free(source);
        cage_free(target);
        *source = new_source;
        *target = new_target;
    } else
        cage_free(&new_source);
    free(vertex[0]);
    free(vertex[1]);
    match_free(&m);
    return ok;
}
