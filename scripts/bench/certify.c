/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Seconds of the processor that it takes to certify a grid, verdict and bounds of the least
 * determinant; and then, that it is one-to-one: the shortest of 5 runs, reading not counted.
 * usage: certify GRID */
#include "grid_io.h"
#include "injective.h"

#include <stdio.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int argc, char **argv) {
    struct grid_file file;
    struct err err;
    double best[2] = {1e9, 1e9};
    if (argc != 2 || !grid_read(&file, argv[1], &err)) return 2;
    for (int i = 0; i < 5; i++) {
        struct jacobian_report r;
        struct injective j;
        double start = now(), took;
        if (!jacobian_report_init(&r, &file.spline, JACOBIAN_PLANE, &jacobian_default_rule, false,
                                  &err))
            return 1;
        took = now() - start;
        best[0] = took < best[0] ? took : best[0];
        start = now();
        if (!injective_init(&j, &file.spline, &r, NULL, &jacobian_default_rule, &err)) return 1;
        took = now() - start;
        best[1] = took < best[1] ? took : best[1];
        if (j.phi != INJECTIVE_YES) return 3;
        injective_free(&j);
        jacobian_report_free(&r);
    }
    grid_file_free(&file);
    printf("%.9f %.9f\n", best[0], best[1]);
    return fflush(stdout) == 0 ? 0 : 1;
}
