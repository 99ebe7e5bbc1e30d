/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "icc_grid.h"

#include "mem.h"
#include "segment.h"

static const double (*vertices(const struct cage *cage))[2] {
    return (const double(*)[2])cage->vertex;
}

void icc_grid_free(struct icc_grid *g) {
    icc_domain_free(&g->domain);
    icc_function_free(&g->function);
    icc_cells_free(&g->cells);
    *g = (struct icc_grid){0};
}

static bool choose_maximum(const struct icc_grid *g, const struct icc_grid_rule *rule,
                           uint32_t *maximum, struct err *err) {
    uint32_t *layer, layers;
    if (g->domain.inside_count == 0)
        return err_set(err, ERR_REFUSAL,
                       "resolution: no vertex of a grid with cells of %.9g lies inside the cage",
                       g->domain.h);
    if (rule->has_maximum) {
        if (!cage_has(g->cage, rule->maximum))
            return err_set(err, ERR_REFUSAL, "the maximum (%.9g, %.9g) is not inside the cage",
                           rule->maximum[0], rule->maximum[1]);
        *maximum = icc_domain_nearest(&g->domain, rule->maximum);
        return true;
    }
    if (!mem_new(layer, icc_domain_size(&g->domain), err)) return false;
    layers = icc_domain_burn(&g->domain, layer);
    *maximum = icc_domain_last(&g->domain, layer, layers);
    free(layer);
    return true;
}

/* With cells of side h. */
static bool make(struct icc_grid *g, const struct cage *cage, const struct icc_grid_rule *rule,
                 double h, struct err *err) {
    uint32_t maximum = 0;
    *g = (struct icc_grid){.cage = cage};
    if (!icc_domain_init(&g->domain, vertices(cage), cage->count, h, err) ||
        !choose_maximum(g, rule, &maximum, err) ||
        !icc_function_init(&g->function, &g->domain, maximum, &rule->function, err) ||
        !icc_cells_init(&g->cells, &g->domain, err))
        return false;
    struct icc_field field = icc_grid_field(g);
    double lambda = 0.5;
    icc_resolution(&field, g->failures);
    cage_to_given(cage, &g->failures[ICC_TEST_BARE].side, &lambda);
    return true;
}

static int first_failure(const struct icc_grid *g) {
    int t = 0;
    while (t < ICC_TESTS && g->failures[t].count == 0) t++;
    return t;
}

static double cell_side(const struct cage *cage, const struct icc_grid_rule *rule) {
    double finer = rule->resolution > 0 ? rule->resolution : 1;
    double points = rule->points > 0 ? rule->points : ICC_POINTS_THESIS;
    return (rule->cell > 0 ? rule->cell : sqrt(cage->area / points)) / finer;
}

/* The smallest cells that are taken unasked: thin cages that lie aslant have large grids. */
static double least_side(const struct cage *cage) {
    const double *low = cage->polygon.lo, *high = cage->polygon.hi;
    double h = sqrt(cage->area / ICC_POINTS_AUTO_MAX);
    while (((high[0] - low[0]) / h + 6) * ((high[1] - low[1]) / h + 6) > ICC_GRID_MAX) h *= 1.125;
    return h;
}

static bool automatic_side(const struct cage *cage, double least, double *h, struct err *err) {
    double side = fmax(sqrt(cage->area / ICC_POINTS_AUTO), least), width;
    if (!icc_width(vertices(cage), cage->count, 2 * side, &width, err)) return false;
    *h = fmax(width / 2, least);
    return true;
}

/* A grid without a vertex inside is too coarse as well; other errors are final. */
static bool make_automatic(struct icc_grid *g, const struct cage *cage,
                           const struct icc_grid_rule *rule, struct err *err) {
    double least = least_side(cage), h;
    if (!automatic_side(cage, least, &h, err)) return false;
    for (;; h /= 2) {
        struct err why;
        bool ok = make(g, cage, rule, h, &why);
        bool coarse =
            ok ? first_failure(g) < ICC_TESTS : g->domain.inside && g->domain.inside_count == 0;
        if (!coarse || h / 2 < least) {
            if (!ok) *err = why;
            return ok;
        }
        icc_grid_free(g);
    }
}

bool icc_grid_init(struct icc_grid *g, const struct cage *cage, const struct icc_grid_rule *rule,
                   struct err *err) {
    bool automatic = !(rule->cell > 0 || rule->points > 0 || rule->resolution > 0);
    char text[ICC_FAILURE_TEXT_MAX];
    int failed;
    *g = (struct icc_grid){.cage = cage};
    if (!(automatic ? make_automatic(g, cage, rule, err)
                    : make(g, cage, rule, cell_side(cage, rule), err)))
        return false;
    failed = first_failure(g);
    if (failed == ICC_TESTS || rule->warn) return true;
    icc_failure_describe((enum icc_test)failed, &g->failures[failed], text);
    return err_set(err, ERR_REFUSAL, "resolution: with cells of %.9g, %s", g->domain.h, text);
}

/* ---- coordinates ------------------------------------------------------------------------------
 */

/* The nearest place on the cage from a point in grid coordinates, and how far it is. O(sides). */
static double nearest_place(const struct icc_grid *g, const double grid[2],
                            struct icc_place *place) {
    double p[2], best = INFINITY;
    icc_domain_to_world(&g->domain, grid, p);
    for (uint32_t side = 0; side < g->cage->count; side++) {
        double lambda, d;
        d = segment_distance2(g->cage->vertex[side], g->cage->vertex[cage_next(g->cage, side)], p,
                              &lambda);
        if (!(d < best)) continue;
        best = d;
        place->side = side;
        place->lambda = lambda;
    }
    return sqrt(best) / g->domain.h;
}

/* Up to the maximum, straight from where it gets stuck. */
static bool go_up(const struct icc_grid *g, const double from[2], struct icc_line *up, bool *lost,
                  double *length, struct err *err) {
    struct icc_field field = icc_grid_field(g);
    if (!icc_trace(&field, from, ICC_UPHILL, up, err)) return false;
    if (up->end == ICC_END_STUCK) {
        *lost = true;
        if (!mem_grow(up->point, &up->capacity, up->count + 1, err)) return false;
        icc_domain_vertex_grid(&g->domain, g->function.maximum, up->point[up->count++]);
    }
    *length = icc_line_length(up);
    return true;
}

bool icc_grid_locate(const struct icc_grid *g, const double p[2], struct icc_lines *lines,
                     struct icc_place *place, struct icc_tally *tally, struct err *err) {
    struct icc_field field = icc_grid_field(g);
    double from[2], top[2], up, down;
    bool lost = false;
    enum cage_where where;
    *place = (struct icc_place){.t = 1};
    where = cage_find(g->cage, p, &place->side, &place->lambda);
    if (where == CAGE_OUTSIDE) place->side = ICC_OUTSIDE;
    tally->points += where != CAGE_OUTSIDE;
    if (where != CAGE_INSIDE) return true;
    icc_domain_to_grid(&g->domain, p, from);
    icc_domain_vertex_grid(&g->domain, g->function.maximum, top);
    if (from[0] == top[0] && from[1] == top[1]) {
        *place = (struct icc_place){0};
        return true;
    }
    if (!go_up(g, from, &lines->up, &lost, &up, err) ||
        !icc_trace(&field, from, ICC_DOWNHILL, &lines->down, err))
        return false;
    down = icc_line_length(&lines->down);
    place->side = lines->down.side;
    place->lambda = lines->down.lambda;
    if (lines->down.end == ICC_END_STUCK) {
        lost = true;
        down += nearest_place(g, lines->down.point[lines->down.count - 1], place);
    }
    place->t = up / (up + down);
    tally->merged += lines->down.shared != SIZE_MAX;
    tally->expanded += lines->down.expanded;
    tally->leaving += lines->up.crossed;
    tally->lost += lost;
    return true;
}

bool icc_grid_place(const struct icc_grid *g, const struct icc_place *place,
                    struct icc_lines *lines, double p[2], struct icc_tally *tally,
                    struct err *err) {
    double from[2], at[2], length;
    bool lost = false;
    tally->points++;
    if (place->t >= 1) {
        cage_point(g->cage, place->side, place->lambda, p);
        return true;
    }
    if (place->t <= 0) {
        icc_domain_vertex(&g->domain, g->function.maximum, p);
        return true;
    }
    cage_point(g->cage, place->side, place->lambda, at);
    icc_domain_to_grid(&g->domain, at, from);
    if (!go_up(g, from, &lines->up, &lost, &length, err)) return false;
    tally->merged += icc_line_at(&lines->up, (1 - place->t) * length, at) >= lines->up.shared;
    icc_domain_to_world(&g->domain, at, p);
    tally->leaving += lines->up.crossed;
    tally->lost += lost;
    return true;
}

void icc_lines_free(struct icc_lines *lines) {
    icc_line_free(&lines->up);
    icc_line_free(&lines->down);
}
