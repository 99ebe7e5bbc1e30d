/* SPDX-License-Identifier: GPL-3.0-or-later */
/* blocks - where to keep something about a few of very many items, whose numbers come in clusters.
 *
 * An array over all items would be touched in many places far apart, each time the first touch of
 * a page. So items are taken in blocks of 64, and a block gets its place when it is first needed:
 *
 *     item      0..63   64..127   128..191   192..255  ...
 *     of          0        2          0          1           place + 1, 0: none yet
 *     place               (1)                   (0)          in the order of need
 *
 * The caller has an array with room for all items (untouched pages cost nothing), uses it at
 * blocks_find or blocks_place, and leaves zeros there before blocks_clear. */
#ifndef BLOCKS_H
#define BLOCKS_H

#include "mem.h"

#include <stdint.h>

enum { BLOCK = 64 };

struct blocks {
    uint32_t *of;   /* of each block: its place + 1, or 0 */
    uint32_t *used; /* the blocks that have places, in their order */
    uint32_t count; /* places given */
};

static inline size_t blocks_room(uint32_t items) {
    return ((size_t)items + BLOCK - 1) / BLOCK * BLOCK;
}

static inline bool blocks_init(struct blocks *b, uint32_t items, struct err *err) {
    size_t n = blocks_room(items) / BLOCK;
    *b = (struct blocks){0};
    return mem_new(b->of, n, err) && mem_new(b->used, n, err);
}

static inline void blocks_free(struct blocks *b) {
    free(b->of);
    free(b->used);
    *b = (struct blocks){0};
}

/* Where item i is kept, or SIZE_MAX if its block has no place. */
static inline size_t blocks_find(const struct blocks *b, uint32_t i) {
    uint32_t place = b->of[i / BLOCK];
    return place == 0 ? SIZE_MAX : (size_t)(place - 1) * BLOCK + i % BLOCK;
}

/* The same; gives its block a place. */
static inline size_t blocks_place(struct blocks *b, uint32_t i) {
    uint32_t *place = &b->of[i / BLOCK];
    if (*place == 0) {
        b->used[b->count] = i / BLOCK;
        *place = ++b->count;
    }
    return (size_t)(*place - 1) * BLOCK + i % BLOCK;
}

/* Takes all places back. */
static inline void blocks_clear(struct blocks *b) {
    while (b->count > 0) b->of[b->used[--b->count]] = 0;
}

#endif
