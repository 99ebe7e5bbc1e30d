# SPDX-License-Identifier: GPL-3.0-or-later
# measure-grid - measures a grid from what the programs printed; shares no code with them.
#
#     awk -f grid.awk -f measure-grid.awk GRID
#
# prints "name value" lines: triangles, points, c1-residual, least-determinant (grid.awk).

BEGIN {
    if (ARGC != 2) fail("usage: awk -f grid.awk -f measure-grid.awk GRID")
    read_grid(ARGV[1])
    printf "triangles %d\n", triangles
    printf "points %d\n", points
    printf "c1-residual %.2g\n", c1_residual()
    printf "least-determinant %.6g\n", least_determinant()
}
