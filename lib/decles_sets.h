/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles_sets - which points and conditions one edit touches: steps 1 and 2 of decles.md.
 *
 * A: anchors. S: slaves. D: derived points, S and what the types of A and S demand. E: every
 * condition that contains a point of A or D. F: the points of E that stay where they are. All are
 * lists, and marks in arrays as large as the grid that are zero between edits, so that an edit
 * costs O(|A| + |D| + |E|). Points of D and conditions of E are in the order of their numbers. */
#ifndef DECLES_SETS_H
#define DECLES_SETS_H

#include "blocks.h"
#include "decles.h"
#include "sparse.h"

enum decles_role { ROLE_NONE, ROLE_ANCHOR, ROLE_DERIVED };

/* What is known of a point during an edit. */
struct decles_mark {
    uint32_t column;    /* 1 + index in `derived` or in `fixed`, 0 elsewhere */
    uint32_t near, far; /* for the searches of decles_suggest: 1 + number of the visit; 0 between */
    enum decles_role role;
};

struct decles_sets {
    const struct grid *grid;
    bool smooth;     /* continuity 1: the types of A and S matter, and there are conditions */
    bool *pinned;    /* of each point; the caller's to set; lasts */
    bool any_pinned; /* the same; while false, do not even look */

    size_t anchor_count, slave_count, derived_count, condition_count, fixed_count;
    uint32_t *anchor, *derived;
    uint64_t *condition;      /* e*d + m */
    struct c1_condition *row; /* the same conditions */
    uint32_t *fixed;          /* A and F: all points of E that are not in D */

    /* private */
    struct blocks blocks;     /* of points with marks */
    struct decles_mark *mark; /* zero between edits */
    uint8_t *ring_done;       /* of each vertex: bit 0 ring 1, bit 1 ring 2 is in D */
    uint8_t *is_in_e;         /* of each condition */
    uint32_t *ring_vertex;    /* where ring_done is not 0 */
    size_t ring_count;
    size_t seen; /* conditions of the point that is being added, old and new */
    size_t cap_anchor, cap_derived, cap_condition, cap_row, cap_fixed, cap_ring;
    bool ok; /* false once memory ran out */
    struct err *err;
};

/* The mark of p to be read; zero unless it was changed in this edit. */
static inline const struct decles_mark *decles_mark(const struct decles_sets *sets, uint32_t p) {
    static const struct decles_mark zero = {0};
    size_t at = blocks_find(&sets->blocks, p);
    return at == SIZE_MAX ? &zero : &sets->mark[at];
}

/* The mark of p to be changed. */
static inline struct decles_mark *decles_mark_at(struct decles_sets *sets, uint32_t p) {
    return &sets->mark[blocks_place(&sets->blocks, p)];
}

static inline bool decles_sets_pinned(const struct decles_sets *sets, uint32_t p) {
    return sets->any_pinned && sets->pinned[p];
}

/* Allocates marks for grid g, which is borrowed. On failure the struct is safe to free. */
bool decles_sets_init(struct decles_sets *sets, const struct grid *g, bool smooth,
                      struct err *err) WARN_UNUSED;
void decles_sets_free(struct decles_sets *sets); /* harmless on a zeroed struct */

/* Steps 1 and 2. Refuses a pinned anchor. To be followed by decles_sets_clear in any case. */
bool decles_sets_begin(struct decles_sets *sets, const struct decles_edit *edit,
                       struct err *err) WARN_UNUSED;

/* Step 3: adds points to D, without regard to their types, and their conditions to E. */
bool decles_sets_add(struct decles_sets *sets, const uint32_t *points, size_t n,
                     struct err *err) WARN_UNUSED;

/* Takes the marks away; the lists can be read until the next edit begins. */
void decles_sets_clear(struct decles_sets *sets);

/* Where the points of `fixed` will be: anchors at their new positions; fixed_count x k, row-major.
 * Released by free. */
bool decles_fixed_values(const struct decles_sets *sets, const struct decles_edit *edit,
                         const struct c1_field *values, double **fixed,
                         struct err *err) WARN_UNUSED;

/* The columns of D (derived = true) or of A and F of those conditions for which keep is true (all
 * if it is NULL). Released by decles_matrix_free. */
bool decles_matrix_init(struct int_matrix *m, const struct decles_sets *sets, bool derived,
                        const bool *keep, struct err *err) WARN_UNUSED;
void decles_matrix_free(struct int_matrix *m);

#endif
