/* SPDX-License-Identifier: GPL-3.0-or-later */
/* relation - the dependences between the rows of a small core of an integer matrix, each one
 * certified: y.A = 0 is checked in exact integers (GMP) before it is believed.
 *
 * Elimination modulo a prime suspects rows of being dependent. Their coefficients are found as
 * small fractions from that one prime, or else, by Cramer's rule, as determinants: their residues
 * modulo as many primes as Hadamard's bound asks for give them exactly. If y.A = 0 fails, the prime
 * had divided some minor of the core by bad luck, and all begins anew with the next one. */
#ifndef RELATION_H
#define RELATION_H

#include "elim.h"
#include "exact.h"

struct relation_list {
    struct exact_relation *relation;
    size_t n, cap;
};

struct relation_term { /* coefficient y of a row */
    uint32_t row;
    mpz_t y;
};

struct relation_task { /* a relation that awaits its residues */
    size_t n;          /* rows: order[0..n-1], the first one dependent */
    size_t order, residue;
    size_t primes; /* how many it takes; residue + k*n + i is that of order[i], prime k */
};

struct relation_finder {
    struct elim elim;
    struct modp_primes primes;
    struct modp *modulus; /* the primes in use for the core at hand */
    uint64_t *inverse;    /* of the product of modulus[0..k-1] modulo modulus[k] */
    size_t moduli;        /* how many of these two are known */
    struct relation_task *task;
    struct relation_term *term;
    mpz_t *sum; /* by column; 0 between calls */
    uint32_t *order;
    uint64_t *residue, *digit;
    size_t tasks, terms, sums, orders, residues;
    size_t modulus_cap, inverse_cap, task_cap, term_cap, sum_cap, order_cap, residue_cap, digit_cap;
};

/* Appends a basis of the relations of the core (no row without entries) to the list; name[r] is
 * what row r is called there. Rows that are dependent in none of them are independent over Q. The
 * finder starts zeroed and can be used again and again. */
bool relation_find(struct relation_finder *finder, const struct int_matrix *core,
                   const uint32_t *name, struct relation_list *list, struct err *err) WARN_UNUSED;

/* Appends an empty relation of n rows, its numbers initialised, or NULL. */
struct exact_relation *relation_append(struct relation_list *list, size_t n, struct err *err);

void relation_cut(struct relation_list *list, size_t n); /* keeps the first n */
void relation_finder_free(struct relation_finder *finder);

#endif
