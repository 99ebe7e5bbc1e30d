/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Triangle's files: vertices and seeds are finite, numbers exist; grids are made of them or
 * refused. All three kinds are tried; .ele and .poly have four vertices beside them. */
#include "fuzzing.h"
#include "triangle_io.h"

#include <math.h>

static const char vertices[] = "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n";

static bool read_kind(struct triangulation *t, int kind, const char *path, const char *node,
                      struct err *err) {
    switch (kind) {
    case 0:
        return triangle_read_node(t, path, err);
    case 1:
        return triangle_read_ele(t, path, node, err);
    default:
        return triangle_read_poly(t, path, node, err);
    }
}

static void check(const struct triangulation *t) {
    const struct lattice_choice choice = {0, 16};
    struct grid g = {.degree = 1, .axes = {0, 1, 2}};
    struct err err = {0};
    for (size_t i = 0; i < t->vertex_count; i++)
        INVARIANT(isfinite(t->vertex[i][0]) && isfinite(t->vertex[i][1]));
    for (size_t i = 0; i < t->triangle_count; i++)
        for (int c = 0; c < 3; c++) INVARIANT(t->triangle[i][c] < t->vertex_count);
    for (size_t i = 0; i < t->segment_count; i++)
        for (int c = 0; c < 2; c++) INVARIANT(t->segment[i][c] < t->vertex_count);
    if (!triangulation_grid(&g, t, &choice, &err))
        INVARIANT(err.kind == ERR_REFUSAL && err.message[0]);
    grid_free(&g);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    struct fuzz_file node = fuzz_open(vertices, sizeof vertices - 1);
    for (int kind = 0; kind < 3; kind++) {
        struct triangulation t;
        struct err err = {0};
        if (read_kind(&t, kind, f.path, node.path, &err)) {
            check(&t);
            triangulation_free(&t);
        } else {
            INVARIANT(err.kind == ERR_INPUT && err.message[0]);
        }
    }
    close(f.fd);
    close(node.fd);
    return 0;
}
