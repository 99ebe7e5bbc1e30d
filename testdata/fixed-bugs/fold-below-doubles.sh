# SPDX-License-Identifier: GPL-3.0-or-later
# Where determinants lie below the range of doubles, the triangle named for a fold was the first of those
# whose upper bound rounds to 0, here a degenerate one.
LC_ALL=C awk 'BEGIN {
    print "grid 1\ndegree 1\nvertices 4\n0 0\n1 0\n1 1\n0 1\ntriangles 2\n0 1 2\n0 2 3"
    print "points 4\n0 0\n1e-200 0\n2e-200 0\n0 -1e-200\nend"
}' | check-grid >report
grep -e '^local' -e '^det' -e '^triangles-' report
