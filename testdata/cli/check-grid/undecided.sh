# The images of two boundaries touch at an irrational place: y = 12 (x^2 - 1/2)^2 touches y = 0.
# What is 2^-40 apart is decided.
touch() { # HEIGHT
    cat <<'GRID'
grid 1
degree 4
vertices 6
0 0
1 -1
1 0
0 10
1 10
0 11
triangles 2
0 1 2
3 4 5
points 30
GRID
    LC_ALL=C awk -v height="$1" 'BEGIN {
        split("0 0 1 -1 1 0", below); split("0 0 1 0 0 1", above); split("3 3 1 -3 3", quartic)
        for (pass = 1; pass <= 3; pass++) { # corners, edges, interiors
            if (pass == 2) {
                edge(below, 1, 2, 0); edge(below, 1, 3, 0); edge(below, 2, 3, 0)
                edge(above, 1, 2, 1); edge(above, 1, 3, 1); edge(above, 2, 3, 1)
                continue
            }
            for (side = 0; side < 2; side++)
                if (pass == 1) {
                    point(side, 4, 0, 0); point(side, 0, 4, 0); point(side, 0, 0, 4)
                } else {
                    point(side, 2, 1, 1); point(side, 1, 2, 1); point(side, 1, 1, 2)
                }
        }
        print "end"
    }
    function edge(corner, a, b, side, n, w) {
        for (n = 1; n < 4; n++) {
            w[1] = w[2] = w[3] = 0
            w[a] = 4 - n; w[b] = n
            point(side, w[1], w[2], w[3])
        }
    }
    function point(side, i, j, k, x, y) {
        if (side) { x = j / 4; y = k / 4 + quartic[j + 1] }
        else { x = (j + k) / 4; y = -j / 4 - (j == 0 ? height : 0) }
        printf "%.17g %.17g\n", x, y
    }'
}
touch 0 | check-grid | sed -n '/^local/p; /^boundary:/,/^all/p'
touch 9.094947017729282e-13 | check-grid | grep -e ^boundary: -e ^one
