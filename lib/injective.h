/* SPDX-License-Identifier: GPL-3.0-or-later */
/* injective - is a deformation proved to be one-to-one?
 *
 * So far near every point: the triangles of the domain do not overlap, det grad phi > 0 on each of
 * them, the fans of their images wind once round inner vertices and less than once round boundary
 * vertices, and with depth sigma1 > sigma0. */
#ifndef INJECTIVE_H
#define INJECTIVE_H

#include "spline.h"

/* True if that is proved. ERR_REFUSAL says what is not: "not one-to-one: ..." or "not proved to be
 * one-to-one: ...". About 1 us a triangle of degree 5 that is bent mildly. */
bool injective_prove(const struct spline *s, struct err *err) WARN_UNUSED;

#endif
