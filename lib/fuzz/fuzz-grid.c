/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Grids: what was read is written, and written again from that, as the same bytes. */
#include "fuzzing.h"
#include "grid_io.h"

/* The grid of a file as text. */
static struct fuzz_text rewrite(struct fuzz_file f) {
    struct fuzz_text text = {0};
    struct grid_file file;
    struct err err = {0};
    struct out out;
    if (grid_read(&file, f.path, &err)) {
        fuzz_out(&out, &text);
        grid_write(&out, &file, NULL, 0);
        INVARIANT(out_close(&out, &err));
        grid_file_free(&file);
    } else {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    }
    close(f.fd);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_text once = rewrite(fuzz_open(data, size));
    if (once.bytes) fuzz_expect_same(once, rewrite(fuzz_open(once.bytes, once.size)));
    return 0;
}
