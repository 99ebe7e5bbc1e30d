/* SPDX-License-Identifier: GPL-3.0-or-later */
/* drawing_io - a drawing as SVG, PDF or PNG, by Cairo. The bytes depend on nothing but the drawing
 * and Cairo. */
#ifndef DRAWING_IO_H
#define DRAWING_IO_H

#include "drawing.h"
#include "out.h"

enum drawing_format { DRAWING_BY_NAME = -1, DRAWING_PNG, DRAWING_SVG, DRAWING_PDF };

/* "png", "svg", "pdf"; NULL ends the table. */
extern const char *const drawing_format_names[];

/* The choice itself, or by the extension of the path (NULL or "-": PNG). ERR_USAGE: no such
 * extension, or PNG or PDF would go to a terminal. */
bool drawing_format(int choice, const char *path, enum drawing_format *format,
                    struct err *err) WARN_UNUSED;

/* PNG: one pixel a unit; refuses pages of more than 32,767 pixels a side, or 10^8 in all
 * (ERR_REFUSAL). */
bool drawing_write(struct out *out, const struct drawing *d, enum drawing_format format,
                   struct err *err) WARN_UNUSED;

#endif
