/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Located models: what was read keeps its promises and is written, and written again from that, as
 * the same bytes. Read with a key, it is what the key says. */
#include "bary_io.h"
#include "fuzzing.h"

static void check(const struct bary *bary) {
    for (size_t i = 0; i < bary->key.count; i++) {
        const double *b = bary->place[i].b;
        if (bary->place[i].triangle == GRID_NONE) continue;
        for (int k = 0; k < 3; k++) INVARIANT(b[k] >= 0 && b[k] <= 1);
        INVARIANT(b[0] + b[1] + b[2] == 1);
        if (!bary->key.triangle_count) continue;
        INVARIANT(bary->place[i].triangle < bary->key.triangle_count);
    }
}

/* The text of what is read from a file. */
static struct fuzz_text rewrite(struct fuzz_file f, const struct bary_key *key) {
    struct fuzz_text text = {0};
    struct bary bary;
    struct err err = {0};
    struct out out;
    if (bary_read(&bary, f.path, key, &err)) {
        check(&bary);
        fuzz_out(&out, &text);
        bary_write(&out, &bary, NULL);
        INVARIANT(out_close(&out, &err));
        bary_free(&bary);
    } else {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    }
    close(f.fd);
    return text;
}

static void round_trip(const void *data, size_t size, const struct bary_key *key) {
    struct fuzz_text once = rewrite(fuzz_open(data, size), key);
    if (once.bytes) fuzz_expect_same(once, rewrite(fuzz_open(once.bytes, once.size), key));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    /* of testdata/good/bary/points.bary */
    static const struct bary_key known = {0xf97c9373, 0x5006ebf6, 5, 2, true, false};
    round_trip(data, size, NULL);
    round_trip(data, size, &known);
    return 0;
}
