/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The buffer holds [lo, hi) unread bytes; the current line lies before lo and stays where it is
 * until the next call of src_raw_line, which may move or grow the buffer:
 *
 *      buf ... begin ......... end \n  lo ............. hi ....... cap
 *              current line            unread           free
 */
#include "src.h"

#include "mem.h"
#include "num.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ROOM = 1 << 18, LEAST = ROOM / 4, QUOTE_MAX = 40 };

bool src_open(struct src *src, const char *path, struct err *err) {
    bool standard = !path || strcmp(path, "-") == 0;
    struct stat st;
    *src = (struct src){.name = standard ? "<stdin>" : path};
    src->fd = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    if (src->fd < 0) return err_system(err, "open", src->name);
    if (fstat(src->fd, &st) == 0 && S_ISDIR(st.st_mode)) {
        errno = EISDIR;
        src_close(src);
        return err_system(err, "read", src->name);
    }
    return true;
}

void src_open_text(struct src *src, const char *name, const char *text, size_t length) {
    *src = (struct src){.name = name, .fd = -1, .cap = length, .hi = length, .ended = true};
    src->buf = (char *)text; /* only refill writes there, which `ended` prevents */
}

void src_close(struct src *src) {
    if (src->fd >= 0) free(src->buf);
    if (src->fd > STDIN_FILENO) close(src->fd);
    src->buf = NULL;
    src->fd = -1;
}

/* Reads more input behind hi, moving or growing the buffer when it is full. */
static bool refill(struct src *src) {
    ssize_t got;
    if (src->lo > 0) {
        memmove(src->buf, src->buf + src->lo, src->hi - src->lo);
        src->hi -= src->lo;
        src->lo = 0;
    }
    if (src->cap - src->hi < LEAST && !mem_grow(src->buf, &src->cap, src->hi + ROOM, &src->err))
        return false;
    do got = read(src->fd, src->buf + src->hi, src->cap - src->hi);
    while (got < 0 && errno == EINTR);
    if (got < 0) return err_system(&src->err, "read", src->name);
    if (got == 0) src->ended = true;
    src->hi += (size_t)got;
    return true;
}

/* Cuts the end-of-line and the comment off the line [begin, raw_end). */
static void trim(struct src *src) {
    const char *hash;
    if (src->raw_end > src->begin && src->raw_end[-1] == '\r') src->raw_end--;
    hash = memchr(src->begin, '#', (size_t)(src->raw_end - src->begin));
    src->comment = hash;
    src->at = src->begin;
    src->end = hash ? hash : src->raw_end;
}

bool src_raw_line(struct src *src) {
    size_t searched = 0;
    if (src->err.kind || src->eof) return false;
    for (;;) {
        size_t n = src->hi - src->lo;
        char *start = src->buf ? src->buf + src->lo : NULL;
        char *newline = n > searched ? memchr(start + searched, '\n', n - searched) : NULL;
        if (newline || (src->ended && n > 0)) {
            src->begin = start;
            src->raw_end = newline ? newline : start + n;
            src->lo += newline ? (size_t)(newline + 1 - start) : n;
            src->line++;
            trim(src);
            return true;
        }
        if (src->ended) {
            src->eof = true;
            src->line++; /* messages about what is missing name the line after the last */
            src->begin = src->at = src->end = src->raw_end = "";
            src->comment = NULL;
            return false;
        }
        searched = n;
        if (!refill(src)) return false;
    }
}

static void skip_blanks(struct src *src) {
    while (src->at < src->end && (*src->at == ' ' || *src->at == '\t')) src->at++;
}

bool src_line(struct src *src) {
    while (src_raw_line(src)) {
        skip_blanks(src);
        if (src->at < src->end) return true;
    }
    return false;
}

bool src_word(struct src *src, const char **word, size_t *length) {
    if (src->err.kind) return false;
    skip_blanks(src);
    *word = src->at;
    while (src->at < src->end && *src->at != ' ' && *src->at != '\t') src->at++;
    *length = (size_t)(src->at - *word);
    return *length > 0;
}

bool src_take(struct src *src, const char *word) {
    const char *before = src->at, *got;
    size_t length;
    if (src_word(src, &got, &length) && length == strlen(word) && memcmp(got, word, length) == 0)
        return true;
    src->at = before;
    return false;
}

bool src_expect(struct src *src, const char *word) {
    char quoted[64];
    if (src_take(src, word)) return true;
    snprintf(quoted, sizeof quoted, "'%s'", word);
    return src_expected(src, quoted);
}

bool src_fail(struct src *src, const char *at, const char *format, ...) {
    char text[sizeof src->err.message];
    va_list args;
    if (src->err.kind) return false;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return err_set_at(&src->err, ERR_INPUT, src->name, src->line,
                      at ? (size_t)(at - src->begin) + 1 : 1, "%s", text);
}

/* Quotes the word for a message: printable ASCII as it is, other bytes as \xNN, long words cut. */
static void quote(char *to, size_t room, const char *word, size_t length) {
    size_t n = 0;
    to[n++] = '\'';
    for (size_t i = 0; i < length && n + 10 < room; i++) {
        unsigned char c = (unsigned char)word[i];
        if (i == QUOTE_MAX) {
            n += (size_t)snprintf(to + n, room - n, "...");
            break;
        }
        if (c >= ' ' && c < 127)
            to[n++] = (char)c;
        else
            n += (size_t)snprintf(to + n, room - n, "\\x%02x", c);
    }
    to[n++] = '\'';
    to[n] = '\0';
}

bool src_expected(struct src *src, const char *what) {
    char quoted[4 * QUOTE_MAX + 16];
    const char *word;
    size_t length;
    if (src->err.kind) return false;
    if (src_word(src, &word, &length))
        quote(quoted, sizeof quoted, word, length);
    else
        snprintf(quoted, sizeof quoted, src->eof ? "end of file" : "end of line");
    return src_fail(src, word, "expected %s, got %s", what, quoted);
}

/* Records a number's error with the word it stands in. */
static bool bad_number(struct src *src, const char *word, const char *what,
                       enum num_status status) {
    src->at = word;
    if (status != NUM_OVERFLOW) return src_expected(src, what);
    return src_fail(src, word, "expected %s, got a number that is too large", what);
}

bool src_double(struct src *src, const char *what, double *x) {
    const char *word, *next;
    enum num_status status;
    if (src->err.kind) return false;
    skip_blanks(src);
    word = src->at;
    status = num_read(word, src->end, x, &next);
    if (status == NUM_OK && (next == src->end || *next == ' ' || *next == '\t')) {
        src->at = next;
        return true;
    }
    return bad_number(src, word, what, status);
}

bool src_int(struct src *src, const char *what, int64_t lo, int64_t hi, int64_t *n) {
    const char *word, *next;
    enum num_status status;
    char range[160];
    if (src->err.kind) return false;
    skip_blanks(src);
    word = src->at;
    status = num_read_int(word, src->end, n, &next);
    if (status == NUM_OK && (next == src->end || *next == ' ' || *next == '\t') && *n >= lo &&
        *n <= hi) {
        src->at = next;
        return true;
    }
    if (lo == INT64_MIN && hi == INT64_MAX) return bad_number(src, word, what, status);
    snprintf(range, sizeof range, "%s in %lld..%lld", what, (long long)lo, (long long)hi);
    return bad_number(src, word, range, NUM_NONE);
}

bool src_end_line(struct src *src) {
    if (src->err.kind) return false;
    skip_blanks(src);
    return src->at == src->end || src_expected(src, "the end of the line");
}
