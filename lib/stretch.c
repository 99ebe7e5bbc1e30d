/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The singular values of [[a, b], [c, d]] are (p + q) / 2 and |p - q| / 2, with
 * p = |(a + d, c - b)| and q = |(a - d, c + b)|; p^2 - q^2 = 4 det gives the smaller one without
 * cancellation. */
#include "stretch.h"

#include <math.h>

static void singular_values(double j[3][3], double *small, double *large) {
    double a = j[0][0], b = j[0][1], c = j[1][0], d = j[1][1];
    double p = sqrt((a + d) * (a + d) + (c - b) * (c - b));
    double q = sqrt((a - d) * (a - d) + (c + b) * (c + b));
    *large = (p + q) / 2;
    *small = *large > 0 ? fabs(a * d - b * c) / *large : 0; /* |p - q| = 4 |det| / (p + q) */
}

bool stretch_sample(const struct spline *s, double *least, double *largest, struct err *err) {
    static const double place[7][3] = {{1, 0, 0},        {0, 1, 0},     {0, 0, 1},
                                       {0.5, 0.5, 0},    {0, 0.5, 0.5}, {0.5, 0, 0.5},
                                       {0.25, 0.25, 0.5}};
    struct spline_cursor cursor;
    if (!spline_cursor_init(&cursor, s, err)) return false;
    *least = INFINITY;
    *largest = 0;
    for (uint32_t t = 0; t < s->grid.triangle_count; t++)
        for (int i = 0; i < 7; i++) {
            double p[3] = {0}, value[3], jacobian[3][3], small, large;
            for (int l = 0; l < 3; l++) {
                double corner[2];
                grid_vertex(&s->grid, s->grid.triangle[t][l], corner);
                for (int c = 0; c < 2; c++) p[c] += place[i][l] * corner[c];
            }
            spline_cursor_evaluate(&cursor, t, place[i], p, value, jacobian);
            singular_values(jacobian, &small, &large);
            *least = fmin(*least, small);
            *largest = fmax(*largest, large);
        }
    spline_cursor_free(&cursor);
    return true;
}
