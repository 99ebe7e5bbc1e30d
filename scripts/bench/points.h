/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The points that the benchmarks of point location ask for: a raster of SIDE x SIDE points strictly
 * inside a box, row by row, or the same points in random order. */
#ifndef POINTS_H
#define POINTS_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { SIDE = 1000, POINT_COUNT = SIDE * SIDE, RUNS = 5 };

struct point {
    double x, y;
};

static inline void make_points(struct point *point, const double box[4], int shuffled) {
    uint64_t state = 1;
    for (int i = 0; i < POINT_COUNT; i++) {
        point[i].x = box[0] + (box[2] - box[0]) * (i % SIDE + 0.5) / SIDE;
        point[i].y = box[1] + (box[3] - box[1]) * (i / SIDE + 0.5) / SIDE;
    }
    for (int i = POINT_COUNT - 1; shuffled && i > 0; i--) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        int j = (int)((state >> 33) % (uint64_t)(i + 1));
        struct point p = point[i];
        point[i] = point[j];
        point[j] = p;
    }
}

static inline double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#endif
