/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzzing - the readers take paths, so the fuzzers lend them files that live in memory; what is
 * written goes there, too.
 *
 * A fuzzer must survive any bytes without a sanitizer's complaint, and where a reader accepts them,
 * what is written from the result must be read again as the same. */
#ifndef FUZZING_H
#define FUZZING_H

#include "out.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

struct fuzz_file {
    int fd;
    char path[40];
};

/* A file in memory with these bytes. */
static inline struct fuzz_file fuzz_open(const void *data, size_t size) {
    struct fuzz_file f = {.fd = memfd_create("input", 0)};
    INVARIANT(f.fd >= 0 && write(f.fd, data, size) == (ssize_t)size);
    INVARIANT(lseek(f.fd, 0, SEEK_SET) == 0);
    snprintf(f.path, sizeof f.path, "/proc/self/fd/%d", f.fd);
    return f;
}

/* What was written, in memory; free() its bytes. NULL: nothing, as of an input that was refused. */
struct fuzz_text {
    char *bytes;
    size_t size;
};

static inline void fuzz_append(void *context, const char *bytes, size_t length) {
    struct fuzz_text *text = context;
    text->bytes = realloc(text->bytes, text->size + length + 1);
    INVARIANT(text->bytes);
    memcpy(text->bytes + text->size, bytes, length);
    text->size += length;
}

/* Opens an output that goes to *text, where all of it is after out_close. */
static inline void fuzz_out(struct out *out, struct fuzz_text *text) {
    struct err err = {0};
    *text = (struct fuzz_text){0};
    INVARIANT(out_open_sink(out, fuzz_append, text, &err));
}

/* Both were written, and are the same; frees them. */
static inline void fuzz_expect_same(struct fuzz_text a, struct fuzz_text b) {
    INVARIANT(a.bytes && b.bytes && a.size == b.size && memcmp(a.bytes, b.bytes, a.size) == 0);
    free(a.bytes);
    free(b.bytes);
}

#endif
