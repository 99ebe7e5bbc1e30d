/* SPDX-License-Identifier: GPL-3.0-or-later */
/* injective - is a deformation one-to-one? With proof.
 *
 * One-to-one includes that nothing is turned over: a map with det grad phi < 0 somewhere is not
 * what is asked for, even where a mirror image would be one-to-one.
 *
 * Theorem. Let M be a component of the domain: triangles glued along edges, with one fan at each
 * vertex. phi is one-to-one on M if
 *
 *   1. det grad phi > 0 on each closed triangle                                    (jacobian.h)
 *   2. the angles of the images of the triangles around a vertex add up to 360 degrees for an
 *      inner vertex, and to less for one on the boundary                              (fans.h)
 *   3. the images of the boundary curves are simple and pairwise disjoint          (boundary.h)
 *
 * and the images of two components are disjoint if
 *
 *   4. a point of neither lies in that of the other                                 (nesting.h)
 *
 * Proof. First, phi is one-to-one near every point. Inside a triangle that is 1. Beside an inner
 * edge, both polynomials go on beyond it with a positive determinant and agree on it, so they map
 * its two sides to the two sides of its image, whether their slopes agree or not. At an inner
 * vertex the images of the corners are sectors, each beside the next; 2 says that they close up
 * after one turn. At a boundary vertex they do not reach round, and at other points of the boundary
 * the image of the one side is one side. (If phi were C1 to the last bit, its derivative at a
 * vertex would be one linear map for all of the fan, which is embedded in the domain, and 2 would
 * follow from 1. But control points are rounded, so no condition of continuity is used here, and 2
 * is always checked. Without 2 at the boundary the theorem would be false: an annulus can be the
 * double cover of a disc branched at two points, with one of its boundary curves drawn in to these
 * points.)
 *
 * A point y off the curves then has w(y) preimages, w being the sum of the winding numbers of the
 * curves around y: each preimage adds +1 to the degree. Off the curves, phi is a covering of each
 * region R with w(R) sheets. Over a curve J, the inner points that map to J are a covering with as
 * many sheets as there are on its right, and beside them there is one boundary curve, once, by 3.
 * Euler characteristics (with compact supports) add up over parts, multiply in coverings, and are 0
 * for circles, so chi(M) = sum w(R) chi(R). Let e(J) be +1 if J runs counter-clockwise round its
 * inside D(J), else -1. Then w is the sum of e(J) over the curves with y in D(J), and the regions
 * in D(J) have chi 1 in all, so
 *
 *     chi(M) = sum e(J).
 *
 * Let M have L curves and genus g, p of its curves positive: p - (L - p) = chi(M) = 2 - 2g - L,
 * that is, p = 1 - g. Outside of all curves w = 0, and w >= 0, so outermost curves are positive.
 * Hence p = 1 and g = 0, there is one outermost curve, and all others run clockwise within it: w
 * <= 1. So no point has two preimages: off the curves by w <= 1; on a curve, an inner preimage
 * counts on both of its sides and the boundary point itself on its left, where there would be 2;
 * and two boundary points are excluded by 3. For 4 see nesting.h.
 *
 * With depth, psi = (phi, a0 sigma0 + a1 sigma1), a0 + a1 = 1, increases with z above each point
 * exactly if sigma1 > sigma0 there. So psi is one-to-one if phi is and sigma1 > sigma0.
 *
 * Of the answer `no` there is a witness: triangles of the domain that overlap, so that there is no
 * map of the plane; a place where the determinant is negative; a vertex whose fan covers itself;
 * two places of the boundary that have one image; a vertex whose image lies in that of another
 * component; for psi also a place where sigma1 <= sigma0, so that a vertical line is turned over or
 * becomes a point. */
#ifndef INJECTIVE_H
#define INJECTIVE_H

#include "boundary.h"
#include "fans.h"
#include "jacobian.h"
#include "nesting.h"
#include "overlap.h"

enum injective_verdict { INJECTIVE_YES, INJECTIVE_UNDECIDED, INJECTIVE_NO };

/* "yes", "undecided", "no" */
extern const char *const injective_verdict_names[];

struct injective {
    enum injective_verdict phi, psi; /* psi is phi without depth */
    struct overlap overlap;
    enum fan_kind fans;
    uint32_t fan_vertex, fan_turns; /* unless FAN_SOUND; fans_worst */
    struct boundary_meeting boundary;
    struct nesting nesting; /* examined if boundary.meet.verdict is MEET_NOT */
};

/* The certificates of the determinant and, with depth, of the thickness are the caller's. The
 * rule's `undecided` also says how near, relative to their extent, the images of two boundary edges
 * may be that are left undecided. 0.2 us a triangle and 1 us a boundary edge. */
bool injective_init(struct injective *j, const struct spline *s,
                    const struct jacobian_report *plane, const struct jacobian_report *thickness,
                    const struct least_rule *rule, struct err *err) WARN_UNUSED;
void injective_free(struct injective *j);

/* True if nothing overlaps, fans are sound, curves simple and disjoint, components apart. If not,
 * ERR_REFUSAL with what is wrong: "not one-to-one: ..." or "not proved to be one-to-one: ...". */
bool injective_holds(const struct injective *j, struct err *err) WARN_UNUSED;

/* All in one: is psi, or without depth phi, proved to be one-to-one? If not, ERR_REFUSAL as above.
 * About 1 us a triangle of degree 5 that is bent mildly. */
bool injective_prove(const struct spline *s, struct err *err) WARN_UNUSED;

#endif
