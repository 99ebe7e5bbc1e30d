/* SPDX-License-Identifier: GPL-3.0-or-later */
/* start[] has room for one more than there are lines, for the end of the last. */
#include "polylines.h"

#include "mem.h"

#include <math.h>
#include <string.h>

static bool begin(struct polylines_maker *m, uint32_t name, double value, struct err *err) {
    struct polylines *p = m->p;
    size_t l = p->line_count;
    if (!mem_grow(p->start, &m->start_cap, l + 2, err) ||
        !mem_grow(p->name_of, &m->name_of_cap, l + 1, err) ||
        !mem_grow(p->value, &m->value_cap, l + 1, err))
        return false;
    if (l == 0) {
        p->range[0] = INFINITY;
        p->range[1] = -INFINITY;
    }
    p->start[l] = p->point_count;
    p->name_of[l] = name;
    p->value[l] = value;
    p->line_count++;
    return true;
}

bool polylines_number(struct polylines_maker *m, double label, struct err *err) {
    if (!begin(m, POLYLINES_NO_NAME, label, err)) return false;
    m->p->range[0] = fmin(m->p->range[0], label);
    m->p->range[1] = fmax(m->p->range[1], label);
    return true;
}

bool polylines_word(struct polylines_maker *m, const char *word, size_t length, struct err *err) {
    struct polylines *p = m->p;
    size_t i = 0;
    while (i < p->name_count &&
           (strlen(p->name[i]) != length || memcmp(p->name[i], word, length) != 0))
        i++;
    if (i < p->name_count) return begin(m, (uint32_t)i, 0, err);
    if (i == POLYLINES_NAMES_MAX)
        return err_set(err, ERR_INPUT, "more than %d different labels", POLYLINES_NAMES_MAX);
    if (!mem_grow(p->name, &m->name_cap, i + 1, err)) return false;
    p->name[i] = mem_alloc(length + 1, 1, err);
    if (!p->name[i]) return false;
    memcpy(p->name[i], word, length);
    p->name_count++;
    return begin(m, (uint32_t)i, 0, err);
}

bool polylines_point(struct polylines_maker *m, const double p[2], struct err *err) {
    struct polylines *all = m->p;
    if (!mem_grow(all->point, &m->point_cap, all->point_count + 1, err)) return false;
    memcpy(all->point[all->point_count++], p, sizeof *all->point);
    return true;
}

void polylines_end(struct polylines_maker *m) {
    m->p->start[m->p->line_count] = m->p->point_count;
}

void polylines_free(struct polylines *p) {
    for (size_t i = 0; i < p->name_count; i++) free(p->name[i]);
    free(p->name);
    free(p->start);
    free(p->point);
    free(p->name_of);
    free(p->value);
    *p = (struct polylines){0};
}
