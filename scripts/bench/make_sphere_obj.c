/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An OBJ sphere of radius 1 for benchmarks: ROWS rings of COLUMNS vertices, two triangles a square,
 * numbers as other programs write them, with 6 decimals, or (third argument) with all their digits.
 * usage: make_sphere_obj ROWS COLUMNS [exact] >OBJ */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
    int rows = argc > 2 ? atoi(argv[1]) : 0, columns = argc > 2 ? atoi(argv[2]) : 0;
    const char *format = argc > 3 ? "v %.17g %.17g %.17g\n" : "v %.6f %.6f %.6f\n";
    if (rows < 2 || columns < 3) return 2;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            double u = acos(-1) * (i + 0.5) / rows, v = 2 * acos(-1) * j / columns;
            printf(format, sin(u) * cos(v), sin(u) * sin(v), cos(u));
        }
    for (int i = 0; i + 1 < rows; i++)
        for (int j = 0; j < columns; j++) {
            int a = i * columns + j + 1, b = i * columns + (j + 1) % columns + 1;
            printf("f %d %d %d\nf %d %d %d\n", a, a + columns, b, b, a + columns, b + columns);
        }
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
