/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors. Let coordinates be at most 1, each within e of the true one, and u = 2^-53. A direction m
 * is any pair of doubles, without error. Then m.x computed is within (|m_x| + |m_y|)(e + 3u) of the
 * true value, to first order: a product rounds by u |m_x|, their sum by u (|m_x| + |m_y|). The code
 * takes e + 4u. For the difference of two points it is twice that. A direction so short that its
 * products might underflow proves nothing. */
#include "arc.h"

#include <math.h>
#include <string.h>

static double spread(const double m[2], double error) {
    double length = fabs(m[0]) + fabs(m[1]);
    return length > 0x1p-900 ? length * (error + 0x1p-51) : INFINITY;
}

static double dot(const double m[2], const double x[2]) {
    return m[0] * x[0] + m[1] * x[1];
}

static double cross(const double x[2], const double y[2]) {
    return x[0] * y[1] - x[1] * y[0];
}

static double larger_error(int d, const struct arc *a, const struct arc *b) {
    return arc_error(d, a->level > b->level ? a->level : b->level);
}

/* Differences to qa[0], halved lest they overflow; the halving is exact but for subnormal numbers,
 * which lose less than 2^-53 of what arc_load accepts. */
static double subtract(int d, const double (*q)[2], const double origin[2], struct arc *a) {
    double most = 0;
    a->level = 0;
    a->index = 0;
    for (int i = 0; i <= d; i++)
        for (int c = 0; c < 2; c++) {
            a->c[i][c] = q[i][c] * 0.5 - origin[c] * 0.5;
            most = fmax(most, fabs(a->c[i][c]));
        }
    return most;
}

static void scale(int d, int exponent, struct arc *a) {
    double factor = ldexp(1, -exponent / 2), rest = ldexp(1, -exponent - -exponent / 2);
    for (int i = 0; i <= d; i++)
        for (int c = 0; c < 2; c++) a->c[i][c] = a->c[i][c] * factor * rest;
}

bool arc_load(int d, const double (*qa)[2], const double (*qb)[2], struct arc *a, struct arc *b) {
    double most = fmax(subtract(d, qa, qa[0], a), subtract(d, qb, qa[0], b));
    int exponent;
    if (most < 0x1p-1000) return false;
    (void)frexp(most, &exponent);
    scale(d, exponent, a);
    scale(d, exponent, b);
    return true;
}

void arc_halve(int d, const struct arc *a, struct arc half[2]) {
    double row[ARC_DEGREE_MAX + 1][2];
    memcpy(row, a->c, sizeof row);
    for (int h = 0; h < 2; h++) {
        half[h].level = a->level + 1;
        half[h].index = 2 * a->index + (uint64_t)h;
    }
    for (int k = 0; k <= d; k++)
        for (int c = 0; c < 2; c++) {
            half[0].c[k][c] = row[0][c];
            half[1].c[d - k][c] = row[d - k][c];
            for (int i = 0; i < d - k; i++) row[i][c] = (row[i][c] + row[i + 1][c]) * 0.5;
        }
}

double arc_size(int d, const struct arc *a) {
    double size = 0;
    for (int c = 0; c < 2; c++) {
        double lo = a->c[0][c], hi = lo;
        for (int i = 1; i <= d; i++) {
            lo = a->c[i][c] < lo ? a->c[i][c] : lo;
            hi = a->c[i][c] > hi ? a->c[i][c] : hi;
        }
        size = fmax(size, hi - lo);
    }
    return size;
}

/* Differences of control points; returns their number. */
static int differences(int d, const struct arc *a, double (*x)[2]) {
    for (int i = 0; i < d; i++)
        for (int c = 0; c < 2; c++) x[i][c] = a->c[i + 1][c] - a->c[i][c];
    return d;
}

/* The bisector of the angle that n directions span, if it is less than 180 degrees. */
static void bisect(int n, const double (*x)[2], double m[2]) {
    const double *low = x[0], *high = x[0];
    double length[2];
    for (int i = 1; i < n; i++) {
        if (cross(low, x[i]) < 0) low = x[i];
        if (cross(high, x[i]) > 0) high = x[i];
    }
    length[0] = sqrt(dot(low, low));
    length[1] = sqrt(dot(high, high));
    for (int c = 0; c < 2; c++) m[c] = low[c] / length[0] + high[c] / length[1];
}

bool arc_monotone(int d, const struct arc *a, const struct arc *b) {
    double x[2 * ARC_DEGREE_MAX][2] = {{0}}, m[2], error;
    int n = differences(d, a, x);
    if (b) n += differences(d, b, x + n);
    bisect(n, (const double(*)[2])x, m);
    error = 2 * spread(m, larger_error(d, a, b ? b : a));
    for (int i = 0; i < n; i++)
        if (!(dot(m, x[i]) > error)) return false; /* nan, too */
    return true;
}

struct range {
    double lo, hi;
};

static struct range range_along(const double m[2], int d, const struct arc *a) {
    struct range r = {INFINITY, -INFINITY};
    for (int i = 0; i <= d; i++) {
        double x = dot(m, a->c[i]);
        r.lo = x < r.lo ? x : r.lo;
        r.hi = x > r.hi ? x : r.hi;
    }
    return r;
}

static void chord_normal(int d, const struct arc *a, double m[2]) {
    m[0] = a->c[0][1] - a->c[d][1];
    m[1] = a->c[d][0] - a->c[0][0];
}

double arc_width(int d, const struct arc *a) {
    double m[2];
    struct range r;
    chord_normal(d, a, m);
    if (m[0] == 0 && m[1] == 0) return arc_size(d, a);
    r = range_along(m, d, a);
    return (r.hi - r.lo) / sqrt(dot(m, m));
}

bool arc_apart(int d, const struct arc *a, const struct arc *b) {
    double m[4][2] = {{1, 0}, {0, 1}}, error = larger_error(d, a, b);
    chord_normal(d, a, m[2]);
    chord_normal(d, b, m[3]);
    for (int i = 0; i < 4; i++) {
        struct range ra = range_along(m[i], d, a), rb = range_along(m[i], d, b);
        double margin = 2 * spread(m[i], error);
        if (ra.lo - rb.hi > margin || rb.lo - ra.hi > margin) return true;
    }
    return false;
}

/* Does a go from one side of b to the other, along m? */
static bool passes(int d, const struct arc *a, const struct arc *b, const double m[2],
                   double error) {
    struct range r = range_along(m, d, b);
    double begin = dot(m, a->c[0]), end = dot(m, a->c[d]), margin = 2 * spread(m, error);
    return (r.lo - begin > margin && end - r.hi > margin) ||
           (r.lo - end > margin && begin - r.hi > margin);
}

bool arc_cross(int d, const struct arc *a, const struct arc *b) {
    double ma[2], mb[2], error = larger_error(d, a, b);
    chord_normal(d, a, ma);
    chord_normal(d, b, mb);
    return fabs(cross(ma, mb)) > 0x1p-50 * (fabs(ma[0] * mb[1]) + fabs(ma[1] * mb[0])) &&
           passes(d, a, b, mb, error) && passes(d, b, a, ma, error);
}
