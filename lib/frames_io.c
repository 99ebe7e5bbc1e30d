/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "frames_io.h"

#include "mem.h"
#include "src.h"

#include <string.h>

static bool read_name(struct src *src, const char *what, char **name) {
    const char *word;
    size_t length;
    if (src_take(src, "-")) return src_fail(src, NULL, "expected names of files, got '-'");
    if (!src_word(src, &word, &length)) return src_expected(src, what);
    if (memchr(word, 0, length)) return src_fail(src, word, "expected %s, got a NUL byte", what);
    if (!mem_new(*name, length + 1, &src->err)) return false;
    memcpy(*name, word, length);
    return true;
}

static bool read_all(struct src *src, struct frames *f) {
    size_t cap = 0;
    while (src_line(src)) {
        struct frame *frame;
        if (!mem_grow(f->frame, &cap, f->count + 1, &src->err)) return false;
        frame = &f->frame[f->count++];
        *frame = (struct frame){.line = src->line};
        if (!read_name(src, "a grid's file", &frame->grid) ||
            !read_name(src, "a picture's file", &frame->picture) || !src_end_line(src))
            return false;
    }
    if (src->err.kind) return false;
    return f->count > 0 || src_expected(src, "a line 'GRID PICTURE'");
}

bool frames_read(struct frames *f, const char *path, struct err *err) {
    struct src src;
    bool ok;
    *f = (struct frames){0};
    if (!src_open(&src, path, err)) return false;
    ok = read_all(&src, f);
    if (!ok) {
        *err = src.err;
        frames_free(f);
    }
    src_close(&src);
    return ok;
}

void frames_free(struct frames *f) {
    for (size_t i = 0; i < f->count; i++) {
        free(f->frame[i].grid);
        free(f->frame[i].picture);
    }
    free(f->frame);
    *f = (struct frames){0};
}
