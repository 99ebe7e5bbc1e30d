/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "places_io.h"

#include "list_io.h"
#include "mem.h"
#include "num.h"

#include <stdio.h>

enum { COUNT_MAX = INT32_MAX }; /* as in list_io.c */

static bool read_outside(struct src *src, struct icc_place *place, double x[3]) {
    place->side = ICC_OUTSIDE;
    return src_double(src, "x of a point", &x[0]) && src_double(src, "y of a point", &x[1]);
}

/* The word at `at` is out of range. */
static bool refuse(struct src *src, const char *at, const char *what) {
    src->at = at;
    return src_expected(src, what);
}

/* Any whole number: whether the cage has such a side matters only where t > 0. */
static bool is_side(const char *word, size_t length, int64_t *k) {
    const char *next;
    return num_read_int(word, word + length, k, &next) == NUM_OK && next == word + length &&
           *k >= 0;
}

static bool refuse_side(struct src *src, const char *at, const struct cage *cage) {
    char what[64];
    snprintf(what, sizeof what, "a side number in 0..%zu or -", cage->count - 1);
    return refuse(src, at, what);
}

static bool read_place(struct src *src, const struct cage *cage, struct icc_place *place,
                       double x[3]) {
    const char *first, *second, *third;
    size_t length;
    int64_t k;
    if (src_take(src, "-")) return read_outside(src, place, x);
    if (!src_word(src, &first, &length) || !is_side(first, length, &k))
        return refuse_side(src, first, cage);
    second = src->at;
    if (!src_double(src, "lambda", &place->lambda)) return false;
    third = src->at;
    if (!src_double(src, "t", &place->t)) return false;
    if (!(place->t >= 0 && place->t <= 1)) return refuse(src, third, "t in 0..1");
    if (place->t == 0) {
        *place = (struct icc_place){0, 0, 0};
        return true;
    }
    if (k >= (int64_t)cage->count) return refuse_side(src, first, cage);
    if (!(place->lambda >= 0 && place->lambda <= 1)) return refuse(src, second, "lambda in 0..1");
    place->side = (uint32_t)k;
    cage_from_given(cage, &place->side, &place->lambda);
    return true;
}

static bool read_all(struct src *src, const struct cage *cage, struct places *p) {
    size_t place_cap = 0, point_cap = 0;
    while (list_next(src, 2)) {
        if (p->count == COUNT_MAX)
            return src_fail(src, src->begin, "more than %d lines", COUNT_MAX);
        if (!mem_grow(p->place, &place_cap, p->count + 1, &src->err) ||
            !mem_grow(p->point, &point_cap, p->count + 1, &src->err))
            return false;
        for (int k = 0; k < 3; k++) p->point[p->count][k] = 0;
        if (!read_place(src, cage, &p->place[p->count], p->point[p->count])) return false;
        p->count++;
    }
    if (src->err.kind) return false;
    return p->count > 0 || src_expected(src, "coordinates k lambda t");
}

bool places_read(struct places *p, const struct filemap *f, const struct cage *cage,
                 struct err *err) {
    struct src src;
    *p = (struct places){0};
    src_open_text(&src, f->name, f->data, f->length);
    if (read_all(&src, cage, p)) return true;
    *err = src.err;
    places_free(p);
    return false;
}

void places_free(struct places *p) {
    free(p->place);
    free(p->point);
    *p = (struct places){0};
}

/* Cuts out the next n words, and what stands between them. */
static void cut_words(struct list_copier *k, int n) {
    const char *begin = NULL, *word = NULL;
    size_t length = 0;
    for (int i = 0; i < n && src_word(&k->src, &word, &length); i++)
        if (i == 0) begin = word;
    if (begin) list_copier_cut(k, begin, word + length);
}

static void put_two(struct out *out, double x, double y, int digits) {
    out_double(out, x, digits);
    out_char(out, ' ');
    out_double(out, y, digits);
}

static bool changed(const struct filemap *f, struct err *err) {
    return err_set(err, ERR_INPUT, "%s was changed while it was read", f->name);
}

bool places_name(struct out *out, const struct filemap *f, const struct places *p,
                 const struct cage *cage, int digits, struct err *err) {
    struct list_copier k;
    list_copier_begin(&k, out, f, 2);
    for (size_t i = 0; i < p->count; i++) {
        struct icc_place place = p->place[i];
        if (!list_copier_next(&k)) return changed(f, err);
        if (place.side == ICC_OUTSIDE) {
            list_copier_cut(&k, k.src.at, k.src.at);
            out_text(out, "- ");
            continue;
        }
        if (place.t > 0) cage_to_given(cage, &place.side, &place.lambda);
        cut_words(&k, 2);
        out_int(out, place.side);
        out_char(out, ' ');
        put_two(out, place.lambda, place.t, digits);
    }
    return list_copier_end(&k, err);
}

bool places_ask(struct out *out, const struct filemap *f, const struct places *p, int digits,
                struct err *err) {
    struct list_copier k;
    list_copier_begin(&k, out, f, 2);
    for (size_t i = 0; i < p->count; i++) {
        const char *word;
        size_t length;
        if (!list_copier_next(&k)) return changed(f, err);
        if (p->place[i].side == ICC_OUTSIDE) { /* x and y stay as they are */
            const char *dash = k.src.at;
            if (!src_take(&k.src, "-") || !src_word(&k.src, &word, &length)) return changed(f, err);
            list_copier_cut(&k, dash, word);
            continue;
        }
        cut_words(&k, 3);
        put_two(out, p->point[i][0], p->point[i][1], digits);
    }
    return list_copier_end(&k, err);
}
