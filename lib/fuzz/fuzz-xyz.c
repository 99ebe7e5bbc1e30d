/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists of points: a copy with the same points has as many, and lies in as many lines; the copy of
 * the copy is the same text; further columns come behind all others. */
#include "fuzzing.h"
#include "list_io.h"

/* The copy as text; none if the list was refused. */
static struct fuzz_text copy(const char *path, int columns, bool further, size_t *count) {
    struct filemap f;
    struct obj_points p;
    struct fuzz_text text = {0};
    struct err err = {0};
    struct out out;
    INVARIANT(filemap_open(&f, path, &err));
    if (list_read(&p, &f, columns, &err)) {
        double(*more)[5] = calloc(p.vertex_count, sizeof *more);
        struct list_change change = {columns, p.vertex, further ? more : NULL, 0};
        fuzz_out(&out, &text);
        INVARIANT(list_copy(&out, &f, p.vertex_count, &change, &err) && out_close(&out, &err));
        for (size_t i = 0; i < p.vertex_count; i += 1 + p.vertex_count / 4)
            INVARIANT(list_line(&f, columns, i) > i);
        *count = p.vertex_count;
        free(more);
        obj_points_free(&p);
    } else {
        INVARIANT(err.kind == ERR_INPUT && err.message[0] && err.line > 0);
    }
    filemap_close(&f);
    return text;
}

static size_t lines(const char *text, size_t size) {
    size_t n = 0;
    for (size_t i = 0; i < size; i++) n += text[i] == '\n';
    return n;
}

static void check(const uint8_t *data, size_t size, int columns, bool further) {
    struct fuzz_file f = fuzz_open(data, size);
    size_t count, again;
    struct fuzz_text once = copy(f.path, columns, further, &count);
    close(f.fd);
    if (!once.bytes) return;
    INVARIANT(lines(once.bytes, once.size) == lines((const char *)data, size));
    f = fuzz_open(once.bytes, once.size);
    fuzz_expect_same(once, copy(f.path, columns, false, &again));
    INVARIANT(again == count);
    close(f.fd);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    for (int columns = 2; columns <= 3; columns++) {
        check(data, size, columns, false);
        check(data, size, columns, true);
    }
    return 0;
}
