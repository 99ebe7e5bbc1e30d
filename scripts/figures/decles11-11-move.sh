# title: One control point moved
# paper: Not known to us. The user moves control points with the mouse.
# picture: a red blood cell at rest
# picture: after the edit
# picture: the control points that moved
# seen: The corner at the cell's side is pulled outwards; {slaves} slaves within 5 steps of the net and further
#   points, {derived} in all, follow. Thickness does not change where sigma does not: {thickness} of what it was.
cell=$DATA/models/red_blood_cell.obj
mkgrid --model "$cell" --cells 6 -o rest.grid
printf 'edits 1\nmove v^1.8,0 by 1.1 0.3 reach 5\n' >one.edits
decles-edit --verbose one.edits rest.grid -o moved.grid 2>&1 | awk -f "$HERE/lib/counts.awk"
check-grid moved.grid | sed -n 's/^thickness-lower:/thickness/p; /^local/p'
deform-mesh "$cell" moved.grid -o moved.obj
render-model --view -25,50 --size 400x300 -o decles11-11-move-1.png "$cell"
render-model --view -25,50 --size 430x300 -o decles11-11-move-2.png moved.obj
draw-grid --model "$cell" --edit one.edits:2 --side both --layers triangles,sets --width 640 -o decles11-11-move-3.png rest.grid
