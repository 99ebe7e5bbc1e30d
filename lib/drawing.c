/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawing.h"

#include "mem.h"

#include <math.h>
#include <string.h>

void drawing_init(struct drawing *d) {
    *d = (struct drawing){0};
}

void drawing_free(struct drawing *d) {
    for (size_t i = 0; i < d->picture_count; i++) free(d->picture[i].pixel);
    free(d->shape);
    free(d->op);
    free(d->point);
    free(d->picture);
    *d = (struct drawing){0};
}

bool drawing_ok(const struct drawing *d, struct err *err) {
    if (!d->err.kind) return true;
    *err = d->err;
    return false;
}

/* ---- paths ---- */

static void add_op(struct drawing *d, enum drawing_op op) {
    if (d->err.kind || !mem_grow(d->op, &d->op_cap, d->op_count + 1, &d->err)) return;
    d->op[d->op_count++] = (unsigned char)op;
}

static void add_point(struct drawing *d, double x, double y) {
    if (d->err.kind || !mem_grow(d->point, &d->point_cap, d->point_count + 1, &d->err)) return;
    d->point[d->point_count][0] = x;
    d->point[d->point_count++][1] = y;
}

void drawing_move(struct drawing *d, double x, double y) {
    add_op(d, DRAWING_MOVE);
    add_point(d, x, y);
}

void drawing_line(struct drawing *d, double x, double y) {
    add_op(d, DRAWING_LINE);
    add_point(d, x, y);
}

void drawing_curve(struct drawing *d, const double a[2], const double b[2], const double end[2]) {
    add_op(d, DRAWING_CURVE);
    add_point(d, a[0], a[1]);
    add_point(d, b[0], b[1]);
    add_point(d, end[0], end[1]);
}

void drawing_close(struct drawing *d) {
    add_op(d, DRAWING_CLOSE);
}

/* ---- shapes ---- */

static void add_shape(struct drawing *d, const struct drawing_shape *shape) {
    if (d->err.kind || !mem_grow(d->shape, &d->shape_cap, d->shape_count + 1, &d->err)) return;
    d->shape[d->shape_count++] = *shape;
}

void drawing_paint(struct drawing *d, const struct drawing_ink *ink) {
    struct drawing_shape shape = {.ink = *ink,
                                  .op = d->op_inked,
                                  .op_count = d->op_count - d->op_inked,
                                  .point = d->point_inked,
                                  .picture = SIZE_MAX};
    if (shape.op_count > 0) add_shape(d, &shape);
    d->op_inked = d->op_count;
    d->point_inked = d->point_count;
}

void drawing_place(struct drawing *d, uint32_t width, uint32_t height, uint32_t *pixel,
                   const double first[2], const double last[2]) {
    struct drawing_picture picture = {.width = width, .height = height, .pixel = pixel};
    struct drawing_shape shape = {
        .op = d->op_inked, .point = d->point_inked, .picture = d->picture_count};
    memcpy(picture.at[0], first, sizeof picture.at[0]);
    memcpy(picture.at[1], last, sizeof picture.at[1]);
    if (d->err.kind || !mem_grow(d->picture, &d->picture_cap, d->picture_count + 1, &d->err)) {
        free(pixel);
        return;
    }
    d->picture[d->picture_count++] = picture;
    add_shape(d, &shape);
}

/* ---- parts ---- */

/* Four cubic arcs; they leave the circle by 0.03 % of the radius. */
void drawing_disc(struct drawing *d, double x, double y, double radius) {
    static const double turn[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    const double arm = 0.5522847498307936 * radius; /* 4/3 (sqrt 2 - 1) */
    drawing_move(d, x + radius, y);
    for (int i = 0; i < 4; i++) {
        const double *from = turn[i], *to = turn[i + 1];
        double a[2], b[2], end[2];
        for (int c = 0; c < 2; c++) {
            double centre = c ? y : x;
            a[c] = centre + radius * from[c] + arm * to[c];
            b[c] = centre + radius * to[c] + arm * from[c];
            end[c] = centre + radius * to[c];
        }
        drawing_curve(d, a, b, end);
    }
    drawing_close(d);
}

void drawing_polygon(struct drawing *d, size_t n, const double (*point)[2]) {
    for (size_t i = 0; i < n; i++) (i ? drawing_line : drawing_move)(d, point[i][0], point[i][1]);
    drawing_close(d);
}

void drawing_arrow(struct drawing *d, const double from[2], const double to[2], double head,
                   const struct drawing_ink *ink) {
    double dx = to[0] - from[0], dy = to[1] - from[1], length = sqrt(dx * dx + dy * dy);
    struct drawing_ink solid = {.fill = ink->stroke};
    double base[2];
    if (!(length > 0)) return;
    if (head > length / 2) head = length / 2;
    dx *= head / length;
    dy *= head / length;
    base[0] = to[0] - dx;
    base[1] = to[1] - dy;
    drawing_move(d, from[0], from[1]);
    drawing_line(d, base[0], base[1]);
    drawing_paint(
        d, &(struct drawing_ink){.stroke = ink->stroke, .width = ink->width, .dash = ink->dash});
    drawing_polygon(d, 3,
                    (const double[][2]){{to[0], to[1]},
                                        {base[0] - 0.35 * dy, base[1] + 0.35 * dx},
                                        {base[0] + 0.35 * dy, base[1] - 0.35 * dx}});
    drawing_paint(d, &solid);
}
