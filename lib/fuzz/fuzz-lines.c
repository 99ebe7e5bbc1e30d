/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Polylines: every line has a point, and a name or a finite value within the range. */
#include "fuzzing.h"
#include "polylines_io.h"

#include <math.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    struct fuzz_file f = fuzz_open(data, size);
    struct polylines p;
    struct err err = {0};
    if (polylines_read(&p, f.path, &err)) {
        INVARIANT(p.line_count > 0 && p.start[0] == 0 && p.start[p.line_count] == p.point_count);
        for (size_t l = 0; l < p.line_count; l++) {
            INVARIANT(p.start[l] < p.start[l + 1]);
            if (p.name_of[l] != POLYLINES_NO_NAME)
                INVARIANT(p.name_of[l] < p.name_count && p.name[p.name_of[l]][0]);
            else
                INVARIANT(p.value[l] >= p.range[0] && p.value[l] <= p.range[1]);
        }
        for (size_t i = 0; i < p.point_count; i++)
            INVARIANT(isfinite(p.point[i][0]) && isfinite(p.point[i][1]));
        polylines_free(&p);
    } else {
        INVARIANT(err.kind == ERR_INPUT && err.message[0]);
    }
    close(f.fd);
    return 0;
}
