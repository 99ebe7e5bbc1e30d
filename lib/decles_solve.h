/* SPDX-License-Identifier: GPL-3.0-or-later */
/* decles_solve - step 6 of decles.md: the positions of D nearest to the suggested ones that keep
 * E. */
#ifndef DECLES_SOLVE_H
#define DECLES_SOLVE_H

#include "clsq.h"
#include "decles_sets.h"
#include "exact.h"

struct decles_targets {
    int k;
    const double *suggested; /* p' of each point of D, k columns */
    const double *weight;    /* of each point of D */
    const double *fixed;     /* of A and F: decles_fixed_values */
};

/* Fills x (derived_count x k, row-major). */
bool decles_solve(const struct decles_sets *sets, const struct exact_rows *rows,
                  const struct decles_targets *targets, double *x, struct clsq_report *report,
                  struct err *err) WARN_UNUSED;

#endif
