/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_map.h"

#include <math.h>

const char *const icc_method_names[ICC_METHODS + 1] = {"ray", "grid", NULL};

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
        rule->points = n < 0x1p62 ? (size_t)n : (size_t)1 << 62;
    } else if (!rule->has_points)
        rule->points = icc_mesh_points(source->count);
}

static bool prepare(struct icc_map *m, int cage, struct err *err) {
    if (cage == 0 && m->ready) return true;
    if (cage == 0) m->ready = true;
    return icc_ray_prepare(&m->ray[cage], purpose(m->use, cage), err);
}

/* What holds for both methods, in the words of method grid. */
static void choose_cells(struct icc_rule *rule) {
    for (int k = 0; k < 2; k++) {
        rule->grid[k].cell = rule->cell;
        rule->grid[k].points = rule->has_points ? (double)rule->points : 0;
    }
}

bool icc_map_init(struct icc_map *m, const struct cage *source, const struct icc_rule *rule,
                  enum icc_use use, struct err *err) {
    bool ok;
    *m = (struct icc_map){.use = use, .rule = *rule, .source = source};
    if (rule->method == ICC_GRID) {
        choose_cells(&m->rule);
        ok = icc_grid_init(&m->grid[0], source, &m->rule.grid[0], err);
    } else {
        choose_points(&m->rule, source);
        ok = icc_ray_init(&m->ray[0], source, NULL, m->rule.points, err) &&
             (use != ICC_NAME || prepare(m, 0, err));
    }
    if (!ok) icc_map_free(m);
    return ok;
}

void icc_map_free(struct icc_map *m) {
    for (int k = 0; k < 2; k++) {
        icc_ray_free(&m->ray[1 - k]);
        icc_grid_free(&m->grid[1 - k]);
    }
    icc_lines_free(&m->lines);
    *m = (struct icc_map){0};
}

/* What finds points takes room that binding needs more: so it comes last. */
bool icc_map_target(struct icc_map *m, const struct cage *target, struct err *err) {
    m->target = target;
    if (m->rule.method == ICC_GRID) {
        icc_grid_free(&m->grid[1]);
        return icc_grid_init(&m->grid[1], target, &m->rule.grid[1], err);
    }
    icc_ray_free(&m->ray[1]);
    return icc_ray_init(&m->ray[1], target, &m->ray[0], m->rule.points, err) &&
           prepare(m, 0, err) && prepare(m, 1, err);
}

/* One point; false: it lies outside. */
static bool ray_step(const struct icc_map *m, struct icc_ray_cursor *cursor,
                     struct icc_place *place, double p[2]) {
    switch (m->use) {
    case ICC_FORWARD:
        return icc_ray_map(&m->ray[0], &m->ray[1], cursor, p, p);
    case ICC_INVERSE:
        return icc_ray_map(&m->ray[1], &m->ray[0], cursor, p, p);
    case ICC_NAME:
        return icc_ray_coordinates(&m->ray[0], cursor, p, place);
    default:
        if (place->side == ICC_OUTSIDE) return false;
        icc_ray_point(&m->ray[1], cursor, place, p);
        return true;
    }
}

/* The same; false: no memory. A point outside has a place outside afterwards. */
static bool grid_step(struct icc_map *m, struct icc_place *place, double p[2], struct err *err) {
    int from = m->use == ICC_INVERSE;
    if (m->use != ICC_ASK &&
        !icc_grid_locate(&m->grid[from], p, &m->lines, place, &m->tally[from], err))
        return false;
    return m->use == ICC_NAME || place->side == ICC_OUTSIDE ||
           icc_grid_place(&m->grid[!from], place, &m->lines, p, &m->tally[!from], err);
}

bool icc_map_batch(struct icc_map *m, struct icc_batch *b, struct err *err) {
    struct icc_ray_cursor cursor = {0, 0};
    b->outside = 0;
    m->tally[0] = m->tally[1] = (struct icc_tally){0};
    for (size_t i = 0; i < b->count; i++) {
        struct icc_place here = {0}, *place = b->places ? &b->places[i] : &here;
        double *x = &b->points[i][b->axes[0]], *y = &b->points[i][b->axes[1]];
        double p[2] = {*x, *y};
        progress_tell(b->progress, i, b->count);
        if (m->rule.method == ICC_GRID) {
            if (!grid_step(m, place, p, err)) return false;
        } else if (!ray_step(m, &cursor, place, p))
            place->side = ICC_OUTSIDE;
        if (place->side == ICC_OUTSIDE && b->outside++ == 0) b->first = i;
        *x = p[0];
        *y = p[1];
    }
    return true;
}
