/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_plane.h"

static bool refuse(const struct icc_sample_report *r, struct err *err) {
    return err_set(err, ERR_REFUSAL,
                   "fold: %zu triangles are turned over, one at (%.9g, %.9g) of the source; method "
                   "ray has no folds",
                   r->left, r->where[0], r->where[1]);
}

static bool map_all(void *context, double (*point)[3], size_t count, struct err *err) {
    struct icc_batch batch = {.count = count, .points = point, .axes = {0, 1}};
    return icc_map_batch(context, &batch, err);
}

/* Is there hope that an overlay does what a sample, refused for that reason, does not? */
static bool has_hope(const struct icc_map *m, const struct icc_sample_report *r,
                     const struct err *why) {
    return m->rule.method == ICC_RAY && !r->too_many &&
           (why->kind == ERR_NONE || why->kind == ERR_REFUSAL);
}

bool icc_plane(struct plane_map *map, const struct icc_plane *p, struct icc_plane_report *report,
               struct err *err) {
    struct icc_map *m = p->map;
    bool inverse = m->use == ICC_INVERSE;
    const struct icc_sampled what = {inverse ? m->target : m->source,
                                     inverse ? m->source : m->target, map_all, m};
    struct err why = {0};
    *report = (struct icc_plane_report){0};
    bool ok = icc_sample(map, &what, p->max_area, p->digits, &report->sample, &why) &&
              report->sample.left == 0 && plane_map_prove(map, &why);
    if (ok) return true;
    plane_map_free(map);
    if (!has_hope(m, &report->sample, &why)) {
        if (why.kind == ERR_NONE) return refuse(&report->sample, err);
        *err = why;
        return false;
    }
    report->overlay = true;
    ok = icc_overlay(map, &m->ray[inverse], &m->ray[!inverse], p->max_area, p->digits, err) &&
         plane_map_prove(map, err);
    if (!ok) plane_map_free(map);
    return ok;
}
