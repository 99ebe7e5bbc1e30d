/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"

#include "c1.h"
#include "stretch.h"
#include "volume.h"

bool check_init(struct check *c, const struct spline *s, const struct least_rule *rule, bool all,
                struct err *err) {
    const struct grid *g = &s->grid;
    bool ok;
    *c = (struct check){0};
    c1_vertices(g, &c->inner_vertices, &c->singular_vertices);
    ok = topology_survey(&c->topology, g, err) && continuity_survey(&c->continuity, s, err) &&
         stretch_sample(s, &c->stretch[0], &c->stretch[1], err) &&
         jacobian_report_init(&c->plane, s, JACOBIAN_PLANE, rule, all, err);
    if (ok && s->sigma)
        ok = jacobian_report_init(&c->thickness, s, JACOBIAN_THICKNESS, rule, all, err) &&
             volume_of_prisms(s, &c->volume, &c->volume_ratio, err);
    if (ok &&
        injective_init(&c->injective, s, &c->plane, s->sigma ? &c->thickness : NULL, rule, err))
        return true;
    jacobian_report_free(&c->plane);
    jacobian_report_free(&c->thickness);
    return false;
}

void check_free(struct check *c) {
    jacobian_report_free(&c->plane);
    jacobian_report_free(&c->thickness);
    injective_free(&c->injective);
}

static bool is_certified(const struct jacobian_report *r, const char *what, struct err *err) {
    if (r->least.verdict == JACOBIAN_CERTIFIED) return true;
    return err_set(err, ERR_REFUSAL, "%s: %s, see triangle %u", what,
                   jacobian_verdict_names[r->least.verdict], r->triangle);
}

bool check_holds(const struct check *c, const struct spline *s, struct err *err) {
    uint32_t e = c->continuity.worst;
    if (c->injective.overlap.kind == OVERLAP_NONE &&
        (!is_certified(&c->plane, "det grad phi > 0", err) ||
         (s->sigma && !is_certified(&c->thickness, "sigma1 > sigma0", err))))
        return false;
    if (!injective_holds(&c->injective, err)) return false;
    return c->continuity.edges[0] == 0 ||
           err_set(err, ERR_REFUSAL, "not C1 across %u edges, worst across {%u,%u}",
                   c->continuity.edges[0], s->grid.edge[e][0], s->grid.edge[e][1]);
}
