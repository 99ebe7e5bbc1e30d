# SPDX-License-Identifier: GPL-3.0-or-later
# An edit script that bends a worm to a posture. Reads the midline of a micrograph (frame,point,x,y,
# width; y downwards), the grid's rows of control points ("row Y" a line) and a model whose body lies
# along z (OBJ), the grid's x, with y across.
#
# First the worm is made thicker: the rows move apart, all by one affine map. The body is cut into pieces of the same length along z by hinges. The directions of the pieces, at
# rest and in the micrograph, tell by how much each hinge must turn. From head to tail, all that lies
# on the head's side of a hinge turns about the midline there, where nothing has moved yet; points
# near the hinge follow softly. Then all is scaled, turned and moved onto the micrograph, as the
# joints of both midlines demand in the sense of least squares.
#
# usage: awk -v across=FACTOR -v hinges=N [-v soft=R] [-v flip=1] -f posture.awk MIDLINE ROWS MODEL

BEGIN { FS = "[ ,]+"; pi = atan2(0, -1); slab = 0.1; if (!soft) soft = 0.8 }

$1 == "frame" { next }
FNR == NR { # the micrograph, y upwards
    tx[tn] = $3; ty[tn++] = -$4
    next
}
$1 == "row" { row[rows++] = $2; next }
$1 == "v" { # the model: how far it reaches to both sides, slab by slab
    k = int(($4 + 100) / slab)
    if (!(k in low) || $3 < low[k]) low[k] = $3
    if (!(k in high) || $3 > high[k]) high[k] = $3
    if (least == "" || $4 < least) least = $4
    if (most == "" || $4 > most) most = $4
}

# A midline as a function of the part of its length.
function measure(n, x, y, part,    i) {
    part[0] = 0
    for (i = 1; i < n; i++) part[i] = part[i - 1] + sqrt((x[i] - x[i - 1])^2 + (y[i] - y[i - 1])^2)
    length_of = part[n - 1]
    for (i = 1; i < n; i++) part[i] /= length_of
}
function place(n, x, y, part, s,    i, f) { # sets at_x, at_y
    for (i = 1; i < n - 1 && part[i] < s; i++);
    f = (s - part[i - 1]) / (part[i] - part[i - 1])
    at_x = x[i - 1] + f * (x[i] - x[i - 1]); at_y = y[i - 1] + f * (y[i] - y[i - 1])
}
function half_turn(angle) { return atan2(sin(angle), cos(angle)) } # -pi .. pi

# The model's midline: the middle between both sides, smoothed a little.
function midline(    k, i) {
    for (k = int((least + 100) / slab); k <= int((most + 100) / slab); k++) if (k in low) {
        mx[mn] = (k + 0.5) * slab - 100; raw[mn++] = across * (low[k] + high[k]) / 2
    }
    for (i = 0; i < mn; i++) my[i] = (i > 1 && i < mn - 2) ? \
        (raw[i - 2] + raw[i - 1] + raw[i] + raw[i + 1] + raw[i + 2]) / 5 : raw[i]
    mx[0] = least; mx[mn - 1] = most
}

END {
    midline()
    measure(mn, mx, my, mp); model = length_of
    measure(tn, tx, ty, tp); target = length_of
    for (i = 0; i <= hinges + 1; i++) { # joints: the ends and the hinges
        s = i / (hinges + 1)
        place(mn, mx, my, mp, s); px[i] = at_x; py[i] = at_y
        place(tn, tx, ty, tp, flip ? 1 - s : s); qx[i] = at_x; qy[i] = at_y
    }
    for (i = 0; i <= hinges; i++)
        turn[i] = atan2(qy[i + 1] - qy[i], qx[i + 1] - qx[i]) - atan2(py[i + 1] - py[i], px[i + 1] - px[i])
    print "edits 1\nbegin"
    for (i = 0; i < rows; i++) printf "move box:-9,%s,9,%s by 0 %.17g\n", row[i], row[i], (across - 1) * row[i]
    print "end"
    for (i = hinges; i >= 1; i--)
        printf "rotate box:%.4f,-9,9,9 about %.4f %.4f by %.3f within %.4g\n", px[i] + soft, px[i], py[i],
            half_turn(turn[i] - turn[i - 1]) * 180 / pi, 2 * soft
    # Where the joints are now: the piece of the tail has not moved.
    x = px[0]; y = py[0]; scale = target / model
    for (i = 0; i <= hinges + 1; i++) {
        if (i > 0) {
            c = cos(turn[i - 1] - turn[0]); s = sin(turn[i - 1] - turn[0])
            dx = px[i] - px[i - 1]; dy = py[i] - py[i - 1]
            x += c * dx - s * dy; y += s * dx + c * dy
        }
        jx[i] = x; jy[i] = y
        ax += x; ay += y; bx += qx[i]; by += qy[i]
    }
    n = hinges + 2; ax /= n; ay /= n; bx /= n; by /= n
    for (i = 0; i < n; i++) {
        re += (jx[i] - ax) * (qx[i] - bx) + (jy[i] - ay) * (qy[i] - by)
        im += (jx[i] - ax) * (qy[i] - by) - (jy[i] - ay) * (qx[i] - bx)
        norm += (jx[i] - ax)^2 + (jy[i] - ay)^2
    }
    printf "rotate all about %.6f %.6f by %.6f\n", ax, ay, atan2(im, re) * 180 / pi
    printf "scale all about %.6f %.6f by %.6f\n", ax, ay, sqrt(re^2 + im^2) / norm
    printf "move all by %.6f %.6f\n", bx - ax, by - ay
}
