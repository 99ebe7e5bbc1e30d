/* SPDX-License-Identifier: GPL-3.0-or-later */
/* places_io - integral curve coordinates as text, one point a line:
 *
 *     k lambda t      side 0 .. sides - 1 as the cage was given, and lambda and t in [0,1]
 *     - x y           a point outside, which has none
 *
 * Lists of places are lists (list_io.h): further columns, comments and blank lines stay, lines HOLE
 * too. At the maximum t is 0; then k and lambda may be any numbers. Written, the maximum is 0 0 0.
 */
#ifndef PLACES_IO_H
#define PLACES_IO_H

#include "cage.h"
#include "filemap.h"
#include "icc_map.h"
#include "out.h"

struct places {
    size_t count;
    struct icc_place *place; /* of the prepared cage; side ICC_OUTSIDE: a point outside, */
    double (*point)[3];      /* which is here: x y 0 */
};

/* Reads coordinates for a cage. There must be one line. Errors: file:LINE:COL. Freed by places_free
 * on success. */
bool places_read(struct places *p, const struct filemap *f, const struct cage *cage,
                 struct err *err) WARN_UNUSED;
void places_free(struct places *p); /* harmless on a zeroed struct */

/* Writes a copy of a list of points with coordinates instead; digits as in num_print. */
bool places_name(struct out *out, const struct filemap *f, const struct places *p,
                 const struct cage *cage, int digits, struct err *err) WARN_UNUSED;

/* Writes a copy of a list of coordinates with p->point instead. */
bool places_ask(struct out *out, const struct filemap *f, const struct places *p, int digits,
                struct err *err) WARN_UNUSED;

#endif
