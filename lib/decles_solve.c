/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "decles_solve.h"

#include <math.h>
#include <string.h>

/* A point that the conditions force to 0 comes out as the solver's error, 2^-70 of the solution or
 * less, and would be off by all of its terms in a later edit where everything else is 0 (heights
 * often are). Nothing that small is meant. */
static void flush_zeros(double *x, size_t n, const double *fixed, size_t fixed_count, size_t k,
                        size_t c) {
    double largest = 0;
    for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(x[i * k + c]));
    for (size_t i = 0; i < fixed_count; i++) largest = fmax(largest, fabs(fixed[i * k + c]));
    for (size_t i = 0; i < n; i++)
        if (fabs(x[i * k + c]) < 0x1p-66 * largest) x[i * k + c] = 0;
}

bool decles_solve(const struct decles_sets *sets, const struct exact_rows *rows,
                  const struct decles_targets *targets, double *x, struct clsq_report *report,
                  struct err *err) {
    struct int_matrix a, f = {0};
    struct clsq_problem problem = {.a = &a,
                                   .f = &f,
                                   .k = targets->k,
                                   .weight = targets->weight,
                                   .target = targets->suggested,
                                   .fixed = targets->fixed};
    bool ok = decles_matrix_init(&a, sets, true, rows->independent, err) &&
              decles_matrix_init(&f, sets, false, rows->independent, err) &&
              clsq_solve(&problem, x, report, err);
    for (int c = 0; ok && c < targets->k; c++)
        flush_zeros(x, sets->derived_count, targets->fixed, sets->fixed_count, (size_t)targets->k,
                    (size_t)c);
    decles_matrix_free(&a);
    decles_matrix_free(&f);
    return ok;
}
