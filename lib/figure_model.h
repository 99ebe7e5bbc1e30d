/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_model - a model before and after a deformation, in the grid's frame, as figures show it.
 */
#ifndef FIGURE_MODEL_H
#define FIGURE_MODEL_H

#include "deform.h"
#include "model.h"

/* Gives the model (in its own axes) coordinates x, y, depth of the grid's frame, and *deformed the
 * same elements with deformed vertices. Vertices outside the grid stay where they are. The arrays
 * of elements are the model's. *deformed.vertex is the caller's to free. */
bool figure_model(struct model *model, struct model *deformed, const struct spline *s,
                  struct err *err) WARN_UNUSED;

#endif
