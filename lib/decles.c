/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The steps of one edit, in order:
 *
 *   1 2  sets A, S, D, E        decles_sets.c
 *   0    E holds                decles_rank.c
 *   3    D grows, or conflict       "
 *   4    redundant conditions       "
 *   5    suggested positions    decles_suggest.c
 *   6    least squares          decles_solve.c
 *   7    update                 here
 *
 * Step 7 writes A and D, then judges what it wrote: gain, and every condition of E within the very
 * tolerance of step 0 (c1_holds). Conditions outside E have none of their points changed, so a
 * spline that passes step 0 everywhere does so after any number of edits. What fails is taken back
 * bit by bit.
 */
#include "decles.h"

#include "decles_motion.h"
#include "decles_rank.h"
#include "decles_sets.h"
#include "decles_solve.h"
#include "decles_suggest.h"
#include "mem.h"

#include <float.h>
#include <math.h>
#include <string.h>

struct decles_editor {
    struct decles_sets sets;
    struct decles_suggester suggester;
    double *weight; /* of each point; 0 stands for 1 */
    bool weighted;  /* there are others: else do not even look, the array is large */
    double max_gain, extent;
    double range; /* of coordinates */
    /* lists, k columns each (but weights) */
    double *suggested, *before, *solution, *anchor_before, *weights;
    size_t cap_suggested, cap_before, cap_solution, cap_anchor_before, cap_weights;
};

struct decles_editor *decles_new(const struct grid *g, const struct decles_options *options,
                                 struct err *err) {
    struct decles_editor *e;
    bool smooth = options->continuity == 1;
    if (smooth && g->degree < 5) {
        err_set(err, ERR_REFUSAL,
                "editing with continuity 1 needs degree 5 or more, the grid has %d", g->degree);
        return NULL;
    }
    if (!mem_new(e, 1, err)) return NULL;
    e->max_gain = options->max_gain;
    e->extent = c1_extent(g);
    e->range = smooth ? C1_RANGE : DBL_MAX;
    if (!decles_sets_init(&e->sets, g, smooth, err) || !decles_suggester_init(&e->suggester, err) ||
        !mem_new(e->weight, g->point_count, err)) {
        decles_free(e);
        return NULL;
    }
    return e;
}

void decles_free(struct decles_editor *e) {
    if (!e) return;
    decles_sets_free(&e->sets);
    decles_suggester_free(&e->suggester);
    free(e->weight);
    free(e->suggested);
    free(e->before);
    free(e->solution);
    free(e->anchor_before);
    free(e->weights);
    free(e);
}

void decles_pin(struct decles_editor *e, uint32_t p, bool pinned) {
    INVARIANT(p < e->sets.grid->point_count);
    e->sets.pinned[p] = pinned;
    e->sets.any_pinned = e->sets.any_pinned || pinned;
}

bool decles_is_pinned(const struct decles_editor *e, uint32_t p) {
    INVARIANT(p < e->sets.grid->point_count);
    return decles_sets_pinned(&e->sets, p);
}

void decles_weigh(struct decles_editor *e, uint32_t p, double weight) {
    INVARIANT(p < e->sets.grid->point_count && weight > 0);
    e->weight[p] = weight;
    e->weighted = true;
}

/* Makes room for D and A, and collects the weights of D. */
static bool make_room(struct decles_editor *e, size_t k, struct err *err) {
    size_t n = e->sets.derived_count;
    if (!mem_grow(e->suggested, &e->cap_suggested, n * k, err) ||
        !mem_grow(e->before, &e->cap_before, n * k, err) ||
        !mem_grow(e->solution, &e->cap_solution, n * k, err) ||
        !mem_grow(e->weights, &e->cap_weights, n, err) ||
        !mem_grow(e->anchor_before, &e->cap_anchor_before, e->sets.anchor_count * k, err))
        return false;
    for (size_t i = 0; i < n; i++) {
        double w = e->weighted ? e->weight[e->sets.derived[i]] : 0;
        e->weights[i] = w == 0 ? 1 : w;
    }
    return true;
}

/* False, with a refusal, unless point p may go there. */
static bool check_range(const struct decles_editor *e, uint32_t p, const double *to, int k,
                        struct err *err) {
    if (fabs(to[0]) <= e->range && (k == 1 || fabs(to[1]) <= e->range)) return true;
    return err_set(err, ERR_REFUSAL, "point %u would leave the range of numbers, %.2g either way",
                   p, e->range);
}

static bool check_anchors(const struct decles_editor *e, const struct decles_edit *edit, int k,
                          struct err *err) {
    for (size_t i = 0; i < edit->anchor_count; i++)
        if (!check_range(e, edit->anchor[i].point, edit->anchor[i].to, k, err)) return false;
    return true;
}

/* Of positions for all of D. */
static bool check_derived(const struct decles_editor *e, const double *list, int k,
                          struct err *err) {
    for (size_t i = 0; i < e->sets.derived_count; i++)
        if (!check_range(e, e->sets.derived[i], list + i * (size_t)k, k, err)) return false;
    return true;
}

/* Keeps the suggestions to a share of their ways. */
static void hold_back(struct decles_editor *e, const struct c1_field *v, double share) {
    size_t k = (size_t)v->k;
    for (size_t i = 0; i < e->sets.derived_count; i++)
        for (size_t c = 0; c < k; c++) {
            double *to = &e->suggested[i * k + c];
            *to = decles_between(v->q[v->stride * e->sets.derived[i] + c], *to, share);
        }
}

/* Step 5. */
static bool suggest(struct decles_editor *e, const struct c1_field *v,
                    const struct decles_edit *edit, struct err *err) {
    if (!decles_suggest(&e->suggester, &e->sets, edit, v, e->suggested, err)) return false;
    if (edit->share > 0 && edit->share < 1) hold_back(e, v, edit->share);
    return check_derived(e, e->suggested, v->k, err);
}

/* Steps 0 to 6: fills the suggestions and the solution. */
static bool solve(struct decles_editor *e, const struct c1_field *values,
                  const struct decles_edit *edit, struct decles_report *report, struct err *err) {
    struct exact_rows rows = {0};
    struct clsq_report solved = {0};
    struct decles_targets targets = {.k = values->k};
    double *fixed = NULL;
    bool ok = decles_sets_begin(&e->sets, edit, err) && check_anchors(e, edit, values->k, err) &&
              decles_close(&e->sets, edit, values, &rows, &report->added, err) &&
              make_room(e, (size_t)values->k, err) && suggest(e, values, edit, err) &&
              decles_fixed_values(&e->sets, edit, values, &fixed, err);
    if (ok) {
        targets.suggested = e->suggested;
        targets.weight = e->weights;
        targets.fixed = fixed;
        ok = decles_solve(&e->sets, &rows, &targets, e->solution, &solved, err) &&
             check_derived(e, e->solution, values->k, err);
    }
    report->rank = rows.rank;
    report->redundant = rows.relation_count;
    report->by_qr = solved.by_qr;
    exact_rows_free(&rows);
    free(fixed);
    return ok;
}

/* Copies the points listed between q and a list of k columns. */
static void gather(const struct c1_field *v, const uint32_t *point, size_t n, double *list) {
    size_t k = (size_t)v->k;
    for (size_t i = 0; i < n; i++)
        memcpy(list + i * k, v->q + v->stride * point[i], k * sizeof *list);
}

static void scatter(const struct c1_field *v, const uint32_t *point, size_t n, const double *list) {
    size_t k = (size_t)v->k;
    for (size_t i = 0; i < n; i++)
        memcpy(v->q + v->stride * point[i], list + i * k, k * sizeof *list);
}

/* Step 7, keeping what was there. */
static void update(struct decles_editor *e, const struct c1_field *v,
                   const struct decles_edit *edit) {
    const struct decles_sets *s = &e->sets;
    gather(v, s->anchor, s->anchor_count, e->anchor_before);
    gather(v, s->derived, s->derived_count, e->before);
    for (size_t i = 0; i < edit->anchor_count; i++)
        memcpy(v->q + v->stride * edit->anchor[i].point, edit->anchor[i].to,
               (size_t)v->k * sizeof *v->q);
    scatter(v, s->derived, s->derived_count, e->solution);
}

static void take_back(struct decles_editor *e, const struct c1_field *v) {
    scatter(v, e->sets.anchor, e->sets.anchor_count, e->anchor_before);
    scatter(v, e->sets.derived, e->sets.derived_count, e->before);
}

/* Half the distance: finite for all finite a and b. */
static double half_distance(const double *a, const double *b, int k) {
    double dx = fabs(0.5 * a[0] - 0.5 * b[0]), dy = k > 1 ? fabs(0.5 * a[1] - 0.5 * b[1]) : 0;
    double large = fmax(dx, dy), small = fmin(dx, dy) / large;
    return small > 0 ? large * sqrt(1 + small * small) : large;
}

static double magnitude(const double *a, int k) {
    return k > 1 ? fmax(fabs(a[0]), fabs(a[1])) : fabs(a[0]);
}

/* Half the largest displacement asked for: of anchors to their positions, of D to p'. Rounding lets
 * E be off by 64 u of its terms before the edit, and that is made good too: it counts as asked for.
 */
static double find_asked(const struct decles_editor *e, const struct decles_edit *edit, int k) {
    const struct decles_sets *s = &e->sets;
    double asked = 0, largest = 0;
    for (size_t i = 0; i < s->anchor_count; i++) {
        const double *before = e->anchor_before + i * (size_t)k;
        asked = fmax(asked, half_distance(edit->anchor[i].to, before, k));
        largest = fmax(largest, magnitude(before, k));
    }
    for (size_t i = 0; i < s->derived_count; i++) {
        size_t at = i * (size_t)k;
        asked = fmax(asked, half_distance(e->suggested + at, e->before + at, k));
        largest = fmax(largest, magnitude(e->before + at, k));
    }
    return asked + 32 * 0x1p-53 * largest;
}

static bool check_gain(const struct decles_editor *e, const struct decles_edit *edit, int k,
                       struct decles_report *report, struct err *err) {
    const struct decles_sets *s = &e->sets;
    double asked = find_asked(e, edit, k), half = 0;
    uint32_t point = GRID_NONE;
    for (size_t i = 0; i < s->derived_count; i++) {
        const double *to = e->solution + i * (size_t)k;
        double moved = half_distance(to, e->before + i * (size_t)k, k);
        if (moved <= half) continue;
        half = moved;
        point = s->derived[i];
    }
    report->displacement = 2 * half;
    report->gain = half == 0 ? 0 : half / asked;
    if (report->gain <= e->max_gain) return true;
    return err_set(err, ERR_REFUSAL,
                   "point %u would move %.3g times as far as what was asked for (limit %.3g)",
                   point, report->gain, e->max_gain);
}

/* Measures E after the update; it must hold as step 0 understands it. */
static bool check_result(const struct decles_sets *s, const struct c1_field *v,
                         struct decles_report *report, struct err *err) {
    report->residual = 0;
    for (size_t r = 0; r < s->condition_count; r++)
        for (int c = 0; c < v->k; c++) {
            struct c1_value value = c1_evaluate(&s->row[r], v, c);
            uint64_t edge = s->condition[r] / (uint64_t)s->grid->degree;
            report->residual = fmax(report->residual, c1_relative(value));
            if (c1_holds(value)) continue;
            return err_set(err, ERR_REFUSAL,
                           "the C1 conditions across the edge %u-%u cannot be kept in double "
                           "precision: off by %.2g of their terms",
                           s->grid->edge[edge][0], s->grid->edge[edge][1], c1_relative(value));
        }
    return true;
}

static void fill_report(const struct decles_editor *e, struct decles_report *report) {
    const struct decles_sets *s = &e->sets;
    report->anchors = s->anchor_count;
    report->slaves = s->slave_count;
    report->derived = s->derived_count;
    report->conditions = s->condition_count;
    report->derived_point = s->derived;
    report->suggested = e->suggested;
    report->before = e->before;
    report->condition = s->condition;
}

bool decles_apply(struct decles_editor *e, double *q, size_t stride, int k,
                  const struct decles_edit *edit, struct decles_report *report, struct err *err) {
    struct c1_field values = {q, stride, k, e->extent};
    bool ok;
    INVARIANT(k == 1 || k == 2);
    memset(report, 0, sizeof *report);
    ok = solve(e, &values, edit, report, err);
    if (ok) {
        update(e, &values, edit);
        ok = check_gain(e, edit, k, report, err) && check_result(&e->sets, &values, report, err);
        if (!ok) take_back(e, &values);
    }
    fill_report(e, report);
    decles_sets_clear(&e->sets);
    return ok;
}
