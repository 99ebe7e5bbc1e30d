/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The nodes of a wedge come in groups, each of the bottom first: corners, edges, interiors.
 * (Upright edges and faces have no nodes of their own, as the degree there is 1.) A cell is
 * positive in the model's axes where the map is: if they mirror the grid's frame, the second and
 * third corner change places. */
#include "vtu_io.h"

#include "frame.h"
#include "history.h"
#include "node_order.h"
#include "utf8.h"

enum { BEZIER_TRIANGLE = 76, BEZIER_WEDGE = 80 };

/* A line of history as <?history ...?>; what XML cannot hold there becomes '?'. */
static void write_instruction(struct out *out, const char *text, const char *end) {
    bool question = false; /* the last character written is one */
    out_text(out, "<?history ");
    while (text < end) {
        int n = utf8_length(text, end);
        bool control = (unsigned char)*text < ' ' && *text != '\t';
        if (question && *text == '>') out_char(out, ' '); /* "?>" ends the instruction */
        question = n == 0 || control || *text == '?';
        if (question)
            out_char(out, '?');
        else
            out_bytes(out, text, (size_t)n);
        text += n > 0 ? n : 1;
    }
    out_text(out, "?>\n");
}

static void open_array(struct out *out, const char *type, const char *name, int components) {
    out_format(out,
               "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"ascii\">\n",
               type, name, components);
}

static void close_array(struct out *out) {
    out_text(out, "</DataArray>\n");
}

static int sheets(const struct spline *s) {
    return s->sigma ? 2 : 1;
}

static void write_point(struct out *out, const struct grid *g, const double xy[2], double depth,
                        int digits) {
    double model[3];
    frame_to_model(g, xy[0], xy[1], depth, model);
    for (int c = 0; c < 3; c++) {
        if (c > 0) out_char(out, ' ');
        out_double(out, model[c], digits);
    }
    out_char(out, '\n');
}

static void write_sources(struct out *out, const struct spline *s) {
    const struct grid *g = &s->grid;
    open_array(out, "Float64", "source", 3);
    for (int sheet = 0; sheet < sheets(s); sheet++)
        for (uint32_t p = 0; p < g->point_count; p++) {
            double xy[2];
            grid_nominal(g, p, xy);
            write_point(out, g, xy, s->sigma ? g->depth[sheet] : 0, 0);
        }
    close_array(out);
}

static void write_points(struct out *out, const struct spline *s, int digits) {
    open_array(out, "Float64", "Points", 3);
    for (int sheet = 0; sheet < sheets(s); sheet++)
        for (uint32_t p = 0; p < s->grid.point_count; p++)
            write_point(out, &s->grid, s->phi[p], s->sigma ? s->sigma[p][sheet] : 0, digits);
    close_array(out);
}

static void write_cell(struct out *out, const struct spline *s, uint32_t t, int weight[][3]) {
    const struct grid *g = &s->grid;
    const int group[] = {0, 3, 3 * g->degree, grid_patch_size(g->degree)};
    int second = frame_is_mirrored(g) ? 2 : 1, third = 3 - second;
    for (int i = 0; i < 3; i++)
        for (int sheet = 0; sheet < sheets(s); sheet++)
            for (int q = group[i]; q < group[i + 1]; q++) {
                const int *w = weight[q];
                if (q + sheet > 0) out_char(out, ' ');
                out_int(out, (int64_t)sheet * g->point_count +
                                 grid_point(g, t, w[0], w[second], w[third]));
            }
    out_char(out, '\n');
}

/* One number a line and cell: first, first + step, ... */
static void write_sequence(struct out *out, const struct spline *s, const char *type,
                           const char *name, int first, int step) {
    open_array(out, type, name, 1);
    for (uint32_t t = 0; t < s->grid.triangle_count; t++) {
        out_int(out, first + (int64_t)t * step);
        out_char(out, '\n');
    }
    close_array(out);
}

static void write_cells(struct out *out, const struct spline *s) {
    int weight[GRID_PATCH_MAX][3], size = sheets(s) * grid_patch_size(s->grid.degree);
    node_order(s->grid.degree, s->sigma ? NODE_ROWS : NODE_NESTED, weight);
    out_text(out, "<Cells>\n");
    open_array(out, "Int64", "connectivity", 1);
    for (uint32_t t = 0; t < s->grid.triangle_count; t++) write_cell(out, s, t, weight);
    close_array(out);
    write_sequence(out, s, "Int64", "offsets", size, size);
    write_sequence(out, s, "UInt8", "types", s->sigma ? BEZIER_WEDGE : BEZIER_TRIANGLE, 0);
    out_text(out, "</Cells>\n");
}

/* What the number of nodes does not tell: a wedge's degrees. */
static void write_degrees(struct out *out, const struct spline *s) {
    out_text(out, "<CellData HigherOrderDegrees=\"HigherOrderDegrees\">\n");
    open_array(out, "Float64", "HigherOrderDegrees", 3);
    for (uint32_t t = 0; t < s->grid.triangle_count; t++)
        out_format(out, "%d %d 1\n", s->grid.degree, s->grid.degree);
    close_array(out);
    out_text(out, "</CellData>\n");
}

void vtu_write(struct out *out, const struct spline *s, const char *history, int digits) {
    const char *text, *end;
    out_text(out, "<?xml version=\"1.0\"?>\n");
    while (history_next(&history, &text, &end)) write_instruction(out, text, end);
    out_text(out, "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                  "header_type=\"UInt64\">\n<UnstructuredGrid>\n");
    out_format(out, "<Piece NumberOfPoints=\"%lld\" NumberOfCells=\"%u\">\n",
               (long long)sheets(s) * s->grid.point_count, s->grid.triangle_count);
    out_text(out, "<PointData>\n");
    write_sources(out, s);
    out_text(out, "</PointData>\n");
    if (s->sigma) write_degrees(out, s);
    out_text(out, "<Points>\n");
    write_points(out, s, digits);
    out_text(out, "</Points>\n");
    write_cells(out, s);
    out_text(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}
