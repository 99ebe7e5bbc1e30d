/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "err.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void set_file(struct err *err, const char *file) {
    size_t length = strlen(file), room = sizeof err->file - 1;
    if (length <= room)
        memcpy(err->file, file, length + 1);
    else /* the end of a long path says more than its beginning */
        snprintf(err->file, sizeof err->file, "...%s", file + length - (room - 3));
}

static void set_message(struct err *err, enum err_kind kind, const char *format, va_list args) {
    err->kind = kind;
    err->file[0] = '\0';
    err->line = err->col = 0;
    vsnprintf(err->message, sizeof err->message, format, args);
}

bool err_set(struct err *err, enum err_kind kind, const char *format, ...) {
    va_list args;
    va_start(args, format);
    set_message(err, kind, format, args);
    va_end(args);
    return false;
}

bool err_set_at(struct err *err, enum err_kind kind, const char *file, size_t line, size_t col,
                const char *format, ...) {
    va_list args;
    va_start(args, format);
    set_message(err, kind, format, args);
    va_end(args);
    return err_place(err, file, line, col);
}

bool err_place(struct err *err, const char *file, size_t line, size_t col) {
    if (err->file[0] == '\0') {
        set_file(err, file);
        err->line = line;
        err->col = col;
    }
    return false;
}

bool err_system(struct err *err, const char *what, const char *file) {
    return err_set(err, ERR_INPUT, "cannot %s %s: %s", what, file, strerror(errno));
}

bool err_memory(struct err *err) {
    return err_set(err, ERR_INPUT, "out of memory");
}

void err_bug(const char *file, int line, const char *condition) {
    fprintf(stderr, "%s:%d: bug: '%s' is false; please report it\n", file, line, condition);
    abort();
}
