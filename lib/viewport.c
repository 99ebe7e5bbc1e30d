/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "viewport.h"

#include <math.h>

struct viewport viewport_fit(const double lo[2], const double hi[2], const uint32_t size[2],
                             bool y_down) {
    struct viewport v = {size[0], size[1], {0, 0}, {0, 0}};
    double step = fmax((hi[0] - lo[0]) / size[0], (hi[1] - lo[1]) / size[1]);
    if (!(step > 0)) step = 1;
    v.step[0] = step;
    v.step[1] = y_down ? step : -step;
    for (int k = 0; k < 2; k++) v.corner[k] = lo[k] + (hi[k] - lo[k]) / 2 - v.step[k] * size[k] / 2;
    return v;
}

bool viewport_scale(struct viewport *v, const double lo[2], const double hi[2], double scale,
                    uint32_t most, bool y_down) {
    double sides[2];
    for (int k = 0; k < 2; k++) {
        sides[k] = ceil((hi[k] - lo[k]) * scale);
        if (!(sides[k] <= most)) return false;
        if (sides[k] < 1) sides[k] = 1;
    }
    *v = (struct viewport){(uint32_t)sides[0],
                           (uint32_t)sides[1],
                           {lo[0], y_down ? lo[1] : hi[1]},
                           {1 / scale, y_down ? 1 / scale : -1 / scale}};
    return true;
}
