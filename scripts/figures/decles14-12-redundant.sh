# title: Conditions that follow from others
# paper: Not known to us. The report's section 4.3.2 removes redundant conditions by exact elimination; it counts two
#   at every inner vertex.
# picture: a vertex of six triangles
# picture: a vertex of four, whose sides lie on two lines: a singular vertex
# picture: the same, moved: its sides lie on four lines
# seen: The vertex in the middle is moved by itself. The six triangles give {conditions-6} conditions,
#   {redundant-6} of which follow from the others. At the singular vertex {redundant-4} of {conditions-4}
#   do, one more than the report counts; where the vertex lies off the crossing of the lines it is
#   {redundant-s} of {conditions-s}. The programs find them by exact arithmetic, never by a tolerance.
counted() {
    printf 'edits 1\nmove v^%s by 0.2 0.15\n' "$2" >$1.edits
    decles-edit --verbose $1.edits $1.grid 2>&1 >/dev/null | awk -v tail=-$1 -f "$HERE/lib/counts.awk" |
        grep -E '^(decles|conditions|rank|redundant)'
    draw-grid --edit $1.edits:2 --side domain --layers triangles,net,quads,sets --width 280 --no-legend \
        -o decles14-12-redundant-$3.png $1.grid
}
mkgrid --rect 0,0,2,2 --cells 2x2 -o 6.grid
mkgrid --rect 0,0,2,2 --cells 1x1 --pattern cross -o 4.grid
printf '5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1.25 0.5\n' >s.node
printf '4 3 0\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 4\n' >s.ele
mkgrid --triangulation s.ele -o s.grid
counted 6 1,1 1
counted 4 1,1 2
counted s 1.25,0.5 3
