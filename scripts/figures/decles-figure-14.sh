# title: [14] figure 14: an edge point between two triangles
# paper: A point in the middle of the one inner edge, moved by itself: four points follow, in two
#   conditions.
# seen: The same: |D| 4, |E| 2. The four are the extremes of the two conditions, two in each triangle.
mkgrid --rect 0,0,2,2 --cells 1x1 -o two.grid
printf 'edits 1\nmove ^0.8,0.8 by 0.3 -0.2\n' >one.edits
decles-edit --verbose one.edits two.grid 2>&1 >/dev/null | grep -o '|A|.*|E| [0-9]*'
draw-grid --edit one.edits:2 --side both --layers triangles,net,points,quads,sets -o decles-figure-14.png two.grid
