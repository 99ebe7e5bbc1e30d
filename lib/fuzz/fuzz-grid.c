/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids: what was read is written, and written again from that, as the same bytes. */
#include "fuzzing.h"
#include "grid_io.h"

#include <string.h>

/* The grid of a file as text; NULL: refused. */
static char *rewrite(const char *path, size_t *size) {
    struct grid_file file;
    struct err err = {0};
    struct out out;
    char written[40];
    if (!grid_read(&file, path, &err)) {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
        return NULL;
    }
    snprintf(written, sizeof written, "/tmp/supple-fuzz-%d", (int)getpid());
    INVARIANT(out_open(&out, written, &err));
    grid_write(&out, &file, NULL, 0);
    INVARIANT(out_close(&out, &err));
    grid_file_free(&file);
    char *text = fuzz_read(written, size);
    unlink(written);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    size_t once_size, twice_size;
    char *once = rewrite(f.path, &once_size);
    close(f.fd);
    if (!once) return 0;
    f = fuzz_open(once, once_size);
    char *twice = rewrite(f.path, &twice_size);
    close(f.fd);
    INVARIANT(twice && once_size == twice_size && memcmp(once, twice, once_size) == 0);
    free(once);
    free(twice);
    return 0;
}
