/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The board is the product of two square waves, q(s) q(t), q = 1 on [0,1), -1 on [1,2), and so on.
 * With the triangle wave Q(s) = integral of q from 0 to s, which is periodic,
 *
 *     integral of q(s) q(t) over a polygon = sum over its sides of  integral Q(s) q(t) dt.
 *
 * A side is cut where s or t is a whole number; on each piece Q(s) is linear and q(t) constant, so
 * that the middle of the piece gives its integral. */
#include "checker.h"

#include <math.h>
#include <stdbool.h>

/* Of numbers that are not large. */
static inline int floor_of(double x) {
    int n = (int)x;
    return n - (n > x);
}

static inline double square_wave(double t) {
    return floor_of(t) & 1 ? -1 : 1;
}

static inline double triangle_wave(double s) {
    double r = s - (floor_of(s) & ~1);
    return r < 1 ? r : 2 - r;
}

/* The whole numbers between two ends, as parameters 0..1 of the way from one to the other. */
struct cuts {
    double begin, length;
    double next, step; /* parameters of the next one, and from one to the next; 1 is beyond all */
};

static struct cuts cuts_of(double from, double to) {
    struct cuts c = {.begin = from, .length = to - from, .next = 1};
    double down = from - floor_of(from), up = floor_of(from) + 1 - from; /* exact near lines */
    if (c.length == 0) return c;
    c.step = 1 / fabs(c.length);
    c.next = c.step * (c.length > 0 ? up : down > 0 ? down : 1);
    return c;
}

/* The integral of Q(s) q(t) dt from a to b. */
static double side(const double a[2], const double b[2]) {
    struct cuts s = cuts_of(a[0], b[0]), t = cuts_of(a[1], b[1]);
    double at = 0, sum = 0;
    if (t.length == 0) return 0;
    while (at < 1) {
        double next = s.next < t.next ? s.next : t.next, end = next < 1 ? next : 1;
        double middle = (at + end) / 2;
        sum += triangle_wave(s.begin + middle * s.length) *
               square_wave(t.begin + middle * t.length) * (end - at);
        if (s.next == next) s.next += s.step;
        if (t.next == next) t.next += t.step;
        at = end;
    }
    return sum * t.length;
}

double checker_share(const double centre[2], const double u[2], const double v[2]) {
    double area = u[0] * v[1] - u[1] * v[0], c[2], corner[4][2], integral = 0, mean;
    bool one_square = true;
    for (int k = 0; k < 2; k++) {
        double half = (fabs(u[k]) + fabs(v[k])) / 2;
        if (!(half < CHECKER_LONG / 2.0)) return 0.5;
        c[k] = centre[k] - 2 * floor(centre[k] / 2); /* near 0, where numbers are denser */
        one_square = one_square && floor_of(c[k] - half) == floor_of(c[k] + half);
        corner[0][k] = c[k] - (u[k] + v[k]) / 2;
        corner[1][k] = c[k] + (u[k] - v[k]) / 2;
        corner[2][k] = c[k] + (u[k] + v[k]) / 2;
        corner[3][k] = c[k] - (u[k] - v[k]) / 2;
    }
    mean = square_wave(c[0]) * square_wave(c[1]);
    if (!one_square &&
        fabs(area) > 0x1p-30 * ((fabs(u[0]) + fabs(v[0])) * (fabs(u[1]) + fabs(v[1])))) {
        for (int i = 0; i < 4; i++) integral += side(corner[i], corner[(i + 1) % 4]);
        mean = fmax(-1, fmin(1, integral / area));
    }
    return (1 - mean) / 2;
}
