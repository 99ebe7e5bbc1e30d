/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "figure_model.h"

#include "mem.h"

#include <string.h>

static void to_frame(const struct grid *g, size_t n, double (*vertex)[3]) {
    for (size_t v = 0; v < n; v++) {
        double at[3];
        memcpy(at, vertex[v], sizeof at);
        for (int c = 0; c < 3; c++) vertex[v][c] = at[g->axes[c]];
    }
}

bool figure_model(struct model *model, struct model *deformed, const struct spline *s,
                  struct err *err) {
    const struct projection projection = projection_of_model(&s->grid);
    struct deform d;
    struct deform_batch batch = {.count = model->vertex_count, .points = model->vertex};
    bool ok;
    *deformed = *model;
    if (!mem_new(deformed->vertex, model->vertex_count, err)) return false;
    batch.images = deformed->vertex;
    if (!deform_init(&d, s, &projection, NULL, err)) return false;
    ok = deform_points(&d, &batch);
    deform_free(&d);
    if (!ok)
        return err_set(err, ERR_REFUSAL, "the image of vertex %zu is not finite", batch.first + 1);
    to_frame(&s->grid, model->vertex_count, model->vertex);
    to_frame(&s->grid, model->vertex_count, deformed->vertex);
    return true;
}
