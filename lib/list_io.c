/* SPDX-License-Identifier: GPL-3.0-or-later */
/* As in obj_copy.c, `done` is how far the text has been dealt with, and what stands between two
 * replacements goes out in one piece. */
#include "list_io.h"

#include "mem.h"

/* What a vertex number must fit, as for OBJ. */
enum { COUNT_MAX = INT32_MAX };

/* Goes to the next line that is a point, and to its first word. */
bool list_next(struct src *src, int columns) {
    while (src_line(src)) {
        if (columns == 3 || !src_take(src, "HOLE")) return true;
        if (!src_end_line(src)) return false;
    }
    return false;
}

static bool read_point(struct src *src, int columns, double x[3]) {
    x[2] = 0;
    return src_double(src, "x of a point", &x[0]) && src_double(src, "y of a point", &x[1]) &&
           (columns == 2 || src_double(src, "z of a point", &x[2]));
}

static bool read_all(struct src *src, int columns, struct obj_points *p) {
    size_t cap = 0;
    while (list_next(src, columns)) {
        if (p->vertex_count == COUNT_MAX)
            return src_fail(src, src->begin, "more than %d points", COUNT_MAX);
        if (!mem_grow(p->vertex, &cap, p->vertex_count + 1, &src->err) ||
            !read_point(src, columns, p->vertex[p->vertex_count]))
            return false;
        p->vertex_count++;
    }
    if (src->err.kind) return false;
    return p->vertex_count > 0 || src_expected(src, columns == 2 ? "a point x y" : "a point x y z");
}

bool list_read(struct obj_points *p, const struct filemap *f, int columns, struct err *err) {
    struct src src;
    *p = (struct obj_points){0};
    src_open_text(&src, f->name, f->data, f->length);
    if (read_all(&src, columns, p)) return true;
    *err = src.err;
    obj_points_free(p);
    return false;
}

size_t list_line(const struct filemap *f, int columns, size_t i) {
    struct src src;
    src_open_text(&src, f->name, f->data, f->length);
    while (list_next(&src, columns) && i > 0) i--;
    return src.line;
}

void list_copier_begin(struct list_copier *k, struct out *out, const struct filemap *f,
                       int columns) {
    *k = (struct list_copier){.out = out, .columns = columns, .done = f->data};
    k->end = f->data + f->length;
    src_open_text(&k->src, f->name, f->data, f->length);
}

bool list_copier_next(struct list_copier *k) {
    return list_next(&k->src, k->columns);
}

void list_copier_cut(struct list_copier *k, const char *begin, const char *end) {
    out_bytes(k->out, k->done, (size_t)(begin - k->done));
    k->done = end;
}

bool list_copier_end(struct list_copier *k, struct err *err) {
    if (list_copier_next(k) || k->src.err.kind)
        return err_set(err, ERR_INPUT, "%s was changed while it was read", k->src.name);
    list_copier_cut(k, k->end, k->end);
    return true;
}

static void put_point(struct list_copier *k, const struct list_change *change, size_t i) {
    const char *word;
    size_t length;
    for (int c = 0; c < change->columns && src_word(&k->src, &word, &length); c++) {
        list_copier_cut(k, word, word + length);
        out_double(k->out, change->point[i][c], change->digits);
    }
    if (!change->further) return;
    while (src_word(&k->src, &word, &length)) list_copier_cut(k, word + length, word + length);
    for (int c = 0; c < 5; c++) {
        out_char(k->out, ' ');
        out_double(k->out, change->further[i][c], change->digits);
    }
}

bool list_copy(struct out *out, const struct filemap *f, size_t count,
               const struct list_change *change, struct err *err) {
    struct list_copier k;
    size_t i = 0;
    list_copier_begin(&k, out, f, change->columns);
    while (i < count && list_copier_next(&k)) put_point(&k, change, i++);
    if (i == count) return list_copier_end(&k, err);
    return err_set(err, ERR_INPUT, "%s was changed while it was read", f->name);
}
