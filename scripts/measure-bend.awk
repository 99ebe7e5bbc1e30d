# SPDX-License-Identifier: GPL-3.0-or-later
# measure-bend - measures a bent worm from what the programs printed; shares no code with them.
#
#     awk -f grid.awk -f measure-bend.awk bent.grid worm.obj bent.obj
#
# prints "name value" lines: vertices, length of the midline before and after, the angle by which the
# midline turns from head to tail, the least det grad phi over 21 places a triangle, the largest C1
# residual relative to the largest coordinate.
#
# The midline is the polyline of the centroids of 32 slices of the body, cut across the grid's x axis in
# the rest position. Control points are numbered as in supple-grid(5).

function read_model(file, X, Y,    n, line, w) {
    n = 0
    while ((getline line < file) > 0)
        if (line ~ /^[ \t]*v[ \t]/) { split(line, w, " "); n++; X[n] = w[1 + axis_x]; Y[n] = w[1 + axis_y] }
    close(file)
    if (n == 0) fail("no vertices in " file)
    return n
}

# ---- the midline ----

function cut_slices(n, X,    i, s, low, high) {
    low = high = X[1]
    for (i = 2; i <= n; i++) { if (X[i] < low) low = X[i]; if (X[i] > high) high = X[i] }
    for (i = 1; i <= n; i++) {
        s = int((X[i] - low) / (high - low) * SLICES)
        slice[i] = s < SLICES ? s : SLICES - 1
    }
}

function centroids(n, X, Y,    i, s, count) {
    for (s = 0; s < SLICES; s++) cx[s] = cy[s] = count[s] = 0
    for (i = 1; i <= n; i++) { s = slice[i]; cx[s] += X[i]; cy[s] += Y[i]; count[s]++ }
    for (s = 0; s < SLICES; s++) {
        if (count[s] == 0) fail("slice " s " of the model is empty")
        cx[s] /= count[s]; cy[s] /= count[s]
    }
}

function midline_length(    s, sum) {
    for (s = 1; s < SLICES; s++) sum += sqrt((cx[s] - cx[s-1])^2 + (cy[s] - cy[s-1])^2)
    return sum
}

function midline_turn(    s, before, now, d, sum) {   # degrees, from the first to the last chord of 3 slices
    for (s = 3; s < SLICES; s++) {
        now = atan2(cy[s] - cy[s-3], cx[s] - cx[s-3])
        if (s > 3) {
            d = now - before
            if (d > PI) d -= 2 * PI
            if (d < -PI) d += 2 * PI
            sum += d
        }
        before = now
    }
    return sum * 180 / PI
}

BEGIN {
    if (ARGC != 4) fail("usage: awk -f grid.awk -f measure-bend.awk GRID MODEL BENT-MODEL")
    SLICES = 32; PI = atan2(0, -1)
    read_grid(ARGV[1])
    n = read_model(ARGV[2], X, Y)
    if (read_model(ARGV[3], U, V) != n) fail("the models differ in their numbers of vertices")
    cut_slices(n, X)
    centroids(n, X, Y); length_before = midline_length(); turn_before = midline_turn()
    centroids(n, U, V); length_after = midline_length(); turn_after = midline_turn()
    printf "vertices %d\n", n
    printf "triangles %d\n", triangles
    printf "midline-before %.4f\n", length_before
    printf "midline-after %.4f\n", length_after
    printf "turn %.1f\n", turn_after - turn_before
    printf "least-determinant %.3f\n", least_determinant()
    printf "c1-residual %.2g\n", c1_residual()
}
