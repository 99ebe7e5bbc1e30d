/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "textured.h"

#include <math.h>

static void extend(double lo[2], double hi[2], double x, double y) {
    lo[0] = fmin(lo[0], x);
    lo[1] = fmin(lo[1], y);
    hi[0] = fmax(hi[0], x);
    hi[1] = fmax(hi[1], y);
}

static void empty(double lo[2], double hi[2]) {
    lo[0] = lo[1] = INFINITY;
    hi[0] = hi[1] = -INFINITY;
}

void textured_box(const struct textured *t, const int axes[2], double lo[2], double hi[2]) {
    empty(lo, hi);
    for (uint32_t f = 0; f < t->face_count; f++)
        for (int c = 0; c < 3; c++) {
            const double *v = t->vertex[t->face[f].vertex[c]];
            extend(lo, hi, v[axes[0]], v[axes[1]]);
        }
}

void textured_pattern_box(const struct textured *t, double lo[2], double hi[2]) {
    empty(lo, hi);
    for (uint32_t f = 0; f < t->face_count; f++)
        for (int c = 0; c < 3; c++) {
            const double *p = t->place[t->face[f].place[c]];
            extend(lo, hi, p[0], p[1]);
        }
}
