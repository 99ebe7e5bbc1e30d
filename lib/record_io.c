/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record_io.h"

#include "mem.h"

#include <stdio.h>
#include <string.h>

bool record_next(struct src *src) {
    return src_line(src) || src->eof;
}

/* A text that grows. */
struct history {
    char **text;
    size_t length, cap;
};

static bool add_line(struct src *src, struct history *h) {
    const char *line = src->comment;
    size_t length = (size_t)(src->raw_end - line), need = h->length + length + 2;
    const char *nul = memchr(line, '\0', length);
    if (nul) return src_fail(src, nul, "expected text, got a NUL byte");
    if (!mem_grow(*h->text, &h->cap, need, &src->err)) return false;
    memcpy(*h->text + h->length, line, length);
    h->length += length + 1;
    (*h->text)[h->length - 1] = '\n';
    (*h->text)[h->length] = '\0';
    return true;
}

bool record_first(struct src *src, const char *name, char **history) {
    struct history h = {.text = history};
    *history = NULL;
    if (!mem_grow(*history, &h.cap, 1, &src->err)) return false;
    **history = '\0';
    if (!record_next(src) || !src_expect(src, name)) return false;
    if (!src_take(src, "1")) return src_expected(src, "version 1");
    if (!src_end_line(src)) return false;
    while (src_raw_line(src)) {
        const char *before = src->at, *word;
        size_t length;
        if (src_word(src, &word, &length)) {
            src->at = before;
            return true;
        }
        if (src->comment && !add_line(src, &h)) return false;
    }
    return src->eof;
}

bool record_count(struct src *src, const char *name, const char *expected, int64_t lo, int64_t hi,
                  uint32_t *count) {
    char what[64];
    int64_t n = 0;
    if (!src_take(src, name)) return src_expected(src, expected);
    snprintf(what, sizeof what, "a number of %s", name);
    if (!src_int(src, what, lo, hi, &n) || !src_end_line(src)) return false;
    *count = (uint32_t)n;
    return record_next(src);
}

bool record_exact_count(struct src *src, const char *name, uint32_t count, const char *meaning) {
    const char *before = src->at;
    char what[128];
    int64_t n = 0;
    snprintf(what, sizeof what, "a number of %s", name);
    if (!src_int(src, what, INT64_MIN, INT64_MAX, &n)) return false;
    if (n != count) {
        src->at = before;
        snprintf(what, sizeof what, "%u, %s", count, meaning);
        return src_expected(src, what);
    }
    return src_end_line(src) && record_next(src);
}

bool record_end(struct src *src, const char *expected) {
    return (src_take(src, "end") || src_expected(src, expected)) && src_end_line(src) &&
           record_next(src) && (src->eof || src_expected(src, "nothing after 'end'"));
}

void record_write_first(struct out *out, const char *name, const char *history, const char *added) {
    out_text(out, name);
    out_text(out, " 1\n");
    if (history) out_text(out, history);
    if (added) {
        out_text(out, "# ");
        out_text(out, added);
        out_char(out, '\n');
    }
}
