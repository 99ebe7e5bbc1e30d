/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Row by row. In a row, points nearer than the clearance to a side are blocked, and a point that is
 * not blocked is inside if it has an odd number of the row's crossings with sides on its left:
 *
 *     ....xxx|xxx.......xx\xxx....      x blocked, | \ sides
 *
 * Crossings are rounded, but no point that counts is near one. Each side is listed in the rows that
 * it comes near to. */
#include "cage_fill.h"

#include "mem.h"
#include "segment.h"

#include <math.h>
#include <string.h>

#define ROW_X 0.9950041652780258 /* cosine and sine of 0.1: the angle between rows and the axis */
#define ROW_Y 0.09983341664682815
#define ROUND 1e-6 /* relative difference of principal moments from which on an axis is certain */

/* Where the lattice lies: centre + rotation by (x, y) of what is in its own frame. */
struct frame {
    double centre[2], x, y;
};

struct fill {
    const struct cage *cage;
    struct frame frame;
    double (*vertex)[2]; /* the cage's, in the frame */
    double clearance;
    double step[2];          /* point i of row j: (i + (j odd ? 1/2 : 0), j) step */
    int64_t low[2], high[2]; /* numbers of columns and rows that may be used */
    size_t *start;           /* row j: side[start[j - low] .. start[j - low + 1]) */
    uint32_t *side;
    double *crossing;
    int64_t *blocked; /* of a column: the last row where it was */
    double (*point)[2];
    size_t count, cap, limit;
};

/* ---- the frame ---- */

/* Integrals over the cage, in diameters from vertex 0: 1, x, y, then about the centroid x^2, xy,
 * y^2; as sums over the triangles of vertex 0 and each side, (0, a, b). */
static void integrate(const struct cage *c, const double centre[2], double sum[6]) {
    const double *o = c->vertex[0];
    memset(sum, 0, 6 * sizeof *sum);
    for (uint32_t k = 0; k < c->count; k++) {
        double a[2], b[2], area;
        for (int i = 0; i < 2; i++) {
            a[i] = (c->vertex[k][i] - o[i]) / c->diameter - centre[i];
            b[i] = (c->vertex[cage_next(c, k)][i] - o[i]) / c->diameter - centre[i];
        }
        area = (a[0] * b[1] - a[1] * b[0]) / 2;
        sum[0] += area;
        for (int i = 0; i < 2; i++) sum[1 + i] += area * (a[i] + b[i]) / 3;
        for (int i = 0; i < 3; i++) {
            int u = i == 2, v = i > 0;
            sum[3 + i] += area * (a[u] * a[v] + b[u] * b[v] + (a[u] + b[u]) * (a[v] + b[v])) / 12;
        }
    }
}

/* The direction of the longer principal axis: half the angle of (xx - yy, 2 xy). False: there is
 * none, but for rounding. */
static bool find_axis(const double second[3], double axis[2]) {
    double p = second[0] - second[2], q = 2 * second[1], r = sqrt(p * p + q * q);
    if (!(r > ROUND * (second[0] + second[2]))) return false;
    axis[0] = sqrt((1 + p / r) / 2);
    axis[1] = sqrt((1 - p / r) / 2) * (q < 0 ? -1 : 1);
    return true;
}

/* Sums over the sides of x^2, xy, y^2 of their midpoints from the centre, in diameters. */
static void weigh_sides(const struct cage *c, const double *weight, const double centre[2],
                        double second[3]) {
    memset(second, 0, 3 * sizeof *second);
    for (uint32_t k = 0; k < c->count; k++) {
        const double *a = c->vertex[k], *b = c->vertex[cage_next(c, k)];
        double m[2], w = weight ? weight[k] : 1;
        for (int i = 0; i < 2; i++)
            m[i] = (a[i] - centre[i] + (b[i] - centre[i])) / (2 * c->diameter);
        for (int i = 0; i < 3; i++) second[i] += w * (m[i == 2] * m[i > 0]);
    }
}

static struct frame find_frame(const struct cage *c, const double *weight) {
    static const double origin[2] = {0, 0};
    double sum[6], centroid[2], sides[3], axis[2] = {1, 0};
    struct frame f;
    integrate(c, origin, sum);
    for (int i = 0; i < 2; i++) centroid[i] = sum[1 + i] / sum[0];
    integrate(c, centroid, sum);
    for (int i = 0; i < 2; i++) f.centre[i] = c->vertex[0][i] + c->diameter * centroid[i];
    weigh_sides(c, weight, f.centre, sides);
    if (!find_axis(sum + 3, axis)) (void)find_axis(sides, axis);
    f.x = ROW_X * axis[0] - ROW_Y * axis[1];
    f.y = ROW_Y * axis[0] + ROW_X * axis[1];
    return f;
}

static void to_frame(const struct frame *f, const double p[2], double q[2]) {
    double x = p[0] - f->centre[0], y = p[1] - f->centre[1];
    q[0] = f->x * x + f->y * y;
    q[1] = f->x * y - f->y * x;
}

static void from_frame(const struct frame *f, const double p[2], double q[2]) {
    q[0] = f->centre[0] + (f->x * p[0] - f->y * p[1]);
    q[1] = f->centre[1] + (f->y * p[0] + f->x * p[1]);
}

/* ---- rows and columns ---- */

static double column_x(const struct fill *f, int64_t i, int64_t j) {
    return ((double)i + (j & 1 ? 0.5 : 0)) * f->step[0];
}

/* The first row or column at or beyond x, of those in use. */
static int64_t number(const struct fill *f, int axis, double x) {
    double n = ceil(x / f->step[axis]);
    return (int64_t)fmin(fmax(n, (double)f->low[axis]), (double)f->high[axis] + 1);
}

static const double *end_of(const struct fill *f, uint32_t side, int which) {
    return f->vertex[which ? cage_next(f->cage, side) : side];
}

static void rows_of(const struct fill *f, uint32_t side, int64_t *first, int64_t *end) {
    double a = end_of(f, side, 0)[1], b = end_of(f, side, 1)[1];
    *first = number(f, 1, fmin(a, b) - f->clearance);
    *end = number(f, 1, fmax(a, b) + f->clearance);
}

static bool list_sides(struct fill *f, struct err *err) {
    size_t rows = (size_t)(f->high[1] - f->low[1] + 1);
    int64_t first, end;
    if (!mem_new(f->start, rows + 2, err)) return false;
    for (uint32_t k = 0; k < f->cage->count; k++) {
        rows_of(f, k, &first, &end);
        for (int64_t j = first; j < end; j++) f->start[j - f->low[1] + 2]++;
    }
    for (size_t j = 2; j < rows + 2; j++) f->start[j] += f->start[j - 1];
    if (!mem_new(f->side, f->start[rows + 1], err)) return false;
    for (uint32_t k = 0; k < f->cage->count; k++) {
        rows_of(f, k, &first, &end);
        for (int64_t j = first; j < end; j++) f->side[f->start[j - f->low[1] + 1]++] = k;
    }
    return true;
}

/* Where a side is at height y, or at its end if it does not reach that. */
static double side_x(const double *a, const double *b, double y) {
    double lambda = a[1] == b[1] ? 0.5 : (y - a[1]) / (b[1] - a[1]);
    return a[0] + fmin(fmax(lambda, 0), 1) * (b[0] - a[0]);
}

/* Blocks what lies too near to a side in row j. */
static void block(struct fill *f, uint32_t side, int64_t j) {
    const double *a = end_of(f, side, 0), *b = end_of(f, side, 1);
    double y = (double)j * f->step[1], r = f->clearance;
    double x0 = side_x(a, b, y - r), x1 = side_x(a, b, y + r);
    if (a[1] == b[1]) x0 = a[0], x1 = b[0];
    int64_t end = number(f, 0, fmax(x0, x1) + r);
    for (int64_t i = number(f, 0, fmin(x0, x1) - r - f->step[0]); i < end; i++) {
        double p[2] = {column_x(f, i, j), y}, lambda;
        if (segment_distance2(a, b, p, &lambda) < r * r) f->blocked[i - f->low[0]] = j;
    }
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Puts the row's crossings in order; returns how many. */
static size_t find_crossings(struct fill *f, int64_t j) {
    const size_t *start = &f->start[j - f->low[1]];
    double y = (double)j * f->step[1];
    size_t n = 0;
    for (size_t at = start[0]; at < start[1]; at++) {
        const double *a = end_of(f, f->side[at], 0), *b = end_of(f, f->side[at], 1);
        if ((a[1] > y) != (b[1] > y)) f->crossing[n++] = side_x(a, b, y);
    }
    qsort(f->crossing, n, sizeof *f->crossing, compare);
    return n;
}

static bool fill_row(struct fill *f, int64_t j, struct err *err) {
    const size_t *start = &f->start[j - f->low[1]];
    size_t n = find_crossings(f, j);
    for (size_t at = start[0]; at < start[1]; at++) block(f, f->side[at], j);
    for (size_t c = 0; c + 1 < n; c += 2) {
        int64_t i = number(f, 0, f->crossing[c] - f->step[0]);
        int64_t end = number(f, 0, f->crossing[c + 1]);
        for (; i < end; i++) {
            double x = column_x(f, i, j);
            if (f->blocked[i - f->low[0]] == j || x < f->crossing[c] || x > f->crossing[c + 1])
                continue;
            if (f->count == f->limit)
                return err_set(err, ERR_REFUSAL, "more than %zu points inside", f->limit);
            if (!mem_grow(f->point, &f->cap, f->count + 1, err)) return false;
            from_frame(&f->frame, (double[2]){x, (double)j * f->step[1]}, f->point[f->count++]);
        }
    }
    return true;
}

static bool prepare(struct fill *f, const double *weight, double spacing, struct err *err) {
    const struct cage *c = f->cage;
    double lo[2] = {0, 0}, hi[2] = {0, 0};
    f->frame = find_frame(c, weight);
    f->step[0] = spacing;
    f->step[1] = spacing * (sqrt(3) / 2);
    if (!mem_new(f->vertex, c->count, err) || !mem_new(f->crossing, c->count, err)) return false;
    for (size_t k = 0; k < c->count; k++) {
        to_frame(&f->frame, c->vertex[k], f->vertex[k]);
        for (int i = 0; i < 2; i++) {
            lo[i] = fmin(lo[i], f->vertex[k][i]);
            hi[i] = fmax(hi[i], f->vertex[k][i]);
        }
    }
    for (int i = 0; i < 2; i++) {
        f->low[i] = (int64_t)ceil(lo[i] / f->step[i]) - 1;
        f->high[i] = (int64_t)floor(hi[i] / f->step[i]) + 1;
    }
    size_t columns = (size_t)(f->high[0] - f->low[0] + 1);
    if (!mem_new(f->blocked, columns, err)) return false;
    for (size_t i = 0; i < columns; i++) f->blocked[i] = INT64_MIN;
    return list_sides(f, err);
}

bool cage_fill(const struct cage *c, const double *weight, double spacing, double clearance,
               size_t limit, double (**point)[2], size_t *count, struct err *err) {
    struct fill f = {.cage = c, .clearance = clearance, .limit = limit};
    bool ok = prepare(&f, weight, spacing, err);
    for (int64_t j = f.low[1]; ok && j <= f.high[1]; j++) ok = fill_row(&f, j, err);
    free(f.vertex);
    free(f.start);
    free(f.side);
    free(f.crossing);
    free(f.blocked);
    if (!ok) free(f.point);
    *point = ok ? f.point : NULL;
    *count = ok ? f.count : 0;
    return ok;
}
