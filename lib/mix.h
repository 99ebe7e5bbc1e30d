/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mix - linear combinations of splines on one domain. The conditions of smoothness are linear and
 * homogeneous, so a combination of C1 splines is C1 whatever the weights. */
#ifndef MIX_H
#define MIX_H

#include "spline.h"

/* Fills *mix with sum over i of weight[i] * spline[i] (n >= 1), each number rounded once from its
 * exact value. All must have the same degree and domain (plane, lattice, depth, vertices,
 * triangles); else ERR_INPUT names the first difference and *culprit the spline that differs from
 * spline[0]. Numbers that leave the range of doubles are an ERR_REFUSAL. */
bool mix_splines(size_t n, const double *weight, const struct spline *spline, struct spline *mix,
                 size_t *culprit, struct err *err) WARN_UNUSED;

#endif
