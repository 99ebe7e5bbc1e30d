/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Edges are sorted by their two ends; then the two triangles of an edge are neighbours. */
#include "mesh.h"

#include "mem.h"
#include "radix.h"

/* Edge e of triangle t, as 3 t + e, with its ends in ascending order as key. */
static struct radix_item edge_item(const struct mesh *m, size_t edge) {
    const uint32_t *v = m->triangle[edge / 3];
    uint64_t a = v[(edge + 1) % 3], b = v[(edge + 2) % 3];
    return (struct radix_item){a < b ? a << 32 | b : b << 32 | a, (uint32_t)edge};
}

static void link_pairs(struct mesh *m, const struct radix_item *item, size_t n) {
    for (size_t i = 0; i < n; i++) {
        uint32_t edge = item[i].value, other = MESH_NONE;
        if (i > 0 && item[i - 1].key == item[i].key) other = item[i - 1].value / 3;
        if (i + 1 < n && item[i + 1].key == item[i].key) other = item[i + 1].value / 3;
        m->across[edge / 3][edge % 3] = other;
    }
}

bool mesh_link(struct mesh *m, struct err *err) {
    struct radix_item *item = NULL, *spare = NULL;
    size_t n = 3 * m->triangle_count;
    bool ok = mem_new(item, n, err) && mem_new(spare, n, err) &&
              mem_new(m->across, m->triangle_count, err);
    INVARIANT(m->triangle_count <= MESH_TRIANGLES_MAX);
    if (ok) {
        for (size_t edge = 0; edge < n; edge++) item[edge] = edge_item(m, edge);
        radix_sort(item, spare, n);
        link_pairs(m, item, n);
    }
    free(item);
    free(spare);
    return ok;
}

void mesh_free(struct mesh *m) {
    free(m->vertex);
    free(m->triangle);
    free(m->across);
    *m = (struct mesh){0};
}
