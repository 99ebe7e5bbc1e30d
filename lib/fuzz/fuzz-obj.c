/* SPDX-License-Identifier: GPL-3.0-or-later */
/* OBJ models: indices of a model exist; a copy whose vertices do not change has the same vertices,
 * and the copy of the copy is the same text, however normals are treated. */
#include "fuzzing.h"
#include "obj_copy.h"
#include "obj_io.h"

#include <string.h>

static void check_model(const char *path) {
    struct model m;
    struct err err = {0};
    if (!model_read(&m, path, &err)) {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
        return;
    }
    for (size_t e = 0; e < m.element_count; e++) {
        size_t least = m.kind[e] == 'f' ? 3 : m.kind[e] == 'l' ? 2 : 1;
        INVARIANT(m.start[e] + least <= m.start[e + 1]);
    }
    for (size_t i = 0; i < m.start[m.element_count]; i++) INVARIANT(m.index[i] < m.vertex_count);
    model_free(&m);
}

/* Halves normals at even vertices and keeps the others, so that shared normals need copies. */
static bool turn(void *context, size_t vertex, const double normal[3], double result[3]) {
    (void)context;
    for (int c = 0; c < 3; c++) result[c] = vertex % 2 ? normal[c] : normal[c] / 2;
    return true;
}

static bool keep(void *context, size_t vertex, const double normal[3], double result[3]) {
    (void)context;
    (void)vertex;
    memcpy(result, normal, 3 * sizeof *result);
    return true;
}

/* The copy as text; NULL: the model was refused. */
static char *copy(const char *path, enum obj_normal_mode mode, obj_turn *how, size_t *size) {
    struct filemap f = {0};
    struct obj_points p = {0};
    struct obj_normals plan = {0};
    struct err err = {0};
    struct out out;
    char written[40], *text = NULL;
    snprintf(written, sizeof written, "/tmp/supple-fuzz-%d", (int)getpid());
    INVARIANT(filemap_open(&f, path, &err));
    if (obj_points_read(&p, &f, &err) &&
        (mode == OBJ_NORMALS_TRANSFORM ? obj_normals_plan(&plan, &f, &p, how, NULL, &err)
                                       : obj_normals_check(&f, &err))) {
        struct obj_change change = {p.vertex, mode, &plan, 0};
        INVARIANT(out_open(&out, written, &err));
        INVARIANT(obj_copy(&out, &f, &p, &change, &err) && out_close(&out, &err));
        text = fuzz_read(written, size);
        unlink(written);
    }
    obj_normals_free(&plan);
    obj_points_free(&p);
    filemap_close(&f);
    return text;
}

static void check_copies(const char *path, enum obj_normal_mode mode, obj_turn *how) {
    size_t once_size, twice_size;
    char *once = copy(path, mode, how, &once_size), *twice;
    struct fuzz_file f;
    if (!once) return;
    f = fuzz_open(once, once_size);
    twice = copy(f.path, mode, keep, &twice_size);
    close(f.fd);
    INVARIANT(twice && once_size == twice_size && memcmp(once, twice, once_size) == 0);
    free(once);
    free(twice);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    check_model(f.path);
    check_copies(f.path, OBJ_NORMALS_KEEP, keep);
    check_copies(f.path, OBJ_NORMALS_DROP, keep);
    check_copies(f.path, OBJ_NORMALS_TRANSFORM, turn);
    close(f.fd);
    return 0;
}
