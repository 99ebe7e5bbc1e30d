/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "vertices_io.h"

#include "list_io.h"
#include "num.h"

#include <stdio.h>
#include <string.h>
#include <zlib.h>

enum { DESCRIPTION_MAX = 64 + 3 * NUM_TEXT_MAX };

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

struct projection vertices_projection(const struct vertices *v, const struct grid *g) {
    return v->format == VERTICES_XY ? projection_of_plane() : projection_of_model(g);
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

/* "NAME 7 at X Y Z", with all digits: rounded ones may look as if they were inside. */
static void describe(const struct vertices *v, size_t i, char *text, size_t room) {
    const char *name = v->format == VERTICES_OBJ ? "vertex" : "point";
    char number[NUM_TEXT_MAX];
    int n = snprintf(text, room, "%s %zu at", name, i + 1);
    for (int c = 0; c < vertices_columns(v); c++) {
        int length = (int)num_print(number, v->points.vertex[i][c], 0);
        n += snprintf(text + n, room - (size_t)n, " %.*s", length, number);
    }
}

bool vertices_refuse(const struct vertices *v, const char *what, size_t outside, size_t first,
                     struct err *err) {
    const char *names = v->format == VERTICES_OBJ ? "vertices" : "points";
    char text[DESCRIPTION_MAX];
    describe(v, first, text, sizeof text);
    return err_set_at(err, ERR_REFUSAL, v->file.name, vertices_line(v, first), 0,
                      "%zu of %zu %s outside %s; the first is %s", outside, v->points.vertex_count,
                      names, what, text);
}

bool vertices_refuse_result(const struct vertices *v, const char *what, size_t i, struct err *err) {
    char text[DESCRIPTION_MAX];
    describe(v, i, text, sizeof text);
    return err_set_at(err, ERR_REFUSAL, v->file.name, vertices_line(v, i), 0,
                      "%s of %s exceeds the range of numbers", what, text);
}
