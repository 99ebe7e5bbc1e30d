/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays grow with the lines that are read, whatever the count says. */
#include "bary_io.h"

#include "grid_io.h"
#include "mem.h"
#include "record_io.h"

#include <stdio.h>
#include <string.h>

bool bary_key(struct bary_key *key, const struct grid *g, const struct vertices *v,
              struct err *err) {
    *key = (struct bary_key){.model = vertices_checksum(v),
                             .count = (uint32_t)v->points.vertex_count,
                             .triangle_count = g->triangle_count,
                             .has_depth = vertices_projection(v, g).has_depth};
    return grid_checksum(g, &key->domain, err);
}

struct reader {
    struct src src;
    const struct bary_key *key;
    struct bary *bary;
    enum { DEPTH_UNKNOWN, DEPTH_ABSENT, DEPTH_PRESENT } depth;
    size_t place_cap, weight_cap;
};

/* Eight digits of a hexadecimal number, in lower case. */
static bool read_hex(const char *word, size_t length, uint32_t *n) {
    static const char digits[] = "0123456789abcdef";
    *n = 0;
    for (size_t i = 0; i < length; i++) {
        uint32_t d = 0;
        while (d < 16 && digits[d] != word[i]) d++;
        if (d == 16) return false;
        *n = *n << 4 | d;
    }
    return length == 8;
}

/* "NAME CHECKSUM", which must be *expected unless that is NULL. */
static bool read_checksum(struct src *src, const char *name, const char *what,
                          const uint32_t *expected, uint32_t *sum) {
    const char *before, *word;
    char text[96];
    size_t length;
    if (!src_expect(src, name)) return false;
    before = src->at;
    if (!src_word(src, &word, &length) || !read_hex(word, length, sum)) {
        src->at = before;
        return src_expected(src, "a checksum of eight digits 0-9 a-f");
    }
    if (expected && *sum != *expected) {
        src->at = before;
        snprintf(text, sizeof text, "%08x, the checksum of %s", *expected, what);
        return src_expected(src, text);
    }
    return src_end_line(src) && record_next(src);
}

static bool read_count(struct reader *r) {
    const struct bary_key *key = r->key;
    uint32_t *count = &r->bary->key.count;
    if (!key) return record_count(&r->src, "points", "'points'", 1, INT32_MAX, count);
    *count = key->count;
    return src_expect(&r->src, "points") &&
           record_exact_count(&r->src, "points", *count, "the number of vertices of the model");
}

/* "- x y z"; outside there is nothing to be checked. */
static bool read_outside(struct src *src, struct place *place) {
    place->triangle = GRID_NONE;
    return src_double(src, "x of a vertex outside", &place->b[0]) &&
           src_double(src, "y of a vertex outside", &place->b[1]) &&
           src_double(src, "z of a vertex outside", &place->b[2]);
}

static bool in_unit_interval(double x) {
    return x >= 0 && x <= 1;
}

/* n numbers in [0,1]. */
static bool read_weights(struct src *src, const char *what, int n, double *x) {
    for (int i = 0; i < n; i++) {
        const char *before = src->at;
        if (!src_double(src, what, &x[i])) return false;
        if (!in_unit_interval(x[i])) {
            src->at = before;
            return src_expected(src, what);
        }
    }
    return true;
}

/* "t b0 b1 b2" */
static bool read_inside(struct reader *r, struct place *place) {
    struct src *src = &r->src;
    int64_t t = 0;
    int64_t last = r->key ? (int64_t)r->key->triangle_count - 1 : GRID_NONE - 1;
    const char *coordinates;
    double *b = place->b;
    if (!src_int(src, "'-' or a triangle", 0, last, &t)) return false;
    place->triangle = (uint32_t)t;
    coordinates = src->at;
    if (!read_weights(src, "a barycentric coordinate in 0..1", 3, b)) return false;
    if (b[0] + b[1] + b[2] == 1) return true;
    return src_fail(src, coordinates + 1,
                    "expected barycentric coordinates whose sum is 1, got %.17g",
                    b[0] + b[1] + b[2]);
}

static bool has_word(const struct src *src) {
    struct src scan = *src;
    const char *word;
    size_t length;
    return src_word(&scan, &word, &length);
}

/* "a0 a1", where there is depth. */
static bool read_depth(struct reader *r, size_t i) {
    struct bary *bary = r->bary;
    if (r->depth == DEPTH_UNKNOWN) r->depth = has_word(&r->src) ? DEPTH_PRESENT : DEPTH_ABSENT;
    if (r->depth == DEPTH_ABSENT) return true;
    return mem_grow(bary->weight, &r->weight_cap, i + 1, &r->src.err) &&
           read_weights(&r->src, "a weight of the depth in 0..1", 2, bary->weight[i]);
}

static bool read_point(struct reader *r, size_t i) {
    struct src *src = &r->src;
    if (!mem_grow(r->bary->place, &r->place_cap, i + 1, &src->err)) return false;
    if (src_take(src, "-")) {
        if (!read_outside(src, &r->bary->place[i])) return false;
        if (r->bary->outside++ == 0) r->bary->first = i;
    } else if (!read_inside(r, &r->bary->place[i]) || !read_depth(r, i)) {
        return false;
    }
    return src_end_line(src) && record_next(src);
}

static bool read_all(struct reader *r) {
    struct src *src = &r->src;
    struct bary *bary = r->bary;
    const struct bary_key *key = r->key;
    char expected[64];
    if (!record_first(src, "bary", &bary->history) ||
        !read_checksum(src, "domain", "the grid's domain", key ? &key->domain : NULL,
                       &bary->key.domain) ||
        !read_checksum(src, "model", "the model's vertices",
                       key && !key->any_model ? &key->model : NULL, &bary->key.model) ||
        !read_count(r))
        return false;
    for (size_t i = 0; i < bary->key.count; i++)
        if (!read_point(r, i)) return false;
    bary->key.has_depth = r->depth == DEPTH_PRESENT;
    snprintf(expected, sizeof expected, "'end' after %u points", bary->key.count);
    return record_end(src, expected);
}

bool bary_read(struct bary *bary, const char *path, const struct bary_key *key, struct err *err) {
    struct reader r = {.key = key, .bary = bary};
    bool ok;
    *bary = (struct bary){0};
    if (key) {
        bary->key.triangle_count = key->triangle_count;
        r.depth = key->has_depth ? DEPTH_PRESENT : DEPTH_ABSENT;
    }
    if (!src_open(&r.src, path, err)) return false;
    ok = read_all(&r);
    if (!ok) {
        *err = r.src.err;
        bary_free(bary);
    }
    src_close(&r.src);
    return ok;
}

static void write_numbers(struct out *out, const double *x, int n) {
    for (int i = 0; i < n; i++) {
        out_char(out, ' ');
        out_double(out, x[i], 0);
    }
}

void bary_write(struct out *out, const struct bary *bary, const char *added) {
    const struct bary_key *key = &bary->key;
    record_write_first(out, "bary", bary->history, added);
    out_format(out, "domain %08x\nmodel %08x\npoints %u\n", key->domain, key->model, key->count);
    for (size_t i = 0; i < key->count; i++) {
        const struct place *place = &bary->place[i];
        bool inside = place->triangle != GRID_NONE;
        if (inside)
            out_int(out, place->triangle);
        else
            out_char(out, '-');
        write_numbers(out, place->b, 3);
        if (inside && bary->weight) write_numbers(out, bary->weight[i], 2);
        out_char(out, '\n');
    }
    out_text(out, "end\n");
}
