/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "obj_points.h"

#include "mem.h"
#include "obj_scan.h"

/* What an index may count: all fit uint32_t, with room for one value that means none. */
enum { COUNT_MAX = INT32_MAX };

static bool add(struct obj_scan *s, double (**array)[3], size_t *cap, size_t *count) {
    if (*count == COUNT_MAX) return obj_fail(s, s->line, "more than %d such lines", COUNT_MAX);
    return mem_grow(*array, cap, *count + 1, &s->err) &&
           obj_numbers(s, "a coordinate", 3, (*array)[(*count)++]);
}

static bool read_all(struct obj_scan *s, struct obj_points *p) {
    size_t vertex_cap = 0, normal_cap = 0;
    enum obj_kind kind;
    while ((kind = obj_next(s)) != OBJ_END) {
        if (kind == OBJ_VERTEX && !(add(s, &p->vertex, &vertex_cap, &p->vertex_count) &&
                                    obj_more_numbers(s, "a weight or colour")))
            return false;
        if (kind == OBJ_NORMAL &&
            !(add(s, &p->normal, &normal_cap, &p->normal_count) && obj_end_line(s)))
            return false;
    }
    return p->vertex_count > 0 || obj_expected(s, s->end, "a vertex line 'v x y z'");
}

bool obj_points_read(struct obj_points *p, const struct filemap *f, struct err *err) {
    struct obj_scan s;
    *p = (struct obj_points){0};
    obj_scan_init(&s, f->name, f->data, f->length);
    if (read_all(&s, p)) return true;
    *err = s.err;
    obj_points_free(p);
    return false;
}

void obj_points_free(struct obj_points *p) {
    free(p->vertex);
    free(p->normal);
    *p = (struct obj_points){0};
}

size_t obj_points_line(const struct filemap *f, size_t i) {
    struct obj_scan s;
    enum obj_kind kind;
    obj_scan_init(&s, f->name, f->data, f->length);
    while ((kind = obj_next(&s)) != OBJ_END)
        if (kind == OBJ_VERTEX && i-- == 0) break;
    return obj_line_number(&s, s.line);
}
