/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rasters of the same band: what is solid, with lines drawn as thin quadrilaterals a little nearer
 * than they are, and one of each kind of glass. Every sample is shaded and added to its pixel. */
#include "scene_render.h"

#include "mem.h"
#include "raster.h"
#include "trig.h"

#include <math.h>
#include <string.h>

enum { BAND = 1 << 22, DISC = 12 };

struct renderer {
    const struct scene *scene;
    const struct scene_camera *camera;
    const struct viewport *view;
    const struct scene_style *style;
    struct raster solid, glass[SCENE_PANES];
    double (*screen)[3][3]; /* corners of each face: column, row, nearness */
    double disc[DISC + 1][2];
    double light[3], half[3];
    float (*sum)[4]; /* of the samples of each pixel: colours times alpha, alpha */
    struct image *image;
};

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(double v[3]) {
    double length = sqrt(dot(v, v));
    for (int c = 0; length > 0 && c < 3; c++) v[c] /= length;
}

/* ---- the camera ---- */

struct scene_camera scene_camera(double azimuth, double elevation) {
    double ca, sa, ce, se;
    trig_degrees(azimuth, &ca, &sa);
    trig_degrees(elevation, &ce, &se);
    return (struct scene_camera){{{ca, sa, 0}, {-sa * se, ca * se, ce}, {sa * ce, -ca * ce, se}}};
}

static void widen(const struct scene_camera *camera, const double p[3], double lo[2],
                  double hi[2]) {
    for (int c = 0; c < 2; c++) {
        double x = dot(camera->axis[c], p);
        lo[c] = fmin(lo[c], x);
        hi[c] = fmax(hi[c], x);
    }
}

bool scene_bounds(const struct scene *s, const struct scene_camera *camera, double lo[2],
                  double hi[2], struct err *err) {
    double room;
    lo[0] = lo[1] = INFINITY;
    hi[0] = hi[1] = -INFINITY;
    for (size_t i = 0; i < s->face_count; i++)
        for (int l = 0; l < 3; l++) widen(camera, s->face[i].corner[l], lo, hi);
    for (size_t i = 0; i < s->line_count; i++)
        for (int l = 0; l < 2; l++) widen(camera, s->line[i].end[l], lo, hi);
    if (!(lo[0] <= hi[0])) return err_set(err, ERR_REFUSAL, "there is nothing to be seen");
    room = 0.02 * fmax(hi[0] - lo[0], hi[1] - lo[1]); /* for the widths of lines */
    for (int c = 0; c < 2; c++) {
        lo[c] -= room;
        hi[c] += room;
    }
    return true;
}

/* Columns, rows and nearness of a point. */
static void project(const struct renderer *r, const double p[3], double screen[3]) {
    for (int c = 0; c < 2; c++)
        screen[c] = r->style->antialias * viewport_pixel(r->view, c, dot(r->camera->axis[c], p));
    screen[2] = dot(r->camera->axis[2], p);
}

/* ---- drawing ---- */

static void draw_triangle(struct raster *r, uint32_t number, double a[3], double b[3],
                          double c[3]) {
    const double corner[3][2] = {{a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]}};
    const double near[3] = {a[2], b[2], c[2]};
    (void)raster_draw(r, number, corner, near);
}

/* A strip, or a disc around a dot; `number` follows those of the faces. */
static void draw_line(struct renderer *r, size_t i) {
    const struct scene_line *line = &r->scene->line[i];
    const uint32_t number = (uint32_t)(r->scene->face_count + i);
    double a[3], b[3], radius = line->width / 2 * r->style->antialias, dx, dy, length;
    double lift = 2 * line->width * fabs(r->view->step[0]);
    project(r, line->end[0], a);
    project(r, line->end[1], b);
    a[2] += lift;
    b[2] += lift;
    dx = b[0] - a[0];
    dy = b[1] - a[1];
    length = sqrt(dx * dx + dy * dy);
    if (line->end[0][0] == line->end[1][0] && line->end[0][1] == line->end[1][1] &&
        line->end[0][2] == line->end[1][2]) {
        for (int k = 0; k < DISC; k++) {
            const double *u = r->disc[k], *v = r->disc[k + 1];
            double p[3] = {a[0] + radius * u[0], a[1] + radius * u[1], a[2]};
            double q[3] = {a[0] + radius * v[0], a[1] + radius * v[1], a[2]};
            draw_triangle(&r->solid, number, a, p, q);
        }
    } else if (length > 0) {
        double nx = -dy / length * radius, ny = dx / length * radius;
        double q[4][3] = {{a[0] + nx, a[1] + ny, a[2]},
                          {a[0] - nx, a[1] - ny, a[2]},
                          {b[0] - nx, b[1] - ny, b[2]},
                          {b[0] + nx, b[1] + ny, b[2]}};
        draw_triangle(&r->solid, number, q[0], q[1], q[2]);
        draw_triangle(&r->solid, number, q[0], q[2], q[3]);
    }
}

static void draw_band(struct renderer *r) {
    for (size_t i = 0; i < r->scene->face_count; i++) {
        const struct scene_face *f = &r->scene->face[i];
        double(*at)[3] = r->screen[i];
        draw_triangle((f->colour & 255) < 255 ? &r->glass[f->pane] : &r->solid, (uint32_t)i, at[0],
                      at[1], at[2]);
    }
    for (size_t i = 0; i < r->scene->line_count; i++) draw_line(r, i);
}

/* ---- light ---- */

/* The normal at a sample, towards the eye: of the face, or between those of its corners. */
static void normal_at(const struct renderer *r, uint32_t number, double x, double y, double n[3]) {
    const struct scene_face *f = &r->scene->face[number];
    double(*at)[3] = r->screen[number];
    double area = (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
                  (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
    double b1 =
        ((x - at[0][0]) * (at[2][1] - at[0][1]) - (y - at[0][1]) * (at[2][0] - at[0][0])) / area;
    double b2 =
        ((at[1][0] - at[0][0]) * (y - at[0][1]) - (at[1][1] - at[0][1]) * (x - at[0][0])) / area;
    for (int c = 0; c < 3; c++)
        n[c] = (1 - b1 - b2) * f->normal[0][c] + b1 * f->normal[1][c] + b2 * f->normal[2][c];
    if (!(dot(n, n) > 0)) /* flat */
        for (int c = 0; c < 3; c++) {
            int i = (c + 1) % 3, j = (c + 2) % 3;
            n[c] = (f->corner[1][i] - f->corner[0][i]) * (f->corner[2][j] - f->corner[0][j]) -
                   (f->corner[1][j] - f->corner[0][j]) * (f->corner[2][i] - f->corner[0][i]);
        }
    normalise(n);
    if (dot(n, r->camera->axis[2]) < 0)
        for (int c = 0; c < 3; c++) n[c] = -n[c];
}

/* Ambient and diffuse light on the colour, and a highlight of white. */
static void light_face(const struct renderer *r, uint32_t number, double x, double y,
                       double colour[3]) {
    const uint32_t own = r->scene->face[number].colour;
    double n[3], diffuse, shine;
    normal_at(r, number, x, y, n);
    diffuse = fmax(0, dot(n, r->light));
    shine = fmax(0, dot(n, r->half));
    for (int i = 0; i < 5; i++) shine *= shine; /* to the 32nd power */
    for (int c = 0; c < 3; c++)
        colour[c] = fmin(255, (own >> (24 - 8 * c) & 255) * (0.35 + 0.65 * diffuse) + 50 * shine);
}

static void flat_colour(uint32_t own, double colour[3]) {
    for (int c = 0; c < 3; c++) colour[c] = own >> (24 - 8 * c) & 255;
}

/* Puts the pane at a sample, if it is not behind something solid, before what is behind it. */
static void look_through(const struct renderer *r, const struct raster *glass, size_t at, double x,
                         double y, double colour[3], double *alpha) {
    const uint32_t face = glass->face[at];
    double pane[3], cover;
    if (face == RASTER_NONE || !(glass->nearness[at] > r->solid.nearness[at])) return;
    cover = (r->scene->face[face].colour & 255) / 255.0;
    light_face(r, face, x, y, pane);
    for (int c = 0; c < 3; c++) colour[c] += cover * (pane[c] - colour[c]);
    *alpha += cover * (1 - *alpha);
}

/* Adds one sample: colours times alpha, and alpha. */
static void shade_sample(const struct renderer *r, size_t at, double x, double y, float sum[4]) {
    const uint32_t solid = r->solid.face[at];
    const int nearer = r->glass[1].nearness[at] > r->glass[0].nearness[at];
    double colour[3], alpha = 1;
    if (solid == RASTER_NONE) {
        flat_colour(r->style->background, colour);
        alpha = (r->style->background & 255) / 255.0;
    } else if (solid >= r->scene->face_count)
        flat_colour(r->scene->line[solid - r->scene->face_count].colour, colour);
    else
        light_face(r, solid, x, y, colour);
    for (int c = 0; c < 3; c++) colour[c] *= alpha;
    look_through(r, &r->glass[!nearer], at, x, y, colour, &alpha);
    look_through(r, &r->glass[nearer], at, x, y, colour, &alpha);
    for (int c = 0; c < 3; c++) sum[c] += (float)colour[c];
    sum[3] += (float)alpha;
}

static void shade_band(struct renderer *r) {
    const uint32_t n = (uint32_t)r->style->antialias;
    for (uint32_t row = 0; row < r->solid.rows; row++)
        for (uint32_t column = 0; column < r->solid.width; column++) {
            size_t at = (size_t)row * r->solid.width + column;
            uint32_t y = r->solid.first_row + row;
            shade_sample(r, at, column + 0.5, y + 0.5,
                         r->sum[(size_t)(y / n) * r->view->width + column / n]);
        }
}

static void set_light(struct renderer *r) {
    static const double from[3] = {-0.45, 0.55, 0.75}; /* right, up, towards */
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) r->light[c] += from[k] * r->camera->axis[k][c];
    normalise(r->light);
    for (int c = 0; c < 3; c++) r->half[c] = r->light[c] + r->camera->axis[2][c];
    normalise(r->half);
}

/* ---- the picture ---- */

static void finish(struct renderer *r) {
    const struct image *image = r->image;
    const float samples = (float)(r->style->antialias * r->style->antialias);
    const float full = image_full(image->sample);
    for (size_t i = 0; i < (size_t)image->width * image->height; i++) {
        float *value = image->value + i * (size_t)image->channels, alpha = r->sum[i][3] / samples;
        for (int c = 0; c < 3; c++) {
            value[c] = r->sum[i][c] / samples / 255 * full;
            if (image->straight && alpha > 0) value[c] /= alpha;
        }
        if (image->alpha >= 0) value[image->alpha] = alpha * full;
    }
}

static bool prepare(struct renderer *r, struct err *err) {
    const uint32_t n = (uint32_t)r->style->antialias, w = n * r->view->width,
                   h = n * r->view->height;
    set_light(r);
    for (int k = 0; k <= DISC; k++) trig_degrees(k * 360.0 / DISC, &r->disc[k][0], &r->disc[k][1]);
    if (!mem_new(r->sum, (size_t)r->view->width * r->view->height, err) ||
        !mem_new(r->screen, r->scene->face_count, err) ||
        !raster_init(&r->solid, w, h, n, BAND, err) ||
        !raster_init(&r->glass[0], w, h, n, BAND, err) ||
        !raster_init(&r->glass[1], w, h, n, BAND, err))
        return false;
    for (size_t i = 0; i < r->scene->face_count; i++)
        for (int l = 0; l < 3; l++) project(r, r->scene->face[i].corner[l], r->screen[i][l]);
    return true;
}

bool scene_render(const struct scene *s, const struct scene_camera *camera,
                  const struct viewport *view, const struct scene_style *style, struct image *image,
                  struct err *err) {
    struct renderer r = {
        .scene = s, .camera = camera, .view = view, .style = style, .image = image};
    bool ok = prepare(&r, err);
    while (ok && raster_next_band(&r.solid) && raster_next_band(&r.glass[0]) &&
           raster_next_band(&r.glass[1])) {
        draw_band(&r);
        shade_band(&r);
        progress_step(style->progress, r.solid.first_row + r.solid.rows, r.solid.height);
    }
    if (ok) finish(&r);
    raster_free(&r.solid);
    for (int k = 0; k < SCENE_PANES; k++) raster_free(&r.glass[k]);
    free(r.screen);
    free(r.sum);
    return ok;
}
