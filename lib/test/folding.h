/* SPDX-License-Identifier: GPL-3.0-or-later */
/* folding - where a deformation folds on the straight way to another one: by dense samples and in
 * exact rationals, by de Casteljau's averages of the control points, not by lib/. */
#ifndef FOLDING_H
#define FOLDING_H

#include "spline.h"

#include <gmp.h>

/* Two deformations on one grid, what is looked at, and in which triangle. */
struct folding {
    const struct spline *from, *to;
    bool thickness; /* (sigma1 - sigma0) / (b - a), else det grad phi */
    uint32_t triangle;
};

/* At share s of the way, at barycentric coordinates b, exactly. */
void folding_value(const struct folding *f, const mpq_t s, const mpq_t b[3], mpq_t value);

/* Reads the place and the triangle in "triangle 17: expected WHAT > M, got V at (1 2 5)/8 = ...",
 * and returns folding_value there, less the margin, as a sign. */
int folding_sign_of_text(const struct spline *from, const struct spline *to, const char *text,
                         double s, double margin);

/* The least share of the way at which a sample of the triangle is `margin` or less, for samples in
 * n + 1 rows and, finer and finer, around the best of them; INFINITY: none, up to share 1. Right to
 * about 1e-14 of the largest values. */
double folding_first_loss(const struct folding *f, double margin, int n);

#endif
