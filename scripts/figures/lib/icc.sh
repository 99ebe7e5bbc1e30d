# shellcheck shell=sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What the figures of [13] share. Reads no input; the functions write to standard output unless they say
# which files.

# The pairs of cages of scripts/icc-defects: NAME.from.xy, NAME.to.xy.
cages() { awk -v folder=. -f "$HERE/../icc-cages.awk"; }

# legs BEND: a cage of 54 vertices with three legs, which are bent by BEND radians at their tips.
legs() {
    awk -v bend="$1" 'BEGIN {
        for (i = 0; i < 54; i++) {
            turn = 8 * atan2(1, 1) * i / 54
            r = 1 + 0.5 * cos(3 * turn)
            turn += bend * (r - 0.5)
            printf "%.9g %.9g\n", r * cos(turn), r * sin(turn)
        }
    }'
}

# outline CAGE [LABEL]: the cage as a closed polyline.
outline() {
    awk -v label="${2:-cage}" '
        NF { line = $1 " " $2 " " label; print line; if (!first) first = line }
        END { print first; print "" }' "$1"
}

# places CAGE N: "k lambda" of N places at equal distances along the cage, from vertex 0.
places() {
    awk -v n="$2" '
        NF { x[m] = $1; y[m++] = $2 }
        END {
            for (k = 0; k < m; k++) {
                j = (k + 1) % m
                length_of[k] = sqrt((x[j] - x[k])^2 + (y[j] - y[k])^2)
                whole += length_of[k]
            }
            for (k = i = 0; i < n; i++) {
                for (way = i / n * whole - done; way > length_of[k] && k < m - 1; k++) {
                    way -= length_of[k]
                    done += length_of[k]
                }
                printf "%d %.9g\n", k, way < length_of[k] ? way / length_of[k] : 1
            }
        }' "$1"
}

# leaving CAGE: labels the polylines of standard input, "leaving" those that are outside the cage in the
# middle of a segment, by more than rounding, the others "line".
leaving() {
    awk '
        BEGIN { n = m = 0 }
        FNR == NR { if (NF) { cx[n] = $1; cy[n++] = $2 } next }
        NF { x[m] = $1; y[m++] = $2; next }
        { end() }
        END { end() }
        function outside(u, v,    i, j, in_it) {
            for (i = 0; i < n; i++) {
                j = (i + 1) % n
                if ((cy[i] > v) != (cy[j] > v) && u < cx[i] + (v - cy[i]) / (cy[j] - cy[i]) * (cx[j] - cx[i])) in_it = !in_it
            }
            return !in_it
        }
        function end(    i, label) {
            label = "line"
            for (i = 1; i < m; i++)
                if ((x[i] - x[i - 1])^2 + (y[i] - y[i - 1])^2 > 1e-12 && outside((x[i] + x[i - 1]) / 2, (y[i] + y[i - 1]) / 2))
                    label = "leaving"
            for (i = 0; i < m; i++) print x[i], y[i], label
            if (m) print ""
            m = 0
        }' "$1" -
}

# draw PICTURE [OPTION]...: the polylines of standard input.
draw() {
    picture=$1
    shift
    draw-grid --no-grid --lines - "$@" -o "$picture"
}

# folds MODEL: what became of the triangles of an OBJ whose vt are the source.
folds() {
    awk '
        $1 == "vt" { u[++nt] = $2; w[nt] = $3 }
        $1 == "v" { x[++nv] = $2; y[nv] = $3 }
        function turn(x, y, a, b, c) { return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]) }
        $1 == "f" {
            for (i = 2; i <= 4; i++) { split($i, part, "/"); p[i] = part[1]; q[i] = part[2] }
            before = turn(u, w, q[2], q[3], q[4])
            after = turn(x, y, p[2], p[3], p[4]) / before
            n++
            if (after < -1e-9) over++
            else if (after < 1e-6) flat++
        }
        END { printf "of %d triangles %d turned over, %d without area\n", n, over, flat }' "$1"
}

# regular N INNER: a cage of 2 N vertices on the unit circle, every second of which is drawn in to the
# radius INNER.
regular() {
    awk -v n="$1" -v inner="$2" 'BEGIN {
        for (i = 0; i < 2 * n; i++) {
            turn = 4 * atan2(1, 1) * (i / n + 0.5)
            r = i % 2 ? inner : 1
            printf "%.9g %.9g\n", r * cos(turn), r * sin(turn)
        }
    }'
}

# checkers FIGURE SOURCE TARGET AREA [OPTION]...: the source with a checkerboard (or as $render says), and its
# image by the thesis method and by ours: FIGURE-1.png, -2.png, -3.png. Options are for method grid. Prints
# what became of the triangles and of lines.
checkers() {
    figure=$1 source=$2 target=$3 area=$4
    shift 4
    icc-map --mesh "$area" "$source" "$source" >rest.obj
    icc-map --mesh "$area" "$source" "$target" >ray.obj
    icc-map --method grid --verbose "$@" --model rest.obj "$source" "$target" >grid.obj 2>notes
    sed -n "s/.*: \(cells of [^,]*, [^,]*\).*/\1/p" notes
    sed -n 's/.*: of \([0-9]* points\), lines merged: \([0-9]*\).*/\2 of \1/p' notes |
        awk '{ print NR == 1 ? "merged-source" : "merged-target", $0 }'
    echo "thesis $(folds grid.obj)"
    echo "ours $(folds ray.obj)"
    n=0
    for map in rest grid ray; do
        n=$((n + 1))
        # shellcheck disable=SC2086 # several options
        render-checker ${render:---size 310x310 --squares 20} --mark-folds -o "$figure-$n.png" $map.obj
    done
}
