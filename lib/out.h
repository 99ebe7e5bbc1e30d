/* SPDX-License-Identifier: GPL-3.0-or-later */
/* out - buffered output that is checked: to stdout, or to a temporary beside the named file,
 * renamed over it by out_close, so that an old file survives every failure. Errors stick until
 * out_close. */
#ifndef OUT_H
#define OUT_H

#include "err.h"

#include <stdint.h>

struct out {
    struct err err; /* sticky */
    /* private */
    int fd;
    char *path, *temp; /* NULL: stdout */
    char *buf;
    size_t used;
    void (*sink)(void *context, const char *bytes, size_t length); /* NULL: fd */
    void *context;
};

/* NULL or "-" is stdout. Ended by out_close or out_discard. */
bool out_open(struct out *out, const char *path, struct err *err) WARN_UNUSED;

/* What is written goes to a function instead of a file, a checksum for example. */
bool out_open_sink(struct out *out, void (*sink)(void *context, const char *bytes, size_t length),
                   void *context, struct err *err) WARN_UNUSED;

void out_bytes(struct out *out, const char *bytes, size_t length);
void out_text(struct out *out, const char *text);
void out_char(struct out *out, char c);
void out_int(struct out *out, int64_t n);
void out_double(struct out *out, double x, int digits); /* digits as in num_print */
/* "WORD X Y ..." and a newline. */
void out_record(struct out *out, const char *word, const double *x, int n, int digits);
void out_format(struct out *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes what is left, closes, renames; reports the first failure of all. */
bool out_close(struct out *out, struct err *err) WARN_UNUSED;

/* A file that is written, but has not got its name yet: several can appear at once, or none. */
struct out_pending {
    char *path, *temp; /* NULL: nothing to rename */
};

/* Like out_close, but leaves the renaming to out_commit; ended by that or by out_revoke. */
bool out_close_pending(struct out *out, struct out_pending *pending, struct err *err) WARN_UNUSED;
bool out_commit(struct out_pending *pending, struct err *err) WARN_UNUSED;
void out_revoke(struct out_pending *pending); /* idempotent, harmless on a zeroed struct */

/* Removes the temporary; bytes that already went to stdout cannot be taken back. Idempotent, and
 * harmless after out_close or on a zeroed struct. */
void out_discard(struct out *out);

#endif
