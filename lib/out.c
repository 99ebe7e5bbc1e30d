/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out.h"

#include "mem.h"
#include "num.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ROOM = 1 << 18 };

static const char *name_of(const struct out *out) {
    return out->path ? out->path : "<stdout>";
}

/* Creates PATH.XXXXXX beside path, with the permissions that an ordinary creation would give. */
static bool open_temporary(struct out *out, const char *path, struct err *err) {
    size_t length = strlen(path);
    struct stat st;
    mode_t mask = umask(0);
    umask(mask);
    out->path = mem_alloc(length + 1, 1, err);
    out->temp = mem_alloc(length + 8, 1, err);
    if (!out->path || !out->temp) return false;
    memcpy(out->path, path, length);
    if (stat(path, &st) == 0 && !S_ISREG(st.st_mode)) { /* a device or a pipe: write to it */
        free(out->temp);
        out->temp = NULL;
        out->fd = open(path, O_WRONLY | O_CLOEXEC);
    } else {
        memcpy(out->temp, path, length);
        memcpy(out->temp + length, ".XXXXXX", 7);
        out->fd = mkstemp(out->temp);
        if (out->fd >= 0) (void)fchmod(out->fd, 0666 & ~mask);
    }
    return out->fd >= 0 || err_system(err, "create", path);
}

bool out_open(struct out *out, const char *path, struct err *err) {
    *out = (struct out){.fd = STDOUT_FILENO};
    out->buf = mem_alloc(ROOM, 1, err);
    if (!out->buf) return false;
    if (!path || strcmp(path, "-") == 0) return true;
    if (open_temporary(out, path, err)) return true;
    if (out->temp) out->temp[0] = '\0'; /* nothing was created */
    out_discard(out);
    return false;
}

bool out_open_sink(struct out *out, void (*sink)(void *context, const char *bytes, size_t length),
                   void *context, struct err *err) {
    *out = (struct out){.fd = -1, .sink = sink, .context = context};
    out->buf = mem_alloc(ROOM, 1, err);
    return out->buf != NULL;
}

static void write_all(struct out *out, const char *bytes, size_t length) {
    if (out->sink) {
        out->sink(out->context, bytes, length);
        return;
    }
    while (length > 0 && !out->err.kind) {
        ssize_t done = write(out->fd, bytes, length);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) {
            err_system(&out->err, "write", name_of(out));
            return;
        }
        bytes += done;
        length -= (size_t)done;
    }
}

static void flush(struct out *out) {
    write_all(out, out->buf, out->used);
    out->used = 0;
}

void out_bytes(struct out *out, const char *bytes, size_t length) {
    if (length > ROOM - out->used) flush(out);
    if (length > ROOM) {
        write_all(out, bytes, length);
        return;
    }
    memcpy(out->buf + out->used, bytes, length);
    out->used += length;
}

void out_text(struct out *out, const char *text) {
    out_bytes(out, text, strlen(text));
}

void out_char(struct out *out, char c) {
    out_bytes(out, &c, 1);
}

void out_int(struct out *out, int64_t n) {
    if (ROOM - out->used < NUM_TEXT_MAX) flush(out);
    out->used += num_print_int(out->buf + out->used, n);
}

void out_double(struct out *out, double x, int digits) {
    if (ROOM - out->used < NUM_TEXT_MAX) flush(out);
    out->used += num_print(out->buf + out->used, x, digits);
}

void out_record(struct out *out, const char *word, const double *x, int n, int digits) {
    out_text(out, word);
    for (int i = 0; i < n; i++) {
        out_char(out, ' ');
        out_double(out, x[i], digits);
    }
    out_char(out, '\n');
}

void out_format(struct out *out, const char *format, ...) {
    char text[1024];
    va_list args;
    int n;
    va_start(args, format);
    n = vsnprintf(text, sizeof text, format, args);
    va_end(args);
    INVARIANT(n >= 0 && (size_t)n < sizeof text);
    out_bytes(out, text, (size_t)n);
}

bool out_close_pending(struct out *out, struct out_pending *pending, struct err *err) {
    bool ok;
    *pending = (struct out_pending){0};
    flush(out);
    if (!out->sink && close(out->fd) < 0 && !out->err.kind)
        err_system(&out->err, "write", name_of(out));
    out->fd = -1;
    ok = out->err.kind == ERR_NONE;
    if (ok && out->temp) {
        *pending = (struct out_pending){out->path, out->temp};
        out->path = out->temp = NULL;
    }
    if (!ok) *err = out->err;
    out_discard(out);
    return ok;
}

bool out_commit(struct out_pending *pending, struct err *err) {
    bool ok = !pending->temp || rename(pending->temp, pending->path) == 0 ||
              err_system(err, "rename to", pending->path);
    if (ok && pending->temp) pending->temp[0] = '\0';
    out_revoke(pending);
    return ok;
}

void out_revoke(struct out_pending *pending) {
    if (pending->temp && pending->temp[0]) unlink(pending->temp);
    free(pending->path);
    free(pending->temp);
    *pending = (struct out_pending){0};
}

bool out_close(struct out *out, struct err *err) {
    struct out_pending pending;
    return out_close_pending(out, &pending, err) && out_commit(&pending, err);
}

void out_discard(struct out *out) {
    if (out->temp && out->temp[0]) unlink(out->temp);
    if (out->fd > STDERR_FILENO) close(out->fd);
    free(out->path);
    free(out->temp);
    free(out->buf);
    *out = (struct out){.fd = -1};
}
