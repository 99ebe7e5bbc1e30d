/* SPDX-License-Identifier: GPL-3.0-or-later */
/* topology - what a grid is made of. */
#ifndef TOPOLOGY_H
#define TOPOLOGY_H

#include "grid.h"

struct topology {
    uint32_t inner_edges, boundary_edges;
    uint32_t components; /* parts that share no vertex */
    uint32_t loops;      /* closed chains of boundary edges; each part has one, and one a hole */
};

bool topology_survey(struct topology *t, const struct grid *g, struct err *err) WARN_UNUSED;

/* component[v], from 0, by the lowest vertex of each; *count of them. */
bool topology_components(const struct grid *g, uint32_t *component, uint32_t *count,
                         struct err *err) WARN_UNUSED;

#endif
