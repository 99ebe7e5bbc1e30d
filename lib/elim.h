/* SPDX-License-Identifier: GPL-3.0-or-later */
/* elim - sparse elimination of an integer matrix modulo a prime, with a log of what was done.
 *
 * Row operations R <- R - f P make every row either a pivot row P, the only one left with an entry
 * in its pivot column, or zero: a dependent row. The log gives the combination of original rows
 * that a zero row is. Beside each residue goes its real value in double precision, rows scaled to
 * 1, which only guides the choice of pivots: |f| <= 2 in real numbers, so that no row is dropped
 * that the others determine badly. */
#ifndef ELIM_H
#define ELIM_H

#include "modp.h"
#include "sparse.h"

struct elim_entry {
    uint64_t value;
    double real;
    uint32_t col;
};

struct elim_row {
    size_t start; /* its entries: n of them, with room for `room`, in elim.entry */
    uint32_t n, room;
    uint32_t op;   /* newest operation on this row, an index into elim.op */
    uint32_t seen; /* mark: a column + 1 while rows of a column are collected */
    uint32_t mark; /* mark: member of the set that elim_reach found last */
    bool active;
};

struct elim_col {
    uint32_t node;       /* list of rows that have or had an entry here */
    uint32_t count;      /* active rows that have an entry here */
    uint32_t next, prev; /* columns of equal count */
    uint32_t place;      /* index + 1 in the row that is being changed */
};

struct elim_node {
    uint32_t row, next;
};

struct elim_op { /* its row <- its row - factor * (row `pivot`) */
    uint64_t factor;
    uint32_t pivot, next; /* next: the operation before it on the same row */
};

struct elim_hit { /* an entry of the pivot column: row, and index in the row */
    uint32_t row, index;
};

struct elim_pivot {
    uint32_t row, col;
};

struct elim {
    struct modp m;
    size_t rows, cols;
    size_t rank, dependent_count;
    struct elim_pivot *pivot; /* rank of them, in the order of elimination */
    uint32_t *dependent;      /* rows that became zero, in this order */
    uint64_t *pivot_value;    /* by row */
    uint64_t *weight;         /* by row; 0 between calls */
    /* working memory */
    struct elim_row *row;
    struct elim_col *col;
    struct elim_entry *entry;
    struct elim_node *node;
    struct elim_op *op;
    struct elim_hit *hit;
    uint32_t *bucket, *stack;
    size_t entries, nodes, ops, hits, lightest;
    size_t pivot_cap, dependent_cap, pivot_value_cap, weight_cap, row_cap, col_cap;
    size_t entry_cap, node_cap, op_cap, hit_cap, bucket_cap, stack_cap;
    uint32_t mark;
};

/* Eliminates a (no row without entries) modulo m; fills rank, pivot, dependent. The struct starts
 * zeroed and can be used again and again. */
bool elim_run(struct elim *e, const struct int_matrix *a, struct modp m,
              struct err *err) WARN_UNUSED;

/* The same pivots once more, for another prime; *good = false if one of them vanishes. */
bool elim_replay(struct elim *e, const struct int_matrix *a, struct modp m, bool *good,
                 struct err *err) WARN_UNUSED;

/* The rows that the log combines into row r: fills order (room for rank + 1), r first and each row
 * before the pivot rows that it used; returns their number. */
size_t elim_reach(struct elim *e, uint32_t r, uint32_t *order);

/* With an order from elim_reach, fills y[i] with the residue of the combination: sum over i of y[i]
 * * (row order[i]) = 0, y[0] = 1; and *det with the determinant, up to a sign that depends on the
 * pivots only, of the other rows in their pivot columns. False if the combination leaves `order`:
 * that happens after a replay, when the first prime divided an entry by bad luck. */
bool elim_combine(struct elim *e, const uint32_t *order, size_t n, uint64_t *y, uint64_t *det);

void elim_free(struct elim *e);

#endif
