/* SPDX-License-Identifier: GPL-3.0-or-later */
/* lettering - text as strokes, so that a picture depends on no font.
 *
 * Letters stand on the baseline; capitals are `size` high, small letters two thirds of that. */
#ifndef LETTERING_H
#define LETTERING_H

#include "drawing.h"

enum lettering_align { LETTERING_LEFT, LETTERING_CENTRE, LETTERING_RIGHT };

/* ASCII but for " # $ & ; ? @ \ ^ ` ~, which are drawn as a box. */
void lettering(struct drawing *d, double x, double y, double size, enum lettering_align align,
               uint32_t colour, const char *text);

/* The same strokes, wider: under the text, they keep what is below it away. */
void lettering_halo(struct drawing *d, double x, double y, double size, enum lettering_align align,
                    uint32_t colour, const char *text);

double lettering_width(const char *text, double size);

#endif
