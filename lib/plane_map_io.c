/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plane_map_io.h"

void plane_map_write(struct out *out, const struct plane_map *map, const char *history,
                     int digits) {
    out_text(out, history);
    for (size_t v = 0; v < map->vertex_count; v++)
        out_record(out, "v", (double[3]){map->at[1][v][0], map->at[1][v][1], 0}, 3, digits);
    for (size_t v = 0; v < map->vertex_count; v++) out_record(out, "vt", map->at[0][v], 2, 0);
    for (size_t t = 0; t < map->triangle_count; t++) {
        out_char(out, 'f');
        for (int c = 0; c < 3; c++) {
            int64_t number = (int64_t)map->triangle[t][c] + 1;
            out_char(out, ' ');
            out_int(out, number);
            out_char(out, '/');
            out_int(out, number);
        }
        out_char(out, '\n');
    }
}
