/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawing_io.h"

#include "mem.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum { SIDE_MAX = 32767, PIXELS_MAX = 100000000 };
static const double points_a_unit = 0.75; /* 72 points and 96 units an inch */

const char *const drawing_format_names[] = {"png", "svg", "pdf", NULL};

bool drawing_format(int choice, const char *path, enum drawing_format *format, struct err *err) {
    const char *dot = path ? strrchr(path, '.') : NULL;
    bool standard = !path || strcmp(path, "-") == 0;
    *format = choice == DRAWING_BY_NAME ? DRAWING_PNG : (enum drawing_format)choice;
    if (standard && *format != DRAWING_SVG && isatty(STDOUT_FILENO))
        return err_set(err, ERR_USAGE, "a picture does not go to a terminal; use -o FILE");
    if (choice != DRAWING_BY_NAME || standard) return true;
    for (int i = 0; dot && drawing_format_names[i]; i++)
        if (strcasecmp(dot + 1, drawing_format_names[i]) == 0) {
            *format = (enum drawing_format)i;
            return true;
        }
    return err_set(err, ERR_USAGE, "expected a file name that ends in .png, .svg or .pdf, got '%s'",
                   path);
}

static cairo_status_t put(void *context, const unsigned char *bytes, unsigned length) {
    out_bytes(context, (const char *)bytes, length);
    return CAIRO_STATUS_SUCCESS;
}

/* ---- shapes ---- */

static void set_colour(cairo_t *cr, uint32_t colour) {
    cairo_set_source_rgba(cr, (colour >> 24) / 255.0, (colour >> 16 & 255) / 255.0,
                          (colour >> 8 & 255) / 255.0, (colour & 255) / 255.0);
}

static void trace(cairo_t *cr, const struct drawing *d, const struct drawing_shape *s) {
    const double(*p)[2] = (const double(*)[2])(d->point + s->point);
    for (size_t i = 0; i < s->op_count; i++) switch (d->op[s->op + i]) {
        case DRAWING_MOVE:
            cairo_move_to(cr, p[0][0], p[0][1]);
            p++;
            break;
        case DRAWING_LINE:
            cairo_line_to(cr, p[0][0], p[0][1]);
            p++;
            break;
        case DRAWING_CURVE:
            cairo_curve_to(cr, p[0][0], p[0][1], p[1][0], p[1][1], p[2][0], p[2][1]);
            p += 3;
            break;
        default:
            cairo_close_path(cr);
        }
}

static void paint(cairo_t *cr, const struct drawing *d, const struct drawing_shape *s) {
    const struct drawing_ink *ink = &s->ink;
    cairo_new_path(cr);
    trace(cr, d, s);
    if (ink->fill & 255) {
        set_colour(cr, ink->fill);
        cairo_fill_preserve(cr);
    }
    if (ink->stroke & 255) {
        set_colour(cr, ink->stroke);
        cairo_set_line_width(cr, ink->width);
        cairo_set_dash(cr, &ink->dash, ink->dash > 0, 0);
        cairo_stroke_preserve(cr);
    }
}

/* Cairo wants premultiplied 0xAARRGGBB in rows of its own length. */
static cairo_surface_t *surface_of(const struct drawing_picture *p) {
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (int)p->width, (int)p->height);
    unsigned char *row = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    if (!row) return surface; /* its status says why */
    for (uint32_t r = 0; r < p->height; r++, row += stride)
        for (uint32_t c = 0; c < p->width; c++) {
            uint32_t rgba = p->pixel[(size_t)r * p->width + c], a = rgba & 255, argb = a << 24;
            for (int k = 0; k < 3; k++)
                argb |= ((rgba >> (24 - 8 * k) & 255) * a + 127) / 255 << (16 - 8 * k);
            memcpy(row + 4 * c, &argb, sizeof argb);
        }
    cairo_surface_mark_dirty(surface);
    return surface;
}

static void place(cairo_t *cr, const struct drawing_picture *p) {
    cairo_surface_t *surface = surface_of(p);
    cairo_save(cr);
    cairo_translate(cr, p->at[0][0], p->at[0][1]);
    cairo_scale(cr, (p->at[1][0] - p->at[0][0]) / p->width,
                (p->at[1][1] - p->at[0][1]) / p->height);
    cairo_set_source_surface(cr, surface, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_BILINEAR);
    cairo_paint(cr);
    cairo_restore(cr);
    cairo_surface_destroy(surface);
}

/* ---- documents ---- */

static void render(cairo_t *cr, const struct drawing *d) {
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    for (size_t i = 0; i < d->shape_count; i++)
        if (d->shape[i].picture == SIZE_MAX)
            paint(cr, d, &d->shape[i]);
        else
            place(cr, &d->picture[d->shape[i].picture]);
}

static cairo_surface_t *new_surface(struct out *out, const struct drawing *d,
                                    enum drawing_format format) {
    double w = d->width * points_a_unit, h = d->height * points_a_unit;
    cairo_surface_t *surface;
    switch (format) {
    case DRAWING_SVG:
        return cairo_svg_surface_create_for_stream(put, out, w, h);
    case DRAWING_PDF: /* without the clock */
        surface = cairo_pdf_surface_create_for_stream(put, out, w, h);
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                       "1970-01-01T00:00:00Z");
        return surface;
    default:
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)ceil(d->width),
                                          (int)ceil(d->height));
    }
}

bool drawing_write(struct out *out, const struct drawing *d, enum drawing_format format,
                   struct err *err) {
    cairo_surface_t *surface;
    cairo_t *cr;
    cairo_status_t status;
    if (format == DRAWING_PNG && !(d->width <= SIDE_MAX && d->height <= SIDE_MAX))
        return err_set(err, ERR_REFUSAL,
                       "expected a picture of at most %d x %d pixels, got %.0f x %.0f", SIDE_MAX,
                       SIDE_MAX, d->width, d->height);
    if (format == DRAWING_PNG && ceil(d->width) * ceil(d->height) > PIXELS_MAX)
        return err_set(err, ERR_REFUSAL,
                       "%.0f x %.0f pixels are more than %d: a smaller --width, or an SVG or PDF",
                       d->width, d->height, PIXELS_MAX);
    surface = new_surface(out, d, format);
    cr = cairo_create(surface);
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_paint(cr);
    if (format != DRAWING_PNG) cairo_scale(cr, points_a_unit, points_a_unit);
    render(cr, d);
    cairo_show_page(cr);
    status = cairo_status(cr);
    cairo_destroy(cr);
    if (!status && format == DRAWING_PNG)
        status = cairo_surface_write_to_png_stream(surface, put, out);
    cairo_surface_finish(surface);
    if (!status) status = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    return !status || err_set(err, ERR_INPUT, "cannot draw: %s", cairo_status_to_string(status));
}
