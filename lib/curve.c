/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cubic with the curve's ends and end tangents is compared with the curve: raised to the
 * curve's degree, the difference is a Bezier curve, which lies in the hull of its control points.
 * If these are small, the cubic will do; else the curve is halved (de Casteljau). */
#include "curve.h"

#include <math.h>
#include <string.h>

enum { DEPTH_MAX = 12 };

static void cubic_of(int n, const double (*q)[2], double cubic[4][2]) {
    for (int c = 0; c < 2; c++) {
        cubic[0][c] = q[0][c];
        cubic[1][c] = q[0][c] + n * (q[1][c] - q[0][c]) / 3;
        cubic[2][c] = q[n][c] + n * (q[n - 1][c] - q[n][c]) / 3;
        cubic[3][c] = q[n][c];
    }
}

/* The largest coordinate of a control point of curve minus cubic. The cubic is raised one degree
 * after the other: r_i = (i r_i-1 + (m - i) r_i) / m, from degree m-1 to m. */
static double departure(int n, const double (*q)[2], double cubic[4][2]) {
    double raised[CURVE_DEGREE_MAX + 1][2], most = 0;
    memcpy(raised, cubic, 4 * sizeof *raised);
    for (int m = 4; m <= n; m++)
        for (int i = m; i >= 0; i--)
            for (int c = 0; c < 2; c++) {
                double before = i > 0 ? raised[i - 1][c] : 0, here = i < m ? raised[i][c] : 0;
                raised[i][c] = (i * before + (m - i) * here) / m;
            }
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 2; c++) most = fmax(most, fabs(raised[i][c] - q[i][c]));
    return most;
}

static void halve(int n, const double (*q)[2], double (*left)[2], double (*right)[2]) {
    memcpy(right, q, (size_t)(n + 1) * sizeof *right);
    for (int k = 0; k <= n; k++) {
        memcpy(left[k], right[0], sizeof *left);
        for (int i = 0; i < n - k; i++)
            for (int c = 0; c < 2; c++) right[i][c] = (right[i][c] + right[i + 1][c]) / 2;
    }
}

static void draw(struct drawing *d, int n, const double (*q)[2], double tolerance, int depth) {
    double cubic[4][2], left[CURVE_DEGREE_MAX + 1][2], right[CURVE_DEGREE_MAX + 1][2];
    cubic_of(n, q, cubic);
    if (n <= 3 || depth == DEPTH_MAX || departure(n, q, cubic) <= tolerance) {
        drawing_curve(d, cubic[1], cubic[2], cubic[3]);
        return;
    }
    halve(n, q, left, right);
    draw(d, n, (const double(*)[2])left, tolerance, depth + 1);
    draw(d, n, (const double(*)[2])right, tolerance, depth + 1);
}

void curve_draw(struct drawing *d, int degree, const double (*q)[2], double tolerance) {
    if (degree == 1)
        drawing_line(d, q[1][0], q[1][1]);
    else
        draw(d, degree, q, tolerance, 0);
}
