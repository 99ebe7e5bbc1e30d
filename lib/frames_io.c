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

static bool read_frame(struct src *src, int to, struct frame *frame) {
    *frame = (struct frame){.input = NULL};
    if (!read_name(src, "an input's file", &frame->input) ||
        !read_name(src, "a picture's file", &frame->picture) || !src_end_line(src))
        return false;
    if (image_output_format(to, frame->picture, &frame->format, &src->err)) return true;
    src->err.kind = ERR_INPUT; /* of the list, not of the command line */
    return err_place(&src->err, src->name, src->line, 0);
}

static bool read_all(struct src *src, int to, struct frames *f) {
    size_t cap = 0;
    while (src_line(src))
        if (!mem_grow(f->frame, &cap, f->count + 1, &src->err) ||
            !read_frame(src, to, &f->frame[f->count++]))
            return false;
    if (src->err.kind) return false;
    return f->count > 0 || src_expected(src, "a line 'INPUT PICTURE'");
}

bool frames_read(struct frames *f, const char *path, int to, struct err *err) {
    struct src src;
    bool ok;
    *f = (struct frames){0};
    if (!src_open(&src, path, err)) return false;
    ok = read_all(&src, to, f);
    if (!ok) {
        *err = src.err;
        frames_free(f);
    }
    src_close(&src);
    return ok;
}

void frames_free(struct frames *f) {
    for (size_t i = 0; i < f->count; i++) {
        free(f->frame[i].input);
        free(f->frame[i].picture);
    }
    free(f->frame);
    *f = (struct frames){0};
}

bool frames_make(const char *path, int to, frames_maker *make, void *context, struct err *err) {
    struct frames f;
    bool ok = frames_read(&f, path, to, err);
    for (size_t i = 0; ok && i < f.count; i++)
        ok = make(context, f.frame[i].input, f.frame[i].picture, f.frame[i].format, err);
    frames_free(&f);
    return ok;
}
