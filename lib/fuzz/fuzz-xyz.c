/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists of points: a copy with the same points has as many, and lies in as many lines; the copy of
 * the copy is the same text; further columns come behind all others. */
#include "fuzzing.h"
#include "list_io.h"

#include <string.h>

/* The copy as text; NULL: refused. */
static char *copy(const char *path, int columns, bool further, size_t *count, size_t *size) {
    struct filemap f;
    struct obj_points p;
    struct err err = {0};
    struct out out;
    char written[40], *text = NULL;
    snprintf(written, sizeof written, "/tmp/supple-fuzz-%d", (int)getpid());
    INVARIANT(filemap_open(&f, path, &err));
    if (list_read(&p, &f, columns, &err)) {
        double(*more)[5] = calloc(p.vertex_count, sizeof *more);
        struct list_change change = {columns, p.vertex, further ? more : NULL, 0};
        INVARIANT(out_open(&out, written, &err));
        INVARIANT(list_copy(&out, &f, p.vertex_count, &change, &err) && out_close(&out, &err));
        for (size_t i = 0; i < p.vertex_count; i += 1 + p.vertex_count / 4)
            INVARIANT(list_line(&f, columns, i) > i);
        text = fuzz_read(written, size);
        unlink(written);
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
    size_t count, again, once_size, twice_size;
    char *once = copy(f.path, columns, further, &count, &once_size), *twice;
    close(f.fd);
    if (!once) return;
    INVARIANT(lines(once, once_size) == lines((const char *)data, size));
    f = fuzz_open(once, once_size);
    twice = copy(f.path, columns, false, &again, &twice_size);
    close(f.fd);
    INVARIANT(twice && again == count && once_size == twice_size &&
              memcmp(once, twice, once_size) == 0);
    free(once);
    free(twice);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    for (int columns = 2; columns <= 3; columns++) {
        check(data, size, columns, false);
        check(data, size, columns, true);
    }
    return 0;
}
