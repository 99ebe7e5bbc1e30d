/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One statement lies in the text like this (a continued one has more lines before `stop`):
 *
 *      line            at                stop next
 *      v__keyword__here____words_left____\r\n the next statement
 */
#include "obj_scan.h"

#include "num.h"
#include "src.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void obj_scan_init(struct obj_scan *s, const char *name, const char *text, size_t length) {
    *s = (struct obj_scan){.name = name, .text = text, .end = text + length, .next = text};
}

static inline bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/* Where the line goes on if a continuation (backslash, end of line) starts at p, else p. */
static const char *skip_continuation(const char *p, const char *stop) {
    if (stop - p >= 2 && p[0] == '\\' && p[1] == '\n') return p + 2;
    if (stop - p >= 3 && p[0] == '\\' && p[1] == '\r' && p[2] == '\n') return p + 3;
    return p;
}

static inline const char *skip_blanks(const char *p, const char *stop) {
    const char *before;
    do {
        while (p < stop && is_blank(*p)) p++;
        before = p;
        if (p < stop && *p == '\\') p = skip_continuation(p, stop);
    } while (p != before);
    return p;
}

/* Does a word end at the backslash p? Only beside a blank: some programs read "1.2\" and "3" as
 * 1.23, others as two numbers, and it is not for us to choose. */
static bool is_continuation_break(const char *p, const char *stop) {
    const char *after = skip_continuation(p, stop);
    return after > p && (after == stop || is_blank(*after) || *after == '\\' || *after == '#');
}

static inline bool is_break(const char *p, const char *stop) {
    return p == stop || is_blank(*p) || *p == '#' || (*p == '\\' && is_continuation_break(p, stop));
}

static inline const char *skip_word(const char *p, const char *stop) {
    while (!is_break(p, stop)) p++;
    return p;
}

/* Is the line end at `newline` a continuation? Not in a comment. */
static bool is_continued(const char *line, const char *newline) {
    const char *last = newline > line && newline[-1] == '\r' ? newline - 1 : newline;
    return last > line && last[-1] == '\\' && !memchr(line, '#', (size_t)(last - line));
}

static void find_end(struct obj_scan *s) {
    const char *line = s->line, *newline;
    while ((newline = memchr(line, '\n', (size_t)(s->end - line))) && is_continued(line, newline))
        line = newline + 1;
    s->stop = newline ? newline : s->end;
    s->next = newline ? newline + 1 : s->end;
    if (s->stop > s->line && s->stop[-1] == '\r') s->stop--;
}

static enum obj_kind kind_of(const char *word, size_t length) {
    switch (length) {
    case 1:
        if (word[0] == 'v') return OBJ_VERTEX;
        if (word[0] == 'f') return OBJ_FACE;
        if (word[0] == 'l') return OBJ_LINE;
        if (word[0] == 'p') return OBJ_POINT;
        return OBJ_OTHER;
    case 2:
        if (word[0] == 'v' && word[1] == 'n') return OBJ_NORMAL;
        if (word[0] == 'v' && word[1] == 't') return OBJ_TEXTURE;
        if (word[0] == 'f' && word[1] == 'o') return OBJ_FACE;
        return OBJ_OTHER;
    case 4:
        return memcmp(word, "surf", 4) == 0 ? OBJ_SURFACE : OBJ_OTHER;
    default:
        return OBJ_OTHER;
    }
}

enum obj_kind obj_next(struct obj_scan *s) {
    const char *word;
    s->line = s->next;
    if (s->err.kind || s->line == s->end) return OBJ_END;
    find_end(s);
    word = skip_blanks(s->line, s->stop);
    s->at = skip_word(word, s->stop);
    return kind_of(word, (size_t)(s->at - word));
}

bool obj_word(struct obj_scan *s, const char **begin, const char **end) {
    *begin = skip_blanks(s->at, s->stop);
    *end = s->at = skip_word(*begin, s->stop);
    return *end > *begin;
}

static bool number(struct obj_scan *s, const char *what, double *x) {
    const char *p = skip_blanks(s->at, s->stop), *next;
    enum num_status status = num_read(p, s->stop, x, &next);
    if (status == NUM_OK && is_break(next, s->stop)) {
        s->at = next;
        return true;
    }
    if (status == NUM_OVERFLOW) return obj_fail(s, p, "expected %s, got a number too large", what);
    return obj_expected(s, p, what);
}

bool obj_numbers(struct obj_scan *s, const char *what, int n, double *x) {
    for (int i = 0; i < n; i++)
        if (!number(s, what, &x[i])) return false;
    return true;
}

static bool at_end(const struct obj_scan *s) {
    const char *p = skip_blanks(s->at, s->stop);
    return p == s->stop || *p == '#';
}

bool obj_more_numbers(struct obj_scan *s, const char *what) {
    double ignored;
    while (!at_end(s))
        if (!number(s, what, &ignored)) return false;
    return true;
}

bool obj_end_line(struct obj_scan *s) {
    return at_end(s) || obj_expected(s, skip_blanks(s->at, s->stop), "the end of the line");
}

/* Reads an index at *p unless a slash or the end of the word stands there (0 then). */
static bool optional_index(struct obj_scan *s, const char **p, int64_t *n) {
    const char *at = *p;
    *n = 0;
    if (is_break(at, s->stop) || *at == '/') return true;
    switch (num_read_int(at, s->stop, n, p)) {
    case NUM_NONE:
        return obj_expected(s, at, "an index");
    case NUM_OVERFLOW:
        return obj_fail(s, at, "index out of range");
    case NUM_OK:
        break;
    }
    return *n != 0 || obj_fail(s, at, "index 0: indices count from 1, or back from -1");
}

bool obj_corner(struct obj_scan *s, struct obj_corner *c) {
    const char *p = skip_blanks(s->at, s->stop);
    if (s->err.kind || p == s->stop || *p == '#') return false;
    *c = (struct obj_corner){.begin = p};
    if (!optional_index(s, &p, &c->vertex)) return false;
    if (c->vertex == 0) return obj_expected(s, c->begin, "a vertex index");
    if (p < s->stop && *p == '/') {
        c->cut = p++;
        if (!optional_index(s, &p, &c->texture)) return false;
        if (p < s->stop && *p == '/') {
            if (c->texture) c->cut = p;
            c->normal_at = ++p;
            if (!optional_index(s, &p, &c->normal)) return false;
        }
    }
    if (!is_break(p, s->stop)) return obj_expected(s, c->begin, "indices v, v/vt, v//vn, v/vt/vn");
    c->end = s->at = p;
    return true;
}

bool obj_to_corners(struct obj_scan *s, enum obj_kind kind) {
    const char *begin, *end;
    for (int i = 0; i < 4 && kind == OBJ_SURFACE; i++) (void)obj_word(s, &begin, &end);
    return kind == OBJ_FACE || kind == OBJ_SURFACE;
}

bool obj_resolve(struct obj_scan *s, const struct obj_corner *corner, const char *what,
                 int64_t number_, size_t count, size_t *index) {
    if (number_ > 0) {
        *index = (size_t)number_ - 1;
        return true;
    }
    if (number_ < 0 && (uint64_t)-number_ <= count) {
        *index = count - (size_t)-number_;
        return true;
    }
    return obj_fail(s, corner->begin, "%s %lld does not exist: %zu before this line", what,
                    (long long)number_, count);
}

/* The physical line around `at`, as the line reader would see it; its message is then the same. */
static struct src line_around(const struct obj_scan *s, const char *at) {
    struct src src = {.name = s->name, .line = 1, .begin = s->text, .at = at, .fd = -1};
    src.eof = at == s->end;
    const char *newline, *hash;
    while ((newline = memchr(src.begin, '\n', (size_t)(at - src.begin)))) {
        src.begin = newline + 1;
        src.line++;
    }
    newline = memchr(at, '\n', (size_t)(s->end - at));
    src.end = newline ? newline : s->end;
    if (src.end > at && src.end[-1] == '\r') src.end--;
    hash = memchr(at, '#', (size_t)(src.end - at));
    if (hash) src.end = hash;
    return src;
}

size_t obj_line_number(const struct obj_scan *s, const char *at) {
    return line_around(s, at).line;
}

bool obj_expected(struct obj_scan *s, const char *at, const char *what) {
    struct src src;
    if (s->err.kind) return false;
    src = line_around(s, at);
    src_expected(&src, what);
    s->err = src.err;
    return false;
}

bool obj_fail(struct obj_scan *s, const char *at, const char *format, ...) {
    char text[sizeof s->err.message];
    struct src src;
    va_list args;
    if (s->err.kind) return false;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    src = line_around(s, at);
    src_fail(&src, at, "%s", text);
    s->err = src.err;
    return false;
}
