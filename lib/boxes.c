/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A node has the leaves from .. to; with more than one it has two halves, from .. mid .. to, mid =
 * from + (to - from) / 2. Since m leaves have 2 m - 1 nodes, the halves of node i are the nodes
 * i + 1 and i + 2 (mid - from). */
#include "boxes.h"

#include "mem.h"
#include "radix.h"

#include <math.h>

enum { KEY_BITS = 20 }; /* of each coordinate */

struct node {
    uint32_t from, to;
    size_t number;
};

static struct node half_of(const struct node *n, int h) {
    uint32_t mid = n->from + (n->to - n->from) / 2;
    if (h == 0) return (struct node){n->from, mid, n->number + 1};
    return (struct node){mid, n->to, n->number + 2 * (size_t)(mid - n->from)};
}

static bool is_leaf(const struct node *n) {
    return n->to - n->from == 1;
}

struct box box_of_points(uint32_t n, const double (*point)[2]) {
    struct box all = {{point[0][0], point[0][1]}, {point[0][0], point[0][1]}};
    for (uint32_t i = 1; i < n; i++)
        box_enlarge(&all, &(struct box){{point[i][0], point[i][1]}, {point[i][0], point[i][1]}});
    return all;
}

/* Bit k to bit 2k. */
static uint64_t spread(uint64_t x) {
    x = (x | x << 16) & 0x0000FFFF0000FFFF;
    x = (x | x << 8) & 0x00FF00FF00FF00FF;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0F;
    x = (x | x << 2) & 0x3333333333333333;
    return (x | x << 1) & 0x5555555555555555;
}

/* Where a box's middle lies within `all`, on the curve. */
static uint64_t key_of(const struct box *box, const struct box *all) {
    uint64_t key = 0;
    for (int c = 0; c < 2; c++) {
        double width = all->hi[c] * 0.5 - all->lo[c] * 0.5;
        double from = box->lo[c] * 0.25 + box->hi[c] * 0.25 - all->lo[c] * 0.5;
        double at = width > 0 ? from / width * ((1 << KEY_BITS) - 1) : 0;
        key |= spread(at > 0 ? (uint64_t)at : 0) << c;
    }
    return key;
}

static void fill(struct boxes *b, const struct node *n, const struct box *box) {
    struct box *own = &b->node[n->number];
    if (is_leaf(n)) {
        *own = box[b->item[n->from]];
        return;
    }
    for (int h = 0; h < 2; h++) {
        struct node half = half_of(n, h);
        fill(b, &half, box);
        if (h == 0)
            *own = b->node[half.number];
        else
            box_enlarge(own, &b->node[half.number]);
    }
}

static bool sort(struct boxes *b, const struct box *box, struct err *err) {
    struct radix_item *items = NULL, *spare = NULL;
    struct box all = box[0];
    bool ok = mem_new(items, b->count, err) && mem_new(spare, b->count, err);
    for (uint32_t i = 1; i < b->count; i++) box_enlarge(&all, &box[i]);
    for (uint32_t i = 0; ok && i < b->count; i++)
        items[i] = (struct radix_item){key_of(&box[i], &all), i};
    if (ok) radix_sort(items, spare, b->count);
    for (uint32_t i = 0; ok && i < b->count; i++) b->item[i] = items[i].value;
    free(items);
    free(spare);
    return ok;
}

bool boxes_init(struct boxes *b, const struct box *box, uint32_t count, struct err *err) {
    struct node root = {0, count, 0};
    *b = (struct boxes){.count = count};
    if (count == 0) return true;
    if (mem_new(b->item, count, err) && mem_new(b->node, 2 * (size_t)count - 1, err) &&
        sort(b, box, err)) {
        fill(b, &root, box);
        return true;
    }
    boxes_free(b);
    return false;
}

void boxes_free(struct boxes *b) {
    free(b->item);
    free(b->node);
    *b = (struct boxes){0};
}

struct search {
    const struct boxes *b;
    bool (*pair)(void *context, uint32_t i, uint32_t j);
    bool (*one)(void *context, uint32_t i);
    void *context;
};

/* Pairs of an item of m and one of n. */
static bool between(const struct search *s, const struct node *m, const struct node *n) {
    if (!box_meets(&s->b->node[m->number], &s->b->node[n->number])) return true;
    if (is_leaf(m) && is_leaf(n))
        return s->pair(s->context, s->b->item[m->from], s->b->item[n->from]);
    if (m->to - m->from < n->to - n->from) {
        const struct node *swap = m;
        m = n;
        n = swap;
    }
    for (int h = 0; h < 2; h++) {
        struct node half = half_of(m, h);
        if (!between(s, &half, n)) return false;
    }
    return true;
}

static bool within(const struct search *s, const struct node *n) {
    struct node half[2] = {half_of(n, 0), half_of(n, 1)};
    return is_leaf(n) ||
           (within(s, &half[0]) && within(s, &half[1]) && between(s, &half[0], &half[1]));
}

bool boxes_pairs(const struct boxes *b, bool (*visit)(void *context, uint32_t i, uint32_t j),
                 void *context) {
    struct search s = {.b = b, .pair = visit, .context = context};
    return b->count == 0 || within(&s, &(struct node){0, b->count, 0});
}

static bool below(const struct search *s, const struct node *n, const struct box *box) {
    if (!box_meets(&s->b->node[n->number], box)) return true;
    if (is_leaf(n)) return s->one(s->context, s->b->item[n->from]);
    for (int h = 0; h < 2; h++) {
        struct node half = half_of(n, h);
        if (!below(s, &half, box)) return false;
    }
    return true;
}

bool boxes_query(const struct boxes *b, const struct box *box,
                 bool (*visit)(void *context, uint32_t i), void *context) {
    struct search s = {.b = b, .one = visit, .context = context};
    return b->count == 0 || below(&s, &(struct node){0, b->count, 0}, box);
}
