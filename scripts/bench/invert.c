/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Nanoseconds that it takes to find the preimage of a point, place and point, and to make the
 * index, a triangle:
 *
 *     raster NS
 *     shuffled NS
 *     index NS
 *
 * The shortest of some runs over 1,000,000 points. usage: invert GRID X0 Y0 X1 Y1 */
#include "points.h"

#include "grid_io.h"
#include "inverse.h"

static double measure(const struct inverse *v, const struct point *point, double *sum) {
    double best = 1e9;
    for (int run = 0; run < RUNS; run++) {
        struct inverse_cursor c;
        struct err err = {0};
        double start = seconds(), took;
        if (!inverse_cursor_init(&c, v, &err)) exit(1);
        for (int i = 0; i < POINT_COUNT; i++) {
            double q[2] = {point[i].x, point[i].y}, p[2];
            struct place place;
            if (!inverse_find(&c, q, NULL, NULL, &place)) continue;
            inverse_point(v, q, &place, p);
            *sum += p[0] + p[1];
        }
        inverse_cursor_free(&c);
        took = seconds() - start;
        if (took < best) best = took;
    }
    return best / POINT_COUNT * 1e9;
}

int main(int argc, char **argv) {
    struct point *point = malloc(POINT_COUNT * sizeof *point);
    struct grid_file file;
    struct inverse v;
    struct err err = {0};
    double box[4], sum = 0, start;
    if (argc != 6 || !point || !grid_read(&file, argv[1], &err)) return 2;
    for (int i = 0; i < 4; i++) box[i] = atof(argv[2 + i]);
    start = seconds();
    if (!inverse_init(&v, &file.spline, true, &err)) return 1;
    printf("index %.1f\n", (seconds() - start) / file.spline.grid.triangle_count * 1e9);
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        make_points(point, box, shuffled);
        printf("%s %.2f\n", shuffled ? "shuffled" : "raster", measure(&v, point, &sum));
    }
    inverse_free(&v);
    grid_file_free(&file);
    free(point);
    return sum == sum ? 0 : 1; /* so that the sum is needed */
}
