/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cage_io.h"

#include "xy_io.h"

#include <string.h>

static const char *name_of(const char *path) {
    return !path || strcmp(path, "-") == 0 ? "<stdin>" : path;
}

static bool read_outline(struct polygon *g, const char *path, struct err *err) {
    if (!xy_read_polygon(g, path, err)) return false;
    if (g->loop_count == 1) return true;
    err_set(err, ERR_REFUSAL, "a cage has no holes, got %zu loops", g->loop_count);
    polygon_free(g);
    return err_place(err, name_of(path), 0, 0);
}

bool cage_read(struct cage *c, const char *path, struct err *err) {
    struct polygon g;
    bool ok;
    if (!read_outline(&g, path, err)) return false;
    ok = cage_init(c, (const double(*)[2])g.point, g.point_count, err);
    polygon_free(&g);
    return ok || err_place(err, name_of(path), 0, 0);
}

bool cage_read_like(struct cage *c, const char *path, const struct cage *source,
                    const char *source_path, const char *advice, struct err *err) {
    struct polygon g;
    bool ok;
    if (!read_outline(&g, path, err)) return false;
    if (g.point_count != source->count)
        ok = err_set(err, ERR_REFUSAL, "the cage has %zu vertices, but %s has %zu%s", g.point_count,
                     name_of(source_path), source->count, advice);
    else
        ok = cage_init_like(c, (const double(*)[2])g.point, g.point_count, source, err);
    polygon_free(&g);
    return ok || err_place(err, name_of(path), 0, 0);
}
