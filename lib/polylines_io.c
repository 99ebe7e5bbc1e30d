/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "polylines_io.h"

#include "num.h"
#include "src.h"

#include <string.h>

struct reader {
    struct src src;
    struct polylines_maker maker;
    bool open; /* a polyline has begun */
};

static bool is_number(const char *word, size_t length, double *x) {
    const char *next;
    return num_read(word, word + length, x, &next) == NUM_OK && next == word + length;
}

/* The label is what follows the coordinates, if anything does. */
static bool begin_line(struct reader *r) {
    struct src *src = &r->src;
    struct err err = {0};
    const char *word;
    size_t length;
    double value = 0;
    r->open = true;
    if (!src_word(src, &word, &length) || is_number(word, length, &value))
        return polylines_number(&r->maker, value, &src->err);
    if (memchr(word, 0, length)) return src_fail(src, word, "expected a label, got a NUL byte");
    return polylines_word(&r->maker, word, length, &err) || src_fail(src, word, "%s", err.message);
}

static bool read_point(struct reader *r) {
    struct src *src = &r->src;
    double p[2];
    return src_double(src, "x", &p[0]) && src_double(src, "y", &p[1]) &&
           (r->open || begin_line(r)) && polylines_point(&r->maker, p, &src->err);
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
    if (r->maker.p->point_count == 0) return src_expected(src, "a point");
    polylines_end(&r->maker);
    return true;
}

bool polylines_read(struct polylines *p, const char *path, struct err *err) {
    struct reader r = {.maker = {.p = p}};
    bool ok;
    *p = (struct polylines){0};
    if (!src_open(&r.src, path, err)) return false;
    ok = read_all(&r);
    if (!ok) {
        *err = r.src.err;
        polylines_free(p);
    }
    src_close(&r.src);
    return ok;
}

void polylines_write(struct out *out, const struct polylines *p, int digits) {
    for (size_t l = 0; l < p->line_count; l++) {
        if (l > 0) out_char(out, '\n');
        for (size_t i = p->start[l]; i < p->start[l + 1]; i++) {
            out_double(out, p->point[i][0], digits);
            out_char(out, ' ');
            out_double(out, p->point[i][1], digits);
            out_char(out, ' ');
            if (p->name_of[l] == POLYLINES_NO_NAME)
                out_double(out, p->value[l], digits);
            else
                out_text(out, p->name[p->name_of[l]]);
            out_char(out, '\n');
        }
    }
}
