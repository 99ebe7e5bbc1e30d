/* SPDX-License-Identifier: GPL-3.0-or-later */
/* jacobian - is a deformation one-to-one near every point? With proof.
 *
 * On a triangle, det grad phi is a polynomial of degree 2(d-1), whose Bernstein coefficients are
 *
 *   c_g = d^2 / (2 area) sum over a+b=g of M(a) M(b) / M(g)  P1_a x P2_b,
 *   P1_ijk = q_i,j+1,k - q_i+1,j,k,   P2_ijk = q_i,j,k+1 - q_i+1,j,k,   i+j+k = d-1,
 *
 * M(ijk) = (i+j+k)! / (i! j! k!). The identity has det = 1 everywhere. With depth,
 * det grad psi = det grad phi * thickness, thickness = (sigma1 - sigma0) / (b - a), of degree d.
 * Least values of both are bounded by least.h, in doubles as long as that decides, then in
 * integers: doubles are rational numbers, and everything is exact about the numbers as they are
 * stored. Decles.md, "Non-degeneracy".
 *
 * det is a quadratic form of the net, and has a polar form of two nets on the same grid,
 *
 *   d^2 / (2 area) sum over a+b=g of M(a) M(b) / M(g) (P1_a x R2_b + R1_a x P2_b) / 2,
 *
 * which is det itself where the nets are the same. That of the thickness, which is linear, is the
 * mean of the two. */
#ifndef JACOBIAN_H
#define JACOBIAN_H

#include "least.h"
#include "spline.h"

enum jacobian_kind { JACOBIAN_PLANE, JACOBIAN_THICKNESS };

enum jacobian_verdict {
    JACOBIAN_CERTIFIED,  /* min > 0 */
    JACOBIAN_UNDECIDED,  /* |min| within the rule's bound, or the rule's work was spent */
    JACOBIAN_DEGENERATE, /* 0 at the place; no negative value found */
    JACOBIAN_FOLDS,      /* negative at the place */
};

/* "certified", "undecided", "degenerate", "folds" */
extern const char *const jacobian_verdict_names[];

/* From the signs of a lower and an upper bound of the least value. */
enum jacobian_verdict jacobian_verdict_of(int low, int high);

/* Doubles rounded outwards: low <= min <= high. Beyond the range of doubles they are infinite. */
struct jacobian_bounds {
    double low, high;
    enum jacobian_verdict verdict;
};

/* tolerance 0.01, undecided 2^-100, parts 4096 */
extern const struct least_rule jacobian_default_rule;

struct jacobian_report {
    struct jacobian_bounds least;      /* of the whole grid */
    uint32_t count[4];                 /* triangles of each verdict */
    uint32_t triangle;                 /* where the upper bound is the least, */
    struct least_place place;          /* there, */
    double value;                      /* and the value, rounded once */
    struct jacobian_bounds *bounds_of; /* by triangle */
};

/* Certifies all triangles. The bounds of `least` satisfy the rule's tolerance unless undecided or
 * degenerate; with `all`, so do those of each triangle. About 1 us a triangle of degree 5 that is
 * bent mildly. */
bool jacobian_report_init(struct jacobian_report *r, const struct spline *s,
                          enum jacobian_kind kind, const struct least_rule *rule, bool all,
                          struct err *err) WARN_UNUSED;
void jacobian_report_free(struct jacobian_report *r); /* harmless on a zeroed struct */

/* One triangle. `place` is where the value is `high` or less. */
bool jacobian_triangle(struct least_room *room, const struct spline *s, enum jacobian_kind kind,
                       uint32_t t, const struct least_rule *rule, struct jacobian_bounds *bounds,
                       struct least_place *place, struct err *err) WARN_UNUSED;

/* Degree of the polynomial. */
int jacobian_degree(const struct spline *s, enum jacobian_kind kind);

/* Its coefficients, in doubles and unscaled: *factor times c are meant, each c is within *error.
 * False if doubles cannot do it. */
bool jacobian_coefficients(const struct spline *s, enum jacobian_kind kind, uint32_t t, double *c,
                           double *error, double *factor);

/* The same in integers, exactly: factor times c. c: room for LEAST_SIZE_MAX, initialised. */
void jacobian_coefficients_exact(const struct spline *s, enum jacobian_kind kind, uint32_t t,
                                 mpz_t *c, mpq_t factor);

/* Both for the polar form of s and r, deformations on the same grid. */
bool jacobian_polar(const struct spline *s, const struct spline *r, enum jacobian_kind kind,
                    uint32_t t, double *c, double *error, double *factor);
void jacobian_polar_exact(const struct spline *s, const struct spline *r, enum jacobian_kind kind,
                          uint32_t t, mpz_t *c, mpq_t factor);

#endif
