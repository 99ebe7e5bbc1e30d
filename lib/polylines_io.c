/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "polylines_io.h"

#include "mem.h"
#include "num.h"
#include "src.h"

#include <math.h>
#include <string.h>

struct reader {
    struct src src;
    struct polylines *p;
    size_t point_cap, start_cap, name_of_cap, value_cap, name_cap;
    bool open; /* a polyline has begun */
};

static bool find_name(struct reader *r, const char *word, size_t length, uint32_t *index) {
    struct polylines *p = r->p;
    for (size_t i = 0; i < p->name_count; i++)
        if (strlen(p->name[i]) == length && memcmp(p->name[i], word, length) == 0) {
            *index = (uint32_t)i;
            return true;
        }
    if (p->name_count == POLYLINES_NAMES_MAX)
        return src_fail(&r->src, word, "more than %d different labels", POLYLINES_NAMES_MAX);
    if (!mem_grow(p->name, &r->name_cap, p->name_count + 1, &r->src.err)) return false;
    p->name[p->name_count] = mem_alloc(length + 1, 1, &r->src.err);
    if (!p->name[p->name_count]) return false;
    memcpy(p->name[p->name_count], word, length);
    *index = (uint32_t)p->name_count++;
    return true;
}

static bool is_number(const char *word, size_t length, double *x) {
    const char *next;
    return num_read(word, word + length, x, &next) == NUM_OK && next == word + length;
}

/* The label is what follows the coordinates, if anything does. */
static bool begin_line(struct reader *r) {
    struct polylines *p = r->p;
    struct src *src = &r->src;
    const char *word;
    size_t length, l = p->line_count;
    if (!mem_grow(p->start, &r->start_cap, l + 2, &src->err) ||
        !mem_grow(p->name_of, &r->name_of_cap, l + 1, &src->err) ||
        !mem_grow(p->value, &r->value_cap, l + 1, &src->err))
        return false;
    p->start[l] = p->point_count - 1;
    p->name_of[l] = POLYLINES_NO_NAME;
    p->value[l] = 0;
    if (src_word(src, &word, &length) && !is_number(word, length, &p->value[l]) &&
        !find_name(r, word, length, &p->name_of[l]))
        return false;
    if (p->name_of[l] == POLYLINES_NO_NAME) {
        p->range[0] = fmin(p->range[0], p->value[l]);
        p->range[1] = fmax(p->range[1], p->value[l]);
    }
    p->line_count++;
    r->open = true;
    return true;
}

static bool read_point(struct reader *r) {
    struct polylines *p = r->p;
    struct src *src = &r->src;
    if (!mem_grow(p->point, &r->point_cap, p->point_count + 1, &src->err) ||
        !src_double(src, "x", &p->point[p->point_count][0]) ||
        !src_double(src, "y", &p->point[p->point_count][1]))
        return false;
    p->point_count++;
    return r->open || begin_line(r);
}

static bool read_all(struct reader *r) {
    struct src *src = &r->src;
    while (src_raw_line(src)) {
        const char *word;
        size_t length;
        if (src_word(src, &word, &length)) {
            src->at = word;
            if (!read_point(r)) return false;
        } else if (!src->comment)
            r->open = false;
    }
    if (src->err.kind) return false;
    if (r->p->point_count == 0) return src_expected(src, "a point");
    r->p->start[r->p->line_count] = r->p->point_count;
    return true;
}

bool polylines_read(struct polylines *p, const char *path, struct err *err) {
    struct reader r = {.p = p};
    bool ok;
    *p = (struct polylines){.range = {INFINITY, -INFINITY}};
    if (!src_open(&r.src, path, err)) return false;
    ok = read_all(&r);
    if (!ok) {
        *err = r.src.err;
        polylines_free(p);
    }
    src_close(&r.src);
    return ok;
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
