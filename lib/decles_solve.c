/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "decles_solve.h"

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
    bool ok;
    ok = decles_matrix_init(&a, sets, true, rows->independent, err) &&
         decles_matrix_init(&f, sets, false, rows->independent, err) &&
         clsq_solve(&problem, x, report, err);
    decles_matrix_free(&a);
    decles_matrix_free(&f);
    return ok;
}
