# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Sourced by judges of convert-grid, in an empty folder: deformed grids, and what is missing here.

# The Python that has module $1; without it the judge is skipped (status 77), see scripts/properties.
python_with() {
    for python in python3 /usr/bin/python3; do
        ! "$python" -B -c "import $1" 2>/dev/null || return 0
    done
    echo "no python3 with $1 here"
    exit 77
}

# Moves every control point by up to $2 times the unit, the same way on every machine (seed $1).
perturb() {
    awk -v seed="$1" -v size="$2" '
        function noise() { seed = (seed * 16807) % 2147483647; return size * (seed / 1073741824 - 1) }
        $1 == "end" { inside = 0 }
        inside { for (i = 1; i <= NF; i++) $i = sprintf("%.17g", $i + noise()) }
        $1 == "points" { inside = 1 }
        { print }'
}

# flat-D.grid and deep-D.grid, C1: by the editor; of degrees that it does not take, only C0; and planes other than xy.
smooth_grids() {
    for d in 5 6 7; do
        mkgrid --rect 0,0,4,3 --cells 4x3 --pattern cross --degree $d |
            decles-edit -e 'move @2,1.5 by 0.25 0.125 reach 9' -e 'rotate v@1,1 about 1 1 by 20 reach 7' \
                >flat-$d.grid
        mkgrid --rect 0,0,4,3 --cells 4x3 --degree $d --depth -1,1.5 |
            decles-edit -e 'move @2,1.5 by 0.25 0.125 reach 9' -e 'raise top @1,1 by 0.5 reach 8' \
                -e 'raise bottom @3,2 by -0.25 reach 6' >deep-$d.grid
    done
}

rough_grids() {
    for d in 1 2 3 4 8 9 10 15; do
        mkgrid --rect 0,0,3,2 --cells 3x2 --degree $d | perturb $d 0.02 >flat-$d.grid
        mkgrid --rect 0,0,3,2 --cells 3x2 --degree $d --depth 0,1 | perturb $d 0.02 >deep-$d.grid
    done
    sed 's/^degree .*/&\nplane zy/' deep-3.grid >mirror-3.grid
    sed 's/^degree .*/&\nplane zy/' deep-5.grid >mirror-5.grid
    sed 's/^degree .*/&\nplane zy/' flat-5.grid >mirrorflat-5.grid
    sed 's/^degree .*/&\nplane yz/' flat-6.grid >cyclic-6.grid
}

# A square ring and, apart from it, a triangle: hole-1.grid.
holed_grid() {
    cat >hole-1.grid <<'END'
grid 1
degree 1
lattice 0.5 1 0
depth 0 2
vertices 11
0 0
6 0
6 6
0 6
2 2
4 2
4 4
2 4
10 0
14 0
12 4
triangles 9
0 1 4
1 5 4
1 2 5
2 6 5
2 3 6
3 7 6
3 0 7
0 4 7
9 10 8
points 11
END
    awk '/^vertices/ { n = $2; next }
        n > 0 { n--; print 1 + $1 / 2, $2 / 2, 0, 2 + $1 / 8 }
        /^triangles/ { print "end"; exit }' hole-1.grid >points
    cat points >>hole-1.grid
}

# A history that neither JSON nor XML can hold as it is: hostile-1.grid.
hostile_grid() {
    mkgrid --rect 0,0,1,1 --cells 1x1 --degree 1 >plain
    {
        sed 1q plain
        printf '# "q" back\\slash \t\033\001 \344 \303\244 \355\240\200 \357\277\277 \342\202\254 ?> ?\033> --> ]]> <&>\n'
        sed 1d plain
    } >hostile-1.grid
}
