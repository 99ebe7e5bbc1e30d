/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pivot column: one with the fewest active rows. Pivot row: among those whose real value there is
 * at least half of the largest, the shortest. All active rows with an entry in the pivot column are
 * changed, the pivot row retires.
 *
 * Rows are arrays in one pool; a row that outgrows its room moves to the end of the pool. A column
 * lists the rows that got an entry there at any time; those that lost it are skipped. Columns of
 * equal count form doubly linked lists, so that the lightest is found in O(1). To add a pivot row
 * to a row, the row's entries are announced in col.place; what P has and R has not is fill.
 *
 * Undoing the log: with the weights y of the rows in their present state, an operation R <- R - f P
 * turns y_R R into y_R R - f y_R P, P being the pivot row in its final state. So rows are visited
 * from the dependent one towards older pivots, each after all rows that used it. */
#include "elim.h"

#include "mem.h"

static const uint32_t NONE = UINT32_MAX;

/* ---- columns by count ---- */

static void link_col(struct elim *e, uint32_t c) {
    struct elim_col *col = &e->col[c];
    uint32_t head = e->bucket[col->count];
    col->prev = NONE;
    col->next = head;
    if (head != NONE) e->col[head].prev = c;
    e->bucket[col->count] = c;
    if (col->count < e->lightest) e->lightest = col->count;
}

static void unlink_col(struct elim *e, uint32_t c) {
    const struct elim_col *col = &e->col[c];
    if (col->next != NONE) e->col[col->next].prev = col->prev;
    if (col->prev != NONE)
        e->col[col->prev].next = col->next;
    else
        e->bucket[col->count] = col->next;
}

static void lighten(struct elim *e, uint32_t c) {
    unlink_col(e, c);
    e->col[c].count--;
    link_col(e, c);
}

/* Bucket 0 holds the columns that are done with. */
static uint32_t lightest_col(struct elim *e) {
    if (e->lightest == 0) e->lightest = 1;
    while (e->lightest <= e->rows && e->bucket[e->lightest] == NONE) e->lightest++;
    return e->lightest <= e->rows ? e->bucket[e->lightest] : NONE;
}

/* ---- loading ---- */

static bool make_room(struct elim *e, const struct int_matrix *a, struct err *err) {
    size_t m = a->rows, n = a->cols, nnz = a->start[m];
    if (m >= NONE || n >= NONE || nnz >= NONE) return err_memory(err);
    return mem_grow(e->row, &e->row_cap, m, err) && mem_grow(e->col, &e->col_cap, n, err) &&
           mem_grow(e->pivot, &e->pivot_cap, m, err) &&
           mem_grow(e->dependent, &e->dependent_cap, m, err) &&
           mem_grow(e->pivot_value, &e->pivot_value_cap, m, err) &&
           mem_grow(e->weight, &e->weight_cap, m, err) &&
           mem_grow(e->stack, &e->stack_cap, m, err) && mem_grow(e->hit, &e->hit_cap, m, err) &&
           mem_grow(e->bucket, &e->bucket_cap, m + 1, err) &&
           mem_grow(e->entry, &e->entry_cap, nnz, err) && mem_grow(e->node, &e->node_cap, nnz, err);
}

static void list_row(struct elim *e, uint32_t c, uint32_t r) {
    e->node[e->nodes] = (struct elim_node){.row = r, .next = e->col[c].node};
    e->col[c].node = (uint32_t)e->nodes++;
}

static double scale_of(const struct int_matrix *a, size_t r) {
    int64_t largest = 1;
    for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
        int64_t size = a->value[i] < 0 ? -a->value[i] : a->value[i];
        if (size > largest) largest = size;
    }
    return (double)largest;
}

static void load_row(struct elim *e, const struct int_matrix *a, uint32_t r) {
    uint32_t n = (uint32_t)(a->start[r + 1] - a->start[r]), used = 0;
    struct elim_entry *entry = e->entry + e->entries;
    double scale = scale_of(a, r);
    for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
        entry[used++] = (struct elim_entry){.value = modp_of_int(e->m, a->value[i]),
                                            .real = (double)a->value[i] / scale,
                                            .col = a->col[i]};
        e->col[a->col[i]].count++;
        list_row(e, a->col[i], r);
    }
    e->row[r] =
        (struct elim_row){.start = e->entries, .n = used, .room = n, .op = NONE, .active = true};
    e->entries += n;
    e->weight[r] = 0;
}

static bool load(struct elim *e, const struct int_matrix *a, struct modp m, struct err *err) {
    if (!make_room(e, a, err)) return false;
    e->m = m;
    e->rows = a->rows;
    e->cols = a->cols;
    e->entries = e->nodes = e->ops = 0;
    e->mark = 0;
    for (uint32_t c = 0; c < a->cols; c++) e->col[c] = (struct elim_col){.node = NONE};
    for (uint32_t r = 0; r < a->rows; r++) load_row(e, a, r);
    for (size_t k = 0; k <= a->rows; k++) e->bucket[k] = NONE;
    e->lightest = a->rows + 1;
    for (uint32_t c = 0; c < a->cols; c++) link_col(e, c);
    return true;
}

/* ---- one pivot ---- */

static uint32_t find(const struct elim *e, uint32_t r, uint32_t c) {
    const struct elim_entry *entry = e->entry + e->row[r].start;
    for (uint32_t i = 0; i < e->row[r].n; i++)
        if (entry[i].col == c) return i;
    return NONE;
}

/* The active rows with an entry in column c. */
static void collect(struct elim *e, uint32_t c) {
    e->hits = 0;
    for (uint32_t k = e->col[c].node; k != NONE; k = e->node[k].next) {
        uint32_t r = e->node[k].row, i;
        if (!e->row[r].active || e->row[r].seen == c + 1) continue;
        e->row[r].seen = c + 1; /* an entry that came twice is listed twice */
        i = find(e, r, c);
        if (i != NONE) e->hit[e->hits++] = (struct elim_hit){r, i};
    }
}

static double size_of(const struct elim *e, struct elim_hit h) {
    double x = e->entry[e->row[h.row].start + h.index].real;
    return x < 0 ? -x : x;
}

static uint32_t choose_row(const struct elim *e) {
    double largest = 0;
    uint32_t best = NONE;
    for (size_t i = 0; i < e->hits; i++)
        if (size_of(e, e->hit[i]) > largest) largest = size_of(e, e->hit[i]);
    for (size_t i = 0; i < e->hits; i++) {
        uint32_t r = e->hit[i].row;
        if (size_of(e, e->hit[i]) < largest / 2) continue;
        if (best == NONE || e->row[r].n < e->row[best].n ||
            (e->row[r].n == e->row[best].n && r < best))
            best = r;
    }
    return best;
}

static bool log_op(struct elim *e, uint32_t r, uint32_t pivot, uint64_t factor, struct err *err) {
    if (e->ops >= NONE) return err_memory(err);
    if (!mem_grow(e->op, &e->op_cap, e->ops + 1, err)) return false;
    e->op[e->ops] = (struct elim_op){.factor = factor, .pivot = pivot, .next = e->row[r].op};
    e->row[r].op = (uint32_t)e->ops++;
    return true;
}

/* Makes room for `fill` more entries in row r, and as many list nodes. */
static bool widen(struct elim *e, uint32_t r, uint32_t fill, struct err *err) {
    struct elim_row *row = &e->row[r];
    size_t need = (size_t)row->n + fill, room = need + need / 2;
    if (e->nodes + fill >= NONE) return err_memory(err);
    if (!mem_grow(e->node, &e->node_cap, e->nodes + fill, err)) return false;
    if (need <= row->room) return true;
    if (room > e->cols) room = e->cols;
    if (!mem_grow(e->entry, &e->entry_cap, e->entries + room, err)) return false;
    for (uint32_t i = 0; i < row->n; i++) e->entry[e->entries + i] = e->entry[row->start + i];
    row->start = e->entries;
    row->room = (uint32_t)room;
    e->entries += room;
    return true;
}

/* Announces the entries of r in col.place; returns how many of p's have no counterpart. */
static uint32_t announce(struct elim *e, uint32_t r, uint32_t p) {
    const struct elim_entry *mine = e->entry + e->row[r].start;
    const struct elim_entry *theirs = e->entry + e->row[p].start;
    uint32_t fill = 0;
    for (uint32_t i = 0; i < e->row[r].n; i++) e->col[mine[i].col].place = i + 1;
    for (uint32_t i = 0; i < e->row[p].n; i++) fill += e->col[theirs[i].col].place == 0;
    return fill;
}

/* Forgets the announcements of r and drops its zeros. */
static void compress(struct elim *e, uint32_t r) {
    struct elim_row *row = &e->row[r];
    struct elim_entry *entry = e->entry + row->start;
    uint32_t kept = 0;
    for (uint32_t i = 0; i < row->n; i++) {
        e->col[entry[i].col].place = 0;
        if (entry[i].value == 0)
            lighten(e, entry[i].col);
        else
            entry[kept++] = entry[i];
    }
    row->n = kept;
}

/* R <- R - f P; `real` is f in real numbers. */
static bool subtract(struct elim *e, uint32_t r, uint32_t p, uint64_t f, double real,
                     struct err *err) {
    struct elim_row *row = &e->row[r];
    struct elim_entry *mine;
    const struct elim_entry *theirs;
    if (!widen(e, r, announce(e, r, p), err)) return false;
    mine = e->entry + row->start;
    theirs = e->entry + e->row[p].start;
    for (uint32_t i = 0; i < e->row[p].n; i++) {
        uint32_t c = theirs[i].col, place = e->col[c].place;
        if (place == 0) {
            mine[row->n++] = (struct elim_entry){.col = c};
            place = row->n;
            list_row(e, c, r);
            unlink_col(e, c);
            e->col[c].count++;
            link_col(e, c);
        }
        mine[place - 1].value =
            modp_sub(e->m, mine[place - 1].value, modp_mul(e->m, f, theirs[i].value));
        mine[place - 1].real -= real * theirs[i].real;
    }
    compress(e, r);
    return log_op(e, r, p, f, err);
}

/* Row p, with its entry in column c, retires and clears that column in the collected rows. */
static bool eliminate(struct elim *e, uint32_t p, uint32_t c, struct err *err) {
    struct elim_entry head = e->entry[e->row[p].start + find(e, p, c)];
    uint64_t inverse = e->hits > 1 ? modp_inverse(e->m, head.value) : 0;
    e->row[p].active = false;
    e->pivot_value[p] = head.value;
    for (uint32_t i = 0; i < e->row[p].n; i++) lighten(e, e->entry[e->row[p].start + i].col);
    for (size_t i = 0; i < e->hits; i++) {
        uint32_t r = e->hit[i].row;
        struct elim_entry mine;
        if (r == p) continue;
        mine = e->entry[e->row[r].start + e->hit[i].index];
        if (!subtract(e, r, p, modp_mul(e->m, mine.value, inverse),
                      head.real != 0 ? mine.real / head.real : 0, err))
            return false;
    }
    return true;
}

/* ---- the whole ---- */

/* Rows that the last pivot has made zero. */
static void retire_zero_rows(struct elim *e, bool record) {
    for (size_t i = 0; i < e->hits; i++) {
        uint32_t r = e->hit[i].row;
        if (!e->row[r].active || e->row[r].n > 0) continue;
        e->row[r].active = false;
        if (record) e->dependent[e->dependent_count++] = r;
    }
}

bool elim_run(struct elim *e, const struct int_matrix *a, struct modp m, struct err *err) {
    uint32_t c;
    if (!load(e, a, m, err)) return false;
    e->rank = e->dependent_count = 0;
    while ((c = lightest_col(e)) != NONE) {
        uint32_t p;
        collect(e, c);
        p = choose_row(e);
        e->pivot[e->rank++] = (struct elim_pivot){p, c};
        if (!eliminate(e, p, c, err)) return false;
        retire_zero_rows(e, true);
    }
    INVARIANT(e->rank + e->dependent_count == e->rows);
    return true;
}

bool elim_replay(struct elim *e, const struct int_matrix *a, struct modp m, bool *good,
                 struct err *err) {
    *good = false;
    if (!load(e, a, m, err)) return false;
    for (size_t k = 0; k < e->rank; k++) {
        struct elim_pivot pivot = e->pivot[k];
        if (find(e, pivot.row, pivot.col) == NONE) return true;
        collect(e, pivot.col);
        if (!eliminate(e, pivot.row, pivot.col, err)) return false;
        retire_zero_rows(e, false);
    }
    *good = true;
    return true;
}

/* Depth first; a row is finished, and placed, when all pivot rows that it used are. */
size_t elim_reach(struct elim *e, uint32_t r, uint32_t *order) {
    size_t depth = 0, n = 0;
    uint32_t *next = e->bucket; /* free after elimination; by row: the operation to look at */
    e->mark++;
    e->stack[depth++] = r;
    e->row[r].mark = e->mark;
    next[r] = e->row[r].op;
    while (depth > 0) {
        uint32_t top = e->stack[depth - 1], k = next[top], p;
        if (k == NONE) {
            order[n++] = top;
            depth--;
            continue;
        }
        next[top] = e->op[k].next;
        p = e->op[k].pivot;
        if (e->row[p].mark == e->mark) continue;
        e->row[p].mark = e->mark;
        next[p] = e->row[p].op;
        e->stack[depth++] = p;
    }
    for (size_t i = 0; i < n / 2; i++) {
        uint32_t swap = order[i];
        order[i] = order[n - 1 - i];
        order[n - 1 - i] = swap;
    }
    return n;
}

bool elim_combine(struct elim *e, const uint32_t *order, size_t n, uint64_t *y, uint64_t *det) {
    bool inside = true;
    e->mark++;
    for (size_t i = 0; i < n; i++) e->row[order[i]].mark = e->mark;
    e->weight[order[0]] = 1;
    *det = 1;
    for (size_t i = 0; i < n && inside; i++) {
        uint64_t weight = e->weight[order[i]];
        for (uint32_t k = e->row[order[i]].op; k != NONE && inside; k = e->op[k].next) {
            uint32_t p = e->op[k].pivot;
            inside = e->row[p].mark == e->mark;
            if (inside)
                e->weight[p] =
                    modp_sub(e->m, e->weight[p], modp_mul(e->m, weight, e->op[k].factor));
        }
        if (i > 0) *det = modp_mul(e->m, *det, e->pivot_value[order[i]]);
    }
    for (size_t i = 0; i < n; i++) {
        y[i] = e->weight[order[i]];
        e->weight[order[i]] = 0;
    }
    return inside;
}

void elim_free(struct elim *e) {
    free(e->pivot);
    free(e->dependent);
    free(e->pivot_value);
    free(e->weight);
    free(e->row);
    free(e->col);
    free(e->entry);
    free(e->node);
    free(e->op);
    free(e->hit);
    free(e->bucket);
    free(e->stack);
    *e = (struct elim){0};
}
