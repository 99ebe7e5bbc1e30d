/* SPDX-License-Identifier: GPL-3.0-or-later */
/* textured - a surface of triangles on which each corner has, beside its position, a place in a
 * pattern: a piecewise affine map from the pattern to the surface. */
#ifndef TEXTURED_H
#define TEXTURED_H

#include <stddef.h>
#include <stdint.h>

struct textured_face {
    uint32_t vertex[3], place[3];
    uint8_t sides; /* bit l: the side from corner l to the next is one of the surface's own; others
                      cut a face of more corners into triangles */
};

struct textured {
    size_t vertex_count, place_count;
    uint32_t face_count;
    double (*vertex)[3], (*place)[2];
    struct textured_face *face;
};

/* The boxes of what faces use: of the positions along two axes, and of the places. */
void textured_box(const struct textured *t, const int axes[2], double lo[2], double hi[2]);
void textured_pattern_box(const struct textured *t, double lo[2], double hi[2]);

#endif
