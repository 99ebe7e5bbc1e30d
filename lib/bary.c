/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bary.h"

#include "mem.h"

#include <string.h>

static void find_all(struct bary *bary, struct placer *placer, double (*vertex)[3]) {
    const struct projection *by = &placer->projection;
    for (size_t i = 0; i < bary->key.count; i++) {
        struct place *place = &bary->place[i];
        if (placer_find(placer, vertex[i], place)) {
            if (by->has_depth) depth_weights(by->depth, vertex[i][by->axes[2]], bary->weight[i]);
        } else {
            memcpy(place->b, vertex[i], sizeof place->b);
            if (bary->outside++ == 0) bary->first = i;
        }
    }
}

bool bary_locate(struct bary *bary, const struct bary_key *key, const struct grid *g,
                 const struct projection *projection, double (*vertex)[3], struct err *err) {
    struct placer placer = {0};
    bool ok;
    *bary = (struct bary){.key = *key};
    ok = mem_new(bary->place, key->count, err) &&
         (!projection->has_depth || mem_new(bary->weight, key->count, err)) &&
         placer_init(&placer, g, projection, err);
    if (ok)
        find_all(bary, &placer, vertex);
    else
        bary_free(bary);
    placer_free(&placer);
    return ok;
}

void bary_free(struct bary *bary) {
    free(bary->history);
    free(bary->place);
    free(bary->weight);
    *bary = (struct bary){0};
}
