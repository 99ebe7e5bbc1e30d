/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A step p q of the boundary, counter-clockwise, carries two faces of the wall:
 *
 *     p' ---- q'   top           p q q' and p q' p', seen from outside
 *     |   __/ |
 *     | _/    |
 *     p ----- q    bottom
 *
 * Faces are turned over on the bottom, and where the model's frame mirrors the grid's. */
#include "surface_io.h"

#include "frame.h"

/* A point of a sheet. */
struct corner {
    int sheet;
    uint32_t point;
};

static void write_points(struct out *out, const struct tessellation *t, int digits) {
    for (int s = 0; s < t->sheets; s++)
        for (uint32_t p = 0; p < t->net.point_count; p++)
            out_record(out, "v", t->sheet[s][p], 3, digits);
    for (uint32_t p = 0; p < t->net.point_count; p++) out_record(out, "vt", t->source[p], 2, 0);
}

static void write_face(struct out *out, const struct tessellation *t, bool turned, struct corner a,
                       struct corner b, struct corner c) {
    const struct corner corner[] = {a, turned ? c : b, turned ? b : c};
    out_char(out, 'f');
    for (int m = 0; m < 3; m++) {
        out_char(out, ' ');
        out_int(out, (int64_t)corner[m].sheet * t->net.point_count + corner[m].point + 1);
        out_char(out, '/');
        out_int(out, (int64_t)corner[m].point + 1);
    }
    out_char(out, '\n');
}

static void write_sheet(struct out *out, const struct tessellation *t, int sheet) {
    bool turned = frame_is_mirrored(&t->net) != (t->sheets == 2 && sheet == 0);
    for (uint32_t e = 0; e < t->net.triangle_count; e++)
        for (int row = 0; row < t->net.degree; row++)
            for (int place = 0; place <= 2 * row; place++) {
                uint32_t p[3];
                tessellation_face(t, e, row, place, p);
                write_face(out, t, turned, (struct corner){sheet, p[0]},
                           (struct corner){sheet, p[1]}, (struct corner){sheet, p[2]});
            }
}

static void write_wall(struct out *out, const struct tessellation *t, uint32_t triangle, int l) {
    bool turned = frame_is_mirrored(&t->net);
    for (int step = 0; step < t->net.degree; step++) {
        uint32_t end[2];
        struct corner p, q, p_top, q_top;
        tessellation_step(t, triangle, l, step, end);
        p = (struct corner){0, end[0]};
        q = (struct corner){0, end[1]};
        p_top = (struct corner){1, end[0]};
        q_top = (struct corner){1, end[1]};
        write_face(out, t, turned, p, q, q_top);
        write_face(out, t, turned, p, q_top, p_top);
    }
}

static void write_walls(struct out *out, const struct tessellation *t) {
    const struct grid *g = &t->net;
    for (uint32_t e = 0; e < g->edge_count; e++) {
        uint32_t triangle = g->edge_triangle[e][0];
        if (!grid_edge_is_inner(g, e)) write_wall(out, t, triangle, grid_opposite(g, triangle, e));
    }
}

void surface_write(struct out *out, const struct tessellation *t, const char *history, int digits) {
    out_text(out, history);
    write_points(out, t, digits);
    if (t->sheets == 1) {
        write_sheet(out, t, 0);
        return;
    }
    out_text(out, "g bottom\n");
    write_sheet(out, t, 0);
    out_text(out, "g top\n");
    write_sheet(out, t, 1);
    out_text(out, "g walls\n");
    write_walls(out, t);
}
