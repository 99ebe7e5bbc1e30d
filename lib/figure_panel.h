/* SPDX-License-Identifier: GPL-3.0-or-later */
/* figure_panel - one side of a figure: from the world to the page, and the layers drawn there. */
#ifndef FIGURE_PANEL_H
#define FIGURE_PANEL_H

#include "figure.h"

struct figure_panel {
    struct drawing *drawing;
    const struct figure_content *content;
    const struct figure_options *options;
    bool deformed;
    const double (*point)[2]; /* control points on this side: nominal or phi's; NULL: no spline */
    double lo[2], hi[2];      /* what is shown, world units */
    double scale;             /* page units a world unit */
    double at[2];             /* on the page: where the corner (lo x, hi y) is, or (lo x, lo y) */
    double spacing;           /* of the Bezier net, typically, page units */
};

static inline bool figure_shows(const struct figure_panel *p, enum figure_layer layer) {
    return p->options->layers >> layer & 1;
}

/* World to page. */
static inline void figure_page(const struct figure_panel *p, const double xy[2], double page[2]) {
    page[0] = p->at[0] + p->scale * (xy[0] - p->lo[0]);
    page[1] = p->at[1] + p->scale * (p->options->y_down ? xy[1] - p->lo[1] : p->hi[1] - xy[1]);
}

/* A size that follows the spacing of the net, within limits, page units. */
double figure_size(const struct figure_panel *p, double part, double least, double most);

void figure_picture(const struct figure_panel *p);
void figure_silhouette(const struct figure_panel *p);
bool figure_growth(const struct figure_panel *p, struct err *err) WARN_UNUSED;
void figure_quads(const struct figure_panel *p);
void figure_edges(const struct figure_panel *p, bool boundary);
void figure_net(const struct figure_panel *p);
void figure_points(const struct figure_panel *p);
void figure_labels(const struct figure_panel *p);
void figure_lines(const struct figure_panel *p);
uint32_t figure_word_colour(const struct figure_panel *p, uint32_t name); /* of polylines */
void figure_sets(const struct figure_panel *p);

/* The mark of a control point, whose colour tells its type or its role in an edit. */
void figure_type_mark(struct drawing *d, double x, double y, double size, enum point_type type);
void figure_role_mark(struct drawing *d, double x, double y, double size, enum edit_role role);

/* The legend from the line y on; returns where it ends. */
double figure_legend(const struct figure_panel *p, double y);

#endif
