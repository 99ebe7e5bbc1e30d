/* SPDX-License-Identifier: GPL-3.0-or-later */
/* check - all that can be told about a deformation: what its grid is made of, how smooth it is,
 * whether it folds, and whether it is one-to-one, with proof. */
#ifndef CHECK_H
#define CHECK_H

#include "continuity.h"
#include "injective.h"
#include "topology.h"

struct check {
    struct topology topology;
    uint32_t inner_vertices, singular_vertices;
    struct continuity continuity;
    struct jacobian_report plane, thickness; /* thickness only with depth */
    struct injective injective;
    double volume, volume_ratio; /* with depth: of the deformed prisms */
    double stretch[2];           /* sampled singular values of grad phi */
};

/* With `all`, bounds are refined for each triangle. */
bool check_init(struct check *c, const struct spline *s, const struct least_rule *rule, bool all,
                struct err *err) WARN_UNUSED;
void check_free(struct check *c);

/* Nothing overlaps, phi and sigma are C1, det grad phi > 0 and sigma1 > sigma0 everywhere, and psi
 * is one-to-one? If not, ERR_REFUSAL with what is wrong first. */
bool check_holds(const struct check *c, const struct spline *s, struct err *err) WARN_UNUSED;

#endif
