/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene_prisms - a deformation in space as a thing to be seen: its prisms ([11] 4) and what rules
 * them.
 *
 * The bottom of the prisms is the surface (phi, sigma0) over the grid, the top (phi, sigma1). The
 * control points of sigma0 and sigma1 stand at the height of their coefficients over those of phi;
 * joined as in the Bezier net, they are the nets of both surfaces. Where phi is the identity, the
 * top is the graph of sigma1; a quadrilateral condition of sigma1 says that its four points lie in
 * a plane. Without depth there is one surface, the plane. */
#ifndef SCENE_PRISMS_H
#define SCENE_PRISMS_H

#include "scene.h"
#include "spline.h"

enum scene_prisms_layer {
    PRISMS_GLASS,     /* both surfaces and the outer walls */
    PRISMS_TRIANGLES, /* edges of the triangles on both surfaces, uprights at the boundary */
    PRISMS_POINTS,    /* control points of both; larger where their net is shown */
    PRISMS_NET,       /* Bezier nets of both */
    PRISMS_QUADS,     /* quadrilateral conditions of both, each as two triangles */
};

/* "glass", "triangles", ...; NULL ends the table. */
extern const char *const scene_prisms_layer_names[];

struct scene_prisms_options {
    unsigned layers; /* 1 << PRISMS_... each */
    unsigned sheets; /* with points, net and quads of the bottom (1), the top (2) or both (3) */
    int steps;       /* cuts of each edge of a triangle, 1..32 */
};

/* Without depth the one surface is always shown. */
bool scene_add_prisms(struct scene *s, const struct spline *spline,
                      const struct scene_prisms_options *options, struct err *err) WARN_UNUSED;

#endif
