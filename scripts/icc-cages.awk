# SPDX-License-Identifier: GPL-3.0-or-later
# Pairs of cages for scripts/icc-defects: writes FOLDER/NAME.from.xy and NAME.to.xy.
# usage: awk -v folder=FOLDER -f icc-cages.awk

function put(x, y) { printf "%.9g %.9g\n", x, y >file }
function begin(name, which) { file = folder "/" name "." which ".xy" }

# Points are separated by blanks.
function list(name, which, points,    p, n, i) {
    begin(name, which)
    n = split(points, p, " ")
    for (i = 1; i < n; i += 2) put(p[i], p[i + 1])
    close(file)
}

# A band around a path px, py[0..m], of half width w, closed counter-clockwise by its ends.
function band(name, which, m, w,    i, dx, dy, l, side) {
    begin(name, which)
    for (side = -1; side <= 1; side += 2)
        for (i = side < 0 ? 0 : m; i >= 0 && i <= m; i -= side) {
            dx = px[i < m ? i + 1 : m] - px[i ? i - 1 : 0]
            dy = py[i < m ? i + 1 : m] - py[i ? i - 1 : 0]
            l = sqrt(dx * dx + dy * dy)
            put(px[i] - side * w * dy / l, py[i] + side * w * dx / l)
        }
    close(file)
}

# n vertices of r = 1 + a cos(legs angle); what is left of the y axis is bent by `bend` at its tip.
function blob(name, which, n, legs, a, bend,    i, t, r) {
    begin(name, which)
    for (i = 0; i < n; i++) {
        t = 2 * pi * i / n
        r = 1 + a * cos(legs * t)
        if (cos(t) < 0) t += bend * (r - 1 + a)
        put(r * cos(t), r * sin(t))
    }
    close(file)
}

# Teeth on a bar; their tips are moved by dx.
function comb(name, which, teeth, dx,    i) {
    begin(name, which)
    put(0, 0)
    put(2 * teeth - 1, 0)
    for (i = teeth - 1; i >= 0; i--) {
        if (i < teeth - 1) put(2 * i + 1, 1)
        put(2 * i + 1 + dx, 4)
        put(2 * i + dx, 4)
        if (i) put(2 * i, 1)
    }
    close(file)
}

BEGIN {
    pi = atan2(0, -1)
    list("L-square", "from", "0 0 2 0 2 1 1 1 1 2 0 2")
    list("L-square", "to", "0 0 2 0 2 1 2 2 1 2 0 2")
    list("square-sharp", "from", "0 0 1 0 1 1 0 1")
    list("square-sharp", "to", "0 0 4 0.3 2.2 0.9 1.9 1.6")
    list("square-star", "from", "0.5 0 1 0 1 0.5 1 1 0.5 1 0 1 0 0.5 0 0")
    for (i = 0; i < 8; i++)
        star = star " " (i % 2 ? 1 : 0.45) * cos(pi * (i - 2) / 4) " " (i % 2 ? 1 : 0.45) * sin(pi * (i - 2) / 4)
    list("square-star", "to", star)
    blob("three-legs", "from", 54, 3, 0.5, 0)
    blob("three-legs", "to", 54, 3, 0.5, 0.5)
    for (i = 0; i <= 40; i++) {
        t = 0.5 + 2.6 * i / 40
        px[i] = t * cos(3 * t)
        py[i] = t * sin(3 * t)
    }
    band("spiral-bar", "from", 40, 0.3)
    for (i = 0; i <= 40; i++) {
        px[i] = i / 4
        py[i] = 0
    }
    band("spiral-bar", "to", 40, 0.5)
    comb("comb", "from", 5, 0)
    comb("comb", "to", 5, 0.9)
    list("dumbbell", "from", "0 0 2 0 2 0.8 3 0.8 3 0 5 0 5 2 3 2 3 1.2 2 1.2 2 2 0 2")
    list("dumbbell", "to", "0 0 2 0.3 2.4 0.5 3.2 0.7 3.6 0.1 5 1 4 3 2.8 2.4 3 1.6 2.2 1.4 1.6 1.9 -0.3 1.5")
    for (i = 0; i <= 30; i++) {
        px[i] = i / 5
        py[i] = 0.5 * sin(i / 5)
    }
    band("worm", "from", 30, 0.3)
    for (i = 0; i <= 30; i++) {
        px[i] = 1.8 * sin(i / 13)
        py[i] = 1.8 * cos(i / 13)
    }
    band("worm", "to", 30, 0.3)
}
