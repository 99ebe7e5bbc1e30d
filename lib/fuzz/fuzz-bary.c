/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Located models: what was read keeps its promises and is written, and written again from that, as
 * the same bytes. Read with a key, it is what the key says. */
#include "bary_io.h"
#include "fuzzing.h"

#include <string.h>

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

/* The text of what is read from a file; NULL: refused. */
static char *rewrite(const char *path, const struct bary_key *key, size_t *size) {
    struct bary bary;
    struct err err = {0};
    struct out out;
    char written[40], *text;
    if (!bary_read(&bary, path, key, &err)) {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
        return NULL;
    }
    check(&bary);
    snprintf(written, sizeof written, "/tmp/supple-fuzz-%d", (int)getpid());
    INVARIANT(out_open(&out, written, &err));
    bary_write(&out, &bary, NULL);
    INVARIANT(out_close(&out, &err));
    bary_free(&bary);
    text = fuzz_read(written, size);
    unlink(written);
    return text;
}

static void round_trip(const void *data, size_t data_size, const struct bary_key *key) {
    struct fuzz_file f = fuzz_open(data, data_size);
    size_t once_size, twice_size;
    char *once = rewrite(f.path, key, &once_size), *twice;
    close(f.fd);
    if (!once) return;
    f = fuzz_open(once, once_size);
    twice = rewrite(f.path, key, &twice_size);
    close(f.fd);
    INVARIANT(twice && once_size == twice_size && memcmp(once, twice, once_size) == 0);
    free(once);
    free(twice);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    /* of testdata/good/bary/points.bary */
    static const struct bary_key known = {0xf97c9373, 0x5006ebf6, 5, 2, true};
    round_trip(data, size, NULL);
    round_trip(data, size, &known);
    return 0;
}
