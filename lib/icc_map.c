/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_map.h"

#include <math.h>

const char *const icc_method_names[ICC_METHODS + 1] = {"ray", NULL};

/* What is to be looked up, or asked for, in the source (0) and in the target (1). */
static unsigned purpose(enum icc_use use, int cage) {
    static const unsigned table[][2] = {
        [ICC_FORWARD] = {ICC_RAY_LOOK_UP, ICC_RAY_ASK},
        [ICC_INVERSE] = {ICC_RAY_ASK, ICC_RAY_LOOK_UP},
        [ICC_NAME] = {ICC_RAY_LOOK_UP, 0},
        [ICC_ASK] = {0, ICC_RAY_ASK},
    };
    return table[use][cage];
}

/* A point of the lattice that icc_mesh lays has an area of sqrt(3)/2 cell^2. */
static void choose_points(struct icc_rule *rule, const struct cage *source) {
    if (rule->cell > 0) {
        double n = source->area / (sqrt(3) / 2 * rule->cell * rule->cell);
        rule->points = n < SIZE_MAX / 2 ? (size_t)n : SIZE_MAX / 2;
    } else if (!rule->has_points)
        rule->points = icc_mesh_points(source->count);
}

static bool prepare(struct icc_map *m, int cage, struct err *err) {
    if (cage == 0 && m->ready) return true;
    if (cage == 0) m->ready = true;
    return icc_ray_prepare(&m->ray[cage], purpose(m->use, cage), err);
}

bool icc_map_init(struct icc_map *m, const struct cage *source, const struct icc_rule *rule,
                  enum icc_use use, struct err *err) {
    *m = (struct icc_map){.use = use, .rule = *rule, .source = source};
    choose_points(&m->rule, source);
    if (icc_ray_init(&m->ray[0], source, NULL, m->rule.points, err) &&
        (use != ICC_NAME || prepare(m, 0, err)))
        return true;
    icc_map_free(m);
    return false;
}

void icc_map_free(struct icc_map *m) {
    icc_ray_free(&m->ray[1]);
    icc_ray_free(&m->ray[0]);
    *m = (struct icc_map){0};
}

/* What finds points takes room that binding needs more: so it comes last. */
bool icc_map_target(struct icc_map *m, const struct cage *target, struct err *err) {
    icc_ray_free(&m->ray[1]);
    m->target = target;
    return icc_ray_init(&m->ray[1], target, &m->ray[0], m->rule.points, err) &&
           prepare(m, 0, err) && prepare(m, 1, err);
}

/* One point; false: it lies outside. */
static bool step(const struct icc_map *m, struct icc_ray_cursor *cursor, struct icc_place *place,
                 const double p[2], double q[2]) {
    switch (m->use) {
    case ICC_FORWARD:
        return icc_ray_map(&m->ray[0], &m->ray[1], cursor, p, q);
    case ICC_INVERSE:
        return icc_ray_map(&m->ray[1], &m->ray[0], cursor, p, q);
    case ICC_NAME:
        return icc_ray_coordinates(&m->ray[0], cursor, p, place);
    default:
        if (place->side == ICC_OUTSIDE) return false;
        icc_ray_point(&m->ray[1], cursor, place, q);
        return true;
    }
}

bool icc_map_batch(struct icc_map *m, struct icc_batch *b, struct err *err) {
    struct icc_ray_cursor cursor = {0, 0};
    (void)err; /* method ray cannot fail any more */
    b->outside = 0;
    for (size_t i = 0; i < b->count; i++) {
        struct icc_place *place = b->places ? &b->places[i] : NULL;
        double *x = &b->points[i][b->axes[0]], *y = &b->points[i][b->axes[1]];
        double p[2] = {*x, *y};
        progress_tell(b->progress, i, b->count);
        if (!step(m, &cursor, place, p, p)) {
            if (b->outside++ == 0) b->first = i;
            if (place) place->side = ICC_OUTSIDE;
        }
        *x = p[0];
        *y = p[1];
    }
    return true;
}
