# title: An edge point between two triangles
# paper: A point in the middle of the one inner edge, moved by itself: four points follow, in two
#   conditions.
# seen: The same: {derived} derived points and {conditions} conditions. The four are the extremes of the
#   two conditions, two in each triangle.
mkgrid --rect 0,0,2,2 --cells 1x1 -o two.grid
printf 'edits 1\nmove ^0.8,0.8 by 0.3 -0.2\n' >one.edits
decles-edit --verbose one.edits two.grid 2>&1 >/dev/null | awk -f "$HERE/lib/counts.awk"
draw-grid --edit one.edits:2 --side both --layers triangles,net,points,quads,sets -o decles14-14-edge-point.png two.grid
