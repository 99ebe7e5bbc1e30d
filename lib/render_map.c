/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Three rows of pixels are known by their centres:
 *
 *     . . . . .     row - 1
 *     . . X . .     row: a pixel X whose 3 x 3 centres see one square, and no line near, is plain
 *     . . . . .     row + 1
 *
 * and one whose 3 x 3 centres agree whether there is a fold has that at all of its samples.
 *
 * Others, and those at the picture's edge, are looked at sample by sample, runs of them in a row of
 * pixels together. */
#include "render.h"

#include "injective.h"
#include "inverse_row.h"
#include "mem.h"

#include <math.h>
#include <string.h>

#define TOLERANCE 0x1p-20 /* of a pixel of the picture */

/* What is known at a point of the picture. */
struct sight {
    struct render_sight sight;
    double square[2]; /* the number of the square that it lies in */
    bool inside;
};

struct painter {
    const struct render_style *style;
    const struct spline *spline;
    const struct viewport *view;
    struct inverse inverse;
    struct inverse_row rows;
    struct inverse_cursor folds; /* to look for preimages that are turned over */
    double (*point)[2];          /* of the row that is looked at */
    struct inverse_spot *spot;
    struct sight *centre[3]; /* rows of pixels: before, this one, next */
    struct sight *sample;    /* a row of samples */
    double (*sum)[4];
};

/* ---- what a point sees */

/* Barycentric coordinates of p in triangle t, and their gradients. */
static void barycentric(const struct inverse *v, uint32_t t, const double p[2], double b[3],
                        double gradient[3][2]) {
    const uint32_t *corner = v->spline->grid.triangle[t];
    const double *a[3] = {v->vertex[corner[0]], v->vertex[corner[1]], v->vertex[corner[2]]};
    double area =
        (a[1][0] - a[0][0]) * (a[2][1] - a[0][1]) - (a[1][1] - a[0][1]) * (a[2][0] - a[0][0]);
    for (int l = 0; l < 3; l++) {
        const double *m = a[(l + 1) % 3], *n = a[(l + 2) % 3];
        gradient[l][0] = (m[1] - n[1]) / area;
        gradient[l][1] = (n[0] - m[0]) / area;
        b[l] = gradient[l][0] * (p[0] - m[0]) + gradient[l][1] * (p[1] - m[1]);
    }
}

/* The distance to the nearest edge of the triangle, in pixels, by the derivative at the point: u
 * and v are the steps of the preimage from pixel to pixel. */
static double line_distance(const struct painter *p, const struct inverse_spot *spot,
                            const struct render_sight *sight) {
    double b[3], gradient[3][2], least = INFINITY;
    barycentric(&p->inverse, spot->triangle, spot->p, b, gradient);
    for (int l = 0; l < 3; l++) {
        double x = gradient[l][0] * sight->u[0] + gradient[l][1] * sight->u[1];
        double y = gradient[l][0] * sight->v[0] + gradient[l][1] * sight->v[1];
        least = fmin(least, fabs(b[l]) / sqrt(x * x + y * y));
    }
    return least;
}

static bool is_turned_over(void *context, const struct place *place) {
    const struct painter *p = context;
    const double nowhere[3] = {0, 0, 0};
    double value[3], j[3][3];
    spline_evaluate(p->spline, place->triangle, place->b, nowhere, value, j);
    return j[0][0] * j[1][1] - j[0][1] * j[1][0] < 0;
}

static bool sees_fold(struct painter *p, const double q[2]) {
    struct place place;
    return p->style->folds && !p->inverse.one_to_one &&
           inverse_find(&p->folds, q, is_turned_over, p, &place);
}

/* Looks at the first n of p->point, not for folds. */
static void look(struct painter *p, size_t n, struct sight *to) {
    const struct texture *t = &p->style->texture;
    inverse_row_find(&p->rows, n, (const double(*)[2])p->point, p->spot);
    for (size_t i = 0; i < n; i++, to++) {
        const struct inverse_spot *spot = &p->spot[i];
        struct render_sight *s = &to->sight;
        to->inside = spot->triangle != GRID_NONE;
        if (!to->inside) continue;
        for (int k = 0; k < 2; k++) {
            s->at[k] = spot->p[k];
            s->u[k] = spot->derivative[k][0] * p->view->step[0];
            s->v[k] = spot->derivative[k][1] * p->view->step[1];
            to->square[k] = t->image ? 0 : floor((s->at[k] - t->origin[k]) / t->square);
        }
        s->line = p->style->lines ? line_distance(p, spot, s) : INFINITY;
        s->fold = false;
    }
}

/* Looks at samples across pixels [begin, end) in row y; n of them in each pixel. */
static void look_across(struct painter *p, uint32_t begin, uint32_t end, double y, int n,
                        struct sight *to) {
    size_t count = (size_t)(end - begin) * (size_t)n;
    double world_y = viewport_world(p->view, 1, y);
    for (size_t i = 0; i < count; i++) {
        p->point[i][0] = viewport_world(p->view, 0, begin + ((double)i + 0.5) / n);
        p->point[i][1] = world_y;
    }
    look(p, count, to);
}

/* ---- pixels */

/* Do a pixel and its eight neighbours see one square, or all of them nothing? */
static bool is_plain(const struct painter *p, uint32_t column, uint32_t row) {
    const struct sight *middle = &p->centre[1][column];
    if (column == 0 || row == 0 || column + 1 == p->view->width || row + 1 == p->view->height)
        return false;
    for (int r = 0; r < 3; r++)
        for (uint32_t c = column - 1; c <= column + 1; c++) {
            const struct sight *s = &p->centre[r][c];
            if (s->inside != middle->inside) return false;
            if (!s->inside) continue;
            if (s->sight.fold != middle->sight.fold || s->square[0] != middle->square[0] ||
                s->square[1] != middle->square[1])
                return false;
        }
    return true;
}

/* Are a pixel and its eight neighbours all of them marked as folds, or none? */
static bool knows_fold(const struct painter *p, uint32_t column, uint32_t row) {
    bool fold = p->centre[1][column].sight.fold;
    if (column == 0 || row == 0 || column + 1 == p->view->width || row + 1 == p->view->height)
        return false;
    for (int r = 0; r < 3; r++)
        for (uint32_t c = column - 1; c <= column + 1; c++)
            if (!p->centre[r][c].inside || p->centre[r][c].sight.fold != fold) return false;
    return true;
}

/* Looks at a row of pixels by their centres. */
static void look_at_centres(struct painter *p, uint32_t row, struct sight *to) {
    look_across(p, 0, p->view->width, row + 0.5, 1, to);
    for (uint32_t c = 0; c < p->view->width; c++)
        if (to[c].inside) to[c].sight.fold = sees_fold(p, p->point[c]);
}

/* Adds the samples of pixels [begin, end) one by one. */
static void add_samples(struct painter *p, uint32_t begin, uint32_t end, uint32_t row) {
    int n = p->style->antialias;
    for (int i = 0; i < n; i++) {
        look_across(p, begin, end, row + (i + 0.5) / n, n, p->sample);
        for (uint32_t c = begin; c < end; c++) {
            bool known = knows_fold(p, c, row);
            for (int k = 0; k < n; k++) {
                size_t at = (size_t)(c - begin) * (size_t)n + (size_t)k;
                struct render_sight *s = &p->sample[at].sight;
                if (!p->sample[at].inside) continue;
                s->fold = known ? p->centre[1][c].sight.fold : sees_fold(p, p->point[at]);
                render_add(p->style, s, p->sum[c]);
            }
        }
    }
}

/* Adds all of a plain pixel. False: it must be looked at by samples. */
static bool add_plain(struct painter *p, uint32_t column, uint32_t row) {
    const struct sight *s = &p->centre[1][column];
    if (!is_plain(p, column, row)) return false;
    return !s->inside || render_add_plain(p->style, &s->sight, p->sum[column]);
}

static void paint_row(struct painter *p, uint32_t row, const struct image *image) {
    uint32_t width = p->view->width;
    memset(p->sum, 0, width * sizeof *p->sum);
    for (uint32_t c = 0, begin; c < width; c++) {
        for (begin = c; c < width && !add_plain(p, c, row);) c++;
        if (c > begin) add_samples(p, begin, c, row);
    }
    for (uint32_t c = 0; c < width; c++) render_set(p->style, p->sum[c], image, c, row);
}

static void paint(struct painter *p, const struct image *image) {
    uint32_t height = p->view->height;
    look_at_centres(p, 0, p->centre[1]);
    for (uint32_t row = 0; row < height; row++) {
        struct sight *before = p->centre[0];
        if (row + 1 < height) look_at_centres(p, row + 1, p->centre[2]);
        paint_row(p, row, image);
        progress_step(p->style->progress, row, height);
        p->centre[0] = p->centre[1];
        p->centre[1] = p->centre[2];
        p->centre[2] = before;
    }
}

static bool begin(struct painter *p, struct err *err) {
    double pixel = fmin(fabs(p->view->step[0]), fabs(p->view->step[1]));
    size_t samples = (size_t)p->view->width * (size_t)p->style->antialias;
    struct err unproved;
    for (int r = 0; r < 3; r++)
        if (!mem_new(p->centre[r], p->view->width, err)) return false;
    return inverse_init(&p->inverse, p->spline, injective_prove(p->spline, &unproved), err) &&
           inverse_row_init(&p->rows, &p->inverse, TOLERANCE * pixel, err) &&
           inverse_cursor_init(&p->folds, &p->inverse, err) && mem_new(p->point, samples, err) &&
           mem_new(p->spot, samples, err) && mem_new(p->sample, samples, err) &&
           mem_new(p->sum, p->view->width, err);
}

bool render_map(const struct render_style *style, const struct spline *s,
                const struct viewport *view, struct image *image, struct err *err) {
    struct painter p = {.style = style, .spline = s, .view = view};
    bool ok = begin(&p, err);
    if (ok) paint(&p, image);
    free(p.sum);
    free(p.sample);
    free(p.spot);
    free(p.point);
    for (int r = 0; r < 3; r++) free(p.centre[r]);
    inverse_cursor_free(&p.folds);
    inverse_row_free(&p.rows);
    inverse_free(&p.inverse);
    return ok;
}

/* ---- boxes */

enum { EDGE_STEPS = 64, INNER_STEPS = 4 };

static void extend(double lo[2], double hi[2], const double p[2]) {
    for (int k = 0; k < 2; k++) {
        lo[k] = fmin(lo[k], p[k]);
        hi[k] = fmax(hi[k], p[k]);
    }
}

void render_domain_box(const struct grid *g, double lo[2], double hi[2]) {
    lo[0] = lo[1] = INFINITY;
    hi[0] = hi[1] = -INFINITY;
    for (uint32_t v = 0; v < g->vertex_count; v++) {
        double p[2];
        grid_vertex(g, v, p);
        extend(lo, hi, p);
    }
}

static void extend_by_image(struct spline_cursor *c, uint32_t t, const double b[3], double lo[2],
                            double hi[2]) {
    const struct grid *g = &c->spline->grid;
    double vertex[2], p[3] = {0, 0, 0}, value[3];
    for (int l = 0; l < 3; l++) {
        grid_vertex(g, g->triangle[t][l], vertex);
        for (int k = 0; k < 2; k++) p[k] += b[l] * vertex[k];
    }
    spline_cursor_evaluate(c, t, b, p, value, NULL);
    extend(lo, hi, value);
}

/* Triangle t, and those of its edges that are the boundary more finely. */
static void extend_by_triangle(struct spline_cursor *c, uint32_t t, double lo[2], double hi[2]) {
    const struct grid *g = &c->spline->grid;
    for (int i = 0; i <= INNER_STEPS; i++)
        for (int j = 0; i + j <= INNER_STEPS; j++) {
            const double b[3] = {(double)i / INNER_STEPS, (double)j / INNER_STEPS,
                                 (double)(INNER_STEPS - i - j) / INNER_STEPS};
            extend_by_image(c, t, b, lo, hi);
        }
    for (int l = 0; l < 3; l++)
        for (int i = 0; i <= EDGE_STEPS && !grid_edge_is_inner(g, g->triangle_edge[t][l]); i++) {
            double b[3] = {0, 0, 0};
            b[(l + 1) % 3] = (double)i / EDGE_STEPS;
            b[(l + 2) % 3] = (double)(EDGE_STEPS - i) / EDGE_STEPS;
            extend_by_image(c, t, b, lo, hi);
        }
}

/* What rounding may make of a side of length 0: an ulp or two of the largest coordinate. */
static void drop_rounding(const struct spline *s, double lo[2], double hi[2]) {
    for (int k = 0; k < 2; k++) {
        double largest = 0;
        for (uint32_t p = 0; p < s->grid.point_count; p++) {
            double nominal[2];
            grid_nominal(&s->grid, p, nominal);
            largest = fmax(largest, fmax(fabs(s->phi[p][k]), fabs(nominal[k])));
        }
        if (hi[k] - lo[k] < 0x1p-44 * largest) lo[k] = hi[k] = lo[k] + (hi[k] - lo[k]) / 2;
    }
}

/* The image of a map that is one-to-one ends at that of the boundary, of others perhaps inside. */
bool render_map_box(const struct spline *s, double lo[2], double hi[2], struct err *err) {
    struct spline_cursor c;
    if (!spline_cursor_init(&c, s, err)) return false;
    lo[0] = lo[1] = INFINITY;
    hi[0] = hi[1] = -INFINITY;
    for (uint32_t t = 0; t < s->grid.triangle_count; t++) extend_by_triangle(&c, t, lo, hi);
    spline_cursor_free(&c);
    drop_rounding(s, lo, hi);
    return true;
}
