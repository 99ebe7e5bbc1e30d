/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A triangle is listed counter-clockwise as the model's axes have it, its normal towards growing
 * depth: where they mirror the grid's frame, the second and third corner change places. */
#include "msh_io.h"

#include "frame.h"
#include "node_order.h"

static const char *sheet_name(const struct tessellation *t, int sheet) {
    return t->sheets == 1 ? "sheet" : sheet == 0 ? "bottom" : "top";
}

static void write_numbers(struct out *out, const double *x, int n, int digits) {
    for (int m = 0; m < n; m++) {
        if (m > 0) out_char(out, ' ');
        out_double(out, x[m], digits);
    }
}

static void write_names(struct out *out, const struct tessellation *t) {
    out_format(out, "$PhysicalNames\n%d\n", t->sheets);
    for (int s = 0; s < t->sheets; s++) out_format(out, "2 %d \"%s\"\n", s + 1, sheet_name(t, s));
    out_text(out, "$EndPhysicalNames\n");
}

/* Surface s + 1: its bounding box, its physical group, no bounding curves. */
static void write_entity(struct out *out, const struct tessellation *t, int s) {
    double box[6];
    for (int c = 0; c < 3; c++) box[c] = box[3 + c] = t->sheet[s][0][c];
    for (uint32_t p = 1; p < t->net.point_count; p++)
        for (int c = 0; c < 3; c++) {
            double x = t->sheet[s][p][c];
            if (x < box[c]) box[c] = x;
            if (x > box[3 + c]) box[3 + c] = x;
        }
    out_format(out, "%d ", s + 1);
    write_numbers(out, box, 6, 0);
    out_format(out, " 1 %d 0\n", s + 1);
}

static void write_nodes(struct out *out, const struct tessellation *t, int digits) {
    int64_t n = t->net.point_count, all = n * t->sheets;
    out_format(out, "$Nodes\n%d %lld 1 %lld\n", t->sheets, (long long)all, (long long)all);
    for (int s = 0; s < t->sheets; s++) {
        out_format(out, "2 %d 0 %lld\n", s + 1, (long long)n);
        for (int64_t p = 0; p < n; p++) {
            out_int(out, s * n + p + 1);
            out_char(out, '\n');
        }
        for (int64_t p = 0; p < n; p++) {
            write_numbers(out, t->sheet[s][p], 3, digits);
            out_char(out, '\n');
        }
    }
    out_text(out, "$EndNodes\n");
}

/* The elements of one sheet. weight: the order of the nodes. */
static void write_sheet(struct out *out, const struct tessellation *t, int s, int weight[][3]) {
    const struct grid *g = &t->net;
    int second = frame_is_mirrored(g) ? 2 : 1, third = 3 - second;
    for (uint32_t e = 0; e < g->triangle_count; e++) {
        out_int(out, (int64_t)s * g->triangle_count + e + 1);
        for (int q = 0; q < grid_patch_size(g->degree); q++) {
            const int *w = weight[q];
            out_char(out, ' ');
            out_int(out,
                    (int64_t)s * g->point_count + grid_point(g, e, w[0], w[second], w[third]) + 1);
        }
        out_char(out, '\n');
    }
}

static void write_elements(struct out *out, const struct tessellation *t) {
    static const int type[] = {0, 2, 9, 21, 23, 25, 42, 43, 44, 45, 46};
    const struct grid *g = &t->net;
    long long all = (long long)t->sheets * g->triangle_count;
    int weight[GRID_PATCH_MAX][3];
    INVARIANT(g->degree <= MSH_DEGREE_MAX);
    node_order(g->degree, NODE_NESTED, weight);
    out_format(out, "$Elements\n%d %lld 1 %lld\n", t->sheets, all, all);
    for (int s = 0; s < t->sheets; s++) {
        out_format(out, "2 %d %d %u\n", s + 1, type[g->degree], g->triangle_count);
        write_sheet(out, t, s, weight);
    }
    out_text(out, "$EndElements\n");
}

void msh_write(struct out *out, const struct tessellation *t, const char *history, int digits) {
    out_text(out, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n");
    out_text(out, history);
    out_text(out, "$EndComments\n");
    write_names(out, t);
    out_format(out, "$Entities\n0 0 %d 0\n", t->sheets);
    for (int s = 0; s < t->sheets; s++) write_entity(out, t, s);
    out_text(out, "$EndEntities\n");
    write_nodes(out, t, digits);
    write_elements(out, t);
}
