# title: A bicubic tensor net, for comparison
# paper: The Bezier net of a patch that is a tensor product, as free-form deformation uses it.
# picture: control points and net (orange), lines of constant parameter (blue)
# seen: 16 control points in 4 rows, and the lines of constant parameter of their patch. Two such patches
#   are C1 when the points on both sides of the seam lie on lines; nine points must move together where
#   four patches meet, against the conditions of a triangulation, which fit any domain.
awk '
function put(x, y, label) { printf "%.6f %.6f %s\n", x, y, label }
function b(i, t) { return (i == 0 ? 1 : i == 3 ? 1 : 3) * t^i * (1 - t)^(3 - i) }
function point(u, v,    i, j) {
    x = y = 0
    for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) {
        x += b(i, u) * b(j, v) * px[i, j]; y += b(i, u) * b(j, v) * py[i, j]
    }
}
BEGIN {
    for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) {
        px[i, j] = i + 0.35 * (j == 2) - 0.3 * (i == 1) * (j == 3); py[i, j] = j + 0.4 * (i % 2) + 0.2 * i * (j == 3)
    }
    for (k = 0; k <= 6; k++) {
        for (t = 0; t <= 40; t++) { point(k / 6, t / 40); put(x, y, "patch") }
        print ""
        for (t = 0; t <= 40; t++) { point(t / 40, k / 6); put(x, y, "patch") }
        print ""
    }
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) put(px[i, j], py[i, j], "net")
        print ""
        for (j = 0; j < 4; j++) put(px[j, i], py[j, i], "net")
        print ""
    }
    for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) { put(px[i, j], py[i, j], "net"); print "" }
}' >tensor.lines
draw-grid --no-grid --lines tensor.lines --width 500 -o decles14-10-tensor-net.png
