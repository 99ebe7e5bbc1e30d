/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "source_io.h"

#include "image_header_io.h"
#include "mem.h"
#include "obj_io.h"
#include "triangulation_io.h"
#include "xy_io.h"

#include <math.h>
#include <string.h>

static bool from_rectangle(struct grid *g, const struct source *s, struct err *err) {
    struct rectangle r = s->rectangle;
    r.lattice = s->lattice;
    return rectangle_grid(g, &r, err) && grid_build(g, err);
}

static bool around(struct grid *g, const struct source *s, const struct model *m, bool flat,
                   struct surround_report *report, struct err *err) {
    struct surround how = s->surround;
    how.lattice = s->lattice;
    how.flat = how.flat || flat;
    return surround_grid(g, m, &how, report, err);
}

static bool from_model(struct grid *g, const struct source *s, struct surround_report *report,
                       struct err *err) {
    struct model m;
    bool ok;
    if (!model_read(&m, s->file, err)) return false;
    ok = around(g, s, &m, false, report, err);
    model_free(&m);
    return ok;
}

/* A polygon with holes as its constrained Delaunay triangles, so that holes stay open; without
 * holes as one face, which then may cross itself. */
static bool outline_faces(struct model *m, const struct polygon *p, struct err *err) {
    const struct domain plain = {{0, 24}, INFINITY, 0, SIZE_MAX};
    struct grid g = {.degree = 1, .axes = {0, 1, 2}};
    size_t corners = p->loop_count == 1 ? p->point_count : 3, faces = 1;
    bool ok = p->loop_count == 1 || domain_grid(&g, p, &plain, err);
    if (ok && p->loop_count > 1) faces = g.triangle_count;
    ok = ok && mem_new(m->start, faces + 1, err) && mem_new(m->index, corners * faces, err) &&
         mem_new(m->kind, faces, err);
    if (ok) {
        for (size_t f = 0; f <= faces; f++) m->start[f] = f * corners;
        memset(m->kind, 'f', faces);
        m->element_count = faces;
        for (size_t i = 0; p->loop_count == 1 && i < corners; i++) m->index[i] = (uint32_t)i;
        if (p->loop_count > 1) memcpy(m->index, g.triangle, faces * sizeof *g.triangle);
    }
    grid_free(&g);
    return ok;
}

/* The outline in the plane of the grid's first two axes, at depth 0. */
static bool outline_model(struct model *m, const struct polygon *p, const int axes[3],
                          struct err *err) {
    *m = (struct model){.vertex_count = p->point_count};
    if (!mem_new(m->vertex, p->point_count, err)) return false;
    for (size_t i = 0; i < p->point_count; i++)
        for (int c = 0; c < 2; c++) m->vertex[i][axes[c]] = p->point[i][c];
    return outline_faces(m, p, err);
}

static bool from_outline(struct grid *g, const struct source *s, struct surround_report *report,
                         struct err *err) {
    struct polygon p;
    struct model m;
    bool ok;
    if (!xy_read_polygon(&p, s->file, err)) return false;
    ok = outline_model(&m, &p, g->axes, err) && around(g, s, &m, !g->has_depth, report, err);
    model_free(&m);
    polygon_free(&p);
    return ok;
}

static bool from_polygon(struct grid *g, const struct source *s, struct err *err) {
    struct domain d = s->domain;
    struct polygon p;
    bool ok;
    if (!xy_read_polygon(&p, s->file, err)) return false;
    d.lattice = s->lattice;
    ok = domain_grid(g, &p, &d, err);
    polygon_free(&p);
    return ok;
}

static bool from_triangulation(struct grid *g, const struct source *s, struct err *err) {
    struct triangulation t;
    bool ok;
    if (!triangulation_read(&t, s->file, g->axes, err)) return false;
    ok = triangulation_grid(g, &t, &s->lattice, err);
    triangulation_free(&t);
    return ok;
}

/* An image must be one even where the frame tells the rectangle. */
static bool from_image(struct grid *g, const struct source *s, struct err *err) {
    struct source framed = *s;
    struct image_header image;
    if (!image_header_read(&image, s->file, err)) return false;
    if (!s->framed) {
        framed.rectangle.low[0] = framed.rectangle.low[1] = 0;
        framed.rectangle.high[0] = image.width;
        framed.rectangle.high[1] = image.height;
    }
    return from_rectangle(g, &framed, err);
}

static bool make(struct grid *g, const struct source *s, struct surround_report *report,
                 struct err *err) {
    switch (s->kind) {
    case SOURCE_RECT:
        return from_rectangle(g, s, err);
    case SOURCE_MODEL:
        return from_model(g, s, report, err);
    case SOURCE_AROUND:
        return from_outline(g, s, report, err);
    case SOURCE_POLYGON:
        return from_polygon(g, s, err);
    case SOURCE_IMAGE:
        return from_image(g, s, err);
    default:
        return from_triangulation(g, s, err);
    }
}

bool source_grid(struct grid *g, const struct source *s, struct surround_report *report,
                 struct err *err) {
    if (make(g, s, report, err)) return true;
    if (s->kind == SOURCE_RECT || s->kind == SOURCE_MODEL || err->kind != ERR_REFUSAL) return false;
    return err_place(err, strcmp(s->file, "-") == 0 ? "<stdin>" : s->file, 0, 0);
}
