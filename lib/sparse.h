/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sparse - integer matrices in compressed rows, what exact.h and clsq.h work on.
 *
 * Row r has the entries value[i] in column col[i], start[r] <= i < start[r+1]; columns of a row are
 * distinct, in any order; no entry is 0. |value| <= 2^53, so that a value is exact as a double. */
#ifndef SPARSE_H
#define SPARSE_H

#include <stddef.h>
#include <stdint.h>

struct int_matrix {
    size_t rows, cols;
    size_t *start;  /* rows + 1 */
    uint32_t *col;  /* start[rows] */
    int64_t *value; /* start[rows] */
};

#endif
