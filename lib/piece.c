/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "piece.h"

#include "bernstein.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define TAME   0.25    /* kappa of a tame piece, at most */
#define NEEDLE 0x1p-40 /* height over length of a triangle that is too thin for Newton's steps */
#define SMALL  0x1p-60 /* a step, in b times in length: the next one would be lost in rounding */
enum { STEPS_MAX = 64 };

/* Where the coefficient with weights (i, j, k), j + k = row, stands. */
static int index_of(int row, int k) {
    return row * (row + 1) / 2 + k;
}

static double dot(const double a[2], const double b[2]) {
    return a[0] * b[0] + a[1] * b[1];
}

static double length(double x, double y) {
    return sqrt(x * x + y * y);
}

/* Twice the area, also of a needle: the products are exact. */
static double exact_area(const double a[2], const double b[2]) {
    struct dd left = dd_two_prod(a[0], b[1]), right = dd_two_prod(a[1], b[0]);
    return (left.hi - right.hi) + (left.lo - right.lo);
}

/* ---- frame */

/* Corner l of T, less the first one. */
static void corner_of(const struct piece *p, int l, double x[2]) {
    x[0] = l ? p->side[l - 1][0] : 0;
    x[1] = l ? p->side[l - 1][1] : 0;
}

static void set_edges(struct piece *p) {
    double area = exact_area(p->side[0], p->side[1]);
    for (int l = 0; l < 3; l++) {
        double m[2], n[2], d[2], size;
        corner_of(p, (l + 1) % 3, m);
        corner_of(p, (l + 2) % 3, n);
        for (int c = 0; c < 2; c++) d[c] = area < 0 ? m[c] - n[c] : n[c] - m[c];
        size = length(d[0], d[1]);
        p->normal[l][0] = size > 0 ? -d[1] / size : 0;
        p->normal[l][1] = size > 0 ? d[0] / size : 0;
        p->height[l] = size > 0 ? fabs(area) / size : 0;
        if (l == 0) p->offset = dot(p->normal[0], m);
    }
}

void piece_frame(struct piece *p, int degree, const struct piece_net *net, double slack) {
    int size = index_of(degree + 1, 0);
    const struct dd *q[3] = {net->q[0], net->q[index_of(degree, 0)], net->q[size - 1]};
    memcpy(p->place, net->place, sizeof p->place);
    for (int c = 0; c < 2; c++) {
        p->corner[c] = q[0][c].hi;
        for (int m = 0; m < 2; m++) p->side[m][c] = dd_add(q[m + 1][c], dd_negate(q[0][c])).hi;
    }
    set_edges(p);
    for (int l = 0; l < 3; l++) {
        double low = 0, high = 0;
        for (int i = 0; i < size; i++) {
            double x[2] = {net->q[i][0].hi - p->corner[0], net->q[i][1].hi - p->corner[1]};
            double d = dot(p->normal[l], x);
            low = d < low ? d : low;
            high = d > high ? d : high;
        }
        p->low[l] = low - slack;
        p->high[l] = high + slack;
    }
}

bool piece_box_is_near(int degree, const struct piece_net *net, const double q[2], double slack) {
    int size = index_of(degree + 1, 0);
    for (int c = 0; c < 2; c++) {
        double low = net->q[0][c].hi, high = low;
        for (int i = 1; i < size; i++) {
            low = net->q[i][c].hi < low ? net->q[i][c].hi : low;
            high = net->q[i][c].hi > high ? net->q[i][c].hi : high;
        }
        if (q[c] < low - slack || q[c] > high + slack) return false;
    }
    return true;
}

/* ---- bend */

/* The coefficient at this row and place of degree times f - corner - b1 side1 - b2 side2. */
static void set_bend(const struct piece *p, int degree, const struct dd q[2], int row, int k,
                     double bend[2]) {
    for (int c = 0; c < 2; c++) {
        struct dd sum = dd_mul_double(dd_add_double(q[c], -p->corner[c]), degree);
        sum = dd_add(sum, dd_two_prod(k - row, p->side[0][c]));
        sum = dd_add(sum, dd_two_prod(-k, p->side[1][c]));
        bend[c] = sum.hi / degree;
    }
}

/* Coefficients of the derivatives of the bend by b1 and b2, over its degree. */
static void derivatives(const double (*bend)[2], int row, int k, double d[2][2]) {
    const double *first = bend[index_of(row, k)];
    for (int m = 0; m < 2; m++) {
        const double *other = bend[index_of(row + 1, k + m)];
        d[m][0] = other[0] - first[0];
        d[m][1] = other[1] - first[1];
    }
}

/* The norm (Frobenius') of the matrix of columns d[0], d[1] times (s1 s2)^-1. */
static double relative_norm(const struct piece *p, double d[2][2]) {
    double sum = 0;
    for (int c = 0; c < 2; c++) {
        double u = d[0][c] / p->height[1], v = d[1][c] / p->height[2];
        double x = u * p->normal[1][0] + v * p->normal[2][0];
        double y = u * p->normal[1][1] + v * p->normal[2][1];
        sum += x * x + y * y;
    }
    return sqrt(sum);
}

static bool is_needle(const struct piece *p) {
    double longest = 0, height = fmin(p->height[0], fmin(p->height[1], p->height[2]));
    for (int m = 0; m < 2; m++) longest = fmax(longest, length(p->side[m][0], p->side[m][1]));
    return !(height > NEEDLE * longest);
}

/* How much the derivative changes along edge l: relative to (s1 s2), and how far from straight the
 * net is along it. */
static double variation(const struct piece *p, int degree, const double (*bend)[2], int l,
                        double *crook) {
    const int m = (l + 1) % 3, n = (l + 2) % 3;
    double most = 0;
    *crook = 0;
    for (int row = 0; row <= degree - 2; row++)
        for (int k = 0; k <= row; k++) {
            double d[2][2], other[2][2], x[2];
            derivatives(bend, row + (m > 0), k + (m > 1), d);
            derivatives(bend, row + (n > 0), k + (n > 1), other);
            for (int i = 0; i < 4; i++) d[i / 2][i % 2] = other[i / 2][i % 2] - d[i / 2][i % 2];
            for (int c = 0; c < 2; c++) x[c] = (n ? d[n - 1][c] : 0) - (m ? d[m - 1][c] : 0);
            *crook = fmax(*crook, length(x[0], x[1]));
            most = fmax(most, relative_norm(p, d));
        }
    return most;
}

/* Halving an edge makes the derivative vary less along it; but where the net is straight already,
 * nothing is left to be gained. Of a needle, the derivatives say nothing. */
static int choose_edge(const struct piece *p, int degree, const double (*bend)[2], bool needle) {
    double most = -1;
    int best = 0;
    for (int l = 0; l < 3; l++) {
        double crook, gain = variation(p, degree, bend, l, &crook);
        if (needle) gain = crook;
        if (crook <= PIECE_NEAR / 256) gain = 0;
        if (gain > most) best = l;
        most = fmax(gain, most);
    }
    return best;
}

void piece_bend(struct piece *p, int degree, const struct piece_net *net, double (*bend)[2]) {
    double largest = 0, kappa = 0;
    bool needle = is_needle(p);
    for (int row = 0, i = 0; row <= degree; row++)
        for (int k = 0; k <= row; k++, i++) {
            set_bend(p, degree, net->q[i], row, k, bend[i]);
            largest = fmax(largest, fmax(fabs(bend[i][0]), fabs(bend[i][1])));
        }
    for (int row = 0; row < degree && !needle; row++)
        for (int k = 0; k <= row; k++) {
            double d[2][2];
            derivatives((const double(*)[2])bend, row, k, d);
            kappa = fmax(kappa, degree * relative_norm(p, d));
        }
    p->tame = !needle && kappa <= TAME;
    p->flat = largest <= PIECE_NEAR / 2;
    p->ratio = kappa / (1 - kappa);
    if (!p->tame && !p->flat) p->longest = choose_edge(p, degree, (const double(*)[2])bend, needle);
}

/* ---- solution. Points are relative to the corner here. */

static double distance(const struct piece *p, int l, const double x[2]) {
    return dot(p->normal[l], x) - (l ? 0 : p->offset);
}

/* The nearest point of the edges. */
static void nearest(const struct piece *p, const double x[2], double b[3]) {
    double best = INFINITY;
    for (int l = 0; l < 3; l++) {
        int m = (l + 1) % 3, n = (l + 2) % 3;
        double from[2], to[2], d[2], v[2], t, away;
        corner_of(p, m, from);
        corner_of(p, n, to);
        for (int c = 0; c < 2; c++) {
            d[c] = to[c] - from[c];
            v[c] = x[c] - from[c];
        }
        t = dot(d, d) > 0 ? fmin(fmax(dot(v, d) / dot(d, d), 0), 1) : 0;
        away = length(v[0] - t * d[0], v[1] - t * d[1]);
        if (!(away < best)) continue;
        best = away;
        b[l] = 0;
        b[m] = 1 - t;
        b[n] = t;
    }
}

static bool is_inside(const double b[3]) {
    return b[0] >= 0 && b[1] >= 0 && b[2] >= 0;
}

/* b of the nearest point of T; true if that is x itself. Along the longest edge, x counts as it is,
 * so that b is good also in a needle, although the weight of the corner opposite is not. */
static bool into_triangle(const struct piece *p, const double x[2], double b[3]) {
    int l = 0, m, n;
    double from[2], to[2], top[2], d[2], square, weight, along;
    for (int k = 1; k < 3; k++)
        if (p->height[k] < p->height[l]) l = k;
    m = (l + 1) % 3;
    n = (l + 2) % 3;
    corner_of(p, l, top);
    corner_of(p, m, from);
    corner_of(p, n, to);
    for (int c = 0; c < 2; c++) d[c] = to[c] - from[c];
    square = dot(d, d);
    weight = distance(p, l, x) / p->height[l];
    along = 0;
    for (int c = 0; c < 2; c++) along += (x[c] - from[c] - weight * (top[c] - from[c])) * d[c];
    b[l] = weight;
    b[n] = along / square;
    b[m] = 1 - b[l] - b[n];
    if (is_inside(b)) return true; /* not so where heights are 0 and quotients nan */
    nearest(p, x, b);
    return false;
}

static void point_at(const struct piece *p, const double b[3], double x[2]) {
    for (int c = 0; c < 2; c++) x[c] = b[1] * p->side[0][c] + b[2] * p->side[1][c];
}

/* y - f(b). */
static void residual(const struct piece *p, const double y[2], const double b[3],
                     const double bend[2], double r[2]) {
    for (int c = 0; c < 2; c++) r[c] = y[c] - b[1] * p->side[0][c] - b[2] * p->side[1][c] - bend[c];
}

/* |q - f(b)|, with products that are exact. */
static double exact_miss(const struct piece *p, const double q[2], const double b[3],
                         const double bend[2]) {
    double r[2];
    for (int c = 0; c < 2; c++) {
        struct dd sum = dd_two_sum(q[c], -p->corner[c]);
        sum = dd_add(sum, dd_two_prod(-b[1], p->side[0][c]));
        sum = dd_add(sum, dd_two_prod(-b[2], p->side[1][c]));
        r[c] = dd_add_double(sum, -bend[c]).hi;
    }
    return length(r[0], r[1]);
}

/* Does (1) say that no point of T maps to within slack / 2 of y? */
static bool is_excluded(const struct piece *p, const double y[2], const double bend[2],
                        const double r[2], double slack) {
    double x[2] = {y[0] - bend[0], y[1] - bend[1]}; /* w + r */
    double most = p->ratio * length(r[0], r[1]) + slack;
    return distance(p, 0, x) < -most || distance(p, 1, x) < -most || distance(p, 2, x) < -most;
}

/* Newton's step, and back into T; returns its size, in b times in length. An error of d in b, or w
 * in length, leaves one of degree kappa d w at most after the next step. */
static double step(const struct piece *p, const double r[2], double gradient[3][2], double b[3],
                   bool *inside) {
    double s[2][2], x[2], det, d[3], before[3];
    for (int m = 0; m < 2; m++)
        for (int c = 0; c < 2; c++) s[m][c] = p->side[m][c] + (gradient[m + 1][c] - gradient[0][c]);
    det = piece_area(s[0], s[1]);
    memcpy(before, b, sizeof before);
    b[1] += piece_area(r, s[1]) / det;
    b[2] += piece_area(s[0], r) / det;
    b[0] = 1 - b[1] - b[2];
    *inside = is_inside(b);
    if (!*inside) {
        point_at(p, b, x);
        nearest(p, x, b);
    }
    for (int l = 0; l < 3; l++) d[l] = b[l] - before[l];
    point_at(p, d, x);
    return fmax(fabs(d[1]), fabs(d[2])) * length(x[0], x[1]);
}

bool piece_solve(const struct piece *p, int degree, const double (*bend)[2], const double q[2],
                 double slack, double b[3], double *miss) {
    const double y[2] = {q[0] - p->corner[0], q[1] - p->corner[1]};
    double value[2], gradient[3][2], r[2];
    bool inside = into_triangle(p, y, b), done = !p->tame;
    for (int i = 0; !done && i < STEPS_MAX; i++) {
        bernstein_gradient(degree, 2, &bend[0][0], b, value, &gradient[0][0]);
        residual(p, y, b, value, r);
        if (is_excluded(p, y, value, r, slack)) return false;
        done = step(p, r, gradient, b, &inside) <= SMALL;
    }
    *miss = 0;
    if (p->tame && done && inside) return true;
    bernstein_value(degree, 2, &bend[0][0], b, value);
    *miss = exact_miss(p, q, b, value);
    return true;
}

/* ---- halves */

static struct dd middle(struct dd a, struct dd b) {
    struct dd sum = dd_add(a, b);
    return (struct dd){0.5 * sum.hi, 0.5 * sum.lo};
}

/* Along edge l, coefficients with weight i on corner l: de Casteljau's averages. */
static void halve_row(int degree, const struct piece_net *net, int l, int i, int c,
                      struct piece_net half[2]) {
    struct dd row[PIECE_DEGREE_MAX + 1];
    int m = (l + 1) % 3, n = (l + 2) % 3, size = degree - i, at[PIECE_DEGREE_MAX + 1];
    for (int t = 0; t <= size; t++) {
        int w[3];
        w[l] = i;
        w[m] = size - t;
        w[n] = t;
        at[t] = index_of(w[1] + w[2], w[2]);
        row[t] = net->q[at[t]][c];
    }
    for (int t = 0; t <= size; t++) { /* (m, middle) begins, (middle, n) ends with weight t on it */
        half[0].q[at[t]][c] = row[0];
        half[1].q[at[size - t]][c] = row[size - t];
        for (int s = 0; s < size - t; s++) row[s] = middle(row[s], row[s + 1]);
    }
}

void piece_halve(int degree, const struct piece_net *net, int l, struct piece_net half[2]) {
    int m = (l + 1) % 3, n = (l + 2) % 3;
    for (int i = 0; i <= degree; i++)
        for (int c = 0; c < 2; c++) halve_row(degree, net, l, i, c, half);
    for (int h = 0; h < 2; h++) {
        memcpy(half[h].place, net->place, sizeof net->place);
        for (int k = 0; k < 3; k++)
            half[h].place[h ? m : n][k] = 0.5 * (net->place[m][k] + net->place[n][k]);
    }
}
