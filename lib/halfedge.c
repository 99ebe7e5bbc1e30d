/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Half edges are sorted by their ends, the lower one first: twins come to lie side by side. */
#include "halfedge.h"

#include "mem.h"
#include "radix.h"

static uint64_t key(const uint32_t (*triangle)[3], uint32_t h) {
    uint64_t a = halfedge_from(triangle, h), b = halfedge_to(triangle, h);
    return a < b ? a << 32 | b : b << 32 | a;
}

static void pair(uint32_t *twin, const struct radix_item *item, size_t n) {
    for (size_t i = 0; i < n; i++) twin[i] = HALFEDGE_NONE;
    for (size_t i = 0; i + 1 < n; i++) {
        uint32_t h = item[i].value, g = item[i + 1].value;
        if (item[i].key != item[i + 1].key) continue;
        INVARIANT(twin[h] == HALFEDGE_NONE);
        twin[h] = g;
        twin[g] = h;
    }
}

bool halfedge_twins(uint32_t **twin, const uint32_t (*triangle)[3], size_t triangle_count,
                    struct err *err) {
    struct radix_item *item = NULL, *spare = NULL;
    size_t n = 3 * triangle_count;
    bool ok = mem_new(*twin, n, err) && mem_new(item, n, err) && mem_new(spare, n, err);
    INVARIANT(triangle_count < UINT32_MAX / 3);
    if (ok) {
        for (size_t i = 0; i < n; i++)
            item[i] = (struct radix_item){key(triangle, (uint32_t)i), (uint32_t)i};
        radix_sort(item, spare, n);
        pair(*twin, item, n);
    } else {
        free(*twin);
        *twin = NULL;
    }
    free(item);
    free(spare);
    return ok;
}
