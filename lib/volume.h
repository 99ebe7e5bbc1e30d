/* SPDX-License-Identifier: GPL-3.0-or-later */
/* volume - of the deformed prisms of a grid with depth, by exact integration. */
#ifndef VOLUME_H
#define VOLUME_H

#include "spline.h"

/* The integral of det grad phi (sigma1 - sigma0) over the domain, and its ratio to the volume of
 * the undeformed prisms; each is computed in rational numbers and rounded once. Where psi is not
 * one-to-one, this is the signed volume. 30 us a triangle of degree 5. */
bool volume_of_prisms(const struct spline *s, double *volume, double *ratio,
                      struct err *err) WARN_UNUSED;

#endif
