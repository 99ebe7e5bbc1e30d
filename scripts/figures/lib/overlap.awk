# SPDX-License-Identifier: GPL-3.0-or-later
# Intersection over union of a model's silhouette (OBJ, faces, plane zy) and a polygon (x y, y downwards),
# on a raster of `per` samples a unit. Below 0.8 is a failure.
BEGIN { if (!per) per = 3 }
FNR == 1 { file++ }
file == 1 && NF >= 2 { ox[n] = $1 * per; oy[n++] = -$2 * per; next }
$1 == "v" { vx[++vn] = $4 * per; vy[vn] = $3 * per }
$1 == "f" { for (i = 2; i <= 4; i++) { split($i, c, "/"); p[i] = c[1] + 0 } fill(p[2], p[3], p[4]) }
function ceiling(x) { return x == int(x) || x < 0 ? int(x) : int(x) + 1 }
# Sample (i, j) stands at (i + 1/2, j + 1/2).
function fill(a, b, c,    j, lo, hi, k, u, v, x, t, e) {
    lo = vy[a]; hi = lo
    if (vy[b] < lo) lo = vy[b]; if (vy[b] > hi) hi = vy[b]
    if (vy[c] < lo) lo = vy[c]; if (vy[c] > hi) hi = vy[c]
    e[0] = a; e[1] = b; e[2] = c
    for (j = ceiling(lo - 0.5); j + 0.5 < hi; j++) {
        l = 1e9; r = -1e9
        for (k = 0; k < 3; k++) {
            u = e[k]; v = e[(k + 1) % 3]
            if ((vy[u] <= j + 0.5) == (vy[v] <= j + 0.5)) continue
            x = vx[u] + (j + 0.5 - vy[u]) / (vy[v] - vy[u]) * (vx[v] - vx[u])
            if (x < l) l = x; if (x > r) r = x
        }
        for (i = ceiling(l - 0.5); i + 0.5 < r; i++) model[i, j] = 1
    }
}
function inside(x, y,    i, k, in_it) {
    for (i = 0; i < n; i++) {
        k = (i + 1) % n
        if ((oy[i] > y) != (oy[k] > y) && x < ox[i] + (y - oy[i]) / (oy[k] - oy[i]) * (ox[k] - ox[i])) in_it = !in_it
    }
    return in_it
}
END {
    for (key in model) { split(key, at, SUBSEP); m++; if (inside(at[1] + 0.5, at[2] + 0.5)) both++ }
    for (i = 0; i < n; i++) { k = (i + 1) % n; area += (ox[i] * oy[k] - ox[k] * oy[i]) / 2 }
    if (area < 0) area = -area
    overlap = both / (m + area - both)
    printf "area of the model %.1f, of the outline %.1f, of both %.1f\noverlap %.3f\n", m / per^2, area / per^2, both / per^2, overlap
    exit overlap < 0.8
}
