/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzzing - the readers take paths, so the fuzzers lend them files that live in memory.
 *
 * A fuzzer must survive any bytes without a sanitizer's complaint, and where a reader accepts them,
 * what is written from the result must be read again as the same. */
#ifndef FUZZING_H
#define FUZZING_H

#include "err.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
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

/* All bytes of a file, NUL behind them; free() them. */
static inline char *fuzz_read(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    char *text;
    long end;
    INVARIANT(file && fseek(file, 0, SEEK_END) == 0);
    end = ftell(file);
    rewind(file);
    text = calloc((size_t)end + 1, 1);
    INVARIANT(text && fread(text, 1, (size_t)end, file) == (size_t)end);
    fclose(file);
    *size = (size_t)end;
    return text;
}

#endif
