/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The places where a vertex leaves its star sound are the kernel of the polygon of its neighbours:
 * what lies left of all edges that its triangles have opposite it. What is tried are the rounded
 * points of the lines from the place that is meant to the kernel's corners and its middle, the
 * nearest first. The kernel is computed in doubles, places that are tried are judged exactly. */
#include "joint.h"

#include "halfedge.h"
#include "num.h"

#include <math.h>
#include <string.h>

enum { CORNERS_MAX = JOINT_STAR_MAX + 4 };

struct kernel {
    double origin[2];
    int n;
    double corner[CORNERS_MAX + 1][2]; /* from the origin; room for the middle */
};

/* The unit of the last digit of x is 10^(1 - digits) |x| at most. */
double joint_rounding(const struct joint *j, int plane, uint32_t v) {
    const double *p = j->map.at[plane][v];
    double most = fmax(fabs(p[0]), fabs(p[1]));
    if (j->digits[plane] == 0) return j->meaning ? j->meaning->error[plane] : 0;
    for (int d = 0; d < j->digits[plane]; d++) most /= 10;
    return 5 * most;
}

static double height(const double a[2], const double b[2], const double p[2]) {
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* Leaves of the kernel what lies left of ab. */
static void clip(struct kernel *k, const double a[2], const double b[2]) {
    struct kernel left = {.n = 0};
    for (int i = 0; i < k->n; i++) {
        const double *p = k->corner[i], *q = k->corner[(i + 1) % k->n];
        double at_p = height(a, b, p), at_q = height(a, b, q);
        if (at_p >= 0) memcpy(left.corner[left.n++], p, sizeof left.corner[0]);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        for (int c = 0; c < 2; c++)
            left.corner[left.n][c] = p[c] + at_p / (at_p - at_q) * (q[c] - p[c]);
        left.n++;
    }
    if (left.n < 3) return; /* for want of precision: it is not empty */
    k->n = left.n;
    memcpy(k->corner, left.corner, (size_t)left.n * sizeof k->corner[0]);
}

static void middle(struct kernel *k) {
    double sum[2] = {0, 0};
    for (int i = 0; i < k->n; i++)
        for (int c = 0; c < 2; c++) sum[c] += k->corner[i][c];
    for (int c = 0; c < 2; c++) k->corner[k->n][c] = sum[c] / k->n;
    k->n++;
}

static const double *end_place(const struct joint *j, int plane, uint32_t corner, bool to) {
    const uint32_t(*triangle)[3] = (const uint32_t(*)[3])j->map.triangle;
    return joint_place(j, plane,
                       to ? halfedge_to(triangle, corner) : halfedge_from(triangle, corner));
}

static void find_kernel(const struct joint *j, int plane, uint32_t v, const struct joint_star *star,
                        struct kernel *k) {
    double size = 0, end[2][2];
    memcpy(k->origin, j->map.at[plane][v], sizeof k->origin);
    for (size_t i = 0; i < star->count; i++)
        for (int c = 0; c < 2; c++)
            size = fmax(size, fabs(end_place(j, plane, star->corner[i], false)[c] - k->origin[c]));
    k->n = 4;
    for (int i = 0; i < 4; i++) { /* a square, counter-clockwise */
        k->corner[i][0] = i == 1 || i == 2 ? size : -size;
        k->corner[i][1] = i >= 2 ? size : -size;
    }
    for (size_t i = 0; i < star->count; i++) {
        for (int e = 0; e < 2; e++)
            for (int c = 0; c < 2; c++)
                end[e][c] = end_place(j, plane, star->corner[i], e == 1)[c] - k->origin[c];
        clip(k, end[0], end[1]);
    }
    middle(k);
}

static bool is_sound(struct joint *j, int plane, const struct joint_star *star) {
    for (size_t i = 0; i < star->count; i++) {
        const uint32_t *t = j->map.triangle[star->corner[i] / 3];
        if (joint_orient(j, plane, t[0], t[1], t[2]) <= 0) return false;
    }
    return true;
}

static bool try_place(struct joint *j, int plane, uint32_t v, const struct joint_star *star,
                      const struct kernel *k, int corner, double step, double reach) {
    double *wish = j->wish[plane][v], at[2];
    bool same = true;
    for (int c = 0; c < 2; c++) {
        double offset = step * k->corner[corner][c];
        at[c] = num_rounded(k->origin[c] + offset, j->digits[plane]);
        if (!(fabs(at[c] - k->origin[c]) <= reach)) return false;
        same = same && at[c] == wish[c];
    }
    if (same) return false;
    memcpy(wish, at, sizeof at);
    return is_sound(j, plane, star);
}

static bool move_in(struct joint *j, int plane, uint32_t v, const struct joint_star *star,
                    double reach) {
    struct kernel k;
    if (is_sound(j, plane, star)) return true;
    find_kernel(j, plane, v, star, &k);
    for (double step = 0x1p-60; step <= 1; step *= 2)
        for (int i = k.n - 1; i >= 0; i--)
            if (try_place(j, plane, v, star, &k, i, step, reach * joint_rounding(j, plane, v)))
                return true;
    return false;
}

bool joint_move(struct joint *j, uint32_t v, const struct joint_star *star, double reach) {
    double old[2][2];
    if (star->boundary || star->count > JOINT_STAR_MAX) return false;
    for (int m = 0; m < 2; m++) memcpy(old[m], j->wish[m][v], sizeof old[m]);
    j->settled[v] = true;
    if (move_in(j, 0, v, star, reach) && move_in(j, 1, v, star, reach)) return true;
    j->settled[v] = false;
    for (int m = 0; m < 2; m++) memcpy(j->wish[m][v], old[m], sizeof old[m]);
    return false;
}
