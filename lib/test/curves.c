/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "curves.h"

#include <math.h>
#include <string.h>

void curve_point(int d, const double (*q)[2], double t, double p[2]) {
    double row[16][2];
    memcpy(row, q, (size_t)(d + 1) * sizeof *q);
    for (int k = d; k > 0; k--)
        for (int i = 0; i < k; i++)
            for (int c = 0; c < 2; c++) row[i][c] = (1 - t) * row[i][c] + t * row[i + 1][c];
    memcpy(p, row[0], sizeof row[0]);
}

double segment_distance(const double a[2], const double b[2], const double p[2]) {
    double ux = b[0] - a[0], uy = b[1] - a[1], length2 = ux * ux + uy * uy;
    double t = length2 > 0 ? ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / length2 : 0;
    t = fmin(1, fmax(0, t));
    ux = p[0] - a[0] - t * ux;
    uy = p[1] - a[1] - t * uy;
    return sqrt(ux * ux + uy * uy);
}
