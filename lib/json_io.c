/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One record a line, so that line-oriented tools and diff get on with it. A number as num.h prints
 * it is a number of JSON. */
#include "json_io.h"

#include "history.h"
#include "utf8.h"

static void write_character(struct out *out, const char *s, int n) {
    if (n == 0)
        out_text(out, "\xef\xbf\xbd"); /* U+FFFD */
    else if ((unsigned char)*s < ' ')
        out_format(out, "\\u%04x", (unsigned)*s);
    else {
        if (*s == '"' || *s == '\\') out_char(out, '\\');
        out_bytes(out, s, (size_t)n);
    }
}

static void write_string(struct out *out, const char *s, const char *end) {
    out_char(out, '"');
    while (s < end) {
        int n = utf8_length(s, end);
        write_character(out, s, n);
        s += n > 0 ? n : 1;
    }
    out_char(out, '"');
}

static void write_history(struct out *out, const char *history) {
    const char *text, *end, *before = "\n";
    out_text(out, "\"history\": [");
    while (history_next(&history, &text, &end)) {
        out_text(out, before);
        write_string(out, text, end);
        before = ",\n";
    }
    out_text(out, "\n],\n");
}

/* An array of n rows, printed by `row`. */
typedef void row_writer(struct out *out, const struct spline *s, uint32_t i, int digits);

static void write_rows(struct out *out, const struct spline *s, const char *name, uint32_t n,
                       row_writer *row, int digits) {
    out_format(out, ",\n\"%s\": [\n", name);
    for (uint32_t i = 0; i < n; i++) {
        out_char(out, '[');
        row(out, s, i, digits);
        out_text(out, i + 1 < n ? "],\n" : "]\n");
    }
    out_char(out, ']');
}

static void write_pair(struct out *out, const double x[2], int digits) {
    out_double(out, x[0], digits);
    out_text(out, ", ");
    out_double(out, x[1], digits);
}

static void write_integers(struct out *out, const uint32_t *x, int n) {
    for (int m = 0; m < n; m++) {
        if (m > 0) out_text(out, ", ");
        out_int(out, x[m]);
    }
}

static void vertex(struct out *out, const struct spline *s, uint32_t i, int digits) {
    (void)digits;
    out_format(out, "%d, %d", s->grid.vertex[i][0], s->grid.vertex[i][1]);
}

static void triangle(struct out *out, const struct spline *s, uint32_t i, int digits) {
    (void)digits;
    write_integers(out, s->grid.triangle[i], 3);
}

static void patch(struct out *out, const struct spline *s, uint32_t i, int digits) {
    uint32_t points[GRID_PATCH_MAX];
    (void)digits;
    grid_patch(&s->grid, i, points);
    write_integers(out, points, grid_patch_size(s->grid.degree));
}

static void nominal(struct out *out, const struct spline *s, uint32_t i, int digits) {
    double xy[2];
    (void)digits;
    grid_nominal(&s->grid, i, xy);
    write_pair(out, xy, 0);
}

static void point(struct out *out, const struct spline *s, uint32_t i, int digits) {
    write_pair(out, s->phi[i], digits);
}

static void height(struct out *out, const struct spline *s, uint32_t i, int digits) {
    write_pair(out, s->sigma[i], digits);
}

static void write_frame(struct out *out, const struct grid *g) {
    out_format(out, "\"degree\": %d,\n\"plane\": \"%c%c\",\n", g->degree, "xyz"[g->axes[0]],
               "xyz"[g->axes[1]]);
    out_text(out, "\"lattice\": {\"step\": ");
    out_double(out, g->lattice.step, 0);
    out_text(out, ", \"origin\": [");
    write_pair(out, (double[]){g->lattice.x0, g->lattice.y0}, 0);
    out_text(out, "]}");
    if (!g->has_depth) return;
    out_text(out, ",\n\"depth\": [");
    write_pair(out, g->depth, 0);
    out_char(out, ']');
}

void json_write(struct out *out, const struct spline *s, const char *history, int digits) {
    const struct grid *g = &s->grid;
    out_text(out, "{\n\"format\": \"supple-grid\",\n\"version\": 1,\n");
    write_history(out, history);
    write_frame(out, g);
    write_rows(out, s, "vertices", g->vertex_count, vertex, 0);
    write_rows(out, s, "triangles", g->triangle_count, triangle, 0);
    write_rows(out, s, "patches", g->triangle_count, patch, 0);
    write_rows(out, s, "nominal", g->point_count, nominal, 0);
    write_rows(out, s, "points", g->point_count, point, digits);
    if (s->sigma) write_rows(out, s, "heights", g->point_count, height, digits);
    out_text(out, "\n}\n");
}
