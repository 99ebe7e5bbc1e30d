/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Polygons: loops of three points or more; their corners lie on them. */
#include "fuzzing.h"
#include "xy_io.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    struct polygon g;
    struct err err = {0};
    if (xy_read_polygon(&g, f.path, &err)) {
        INVARIANT(g.loop_count > 0 && g.loop_start[g.loop_count] == g.point_count);
        for (size_t l = 0; l < g.loop_count; l++)
            INVARIANT(g.loop_start[l] + 3 <= g.loop_start[l + 1]);
        for (size_t i = 0; i < g.point_count; i++) INVARIANT(polygon_side(&g, g.point[i]) == 0);
        polygon_free(&g);
    } else {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    }
    close(f.fd);
    return 0;
}
