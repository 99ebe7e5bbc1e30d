/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of faces lies between the points with i = steps - row and those with one less; even places
 * point to corner 0, odd ones away from it, k = place / 2:
 *
 *            0                   row 0: 0
 *           / \
 *          /_0_\
 *         /\ 1 /\                row 1: 0 1 2
 *        /_0\ /_2\               A = (i, j, k) above, A' = (i, j-1, k+1) beside it,
 *       1          2             B = (i-1, j+1, k), C = (i-1, j, k+1) below: ABC and A C A'
 *
 * Points are evaluated in the lowest triangle that has them, so each has one image. */
#include "tessellate.h"

#include "frame.h"
#include "mem.h"

#include <math.h>

/* The domain's topology with another degree. False: too many points. */
static bool set_degree(struct grid *g, int degree) {
    uint64_t edge = (uint64_t)degree - 1, inner = degree > 1 ? edge * (edge - 1) / 2 : 0;
    uint64_t n = g->vertex_count + g->edge_count * edge + g->triangle_count * inner; /* < 2^52 */
    g->degree = degree;
    g->point_count = (uint32_t)n;
    return n < GRID_NONE;
}

/* The image of point p on one sheet. */
static bool evaluate(struct tessellation *t, struct spline_cursor *cursor, uint32_t p, int sheet) {
    const struct grid *g = &t->net;
    struct grid_place place = grid_place(g, p);
    double at[3] = {t->source[p][0], t->source[p][1], g->has_depth ? g->depth[sheet] : 0};
    double b[3], value[3];
    for (int l = 0; l < 3; l++) b[l] = (double)place.weight[l] / g->degree;
    spline_cursor_evaluate(cursor, place.triangle, b, at, value, NULL);
    frame_to_model(g, value[0], value[1], value[2], t->sheet[sheet][p]);
    return isfinite(value[0]) && isfinite(value[1]) && isfinite(value[2]);
}

static bool evaluate_all(struct tessellation *t, const struct spline *s, struct err *err) {
    struct spline_cursor cursor;
    bool ok;
    if (!spline_cursor_init(&cursor, s, err)) return false;
    ok = true;
    for (uint32_t p = 0; ok && p < t->net.point_count; p++) {
        grid_nominal(&t->net, p, t->source[p]);
        for (int sheet = 0; ok && sheet < t->sheets; sheet++)
            ok = evaluate(t, &cursor, p, sheet) ||
                 err_set(err, ERR_REFUSAL, "the image of %g %g exceeds the range of numbers",
                         t->source[p][0], t->source[p][1]);
    }
    spline_cursor_free(&cursor);
    return ok;
}

static bool allocate(struct tessellation *t, struct err *err) {
    size_t n = t->net.point_count;
    return mem_new(t->source, n, err) && mem_new(t->sheet[0], n, err) &&
           (t->sheets == 1 || mem_new(t->sheet[1], n, err));
}

bool tessellate(struct tessellation *t, const struct spline *s, int steps, struct err *err) {
    INVARIANT(steps >= 1 && steps <= TESSELLATE_STEPS_MAX);
    *t = (struct tessellation){.net = s->grid, .sheets = s->sigma ? 2 : 1};
    if (!set_degree(&t->net, steps))
        return err_set(err, ERR_REFUSAL,
                       "%d steps an edge on %u triangles: more points than 32 bits can number",
                       steps, t->net.triangle_count);
    if (allocate(t, err) && evaluate_all(t, s, err)) return true;
    tessellation_free(t);
    return false;
}

void tessellation_free(struct tessellation *t) {
    free(t->source);
    free(t->sheet[0]);
    free(t->sheet[1]);
    *t = (struct tessellation){0};
}

void tessellation_face(const struct tessellation *t, uint32_t triangle, int row, int place,
                       uint32_t face[3]) {
    const struct grid *g = &t->net;
    int k = place / 2, i = g->degree - row, j = row - k;
    face[0] = grid_point(g, triangle, i, j, k);
    face[1] = grid_point(g, triangle, i - 1, j + 1, k);
    face[2] = grid_point(g, triangle, i - 1, j, k + 1);
    if (place % 2 == 1) {
        face[1] = face[2];
        face[2] = grid_point(g, triangle, i, j - 1, k + 1);
    }
}

void tessellation_step(const struct tessellation *t, uint32_t triangle, int l, int step,
                       uint32_t end[2]) {
    for (int m = 0; m < 2; m++) {
        int weight[3] = {0, 0, 0};
        weight[(l + 1) % 3] = t->net.degree - step - m;
        weight[(l + 2) % 3] = step + m;
        end[m] = grid_point(&t->net, triangle, weight[0], weight[1], weight[2]);
    }
}
