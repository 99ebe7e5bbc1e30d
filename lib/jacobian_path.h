/* SPDX-License-Identifier: GPL-3.0-or-later */
/* jacobian_path - how far one deformation can be moved straight towards another before it folds.
 *
 * Control points q go to r in a straight line: (1-s) q + s r, 0 <= s <= 1, the share of the way. At
 * each place of a triangle,
 *
 *     f(s) = det grad phi - margin      (or the thickness - margin, jacobian.h)
 *
 * is quadratic in s, so it has a polar form: F(x,y), symmetric, affine in x and in y, F(s,s) =
 * f(s),
 *
 *     F(x,y) = (1-x)(1-y) C(q,q) + (x(1-y) + y(1-x)) C(q,r) + xy C(r,r) - margin,
 *
 * with C from jacobian_polar. F(l,l), F(l,h), F(h,h) are the Bernstein coefficients of f on the
 * interval l <= s <= h. Each is a polynomial on the triangle; where all three are positive, and
 * least.h proves it, f > 0 on the triangle for all these s. Everything is exact about the
 * real numbers (1-s) q + s r, not about roundings of them. */
#ifndef JACOBIAN_PATH_H
#define JACOBIAN_PATH_H

#include "jacobian.h"

/* One triangle on the way. About 10 kB. */
struct jacobian_path {
    const struct spline *from, *to; /* on the same grid; borrowed */
    enum jacobian_kind kind;
    uint32_t triangle;
    double margin; /* >= 0 */

    /* private: C(q,q), C(q,r), C(r,r), in doubles, computed when they are needed */
    struct jacobian_form {
        bool known, usable;
        double error, largest, factor;
        double c[LEAST_SIZE_MAX];
    } form[3];
};

/* Nothing to free. */
void jacobian_path_init(struct jacobian_path *p, const struct spline *from, const struct spline *to,
                        enum jacobian_kind kind, uint32_t triangle, double margin);

/* Is F(x,y) > 0 on the triangle? If not, `place` is where it is 0 or less, or, if that is
 * undecided, where it might be. 0 <= x, y <= 1. About 0.5 us for each C that is needed first. */
bool jacobian_path_sign(struct jacobian_path *p, struct least_room *room, double x, double y,
                        enum jacobian_verdict *verdict, struct least_place *place,
                        struct err *err) WARN_UNUSED;

/* det grad phi or the thickness itself at share s, at the place: rounded once. */
bool jacobian_path_value(const struct jacobian_path *p, double s, const struct least_place *place,
                         double *value, struct err *err) WARN_UNUSED;

/* f > 0 is proved for 0 <= s <= held, on the whole triangle. If held is not as far as was asked,
 * then at s = lost, held < lost <= (1 + 2^-9) held, f <= 0 at the place ("degenerate", "folds"),
 * or f > 0 could not be decided for all held < s <= lost ("undecided"). Where the search ends at
 * lost <= 2^-20 with nothing proved but s = 0, held is 0; where f > 0 does not even hold at first,
 * so is lost. */
struct jacobian_exit {
    double held, lost;
    enum jacobian_verdict verdict; /* at `lost`; certified: no exit up to where it was sought */
};
bool jacobian_path_exit(struct jacobian_path *p, struct least_room *room, double upto,
                        struct jacobian_exit *exit, struct least_place *place,
                        struct err *err) WARN_UNUSED;

#endif
