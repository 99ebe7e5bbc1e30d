# title: What follows an anchor, by its type
# paper: For an anchor of each type, the points that become derived and the conditions that are kept.
# picture: a corner: {derived-1} derived points, {conditions-1} conditions
# picture: an edge corner: {derived-2}, {conditions-2}
# picture: an edge point: {derived-3}, {conditions-3}
# picture: an inner corner: {derived-4}, {conditions-4}
# picture: an inner edge point: {derived-5}, {conditions-5}
# seen: The anchor (orange) in the middle of each picture, in degree 5 at a vertex with six triangles; the
#   derived points (blue) lie in the rings 1 and 2 around the vertex and beyond them at the middle
#   conditions. The rules are those of the figure, generalised: to any number of triangles at a vertex, to
#   any degree, and to several anchors.
mkgrid --rect 0,0,2,2 --cells 2x2 -o flat.grid
n=0
for point in v^1,1 ^1.2,1 ^1.4,1 ^1.4,1.2 ^1.6,1.4; do
    n=$((n + 1))
    list-points $point flat.grid | cut -d ' ' -f 1-3
    printf 'edits 1\nmove %s by 0.1 0.05\n' $point >one.edits
    decles-edit --verbose one.edits flat.grid 2>&1 >/dev/null | awk -v tail=-$n -f "$HERE/lib/counts.awk" |
        grep -E '^(derived|conditions)'
    draw-grid --edit one.edits:2 --side domain --layers triangles,net,quads,sets --width 290 --no-legend \
        -o decles14-13-derived-$n.png flat.grid
done
draw-grid --edit one.edits:2 --side domain --layers triangles,net,quads,sets --width 290 -o decles14-13-derived-$n.png flat.grid
