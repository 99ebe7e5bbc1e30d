/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_model - models as things to be seen. */
#ifndef SCENE_MODEL_H
#define SCENE_MODEL_H

#include "model.h"
#include "scene.h"

/* Adds a model, whose axes[0..2] are the frame's x, y and depth. Polygons are cut into fans.
 * `smooth`: normals are the means of those of the faces around each vertex, weighted by area; else
 * every face is flat. Polylines are drawn as lines. */
bool scene_add_model(struct scene *s, const struct model *model, const int axes[3], bool smooth,
                     uint32_t colour, struct err *err) WARN_UNUSED;

#endif
