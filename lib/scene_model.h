/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_model - models and prism grids as things to be seen. */
#ifndef SCENE_MODEL_H
#define SCENE_MODEL_H

#include "model.h"
#include "scene.h"
#include "spline.h"

/* Adds a model, whose axes[0..2] are the frame's x, y and depth. Polygons are cut into fans.
 * `smooth`: normals are the means of those of the faces around each vertex, weighted by area; else
 * every face is flat. Polylines are drawn as lines. */
bool scene_add_model(struct scene *s, const struct model *model, const int axes[3], bool smooth,
                     uint32_t colour, struct err *err) WARN_UNUSED;

/* Adds the deformed prisms ([11] 4): their outer walls and the surfaces sigma0 (bottom) and sigma1
 * (top) as glass, the edges of all triangles on both surfaces, the upright edges at the boundary's
 * vertices, and the control points of sigma0 and sigma1 over those of phi as dots. Without depth:
 * the plane as glass, its edges, the control points. `steps`: cuts of each edge, 1..32. */
bool scene_add_prisms(struct scene *s, const struct spline *spline, int steps,
                      struct err *err) WARN_UNUSED;

#endif
