/* SPDX-License-Identifier: GPL-3.0-or-later */
/* exact - which rows of an integer matrix are independent over Q, and how the others depend on
 * them.
 *
 * Elimination runs modulo the prime 2^61 - 1 first: rows independent there are independent over Q.
 * A row that is dependent there is only suspected: it is certified by an integer vector y with y.A
 * = 0, checked exactly (GMP); where that fails, the prime divides a minor by bad luck and the next
 * prime below decides. No tolerance anywhere; the result depends on the matrix alone. [14] 4.3.2,
 * decles.md step 4.
 *
 * Where there is a choice, the dependent row is one with a large coefficient |y| times the largest
 * entry of the row, so that the other rows determine it stably. */
#ifndef EXACT_H
#define EXACT_H

#include "err.h"
#include "sparse.h"

#include <gmp.h>

/* A dependence: sum over i of y[i] * (row[i] of A) = 0, y primitive (gcd 1), no y[i] = 0, row
 * ascending. dependent is the one of its rows that is not in the chosen independent set; its y is
 * positive. */
struct exact_relation {
    size_t dependent;
    size_t n;
    size_t *row;
    mpz_t *y;
};

/* independent[r]: row r belongs to the chosen maximal independent set, of `rank` rows. The rows -
 * rank relations are a basis of the left null space of A, in the order of their dependent rows. */
struct exact_rows {
    size_t rank;
    bool *independent;
    size_t relation_count;
    struct exact_relation *relation;
};

/* Cost: near-linear for the sparse, planar matrices of C1 conditions, whose relations are local: 15
 * ms for a regular whole grid of 53,400 conditions, 50 to 75 ms where relations have 60 to 120
 * bits, 15 us for 50 rows. Released by exact_rows_free. */
bool exact_rows_init(struct exact_rows *e, const struct int_matrix *a, struct err *err) WARN_UNUSED;
void exact_rows_free(struct exact_rows *e); /* harmless on a zeroed struct */

#endif
