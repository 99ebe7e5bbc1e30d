/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Union and find over vertices: all edges join components, boundary edges alone join loops, since
 * a boundary vertex has two of them. */
#include "topology.h"

#include "mem.h"

static uint32_t find(uint32_t *parent, uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}

/* Sets of vertices joined by edges; vertices without such an edge do not count. */
static uint32_t count_sets(const struct grid *g, uint32_t *parent, bool boundary_only) {
    uint32_t sets = 0;
    for (uint32_t v = 0; v < g->vertex_count; v++) parent[v] = GRID_NONE;
    for (uint32_t e = 0; e < g->edge_count; e++) {
        uint32_t root[2];
        if (boundary_only && grid_edge_is_inner(g, e)) continue;
        for (int i = 0; i < 2; i++) {
            uint32_t v = g->edge[e][i];
            if (parent[v] == GRID_NONE) {
                parent[v] = v;
                sets++;
            }
            root[i] = find(parent, v);
        }
        if (root[0] == root[1]) continue;
        parent[root[1]] = root[0];
        sets--;
    }
    return sets;
}

bool topology_survey(struct topology *t, const struct grid *g, struct err *err) {
    uint32_t *parent;
    *t = (struct topology){0};
    if (!mem_new(parent, g->vertex_count, err)) return false;
    for (uint32_t e = 0; e < g->edge_count; e++)
        if (grid_edge_is_inner(g, e))
            t->inner_edges++;
        else
            t->boundary_edges++;
    t->components = count_sets(g, parent, false);
    t->loops = count_sets(g, parent, true);
    free(parent);
    return true;
}

bool topology_components(const struct grid *g, uint32_t *component, uint32_t *count,
                         struct err *err) {
    uint32_t *parent, n = 0;
    if (!mem_new(parent, g->vertex_count, err)) return false;
    (void)count_sets(g, parent, false);
    for (uint32_t v = 0; v < g->vertex_count; v++) component[v] = GRID_NONE;
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        uint32_t root = find(parent, v);
        if (component[root] == GRID_NONE) component[root] = n++;
        component[v] = component[root];
    }
    *count = n;
    free(parent);
    return true;
}
