/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A part is halved by the midpoint m of its edge opposite corner 0: each row i = const of the
 * coefficients belongs to a polynomial on that edge, and de Casteljau's averages give both halves.
 *
 *            v0                            (m, v0, v1) and (m, v2, v0) are the new corners: the
 * edge /  |  \                         opposite m is halved next (newest vertex bisection), so v1
 * -- m -- v2                      that only four shapes of triangles ever occur.
 *
 * With weights (i, j, k) on (v0, v1, m), the coefficient goes to (k, i, j); with (i, j, k) on
 * (v0, m, v2) to (j, k, i).
 *
 * Errors. An average (x + y) / 2 of numbers of magnitude <= C rounds by u C at most, u = 2^-53
 * (halving is exact, but for underflow below 2^-1074, which 2^-900 <= C drowns), and never exceeds
 * C. A coefficient of a half went through n averages at most, so each generation adds n u C to the
 * error; the code takes twice that, which also covers the rounding of the bound. */
#include "least.h"

#include "mem.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A generation that does not fit, or a late one, is a case for exact arithmetic. */
enum { PARTS_MAX = 48, GENERATIONS_MAX = 44 };

struct part {
    double c[LEAST_SIZE_MAX];
    double corner[3][3]; /* barycentric coordinates */
};

struct least_room {
    struct part part[2][PARTS_MAX + 2]; /* this generation and the next */
};

struct least_room *least_room_new(struct err *err) {
    struct least_room *room;
    return mem_new(room, 1, err) ? room : NULL;
}

void least_room_free(struct least_room *room) {
    free(room);
}

static double least_of(int size, const double *c) {
    double low = c[0];
    for (int i = 1; i < size; i++) low = c[i] < low ? c[i] : low;
    return low;
}

/* The indices of the corners' coefficients. */
static void corners_of(int n, int at[3]) {
    at[0] = 0;
    at[1] = n * (n + 1) / 2;
    at[2] = at[1] + n;
}

void least_quick(int n, const double *c, double error, struct least *f) {
    int at[3], best = 0;
    corners_of(n, at);
    for (int l = 1; l < 3; l++)
        if (c[at[l]] < c[at[best]]) best = l;
    *f = (struct least){.low = least_of(least_size(n), c) - error * (1 + DBL_EPSILON),
                        .high = c[at[best]] + error * (1 + DBL_EPSILON)};
    f->low -= fabs(f->low) * DBL_EPSILON;
    f->high += fabs(f->high) * DBL_EPSILON;
    f->place[best] = 1;
}

static void halve(int n, const struct part *p, struct part *left, struct part *right) {
    double row[LEAST_DEGREE_MAX + 1];
    for (int r = 0; r <= n; r++) {
        memcpy(row, p->c + r * (r + 1) / 2, (size_t)(r + 1) * sizeof *row);
        for (int k = 0; k <= r; k++) {
            int base = (n - k) * (n - k + 1) / 2; /* what is next to m at stage k */
            left->c[base + r - k] = row[0];
            right->c[base + n - r] = row[r - k];
            for (int i = 0; i < r - k; i++) row[i] = (row[i] + row[i + 1]) * 0.5;
        }
    }
    for (int l = 0; l < 3; l++) {
        double m = (p->corner[1][l] + p->corner[2][l]) * 0.5;
        left->corner[0][l] = right->corner[0][l] = m;
        left->corner[1][l] = right->corner[2][l] = p->corner[0][l];
        left->corner[2][l] = p->corner[1][l];
        right->corner[1][l] = p->corner[2][l];
    }
}

static void copy(int n, struct part *to, const struct part *from) {
    memcpy(to->c, from->c, (size_t)least_size(n) * sizeof *to->c);
    memcpy(to->corner, from->corner, sizeof to->corner);
}

/* Lowers the upper bound by the part's corners; returns the part's own lower bound. */
static double look(int n, const struct part *p, double error, struct least *f) {
    struct least own;
    least_quick(n, p->c, error, &own);
    if (own.high < f->high) {
        int l = own.place[0] == 1 ? 0 : own.place[1] == 1 ? 1 : 2;
        f->high = own.high;
        memcpy(f->place, p->corner[l], sizeof f->place);
    }
    return own.low;
}

/* Parts whose values are all above this matter no more. */
static double limit(double high, double tolerance) {
    return high - fabs(high) * tolerance;
}

/* Halves the `count` parts of one generation; keeps those that matter, first in the other half of
 * the room. The bound of those dropped goes into *dropped, of those kept into f->low. */
static int generation(struct least_room *room, int which, int count, int n, double error,
                      const struct least_rule *rule, double *dropped, struct least *f) {
    struct part *next = room->part[1 - which];
    int kept = 0;
    f->low = INFINITY;
    for (int i = 0; i < count && kept <= PARTS_MAX - 2; i++) {
        double low[2];
        halve(n, &room->part[which][i], &next[kept], &next[kept + 1]);
        for (int h = 0; h < 2; h++) low[h] = look(n, &next[kept + h], error, f);
        for (int h = 0, first = kept; h < 2; h++) {
            if (low[h] >= limit(f->high, rule->tolerance)) {
                *dropped = fmin(*dropped, low[h]);
                continue;
            }
            f->low = fmin(f->low, low[h]);
            if (kept != first + h) copy(n, &next[kept], &next[first + h]);
            kept++;
        }
        if (kept > PARTS_MAX - 2 && i + 1 < count) return -1;
    }
    return kept;
}

static bool settled(const struct least *f, const struct least_rule *rule) {
    return (f->low > 0 || f->high < 0) && f->low >= limit(f->high, rule->tolerance);
}

bool least_double(struct least_room *room, int n, const double *c, double error,
                  const struct least_rule *rule, struct least *f) {
    double largest = 0, dropped = INFINITY;
    int count = 1;
    INVARIANT(n >= 0 && n <= LEAST_DEGREE_MAX);
    for (int i = 0; i < least_size(n); i++) largest = fabs(c[i]) > largest ? fabs(c[i]) : largest;
    least_quick(n, c, error, f);
    if (settled(f, rule)) return true;
    if (!(largest >= 0x1p-900 && largest <= 0x1p900)) return false;
    memcpy(room->part[0]->c, c, (size_t)least_size(n) * sizeof *c);
    for (int l = 0; l < 3; l++)
        for (int m = 0; m < 3; m++) room->part[0]->corner[l][m] = l == m;
    for (int g = 0; g < GENERATIONS_MAX; g++) {
        double before = f->low;
        error += n * 0x1p-52 * largest;
        count = generation(room, g & 1, count, n, error, rule, &dropped, f);
        if (count < 0) f->low = before;
        if (count < 0 || (count > 0 && f->high - f->low <= 16 * error)) break; /* mostly errors */
        if (count == 0) break;
    }
    f->low = fmin(f->low, dropped);
    return settled(f, rule);
}
