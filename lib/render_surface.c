/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A band of samples learns first which face each of them sees (raster.h), then what is painted
 * there. Coordinates are those of samples: N of them are a pixel. */
#include "mem.h"
#include "palette.h"
#include "predicate.h"
#include "raster.h"
#include "render.h"

#include <math.h>

enum { BAND = 1 << 22 }; /* samples */

struct painter {
    const struct render_style *style;
    const struct textured *surface;
    const int *axes;
    const struct viewport *view;
    struct raster raster;
    uint8_t *fold; /* by samples of the band: a face that is turned over has it; NULL: not asked */
    /* the face that was seen last */
    uint32_t face;
    double corner[3][2], length[3]; /* of its sides; infinite where they are no lines of the mesh */
    struct raster_plane place[2];
    struct render_sight sight;
};

static void corners_of(const struct painter *p, uint32_t face, double corner[3][2]) {
    for (int c = 0; c < 3; c++) {
        const double *v = p->surface->vertex[p->surface->face[face].vertex[c]];
        for (int k = 0; k < 2; k++)
            corner[c][k] = p->style->antialias * viewport_pixel(p->view, k, v[p->axes[k]]);
    }
}

/* Does the map from the pattern to the world turn the face over? `turn` is that of its samples. */
static bool is_turned(const struct painter *p, uint32_t face, int turn) {
    const uint32_t *place = p->surface->face[face].place;
    const double(*at)[2] = (const double(*)[2])p->surface->place;
    int pattern = predicate_orient(at[place[0]], at[place[1]], at[place[2]]);
    bool mirrored = (p->view->step[0] < 0) != (p->view->step[1] < 0);
    return (mirrored ? -turn : turn) * pattern < 0;
}

static void mark_fold(struct painter *p, const double corner[3][2]) {
    struct raster_scan s;
    const struct raster *r = &p->raster;
    raster_scan_begin(&s, corner, r->width, r->first_row, r->first_row + r->rows);
    while (raster_scan_next(&s))
        for (uint32_t c = s.begin; c < s.end; c++)
            p->fold[(size_t)(s.row - r->first_row) * r->width + c] = 1;
}

static void draw_faces(struct painter *p) {
    const struct textured *t = p->surface;
    size_t n = (size_t)p->raster.rows * p->raster.width;
    for (size_t i = 0; p->fold && i < n; i++) p->fold[i] = 0;
    for (uint32_t f = 0; f < t->face_count; f++) {
        double corner[3][2], near[3];
        int turn;
        corners_of(p, f, corner);
        for (int c = 0; c < 3; c++) near[c] = t->vertex[t->face[f].vertex[c]][p->axes[2]];
        turn = raster_draw(&p->raster, f, (const double(*)[2])corner, near);
        if (p->fold && is_turned(p, f, turn)) mark_fold(p, (const double(*)[2])corner);
    }
}

/* Prepares what all samples of a face share. */
static void look_at_face(struct painter *p, uint32_t face) {
    const struct textured_face *f = &p->surface->face[face];
    double(*corner)[2] = p->corner;
    p->face = face;
    corners_of(p, face, corner);
    for (int k = 0; k < 2; k++) {
        double value[3];
        for (int c = 0; c < 3; c++) value[c] = p->surface->place[f->place[c]][k];
        raster_plane_set(&p->place[k], (const double(*)[2])corner, value);
        p->sight.u[k] = p->style->antialias * p->place[k].slope[0];
        p->sight.v[k] = p->style->antialias * p->place[k].slope[1];
    }
    for (int l = 0; l < 3; l++) {
        const double *a = corner[l], *b = corner[(l + 1) % 3];
        double dx = b[0] - a[0], dy = b[1] - a[1];
        p->length[l] = f->sides >> l & 1 ? sqrt(dx * dx + dy * dy) : 0;
    }
}

/* The distance of a sample from the nearest line of its face, in pixels. */
static double line_distance(const struct painter *p, double x, double y) {
    double least = INFINITY;
    for (int l = 0; l < 3; l++) {
        const double *a = p->corner[l], *b = p->corner[(l + 1) % 3];
        double area = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        if (p->length[l] > 0) least = fmin(least, fabs(area) / p->length[l]);
    }
    return least / p->style->antialias;
}

/* What lies at a point of the face that was looked at. */
static void look(struct painter *p, double x, double y, bool fold) {
    for (int k = 0; k < 2; k++) p->sight.at[k] = raster_plane_at(&p->place[k], x, y);
    if (p->style->lines) p->sight.line = line_distance(p, x, y);
    p->sight.fold = fold;
}

/* Adds what a sample sees to its pixel's sum. */
static void add_sample(struct painter *p, uint32_t column, uint32_t row, double sum[4]) {
    size_t i = (size_t)(row - p->raster.first_row) * p->raster.width + column;
    uint32_t face = p->raster.face[i];
    if (face == RASTER_NONE) return;
    if (face != p->face) look_at_face(p, face);
    look(p, column + 0.5, row + 0.5, p->fold && p->fold[i]);
    render_add(p->style, &p->sight, sum);
}

/* Do all samples of a pixel see one face (or none)? Sets it and whether it is marked as a fold. */
static bool sees_one_face(const struct painter *p, uint32_t column, uint32_t row, uint32_t *face,
                          bool *fold) {
    uint32_t n = (uint32_t)p->style->antialias;
    size_t first = (size_t)(row * n - p->raster.first_row) * p->raster.width + (size_t)column * n;
    *face = p->raster.face[first];
    *fold = p->fold && p->fold[first];
    for (uint32_t y = 0; y < n; y++)
        for (uint32_t x = 0; x < n; x++) {
            size_t i = first + (size_t)y * p->raster.width + x;
            if (p->raster.face[i] != *face || (p->fold && p->fold[i] != *fold)) return false;
        }
    return true;
}

/* The sum of a pixel's samples. Many pixels see but one colour. */
static void add_pixel(struct painter *p, uint32_t column, uint32_t row, double sum[4]) {
    uint32_t n = (uint32_t)p->style->antialias, face;
    bool fold;
    if (sees_one_face(p, column, row, &face, &fold)) {
        if (face == RASTER_NONE) return;
        if (face != p->face) look_at_face(p, face);
        look(p, n * (column + 0.5), n * (row + 0.5), fold);
        if (render_add_plain(p->style, &p->sight, sum)) return;
    }
    for (uint32_t i = 0; i < n * n; i++) add_sample(p, n * column + i % n, n * row + i / n, sum);
}

static void paint_band(struct painter *p, const struct image *image) {
    uint32_t n = (uint32_t)p->style->antialias;
    uint32_t begin = p->raster.first_row / n, end = begin + p->raster.rows / n;
    for (uint32_t row = begin; row < end; row++)
        for (uint32_t column = 0; column < image->width; column++) {
            double sum[4] = {0};
            add_pixel(p, column, row, sum);
            render_set(p->style, sum, image, column, row);
        }
}

bool render_surface(const struct render_style *style, const struct textured *surface,
                    const int axes[3], const struct viewport *view, struct image *image,
                    struct err *err) {
    struct painter p = {
        .style = style, .surface = surface, .axes = axes, .view = view, .face = RASTER_NONE};
    uint32_t n = (uint32_t)style->antialias;
    bool ok = raster_init(&p.raster, n * view->width, n * view->height, n, BAND, err);
    if (ok && style->folds) ok = mem_new(p.fold, (size_t)p.raster.room * p.raster.width, err);
    while (ok && raster_next_band(&p.raster)) {
        draw_faces(&p);
        paint_band(&p, image);
        progress_step(style->progress, p.raster.first_row + p.raster.rows, p.raster.height);
    }
    free(p.fold);
    raster_free(&p.raster);
    return ok;
}
