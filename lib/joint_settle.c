/* SPDX-License-Identifier: GPL-3.0-or-later */
/* At first all vertices are settled, tentatively; of a triangle that is not sound then, all three
 * are loosened, and so on until all are sound: in the end, if need be, when all are loose. After
 * that the triangulation is sound at every moment, and the loose vertices are treated one by one,
 * gently at first, with force when that leads no further. */
#include "joint.h"

#include "mem.h"
#include "num.h"

#include <math.h>
#include <string.h>

#define REACH 8 /* times what rounding moves a vertex: how far it may be moved gently */

enum {
    TRIES = 30, /* how many others give way to a vertex in a row */
    ROUNDS = 8, /* of thinning, if all have an effect */
};

/* What is loose, in the order in which it is tried. */
struct queue {
    uint32_t *vertex;
    size_t count;
    struct joint_star star, around;
};

static bool star_is_sound(struct joint *j, const struct joint_star *star) {
    for (size_t i = 0; i < star->count; i++)
        if (!joint_is_sound(j, star->corner[i] / 3)) return false;
    return true;
}

static bool try_to_settle(struct joint *j, uint32_t v, const struct joint_star *star) {
    j->settled[v] = true;
    return j->settled[v] = star_is_sound(j, star);
}

/* Moves w, inside, to where its triangles are sound wherever v is, loose or settled. */
static bool shift(struct joint *j, uint32_t w, uint32_t v, struct joint_star *star, bool *done,
                  struct err *err) {
    bool settled = j->settled[w];
    double old[2][2];
    *done = false;
    if (!joint_star(j, w, star, err)) return false;
    for (int m = 0; m < 2; m++) memcpy(old[m], j->wish[m][w], sizeof old[m]);
    j->settled[v] = true;
    if (joint_move(j, w, star, INFINITY)) {
        j->settled[v] = false;
        *done = star_is_sound(j, star);
    }
    j->settled[v] = false;
    if (*done) return true;
    j->settled[w] = settled;
    for (int m = 0; m < 2; m++) memcpy(j->wish[m][w], old[m], sizeof old[m]);
    return true;
}

/* Makes the corners of triangle t, around v, give way. */
static bool clear(struct joint *j, uint32_t t, uint32_t v, struct queue *q, bool *done,
                  struct err *err) {
    uint32_t corner[3];
    memcpy(corner, j->map.triangle[t], sizeof corner);
    *done = false;
    for (int c = 0; c < 3 && !*done; c++)
        if (corner[c] != v && !j->fixed[corner[c]] &&
            !joint_remove(j, corner[c], &q->around, done, err))
            return false;
    for (int c = 0; c < 3 && !*done; c++)
        if (corner[c] != v && !j->fixed[corner[c]] &&
            !shift(j, corner[c], v, &q->around, done, err))
            return false;
    return true;
}

/* Makes a neighbour of v give way: one of a triangle that would not be sound where v wants to
 * settle, if possible. */
static bool make_way(struct joint *j, uint32_t v, struct queue *q, bool *done, struct err *err) {
    *done = false;
    for (int round = 0; round < 2; round++)
        for (size_t i = 0; i < q->star.count && !*done; i++) {
            uint32_t t = q->star.corner[i] / 3;
            bool sound;
            j->settled[v] = true;
            sound = joint_is_sound(j, t);
            j->settled[v] = false;
            if (sound == (round == 1) && !clear(j, t, v, q, done, err)) return false;
        }
    return true;
}

/* Settles v, near by if need be, or takes it away. */
static bool treat(struct joint *j, uint32_t v, bool force, struct queue *q, bool *done,
                  struct err *err) {
    if (!joint_star(j, v, &q->star, err)) return false;
    *done = try_to_settle(j, v, &q->star);
    if (*done || j->fixed[v]) return true;
    *done = joint_move(j, v, &q->star, REACH);
    if (!*done && !joint_remove(j, v, &q->around, done, err)) return false;
    *done = *done || (force && joint_move(j, v, &q->star, INFINITY));
    return true;
}

/* The same; for vertices that are fixed or on the boundary, which cannot move, others give way at
 * once, else only by force. */
static bool insist(struct joint *j, uint32_t v, bool force, struct queue *q, bool *done,
                   struct err *err) {
    bool cleared = true;
    if (!treat(j, v, force, q, done, err)) return false;
    if (!force && !j->fixed[v] && !q->star.boundary) return true;
    for (int tries = 0; tries < TRIES && cleared && !*done; tries++)
        if (!make_way(j, v, q, &cleared, err) || !treat(j, v, force, q, done, err)) return false;
    return true;
}

static bool is_loose(const struct joint *j, uint32_t v) {
    return j->corner[v] != JOINT_NONE && !j->settled[v];
}

static bool pass(struct joint *j, bool force, struct queue *q, bool *progress, struct err *err) {
    size_t left = 0;
    *progress = false;
    for (size_t i = 0; i < q->count; i++) {
        uint32_t v = q->vertex[i];
        bool done = false;
        if (is_loose(j, v) && !insist(j, v, force, q, &done, err)) return false;
        *progress = *progress || done;
    }
    for (size_t i = 0; i < q->count; i++)
        if (is_loose(j, q->vertex[i])) q->vertex[left++] = q->vertex[i];
    q->count = left;
    return true;
}

static bool settle_queue(struct joint *j, struct queue *q, struct err *err) {
    bool progress = true, force = false;
    while (q->count > 0 && (progress || !force)) {
        force = !progress;
        if (!pass(j, force, q, &progress, err)) return false;
    }
    if (q->count == 0) return true;
    const double *p = j->map.at[1][q->vertex[0]];
    return err_set(err, ERR_REFUSAL,
                   "precision: the vertices near (%.9g, %.9g) of the target lie too close together "
                   "for the digits that are to be written",
                   p[0], p[1]);
}

/* Loosens all vertices, or as many as it takes for all triangles to be sound. */
static bool loosen(struct joint *j, bool all, struct joint_star *star, struct err *err) {
    size_t count = 0, cap = 0;
    uint32_t *todo = NULL;
    bool ok = mem_grow(todo, &cap, j->map.triangle_count, err);
    for (size_t t = 0; ok && t < j->map.triangle_count; t++)
        if (j->map.triangle[t][0] != JOINT_NONE) todo[count++] = (uint32_t)t;
    while (ok && count > 0) {
        uint32_t t = todo[--count];
        const uint32_t *corner = j->map.triangle[t];
        if (!all && joint_is_sound(j, t)) continue;
        INVARIANT(all || j->settled[corner[0]] || j->settled[corner[1]] || j->settled[corner[2]]);
        for (int c = 0; ok && c < 3; c++) {
            if (!j->settled[corner[c]]) continue;
            j->settled[corner[c]] = false;
            ok = joint_star(j, corner[c], star, err) &&
                 mem_grow(todo, &cap, count + star->count, err);
            for (size_t i = 0; ok && i < star->count; i++) todo[count++] = star->corner[i] / 3;
        }
    }
    free(todo);
    return ok;
}

/* Fixed vertices first, then those on the boundary, because others make way for them. */
static bool enqueue(struct joint *j, struct queue *q, struct err *err) {
    for (int round = 0; round < 3; round++)
        for (uint32_t v = 0; v < j->map.vertex_count; v++) {
            int rank = j->fixed[v] ? 0 : 2;
            if (!is_loose(j, v)) continue;
            if (rank == 2 && !joint_star(j, v, &q->star, err)) return false;
            if (rank == 2 && q->star.boundary) rank = 1;
            if (rank == round) q->vertex[q->count++] = v;
        }
    return true;
}

static bool make_wishes(struct joint *j, const int digits[2], struct err *err) {
    for (int m = 0; m < 2; m++) {
        j->digits[m] = digits[m];
        if (!mem_new(j->wish[m], j->map.vertex_count, err)) return false;
        for (size_t v = 0; v < j->map.vertex_count; v++)
            for (int c = 0; c < 2; c++)
                j->wish[m][v][c] = num_rounded(j->map.at[m][v][c], digits[m]);
    }
    for (size_t v = 0; v < j->map.vertex_count; v++) j->settled[v] = true;
    return true;
}

static void keep_wishes(struct joint *j) {
    joint_forget(j);
    for (int m = 0; m < 2; m++) {
        free(j->map.at[m]);
        j->map.at[m] = j->wish[m];
        j->wish[m] = NULL;
    }
    j->meaning = NULL;
    memset(j->settled, 0, j->map.vertex_count * sizeof *j->settled);
}

/* Is v, in a plane, so close to an edge opposite it? */
static bool is_tight(const struct joint *j, uint32_t v, double slack,
                     const struct joint_star *star) {
    for (int m = 0; m < 2; m++)
        for (size_t i = 0; i < star->count; i++) {
            const uint32_t *t = j->map.triangle[star->corner[i] / 3];
            uint32_t c = star->corner[i] % 3;
            const double *p = joint_place(j, m, v), *a = joint_place(j, m, t[(c + 1) % 3]),
                         *b = joint_place(j, m, t[(c + 2) % 3]);
            double x = b[0] - a[0], y = b[1] - a[1];
            double height = x * (p[1] - a[1]) - y * (p[0] - a[0]);
            if (!(height > slack * joint_rounding(j, m, v) * sqrt(x * x + y * y))) return true;
        }
    return false;
}

/* Takes away what is tight while all around it is where it is meant: later, when vertices lie on
 * the lines of a lattice, that is harder. */
static bool thin(struct joint *j, double slack, struct queue *q, struct err *err) {
    bool again = true;
    for (int round = 0; round < ROUNDS && again; round++) {
        again = false;
        for (size_t i = 0; i < q->count; i++) {
            uint32_t v = q->vertex[i];
            bool done = false;
            if (j->fixed[v] || !is_loose(j, v)) continue;
            if (!joint_star(j, v, &q->star, err)) return false;
            if (is_tight(j, v, slack, &q->star) && !joint_remove(j, v, &q->star, &done, err))
                return false;
            again = again || done;
        }
    }
    return true;
}

bool joint_settle(struct joint *j, const int digits[2], double slack, struct err *err) {
    struct queue q = {0};
    bool ok = mem_new(q.vertex, j->map.vertex_count, err) && make_wishes(j, digits, err) &&
              loosen(j, slack > JOINT_SLACK, &q.star, err);
    ok = ok && enqueue(j, &q, err) && thin(j, slack, &q, err) && settle_queue(j, &q, err);
    if (ok) keep_wishes(j);
    free(q.vertex);
    free(q.star.corner);
    free(q.around.corner);
    return ok;
}
