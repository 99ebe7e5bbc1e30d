/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A sign is computed in doubles together with a bound of its error (proved in the header). Only
 * where the bound does not separate it from zero, the same expression is evaluated exactly: in GMP
 * rationals, every double being one. */
#include "predicate.h"

#include "dd.h"

#include <gmp.h>
#include <stdbool.h>

int64_t predicate_area2(const int32_t a[2], const int32_t b[2], const int32_t c[2]) {
    int64_t bx = (int64_t)b[0] - a[0], by = (int64_t)b[1] - a[1];
    int64_t cx = (int64_t)c[0] - a[0], cy = (int64_t)c[1] - a[1];
    return bx * cy - by * cx;
}

/* Sets q to the exact p - origin - step * n. */
static void exact_offset(mpq_t q, double p, double origin, double step, int32_t n) {
    mpq_t term;
    mpq_init(term);
    mpq_set_si(q, n, 1);
    mpq_set_d(term, step);
    mpq_mul(q, q, term);
    mpq_set_d(term, origin);
    mpq_add(q, q, term);
    mpq_set_d(term, p);
    mpq_sub(q, term, q);
    mpq_clear(term);
}

static int exact_side(const struct lattice *lattice, const int32_t a[2], const int32_t b[2],
                      const double p[2]) {
    mpq_t ex, ey, factor;
    int sign;
    mpq_inits(ex, ey, factor, NULL);
    exact_offset(ex, p[0], lattice->x0, lattice->step, a[0]);
    exact_offset(ey, p[1], lattice->y0, lattice->step, a[1]);
    mpq_set_si(factor, (long)b[0] - a[0], 1);
    mpq_mul(ey, ey, factor);
    mpq_set_si(factor, (long)b[1] - a[1], 1);
    mpq_mul(ex, ex, factor);
    sign = mpq_cmp(ey, ex);
    mpq_clears(ex, ey, factor, NULL);
    return (sign > 0) - (sign < 0);
}

int predicate_side(const struct lattice *lattice, const int32_t a[2], const int32_t b[2],
                   const double p[2]) {
    double bound, side = predicate_side_filter(lattice, a, b, p, &bound);
    if (side > bound) return 1;
    if (side < -bound) return -1;
    return exact_side(lattice, a, b, p);
}

/* Sets q to the exact (p - a) * (r + s - b). */
static void exact_product(mpq_t q, double p, double a, double r, double s, double b) {
    mpq_t second, term;
    mpq_inits(second, term, NULL);
    mpq_set_d(q, p);
    mpq_set_d(term, a);
    mpq_sub(q, q, term);
    mpq_set_d(second, r);
    mpq_set_d(term, s);
    mpq_add(second, second, term);
    mpq_set_d(term, b);
    mpq_sub(second, second, term);
    mpq_mul(q, q, second);
    mpq_clears(second, term, NULL);
}

/* Products l and r of two differences each, { subtrahend, minuend }: the sign of l - r. Of points
 * on a common lattice, as those of images are, the differences are exact doubles, and the products
 * of doubles have exact halves. False: they are not, or leave the range of that. */
static bool compare_products(const double l[2][2], const double r[2][2], int *sign) {
    struct dd difference[4], left, right;
    for (int k = 0; k < 2; k++) {
        difference[k] = dd_two_sum(l[k][1], -l[k][0]);
        difference[2 + k] = dd_two_sum(r[k][1], -r[k][0]);
    }
    for (int k = 0; k < 4; k++) {
        double size = fabs(difference[k].hi);
        if (difference[k].lo != 0 || !(size == 0 || (size > 0x1p-400 && size < 0x1p+400)))
            return false;
    }
    left = dd_two_prod(difference[0].hi, difference[1].hi);
    right = dd_two_prod(difference[2].hi, difference[3].hi);
    *sign = (left.hi > right.hi) - (left.hi < right.hi); /* rounding is monotone */
    if (*sign == 0) *sign = (left.lo > right.lo) - (left.lo < right.lo);
    return true;
}

int predicate_orient_sum(const double a[2], const double b[2], const double c[2],
                         const double rest[2]) {
    double bound, det = predicate_orient_filter(a, b, c, rest, &bound);
    mpq_t left, right;
    int sign;
    if (det > bound) return 1;
    if (det < -bound) return -1;
    mpq_inits(left, right, NULL);
    exact_product(left, b[0], a[0], c[1], rest[1], a[1]);
    exact_product(right, b[1], a[1], c[0], rest[0], a[0]);
    sign = mpq_cmp(left, right);
    mpq_clears(left, right, NULL);
    return (sign > 0) - (sign < 0);
}

int predicate_orient(const double a[2], const double b[2], const double c[2]) {
    static const double none[2] = {0, 0};
    const double left[2][2] = {{a[0], b[0]}, {a[1], c[1]}},
                 right[2][2] = {{a[1], b[1]}, {a[0], c[0]}};
    double bound, det = predicate_orient_filter(a, b, c, none, &bound);
    int sign;
    if (det > bound) return 1;
    if (det < -bound) return -1;
    return compare_products(left, right, &sign) ? sign : predicate_orient_sum(a, b, c, none);
}
