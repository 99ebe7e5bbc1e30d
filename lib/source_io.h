/* SPDX-License-Identifier: GPL-3.0-or-later */
/* source_io - where the grids of mkgrid come from: a rectangle, or a file that is read and handed
 * to the idea that makes a grid of it. */
#ifndef SOURCE_IO_H
#define SOURCE_IO_H

#include "domain.h"
#include "rectangle.h"
#include "surround.h"
#include "triangulation.h"

struct source {
    enum source_kind {
        SOURCE_RECT,
        SOURCE_MODEL,         /* around an OBJ */
        SOURCE_AROUND,        /* around an outline with holes (.xy) */
        SOURCE_POLYGON,       /* the polygon itself (.xy) */
        SOURCE_TRIANGULATION, /* triangulation_io */
        SOURCE_IMAGE,         /* the rectangle that an image fills, image_header_io */
    } kind;
    const char *file; /* but for RECT; "-": stdin */
    struct lattice_choice lattice;
    struct rectangle rectangle; /* for RECT and IMAGE; MODEL and AROUND; POLYGON: */
    struct surround surround;   /* their lattice is ignored */
    struct domain domain;
    bool framed; /* for IMAGE: the rectangle is the frame; else it is 0,0,W,H, one unit a pixel */
};

/* Completes and builds *g, whose degree, axes and possibly depth are set, and is the caller's to
 * free in any case. *report is filled for MODEL and AROUND. */
bool source_grid(struct grid *g, const struct source *s, struct surround_report *report,
                 struct err *err) WARN_UNUSED;

#endif
