# title: What follows an anchor, by its type
# paper: For an anchor of each type, the points that become derived and the conditions that are kept.
# seen: The anchor in the middle of each picture is a corner, an edge corner, an edge point, an inner
#   corner, an inner edge point of degree 5 at a vertex with six triangles. The counts printed are those
#   of the design notes: 30, 29, 23, 23 and 1 derived points; 18, 18, 12, 12 and 1 conditions.
mkgrid --rect 0,0,4,4 --cells 4x4 -o flat.grid
n=0
for point in v^2,2 ^2.2,2 ^2.4,2 ^2.4,2.2 ^2.6,2.4; do
    n=$((n + 1))
    list-points $point flat.grid | cut -d ' ' -f 1-3
    printf 'edits 1\nmove %s by 0.15 0.1\n' $point >one.edits
    decles-edit --verbose one.edits flat.grid 2>&1 >/dev/null | grep -o '|A|.*|E| [0-9]*'
    draw-grid --edit one.edits:2 --side domain --layers triangles,net,quads,sets --width 420 \
        -o decles14-13-derived-$n.png flat.grid
done
