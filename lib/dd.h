/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dd - sums of doubles that carry what rounding would lose.
 *
 * Error-free transforms: dd_two_sum (Knuth 1969) and dd_two_prod (Veltkamp's splitting, Dekker
 * 1971) return a rounded result and its exact error, with + - * alone, so that the bits depend on
 * no fused multiply-add. On them stand
 *   struct dd   hi + lo, about 106 bits: the value is the exact sum, |lo| <= ulp(hi)/2, and hi is
 *               the double nearest to it;
 *   struct td   three doubles, about 159 bits: an accumulator of products of doubles.
 * (Hida, Li, Bailey, "Algorithms for quad-double precision floating point arithmetic", 2001.)
 *
 * Range: a product is exact while |a|, |b| < 2^996 (the splitting multiplies by 2^27 + 1) and
 * 2^-969 < |ab| < 2^1023 or ab = 0 (its error is then no subnormal). Callers scale by powers of two
 * to stay inside; outside, results lose bits or become nan, and nothing is undefined. Sums have no
 * such limits but overflow. */
#ifndef DD_H
#define DD_H

struct dd {
    double hi, lo;
};

struct td {
    double s[3]; /* falling magnitudes; they overlap between td_add and td_renormalise */
};

/* a + b = hi + lo exactly, hi = fl(a + b). Knuth: no condition on |a|, |b|. */
static inline struct dd dd_two_sum(double a, double b) {
    double hi = a + b;
    double b_part = hi - a;
    return (struct dd){hi, (a - (hi - b_part)) + (b - b_part)};
}

/* The same if |a| >= |b| or a = 0. Dekker. */
static inline struct dd dd_fast_two_sum(double a, double b) {
    double hi = a + b;
    return (struct dd){hi, b - (hi - a)};
}

/* a = hi + lo, each of at most 26 bits (one is in a sign), so that products of halves are exact. */
static inline struct dd dd_split(double a) {
    double c = 134217729.0 * a; /* 2^27 + 1 */
    double hi = c - (c - a);
    return (struct dd){hi, a - hi};
}

/* a * b = hi + lo exactly, hi = fl(a * b). */
static inline struct dd dd_two_prod(double a, double b) {
    struct dd x = dd_split(a), y = dd_split(b);
    double p = a * b;
    return (struct dd){p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

/* a + b with a relative error below 2^-104 unless a and b cancel; without carry from lo to hi that
 * would spoil the normal form. */
static inline struct dd dd_add_double(struct dd a, double b) {
    struct dd s = dd_two_sum(a.hi, b);
    return dd_fast_two_sum(s.hi, s.lo + a.lo);
}

/* a + b, relative error below 2^-103, whatever cancels. */
static inline struct dd dd_add(struct dd a, struct dd b) {
    struct dd s = dd_two_sum(a.hi, b.hi), t = dd_two_sum(a.lo, b.lo);
    s = dd_fast_two_sum(s.hi, s.lo + t.hi);
    return dd_fast_two_sum(s.hi, s.lo + t.lo);
}

static inline struct dd dd_negate(struct dd a) {
    return (struct dd){-a.hi, -a.lo};
}

/* a * b, relative error below 2^-102. */
static inline struct dd dd_mul_double(struct dd a, double b) {
    struct dd p = dd_two_prod(a.hi, b);
    return dd_fast_two_sum(p.hi, p.lo + a.lo * b);
}

static inline struct dd dd_mul(struct dd a, struct dd b) {
    struct dd p = dd_two_prod(a.hi, b.hi);
    return dd_fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* a + a sum of exact pairs: error below n * 2^-156 of the largest term for n terms, also where the
 * sum cancels. */
static inline void td_add(struct td *sum, struct dd p) {
    struct dd s0 = dd_two_sum(sum->s[0], p.hi);
    struct dd s1 = dd_two_sum(sum->s[1], p.lo);
    struct dd carry = dd_two_sum(s1.hi, s0.lo);
    *sum = (struct td){{s0.hi, carry.hi, sum->s[2] + (s1.lo + carry.lo)}};
}

/* The same for products a * b. */
static inline void td_add_product(struct td *sum, double a, double b) {
    td_add(sum, dd_two_prod(a, b));
}

/* Makes s[0] the rounded sum and s[1] the rounded rest. The second round is for sums that
 * cancelled, where s[0] may have vanished against s[1]. */
static inline void td_renormalise(struct td *sum) {
    struct dd low = dd_two_sum(sum->s[1], sum->s[2]);
    struct dd high = dd_two_sum(sum->s[0], low.hi);
    low = dd_two_sum(high.lo, low.lo);
    high = dd_two_sum(high.hi, low.hi);
    low = dd_two_sum(high.lo, low.lo);
    *sum = (struct td){{high.hi, low.hi, low.lo}};
}

#endif
