/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The triangle of coefficients is summed row by row, r = d - i:
 *
 *     f = sum_r C(d,r) b0^(d-r) R_r,    R_r = sum_k C(r,k) c_(d-r),(r-k),k b1^(r-k) b2^k
 *
 *            c_d00               R_0
 *         c_.10  c_.01           R_1
 *      c_.20  c_.11  c_.02       R_2    ...
 *
 * the outer sum by Horner's rule in b0; a row, which is homogeneous in b1 and b2, by Horner's rule
 * in b1 while a running power of b2 goes along (Farin's nested scheme). No division, no table of
 * powers.
 *
 * The derivative df/db_l is d times the form of degree d-1 whose coefficients are c_(ijk + e_l):
 * the same triangle without its last row (l = 0), without its first points (l = 1: j >= 1) or its
 * last ones (l = 2: k >= 1). With those three sums f itself is (b0 f0 + b1 f1 + b2 f2) / d. */
#include "bernstein.h"

#include "err.h"

enum { DEGREE_MAX = 15, COMPONENTS_MAX = 4 };

static const double binomial[DEGREE_MAX + 1][DEGREE_MAX + 1] = {
    {1},
    {1, 1},
    {1, 2, 1},
    {1, 3, 3, 1},
    {1, 4, 6, 4, 1},
    {1, 5, 10, 10, 5, 1},
    {1, 6, 15, 20, 15, 6, 1},
    {1, 7, 21, 35, 35, 21, 7, 1},
    {1, 8, 28, 56, 70, 56, 28, 8, 1},
    {1, 9, 36, 84, 126, 126, 84, 36, 9, 1},
    {1, 10, 45, 120, 210, 252, 210, 120, 45, 10, 1},
    {1, 11, 55, 165, 330, 462, 462, 330, 165, 55, 11, 1},
    {1, 12, 66, 220, 495, 792, 924, 792, 495, 220, 66, 12, 1},
    {1, 13, 78, 286, 715, 1287, 1716, 1716, 1287, 715, 286, 78, 13, 1},
    {1, 14, 91, 364, 1001, 2002, 3003, 3432, 3003, 2002, 1001, 364, 91, 14, 1},
    {1, 15, 105, 455, 1365, 3003, 5005, 6435, 6435, 5005, 3003, 1365, 455, 105, 15, 1},
};

/* The sum of a triangle of degree d whose row r starts at c + n * (row (row+1) / 2 + shift), with
 * row = r + (lower ? 1 : 0). Inlined for each n, so that the loops over components unroll. */
static inline __attribute__((always_inline)) void
nested(int d, int n, const double *c, int lower, int shift, const double b[3], double *sum) {
    double total[COMPONENTS_MAX] = {0};
    for (int r = 0; r <= d; r++) {
        const double *row = c + n * ((r + lower) * (r + lower + 1) / 2 + shift);
        double power = 1, part[COMPONENTS_MAX];
        for (int m = 0; m < n; m++) part[m] = row[m];
        for (int k = 1; k <= r; k++) {
            double weight;
            power *= b[2];
            weight = power * binomial[r][k];
            for (int m = 0; m < n; m++) part[m] = part[m] * b[1] + weight * row[n * k + m];
        }
        for (int m = 0; m < n; m++) total[m] = total[m] * b[0] + binomial[d][r] * part[m];
    }
    for (int m = 0; m < n; m++) sum[m] = total[m];
}

static void sum_triangle(int d, int n, const double *c, int lower, int shift, const double b[3],
                         double *sum) {
    switch (n) {
    case 1:
        nested(d, 1, c, lower, shift, b, sum);
        return;
    case 2:
        nested(d, 2, c, lower, shift, b, sum);
        return;
    case 3:
        nested(d, 3, c, lower, shift, b, sum);
        return;
    case 4:
        nested(d, 4, c, lower, shift, b, sum);
        return;
    default:
        INVARIANT(n >= 1 && n <= 4);
    }
}

void bernstein_value(int degree, int n, const double *c, const double b[3], double *value) {
    INVARIANT(degree >= 0 && degree <= DEGREE_MAX);
    sum_triangle(degree, n, c, 0, 0, b, value);
}

void bernstein_gradient(int degree, int n, const double *c, const double b[3], double *value,
                        double *gradient) {
    INVARIANT(degree >= 1 && degree <= DEGREE_MAX);
    sum_triangle(degree - 1, n, c, 0, 0, b, gradient);
    sum_triangle(degree - 1, n, c, 1, 0, b, gradient + n);
    sum_triangle(degree - 1, n, c, 1, 1, b, gradient + 2 * n);
    for (int m = 0; m < n; m++)
        value[m] = b[0] * gradient[m] + b[1] * gradient[n + m] + b[2] * gradient[2 * n + m];
    for (int m = 0; m < 3 * n; m++) gradient[m] *= degree;
}
