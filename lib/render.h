/* SPDX-License-Identifier: GPL-3.0-or-later */
/* render - pictures of a texture that a map takes to the plane.
 *
 * A pixel has N x N samples, evenly spread. What a sample sees of the texture is its mean over the
 * whole footprint of a pixel around the sample, found with the derivative of the map there. All
 * samples together thus average over a tent two pixels wide, and no pattern, however fine, leaves
 * more moire than a percent or so. Edges of the surface, lines of the mesh and marks of folds are
 * as smooth as N x N samples make them. */
#ifndef RENDER_H
#define RENDER_H

#include "progress.h"
#include "spline.h"
#include "texture.h"
#include "textured.h"

struct render_style {
    struct texture texture;
    int antialias; /* N, 1.. */
    bool lines;    /* of the mesh, one pixel wide */
    bool folds;    /* mark where the map turns over */
    double background[4];
    struct progress *progress; /* or NULL */
};

/* What a sample sees. */
struct render_sight {
    double at[2];      /* the place in the pattern */
    double u[2], v[2]; /* its change to the next column and row of pixels */
    double line;       /* the distance to the nearest line of the mesh, in pixels */
    bool fold;
};

/* Adds the sight's colour, multiplied by alpha, to the sum of a pixel's samples. */
void render_add(const struct render_style *style, const struct render_sight *sight, double sum[4]);

/* The sum of all samples of a pixel, if they see one square of the checkerboard and no line:
 * `sight` is that of the pixel's centre, and they lie on one face. False: nothing was added. */
bool render_add_plain(const struct render_style *style, const struct render_sight *sight,
                      double sum[4]);

/* Sets a pixel, RGB or RGBA, from the sum of all its samples, over the background. */
void render_set(const struct render_style *style, const double sum[4], const struct image *image,
                uint32_t column, uint32_t row);

/* Renders a surface as seen along the third of these axes, which grows towards the eye; the first
 * two are x and y. Where the surface lies on itself at the same depth, the last face is seen.
 * The image, allocated, has the view's size. O(faces bands + pixels N^2). */
bool render_surface(const struct render_style *style, const struct textured *surface,
                    const int axes[3], const struct viewport *view, struct image *image,
                    struct err *err) WARN_UNUSED;

/* The box of the domain. */
void render_domain_box(const struct grid *g, double lo[2], double hi[2]);

/* The box of the image of phi, as far as samples tell it: to within a thousandth of how far an edge
 * bends. A side that is nothing but rounding, of a map onto a line or point, is 0. */
bool render_map_box(const struct spline *s, double lo[2], double hi[2],
                    struct err *err) WARN_UNUSED;

/* Renders the pattern on the domain of phi under phi, by the preimage of every sample that counts:
 * where the centres of a pixel and of its neighbours lie in one square, all of it does. Of several
 * preimages the one of inverse.h is seen; any of them marks a fold. Some 1.5 us a pixel with a side
 * of a square in it, for 4 x 4 samples; of maps that are not one-to-one ten times that, and layers
 * of theirs that are narrower than a pixel may be overlooked. */
bool render_map(const struct render_style *style, const struct spline *s,
                const struct viewport *view, struct image *image, struct err *err) WARN_UNUSED;

#endif
