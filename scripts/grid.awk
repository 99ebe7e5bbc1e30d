# SPDX-License-Identifier: GPL-3.0-or-later
# grid - reads a grid and measures its map, for other awk programs; shares no code with lib/.
#
#     read_grid(file)         fills vx, vy, tri, qx, qy, degree, axis_x, axis_y and the numbers of each
#     c1_residual()           the largest jump over an inner edge that a condition of smoothness
#                             reports, over the largest coordinate of a control point
#     least_determinant()     the least det grad phi over 21 places in each triangle
#
# Control points are numbered as in supple-grid(5).

function fail(message) {
    print "measure: " message | "cat >&2"
    failed = 1
    exit 1
}

function abs(x) { return x < 0 ? -x : x }

# ---- reading ----

function record() {   # the next record of the grid in word[]; its first word
    while ((getline line < grid) > 0) {
        sub(/#.*/, "", line)
        if (split(line, word, " ") > 0) return word[1]
    }
    fail(grid " is cut")
}

function read_grid(file,    key, i, l) {
    grid = file; step = 1; x0 = y0 = 0; axis_x = 1; axis_y = 2
    while ((key = record()) != "end" && !failed) {
        if (key == "degree") degree = word[2]
        if (key == "plane") { axis_x = index("xyz", substr(word[2], 1, 1)); axis_y = index("xyz", substr(word[2], 2, 1)) }
        if (key == "lattice") { step = word[2]; x0 = word[3]; y0 = word[4] }
        if (key == "vertices") {
            vertices = word[2]
            for (i = 0; i < vertices; i++) { record(); vx[i] = x0 + step * word[1]; vy[i] = y0 + step * word[2] }
        }
        if (key == "triangles") {
            triangles = word[2]
            for (i = 0; i < triangles; i++) { record(); for (l = 0; l < 3; l++) tri[i, l] = word[l+1] }
        }
        if (key == "points") {
            points = word[2]
            for (i = 0; i < points; i++) { record(); qx[i] = word[1]; qy[i] = word[2] }
        }
    }
    build_edges()
}

# ---- the grid: edges, numbering, conditions, Jacobian ----

function build_edges(    t, l, a, b, i, n) {   # edge[a,b], a < b, numbered by (a,b)
    for (t = 0; t < triangles; t++)
        for (l = 0; l < 3; l++) {
            a = tri[t, (l+1) % 3]; b = tri[t, (l+2) % 3]
            if (a > b) { i = a; a = b; b = i }
            if (!((a, b) in sides)) {   # keep the later ends of a in order
                for (i = ends[a]++; i > 0 && other[a, i-1] > b; i--) other[a, i] = other[a, i-1]
                other[a, i] = b
            }
            side[a, b, sides[a, b]++] = t
        }
    n = 0
    for (a = 0; a < vertices; a++)
        for (i = 0; i < ends[a]; i++) { b = other[a, i]; edge[a, b] = n; edge_a[n] = a; edge_b[n] = b; n++ }
    edges = n
    if (points != vertices + edges * (degree-1) + triangles * (degree-1) * (degree-2) / 2)
        fail("the number of points of " grid " is not that of its triangles")
}

function on_edge(a, b, wb) {   # the point with weight wb at b, degree - wb at a
    return a < b ? vertices + edge[a, b] * (degree-1) + wb - 1 : vertices + edge[b, a] * (degree-1) + degree - wb - 1
}

function point(t, i, j, k,    a, b, c, s) {
    a = tri[t, 0]; b = tri[t, 1]; c = tri[t, 2]
    if (i == degree) return a
    if (j == degree) return b
    if (k == degree) return c
    if (i == 0) return on_edge(b, c, k)
    if (j == 0) return on_edge(a, c, k)
    if (k == 0) return on_edge(a, b, j)
    s = degree - i   # points with a larger i come first: rows of 1, 2, .. s-2 points
    return vertices + edges * (degree-1) + t * (degree-1) * (degree-2) / 2 + (s-2) * (s-1) / 2 + (s - 1 - j)
}

function corner(t, v) { return tri[t, 0] == v ? 0 : tri[t, 1] == v ? 1 : 2 }

# The point of triangle t with weight 1 at its corner off {a,b}, j at a, k at b.
function near_edge(t, off, a, b, j, k,    w) {
    w[corner(t, off)] = degree - j - k; w[corner(t, a)] = j; w[corner(t, b)] = k
    return point(t, w[0], w[1], w[2])
}

function area2(ax, ay, bx, by, cx, cy) { return (bx-ax) * (cy-ay) - (by-ay) * (cx-ax) }

function third(t, a, b) { return tri[t, 0] + tri[t, 1] + tri[t, 2] - a - b }

function c1_residual(    e, a, b, t, u, p, q, m, n, B0, B1, B2, A, r, worst, big, o, s, f, g) {
    worst = 0
    for (e = 0; e < edges; e++) {
        a = edge_a[e]; b = edge_b[e]
        if (sides[a, b] != 2) continue
        t = side[a, b, 0]; u = side[a, b, 1]; p = third(t, a, b); q = third(u, a, b)
        A = area2(vx[p], vy[p], vx[a], vy[a], vx[b], vy[b])
        B0 = area2(vx[q], vy[q], vx[a], vy[a], vx[b], vy[b]) / A
        B1 = area2(vx[p], vy[p], vx[q], vy[q], vx[b], vy[b]) / A
        B2 = 1 - B0 - B1
        for (m = 0; m < degree; m++) {
            n = degree - 1 - m
            o = near_edge(u, q, a, b, n, m); s = near_edge(t, p, a, b, n, m)
            f = near_edge(t, p, a, b, n+1, m); g = near_edge(t, p, a, b, n, m+1)
            r = abs(qx[o] - B0 * qx[s] - B1 * qx[f] - B2 * qx[g]); if (r > worst) worst = r
            r = abs(qy[o] - B0 * qy[s] - B1 * qy[f] - B2 * qy[g]); if (r > worst) worst = r
        }
    }
    for (m = 0; m < points; m++) { if (abs(qx[m]) > big) big = abs(qx[m]); if (abs(qy[m]) > big) big = abs(qy[m]) }
    return worst / big
}

function power(x, n,    r) { r = 1; while (n-- > 0) r *= x; return r }

# det grad phi in triangle t at weights (b0,b1,b2): Bernstein sums of the differences of the net.
function determinant(t, b0, b1, b2,    i, j, k, n, c, p, q, r, ux, uy, wx, wy, D) {
    n = degree - 1; ux = uy = wx = wy = 0
    for (i = 0; i <= n; i++)
        for (j = 0; i + j <= n; j++) {
            k = n - i - j
            c = factorial[n] / (factorial[i] * factorial[j] * factorial[k]) * power(b0, i) * power(b1, j) * power(b2, k)
            p = point(t, i+1, j, k); q = point(t, i, j+1, k); r = point(t, i, j, k+1)
            ux += c * (qx[q] - qx[p]); uy += c * (qy[q] - qy[p])
            wx += c * (qx[r] - qx[p]); wy += c * (qy[r] - qy[p])
        }
    D = area2(vx[tri[t,0]], vy[tri[t,0]], vx[tri[t,1]], vy[tri[t,1]], vx[tri[t,2]], vy[tri[t,2]])
    return degree * degree * (ux * wy - uy * wx) / D
}

function least_determinant(    t, i, j, d, least) {
    factorial[0] = 1
    for (i = 1; i <= degree; i++) factorial[i] = i * factorial[i-1]
    least = 1e300
    for (t = 0; t < triangles; t++)
        for (i = 0; i <= 5; i++)
            for (j = 0; i + j <= 5; j++) {
                d = determinant(t, i/5, j/5, (5-i-j)/5)
                if (d < least) least = d
            }
    return least
}
