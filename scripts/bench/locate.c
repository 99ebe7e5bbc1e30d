/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Nanoseconds that it takes to find the triangle of a point, and its barycentric coordinates:
 *
 *     raster NS
 *     shuffled NS
 *
 * The shortest of some runs over 1,000,000 points.
 * usage: locate GRID X0 Y0 X1 Y1 */
#include "points.h"

#include "grid_io.h"
#include "locate.h"

static double measure(const struct locator *l, const struct point *point, double *sum) {
    double best = 1e9;
    for (int run = 0; run < RUNS; run++) {
        double start = seconds(), took;
        uint32_t hint = 0, t;
        for (int i = 0; i < POINT_COUNT; i++) {
            double p[2] = {point[i].x, point[i].y}, b[3];
            if (locate(l, p, &hint, &t, b)) *sum += b[0] + t;
        }
        took = seconds() - start;
        if (took < best) best = took;
    }
    return best / POINT_COUNT * 1e9;
}

int main(int argc, char **argv) {
    struct point *point = malloc(POINT_COUNT * sizeof *point);
    struct grid_file file;
    struct locator l;
    struct err err = {0};
    double box[4], sum = 0;
    if (argc != 6 || !point || !grid_read(&file, argv[1], &err)) return 2;
    for (int i = 0; i < 4; i++) box[i] = atof(argv[2 + i]);
    if (!locator_init(&l, &file.spline.grid, &err)) return 1;
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        make_points(point, box, shuffled);
        printf("%s %.2f\n", shuffled ? "shuffled" : "raster", measure(&l, point, &sum));
    }
    locator_free(&l);
    grid_file_free(&file);
    free(point);
    return sum > 0 ? 0 : 1; /* so that the sum is needed */
}
