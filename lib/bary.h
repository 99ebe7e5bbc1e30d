/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bary - a model's vertices located in a grid, once for all deformations on its domain ([11] 4.2).
 *
 * The key says what the places belong to; a program that uses places for another domain or another
 * model would be wrong without noticing. */
#ifndef BARY_H
#define BARY_H

#include "place.h"

struct bary_key {
    uint32_t domain, model;  /* checksums (bary_io.h) */
    uint32_t count;          /* vertices */
    uint32_t triangle_count; /* of the grid */
    bool has_depth;          /* do places have weights of the depth? */
    bool any_model;          /* to be read: `model` says nothing, since vertices have moved */
};

struct bary {
    struct bary_key key;
    char *history;       /* the comment lines after the first record, each "# ...\n"; NULL: none */
    struct place *place; /* key.count of them; a vertex outside has its coordinates x y z in b */
    double (*weight)[2]; /* with depth: a0, a1 of depth_weights, inside; else NULL */
    size_t outside;      /* how many places are outside, and the first of them */
    size_t first;
};

/* Locates key.count vertices. */
bool bary_locate(struct bary *bary, const struct bary_key *key, const struct grid *g,
                 const struct projection *projection, double (*vertex)[3],
                 struct err *err) WARN_UNUSED;
void bary_free(struct bary *bary); /* harmless on a zeroed struct */

#endif
