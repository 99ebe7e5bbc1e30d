/* SPDX-License-Identifier: GPL-3.0-or-later */
/* inverse - the preimages of points under the plane map phi of a spline.
 *
 * For a point q in the image of phi, what is found is the place of a p with |phi(p) - q| <= 4 ulp,
 * an ulp being that of the largest |coordinate| of the control points; mostly it is less than 1.
 * Images as programs compute them carry errors of that size, so that those of the boundary may lie
 * off the image. So a q that is less than 9 ulp off it (of the largest |coordinate| of the domain,
 * if that is more) is taken for a point of the image that is at most 1.75 times as far away as the
 * nearest. A q that is more than 16 ulp off it is outside, and what is reported to be outside is
 * proved to be at least 9 ulp off. But where the image of a whole triangle is 10^10 times longer
 * than wide, or hardly wider than an ulp, a search may end early, with a place that is up to 16 ulp
 * off, or say that a q close to it is outside.
 *
 * The place is as good as said; its point p is rounded once more. So the preimage of phi(p) is p to
 * within 8 ulp over the least singular value of grad phi, and half an ulp of p.
 *
 * Of several preimages, the one in the lowest triangle is meant: of a point on a common edge or
 * corner, and of any point under a map that is not one-to-one; in a triangle that folds, which one
 * is not said, but it is always the same.
 *
 * The index cuts the patches into pieces (piece.h) on which Newton's method is proved to find the
 * preimage if there is one, and puts the images of pieces into cells. Pieces that would become too
 * many, because the Jacobian nearly vanishes, are cut further when a point is asked for. A place
 * is a function of the piece and q alone. What came before only decides which piece is tried first,
 * and under a one-to-one map a point well inside of a piece is in no other. So answers depend
 * neither on hints nor on the order of the points: 0.5 us a point where the map is bent mildly.
 *
 * The index is read-only after inverse_init and may be shared by threads; each has a cursor. */
#ifndef INVERSE_H
#define INVERSE_H

#include "cells.h"
#include "piece.h"
#include "place.h"
#include "spline.h"

struct inverse_piece {
    struct piece piece;
    uint32_t triangle;
};

struct inverse {
    const struct spline *spline; /* borrowed, unchanged while the index lives */
    bool one_to_one;
    /* private */
    double scale;                 /* a power of two that brings control points below 2 */
    double border;                /* in these units: 3 ulp, those of the domain if they are more */
    double slack;                 /* how near is looked at */
    uint32_t piece_count, *first; /* [t]: the first piece of triangle t; they follow each other */
    struct inverse_piece *piece;
    double (*bend)[2];   /* of piece n from n * grid_patch_size(degree) on */
    struct cells cells;  /* of pieces, scaled */
    double (*vertex)[2]; /* world */
    uint8_t (*moved)[2]; /* of each triangle and component, see inverse_point */
};

/* With `one_to_one`, phi has been proved to be that (injective.h). Some 4 us a triangle of degree
 * 5, 700 bytes. */
bool inverse_init(struct inverse *v, const struct spline *s, bool one_to_one,
                  struct err *err) WARN_UNUSED;
void inverse_free(struct inverse *v);

struct inverse_cursor {
    const struct inverse *inverse; /* borrowed */
    uint32_t hint;                 /* the piece to be tried first */
    struct dd (*room)[2];          /* nets of pieces that are cut on the way */
};

bool inverse_cursor_init(struct inverse_cursor *c, const struct inverse *v,
                         struct err *err) WARN_UNUSED;
void inverse_cursor_free(struct inverse_cursor *c);

/* Says that the next point is perhaps in triangle t. */
void inverse_cursor_hint(struct inverse_cursor *c, uint32_t t);

/* Is this preimage one that is wanted? */
typedef bool inverse_wanted(void *context, const struct place *place);

/* The place of a preimage of q; false, and place->triangle = GRID_NONE: outside. With `wanted`, the
 * first of them that is wanted (it is asked about each one once or more often). */
bool inverse_find(struct inverse_cursor *c, const double q[2], inverse_wanted *wanted,
                  void *context, struct place *place);

/* The same in triangle t alone. */
bool inverse_find_in(struct inverse_cursor *c, uint32_t t, const double q[2],
                     inverse_wanted *wanted, void *context, struct place *place);

/* The point of a place that was found for q, in world units. A coordinate that phi does not move
 * there is that of q, bit for bit, as in spline_evaluate. */
void inverse_point(const struct inverse *v, const double q[2], const struct place *place,
                   double p[2]);

/* Private: the control points of triangle t, scaled. */
void inverse_net(const struct inverse *v, uint32_t t, struct piece_net *net);

#endif
