/* SPDX-License-Identifier: GPL-3.0-or-later */
/* OBJ models: indices of a model exist; a copy whose vertices do not change has the same vertices,
 * and the copy of the copy is the same text, however normals are treated. Textured faces use what
 * exists. */
#include "fuzzing.h"
#include "obj_copy.h"
#include "obj_io.h"
#include "textured_io.h"

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

/* The copy as text; none if the model was refused. */
static struct fuzz_text copy(const char *path, enum obj_normal_mode mode, obj_turn *how) {
    struct filemap f = {0};
    struct obj_points p = {0};
    struct obj_normals plan = {0};
    struct fuzz_text text = {0};
    struct err err = {0};
    struct out out;
    INVARIANT(filemap_open(&f, path, &err));
    if (obj_points_read(&p, &f, &err) &&
        (mode == OBJ_NORMALS_TRANSFORM ? obj_normals_plan(&plan, &f, &p, how, NULL, &err)
                                       : obj_normals_check(&f, &err))) {
        struct obj_change change = {p.vertex, mode, &plan, 0};
        fuzz_out(&out, &text);
        INVARIANT(obj_copy(&out, &f, &p, &change, &err) && out_close(&out, &err));
    }
    obj_normals_free(&plan);
    obj_points_free(&p);
    filemap_close(&f);
    return text;
}

static void check_copies(const char *path, enum obj_normal_mode mode, obj_turn *how) {
    struct fuzz_text once = copy(path, mode, how);
    struct fuzz_file f;
    if (!once.bytes) return;
    f = fuzz_open(once.bytes, once.size);
    fuzz_expect_same(once, copy(f.path, mode, keep));
    close(f.fd);
}

static void check_textured(const char *path) {
    struct textured t;
    struct filemap file;
    struct err err = {0};
    INVARIANT(filemap_open(&file, path, &err));
    if (textured_read(&t, &file, &err)) {
        INVARIANT(t.face_count > 0);
        for (uint32_t i = 0; i < 3 * t.face_count; i++)
            INVARIANT(t.face[i / 3].vertex[i % 3] < t.vertex_count &&
                      t.face[i / 3].place[i % 3] < t.place_count);
        textured_free(&t);
    } else
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    filemap_close(&file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    check_model(f.path);
    check_textured(f.path);
    check_copies(f.path, OBJ_NORMALS_KEEP, keep);
    check_copies(f.path, OBJ_NORMALS_DROP, keep);
    check_copies(f.path, OBJ_NORMALS_TRANSFORM, turn);
    close(f.fd);
    return 0;
}
