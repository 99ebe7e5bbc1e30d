/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "vertices_io.h"

#include "list_io.h"

#include <stdio.h>
#include <string.h>
#include <zlib.h>

const char *const vertices_format_names[] = {"obj", "xy", "xyz", NULL};

enum vertices_format vertices_format(int choice, const char *path) {
    const char *dot = strrchr(path, '.');
    if (choice != VERTICES_BY_NAME) return (enum vertices_format)choice;
    if (dot && strcmp(dot, ".xy") == 0) return VERTICES_XY;
    if (dot && strcmp(dot, ".xyz") == 0) return VERTICES_XYZ;
    return VERTICES_OBJ;
}

bool vertices_open(struct vertices *v, const char *path, enum vertices_format format,
                   struct err *err) {
    *v = (struct vertices){.format = format};
    if (!filemap_open(&v->file, path, err)) return false;
    if (format == VERTICES_OBJ ? obj_points_read(&v->points, &v->file, err)
                               : list_read(&v->points, &v->file, vertices_columns(v), err))
        return true;
    filemap_close(&v->file);
    return false;
}

void vertices_close(struct vertices *v) {
    obj_points_free(&v->points);
    filemap_close(&v->file);
}

struct frame vertices_frame(const struct vertices *v, const struct grid *g) {
    return v->format == VERTICES_XY ? frame_of_plane() : frame_of_model(g);
}

uint32_t vertices_checksum(const struct vertices *v) {
    uLong sum = crc32_z(0, NULL, 0);
    for (size_t i = 0; i < v->points.vertex_count; i++) {
        unsigned char bytes[24];
        for (int n = 0; n < 24; n++) {
            uint64_t bits;
            memcpy(&bits, &v->points.vertex[i][n / 8], sizeof bits);
            bytes[n] = (unsigned char)(bits >> 8 * (n % 8));
        }
        sum = crc32_z(sum, bytes, sizeof bytes);
    }
    return (uint32_t)sum;
}

size_t vertices_line(const struct vertices *v, size_t i) {
    return v->format == VERTICES_OBJ ? obj_points_line(&v->file, i)
                                     : list_line(&v->file, vertices_columns(v), i);
}

static const char *word(const struct vertices *v, size_t n) {
    if (v->format == VERTICES_OBJ) return n == 1 ? "vertex" : "vertices";
    return n == 1 ? "point" : "points";
}

bool vertices_refuse(const struct vertices *v, size_t outside, size_t first, struct err *err) {
    const double *x = v->points.vertex[first];
    char z[40] = "";
    if (v->format != VERTICES_XY) snprintf(z, sizeof z, " %g", x[2]);
    return err_set_at(err, ERR_REFUSAL, v->file.name, vertices_line(v, first), 0,
                      "%zu of %zu %s outside the grid; the first is %s %zu at %g %g%s", outside,
                      v->points.vertex_count, word(v, 2), word(v, 1), first + 1, x[0], x[1], z);
}

bool vertices_refuse_result(const struct vertices *v, const char *what, size_t i, struct err *err) {
    return err_set_at(err, ERR_REFUSAL, v->file.name, vertices_line(v, i), 0,
                      "%s of %s %zu exceeds the range of numbers", what, word(v, 1), i + 1);
}
