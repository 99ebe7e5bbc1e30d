/* SPDX-License-Identifier: GPL-3.0-or-later */
/* least - certified bounds of the least value of a polynomial in Bernstein form on a triangle.
 *
 *   f(b) = sum over i+j+k=n of c_ijk n!/(i!j!k!) b0^i b1^j b2^k,   order of grid_patch
 *
 * On a part of the triangle, f is no less than the least coefficient with respect to that part, and
 * takes the corners' coefficients as values. Halving parts again and again brings the two together,
 * quadratically. What is sought is the sign of the least value, and bounds low <= min f <= high
 * that are close: high - low <= tolerance * |high|. Where the least value is 0 or nearly so, both
 * can be out of reach; then it is to be shown that |min f| <= undecided.
 *
 * least_double works with doubles and a proved bound of their errors; where that does not do,
 * least_exact does the same with integers (GMP). Neither depends on anything but its arguments. */
#ifndef LEAST_H
#define LEAST_H

#include "err.h"

#include <gmp.h>

enum {
    LEAST_DEGREE_MAX = 28,
    LEAST_SIZE_MAX = (LEAST_DEGREE_MAX + 1) * (LEAST_DEGREE_MAX + 2) / 2,
};

struct least_rule {
    double tolerance; /* 0 < tolerance < 1 */
    double undecided; /* relative to the mean |coefficient| of f; 0 <= undecided < 1 */
    size_t parts;     /* least_exact gives up after so many; bounds hold then, but may be far off */
};

/* Where f is `high` or less: barycentric coordinates weight / (weight[0] + weight[1] + weight[2]).
 */
struct least_place {
    mpz_t weight[3]; /* >= 0, without common divisor */
};
void least_place_init(struct least_place *p); /* corner 0 */
void least_place_free(struct least_place *p);

/* Barycentric coordinates of least_double: multiples of 2^-60. */
void least_place_set(struct least_place *p, const double b[3]);

struct least {
    double low, high;
    double place[3]; /* barycentric coordinates, exact in doubles */
};

struct least_exact {
    mpq_t low, high; /* in units of the integer coefficients; f is `high` at the place */
    struct least_place place;
};
void least_exact_init(struct least_exact *x);
void least_exact_free(struct least_exact *x);

static inline int least_size(int n) {
    return (n + 1) * (n + 2) / 2;
}

/* Bounds from the coefficients as they are, each within `error` of the true one; *place is a corner
 * of the triangle. */
void least_quick(int n, const double *c, double error, struct least *f);

/* Memory for least_double, to be used again and again. */
struct least_room;
struct least_room *least_room_new(struct err *err);
void least_room_free(struct least_room *room);

/* True if sign and bounds are settled; else f holds what is proved. `error` as above; 2^-900 <= the
 * largest |c| <= 2^900, or all is left to least_exact. */
bool least_double(struct least_room *room, int n, const double *c, double error,
                  const struct least_rule *rule, struct least *f);

/* Integer coefficients. Afterwards one of these holds:
 *   low > 0; high < 0; high = 0 (f is 0 at the place, and no negative value was found);
 *   low <= 0 < high <= undecided * mean and -low <= undecided * mean;
 *   rule->parts parts, or 1,024 halvings, did not suffice. */
bool least_exact(int n, const mpz_t *c, const struct least_rule *rule, struct least_exact *x,
                 struct err *err) WARN_UNUSED;

/* f at the place, exactly. */
void least_value(int n, const mpz_t *c, const struct least_place *place, mpq_t value);

#endif
