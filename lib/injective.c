/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "injective.h"

#include <stdio.h>

const char *const injective_verdict_names[] = {"yes", "undecided", "no"};

/* What is known of phi: the worst of what is known of its parts. */
static enum injective_verdict conclude(const struct injective *j, enum jacobian_verdict plane) {
    static const enum injective_verdict of_jacobian[] = {[JACOBIAN_CERTIFIED] = INJECTIVE_YES,
                                                         [JACOBIAN_UNDECIDED] = INJECTIVE_UNDECIDED,
                                                         [JACOBIAN_DEGENERATE] =
                                                             INJECTIVE_UNDECIDED,
                                                         [JACOBIAN_FOLDS] = INJECTIVE_NO};
    static const enum injective_verdict of_fans[] = {[FAN_SOUND] = INJECTIVE_YES,
                                                     [FAN_COVERS] = INJECTIVE_NO,
                                                     [FAN_CLOSES] = INJECTIVE_UNDECIDED,
                                                     [FAN_UNKNOWN] = INJECTIVE_UNDECIDED};
    static const enum injective_verdict of_meet[] = {[MEET_NOT] = INJECTIVE_YES,
                                                     [MEET_UNDECIDED] = INJECTIVE_UNDECIDED,
                                                     [MEET_CROSS] = INJECTIVE_NO,
                                                     [MEET_POINT] = INJECTIVE_NO};
    static const enum injective_verdict of_nesting[] = {[NESTING_NONE] = INJECTIVE_YES,
                                                        [NESTING_UNDECIDED] = INJECTIVE_UNDECIDED,
                                                        [NESTING_INSIDE] = INJECTIVE_NO};
    const enum injective_verdict all[] = {
        j->overlap.kind == OVERLAP_NONE ? INJECTIVE_YES : INJECTIVE_NO, of_jacobian[plane],
        of_fans[j->fans], of_meet[j->boundary.meet.verdict], of_nesting[j->nesting.verdict]};
    enum injective_verdict worst = INJECTIVE_YES;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) worst = all[i] > worst ? all[i] : worst;
    return worst;
}

static bool survey_boundary(struct injective *j, const struct spline *s,
                            const struct least_rule *rule, struct err *err) {
    struct boundary b;
    struct meet_rule near = {rule->undecided, rule->parts};
    bool ok;
    if (!boundary_init(&b, s, err)) return false;
    ok = boundary_meets(&b, &near, &j->boundary, err) &&
         (j->boundary.meet.verdict != MEET_NOT || nesting_survey(&j->nesting, &b, err));
    boundary_free(&b);
    return ok;
}

bool injective_init(struct injective *j, const struct spline *s,
                    const struct jacobian_report *plane, const struct jacobian_report *thickness,
                    const struct least_rule *rule, struct err *err) {
    *j = (struct injective){.nesting = {NESTING_NONE, GRID_NONE, GRID_NONE}};
    boundary_meeting_init(&j->boundary);
    j->fan_vertex = fans_worst(s, &j->fans, &j->fan_turns);
    if (!overlap_find(&j->overlap, &s->grid, err) || !survey_boundary(j, s, rule, err)) {
        injective_free(j);
        return false;
    }
    j->phi = j->psi = conclude(j, plane->least.verdict);
    if (thickness && thickness->least.verdict == JACOBIAN_UNDECIDED && j->psi == INJECTIVE_YES)
        j->psi = INJECTIVE_UNDECIDED;
    if (thickness && thickness->least.verdict >= JACOBIAN_DEGENERATE) j->psi = INJECTIVE_NO;
    return true;
}

void injective_free(struct injective *j) {
    boundary_meeting_free(&j->boundary);
}

static bool check_boundary(const struct boundary_meeting *m, struct err *err) {
    const struct boundary_place *a = &m->place[0], *b = &m->place[1];
    bool self = a->from == b->from;
    char edges[96];
    if (m->meet.verdict == MEET_NOT) return true;
    if (self)
        (void)snprintf(edges, sizeof edges, "the image of edge {%u,%u}", a->from, a->to);
    else
        (void)snprintf(edges, sizeof edges, "the images of edges {%u,%u} and {%u,%u}", a->from,
                       a->to, b->from, b->to);
    if (m->meet.verdict == MEET_UNDECIDED)
        return err_set(err, ERR_REFUSAL,
                       "not proved to be one-to-one: %s %s within %.3g near (%.9g, %.9g)", edges,
                       self ? "comes back" : "come", m->meet.distance, m->image[0], m->image[1]);
    return err_set(err, ERR_REFUSAL, "not one-to-one: %s %s at (%.9g, %.9g)", edges,
                   self ? "meets itself" : "meet", m->image[0], m->image[1]);
}

static bool check_fans(const struct injective *j, struct err *err) {
    switch (j->fans) {
    case FAN_SOUND:
        return true;
    case FAN_COVERS:
        return err_set(err, ERR_REFUSAL,
                       "not one-to-one: the images of the triangles around vertex %u overlap",
                       j->fan_vertex);
    case FAN_CLOSES:
        return err_set(err, ERR_REFUSAL,
                       "not proved to be one-to-one: the images of the triangles around the "
                       "boundary vertex %u make a full turn",
                       j->fan_vertex);
    case FAN_UNKNOWN:
        return err_set(err, ERR_REFUSAL, "not proved to be one-to-one around vertex %u",
                       j->fan_vertex);
    }
    return false;
}

bool injective_holds(const struct injective *j, struct err *err) {
    const struct overlap *o = &j->overlap;
    if (o->kind != OVERLAP_NONE)
        return err_set(err, ERR_REFUSAL, "not one-to-one: triangles %u and %u of the domain %s: %s",
                       o->triangle[0], o->triangle[1],
                       o->kind == OVERLAP_AREA ? "overlap" : "touch", o->text);
    if (!check_fans(j, err) || !check_boundary(&j->boundary, err)) return false;
    switch (j->nesting.verdict) {
    case NESTING_NONE:
        return true;
    case NESTING_INSIDE:
        return err_set(err, ERR_REFUSAL,
                       "not one-to-one: the image of vertex %u lies in that of triangle %u",
                       j->nesting.vertex, j->nesting.triangle);
    case NESTING_UNDECIDED:
        return err_set(err, ERR_REFUSAL,
                       "not proved to be one-to-one: images of components are too close");
    }
    return false;
}

/* `from`: from this verdict on it is known not to be. */
static bool is_certified(const struct jacobian_report *r, const char *what,
                         enum jacobian_verdict from, struct err *err) {
    enum jacobian_verdict verdict = r->least.verdict;
    if (verdict == JACOBIAN_CERTIFIED) return true;
    return err_set(err, ERR_REFUSAL, "%s one-to-one: %s: %s, see triangle %u",
                   verdict >= from ? "not" : "not proved to be", what,
                   jacobian_verdict_names[verdict], r->triangle);
}

/* The certificates first, which are the likeliest to fail. */
static bool prove(const struct spline *s, const struct jacobian_report *plane,
                  const struct jacobian_report *thickness, struct err *err) {
    struct injective j;
    bool ok;
    if (!is_certified(plane, "det grad phi > 0", JACOBIAN_FOLDS, err) ||
        (thickness && !is_certified(thickness, "sigma1 > sigma0", JACOBIAN_DEGENERATE, err)) ||
        !injective_init(&j, s, plane, thickness, &jacobian_default_rule, err))
        return false;
    ok = injective_holds(&j, err);
    injective_free(&j);
    return ok;
}

bool injective_prove(const struct spline *s, struct err *err) {
    const struct least_rule *rule = &jacobian_default_rule;
    struct jacobian_report plane = {0}, thickness = {0};
    bool ok =
        jacobian_report_init(&plane, s, JACOBIAN_PLANE, rule, false, err) &&
        (!s->sigma || jacobian_report_init(&thickness, s, JACOBIAN_THICKNESS, rule, false, err)) &&
        prove(s, &plane, s->sigma ? &thickness : NULL, err);
    jacobian_report_free(&plane);
    jacobian_report_free(&thickness);
    return ok;
}
