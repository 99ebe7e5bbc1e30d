/* SPDX-License-Identifier: GPL-3.0-or-later */
/* scene - what a picture of solid things shows: triangles, glass and lines in space.
 *
 * Coordinates are those of the grid's frame: x to the right, y up, depth towards the eye that looks
 * down on the plane (frame.h). Triangles are lit from both sides. Glass is lit too, and lets what
 * is behind it through: of panes of the same kind only the nearest is seen, of panes of different
 * kinds each. Lines and dots have a width on
 * the picture and are hidden by triangles, not by glass. */
#ifndef SCENE_H
#define SCENE_H

#include "err.h"

#include <stdint.h>

enum scene_pane { SCENE_PRISM, SCENE_MODEL, SCENE_PANES };

struct scene_face {
    double corner[3][3];
    double normal[3][3];  /* at the corners, of any length; 0: that of the face */
    uint32_t colour;      /* 0xRRGGBBAA; AA < 255: glass, */
    enum scene_pane pane; /* of this kind */
};

struct scene_line { /* a dot where both ends are the same */
    double end[2][3];
    double width; /* pixels */
    uint32_t colour;
};

struct scene { /* arrays from mem.h */
    size_t face_count, line_count, face_cap, line_cap;
    struct scene_face *face;
    struct scene_line *line;
};

bool scene_add_face(struct scene *s, const struct scene_face *face, struct err *err) WARN_UNUSED;
bool scene_add_line(struct scene *s, const struct scene_line *line, struct err *err) WARN_UNUSED;
void scene_free(struct scene *s); /* harmless on a zeroed struct */

#endif
