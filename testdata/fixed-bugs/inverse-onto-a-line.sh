# SPDX-License-Identifier: GPL-3.0-or-later
# A crooked map of a square onto a segment of the line y = 2x: points of that segment were outside, after a
# tenth of a second each, since nothing told how far along the line the pieces of triangles reach.
LC_ALL=C awk 'BEGIN {
    print "grid 1\ndegree 2\nvertices 4\n0 0\n4 0\n0 4\n4 4\ntriangles 2\n0 1 3\n0 3 2\npoints 9"
    n = split("-6 8 2 -5 -1.5 -7.75 -1.25 7 3.5", x, " ")
    for (i = 1; i <= n; i++) print x[i], 2 * x[i]
    print "end"
}' >line.grid
printf '1 2\n0.25 0.5\n-3 -6\n' >points.xy
deform-mesh --inverse --any points.xy line.grid >back.xy && deform-mesh --digits 14 back.xy line.grid
