/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row with a column of its own has y = 0 in every relation y.A = 0, so it is independent of the
 * others and can be set aside; that may leave other rows with a column of their own. Of the
 * conditions of a C1 grid, the middle ones go first (their extremes lie in no other condition),
 * then those of ring 2; what cannot be set aside falls into small cores around the vertices,
 * without common columns:
 *
 *      x . .  .  .         a column that is left knows the number of its rows and the exclusive or
 *      x x .  .  .         of their numbers: when the number is 1, that is the row itself, and no
 *      . x [x x] .         lists are needed
 *      . . [x x] .
 *
 * Relations exist only inside a core; relation.h finds them. */
#include "exact.h"

#include "mem.h"
#include "relation.h"

struct peel_col {
    uint32_t count, rows; /* rows that are left with an entry here, the exclusive or of them */
};

struct peeling {
    struct peel_col *col;
    uint32_t *stack;  /* columns that have had a single row, each once */
    size_t left;      /* rows that are left */
    uint32_t *row_of; /* rows that are left, by column: from first[c] on, col[c].count of them */
    size_t *first;
    uint32_t *local; /* by column: number in its core + 1 */
    uint32_t *queue; /* rows that are left, core by core */
    bool *queued;    /* by row */
};

struct cores {
    struct peeling p;
    struct int_matrix core; /* the core at hand, columns numbered anew */
    size_t start_cap, col_cap, value_cap;
    struct relation_finder finder;
    struct relation_list list;
};

/* ---- rows with a column of their own ---- */

static void set_aside(struct peeling *p, const struct int_matrix *a, uint32_t r, size_t *depth) {
    for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
        struct peel_col *col = &p->col[a->col[i]];
        col->rows ^= r;
        if (--col->count == 1) p->stack[(*depth)++] = a->col[i];
    }
}

/* Marks the rows that can be set aside as independent. */
static bool peel(struct peeling *p, const struct int_matrix *a, bool *independent,
                 struct err *err) {
    size_t depth = 0;
    if (!mem_new(p->col, a->cols, err) || !mem_new(p->stack, a->cols, err)) return false;
    for (uint32_t r = 0; r < a->rows; r++) {
        p->left += a->start[r] < a->start[r + 1];
        for (size_t i = a->start[r]; i < a->start[r + 1]; i++) {
            INVARIANT(a->col[i] < a->cols && a->value[i] != 0);
            p->col[a->col[i]].count++;
            p->col[a->col[i]].rows ^= r;
        }
    }
    for (uint32_t c = 0; c < a->cols; c++)
        if (p->col[c].count == 1) p->stack[depth++] = c;
    while (depth > 0) {
        const struct peel_col *col = &p->col[p->stack[--depth]];
        uint32_t r = col->rows;
        if (col->count == 0) continue; /* its row went by another column */
        independent[r] = true;
        p->left--;
        set_aside(p, a, r, &depth);
    }
    return true;
}

/* ---- cores ---- */

static bool is_left(const struct int_matrix *a, const bool *independent, uint32_t r) {
    return !independent[r] && a->start[r] < a->start[r + 1];
}

/* Lists the rows that are left by columns. */
static bool list_rows(struct peeling *p, const struct int_matrix *a, const bool *independent,
                      struct err *err) {
    size_t total = 0;
    if (!mem_new(p->first, a->cols + 1, err)) return false;
    for (uint32_t c = 0; c < a->cols; c++) p->first[c] = total += p->col[c].count;
    if (!mem_new(p->row_of, total, err) || !mem_new(p->local, a->cols, err) ||
        !mem_new(p->queue, p->left, err) || !mem_new(p->queued, a->rows, err))
        return false;
    for (uint32_t r = (uint32_t)a->rows; r-- > 0;) {
        if (!is_left(a, independent, r)) continue;
        for (size_t i = a->start[r]; i < a->start[r + 1]; i++) p->row_of[--p->first[a->col[i]]] = r;
    }
    return true;
}

/* Appends row r to the core at hand, and its neighbours to the queue. */
static bool add_row(struct cores *s, const struct int_matrix *a, uint32_t r, size_t *queued,
                    struct err *err) {
    struct int_matrix *core = &s->core;
    size_t n = core->start[core->rows], more = a->start[r + 1] - a->start[r];
    if (!mem_grow(core->start, &s->start_cap, core->rows + 2, err) ||
        !mem_grow(core->col, &s->col_cap, n + more, err) ||
        !mem_grow(core->value, &s->value_cap, n + more, err))
        return false;
    for (size_t i = a->start[r]; i < a->start[r + 1]; i++, n++) {
        uint32_t c = a->col[i];
        const uint32_t *row = s->p.row_of + s->p.first[c];
        if (s->p.local[c] == 0) {
            s->p.local[c] = (uint32_t)++core->cols;
            for (uint32_t k = 0; k < s->p.col[c].count; k++) {
                if (s->p.queued[row[k]]) continue;
                s->p.queued[row[k]] = true;
                s->p.queue[(*queued)++] = row[k];
            }
        }
        core->col[n] = s->p.local[c] - 1;
        core->value[n] = a->value[i];
    }
    core->start[++core->rows] = n;
    return true;
}

/* Collects the core of row r, breadth first, and finds its relations. */
static bool do_core(struct cores *s, const struct int_matrix *a, uint32_t r, size_t *queued,
                    struct err *err) {
    size_t begin = *queued;
    s->core.rows = s->core.cols = 0;
    if (!mem_grow(s->core.start, &s->start_cap, 1, err)) return false;
    s->core.start[0] = 0;
    s->p.queued[r] = true;
    s->p.queue[(*queued)++] = r;
    for (size_t k = begin; k < *queued; k++)
        if (!add_row(s, a, s->p.queue[k], queued, err)) return false;
    return relation_find(&s->finder, &s->core, s->p.queue + begin, &s->list, err);
}

/* A row of zeros: 1 * row = 0. */
static bool add_zero_row(struct relation_list *list, uint32_t r, struct err *err) {
    struct exact_relation *relation = relation_append(list, 1, err);
    if (!relation) return false;
    relation->dependent = relation->row[0] = r;
    mpz_set_ui(relation->y[0], 1);
    return true;
}

static bool find_relations(struct cores *s, const struct int_matrix *a, const bool *independent,
                           struct err *err) {
    size_t queued = 0;
    if (s->p.left > 0 && !list_rows(&s->p, a, independent, err)) return false;
    for (uint32_t r = 0; r < a->rows; r++) {
        if (a->start[r] == a->start[r + 1]) {
            if (!add_zero_row(&s->list, r, err)) return false;
        } else if (!independent[r] && !s->p.queued[r]) {
            if (!do_core(s, a, r, &queued, err)) return false;
        }
    }
    return true;
}

/* ---- the whole ---- */

static int by_dependent(const void *a, const void *b) {
    size_t r = ((const struct exact_relation *)a)->dependent;
    size_t s = ((const struct exact_relation *)b)->dependent;
    return r < s ? -1 : r > s;
}

static void conclude(struct exact_rows *e, const struct int_matrix *a,
                     const struct relation_list *list) {
    if (list->n > 0) qsort(list->relation, list->n, sizeof *list->relation, by_dependent);
    e->relation = list->relation;
    e->relation_count = list->n;
    e->rank = a->rows - list->n;
    for (size_t r = 0; r < a->rows; r++) e->independent[r] = true;
    for (size_t i = 0; i < list->n; i++) e->independent[list->relation[i].dependent] = false;
}

static void cores_free(struct cores *s) {
    free(s->p.col);
    free(s->p.stack);
    free(s->p.row_of);
    free(s->p.first);
    free(s->p.local);
    free(s->p.queue);
    free(s->p.queued);
    free(s->core.start);
    free(s->core.col);
    free(s->core.value);
    relation_finder_free(&s->finder);
}

bool exact_rows_init(struct exact_rows *e, const struct int_matrix *a, struct err *err) {
    struct cores s = {0};
    bool ok;
    *e = (struct exact_rows){0};
    if (a->rows >= UINT32_MAX || a->cols >= UINT32_MAX) return err_memory(err);
    ok = mem_new(e->independent, a->rows, err) && peel(&s.p, a, e->independent, err) &&
         find_relations(&s, a, e->independent, err);
    if (ok) {
        conclude(e, a, &s.list);
    } else {
        relation_cut(&s.list, 0);
        free(s.list.relation);
        exact_rows_free(e);
    }
    cores_free(&s);
    return ok;
}

void exact_rows_free(struct exact_rows *e) {
    struct relation_list list = {.relation = e->relation, .n = e->relation_count};
    relation_cut(&list, 0);
    free(list.relation);
    free(e->independent);
    *e = (struct exact_rows){0};
}
