# title: A deformation of the plane, edited by hand
# paper: Not known to us. The report's subject is a smooth deformation of the plane that a user edits by moving
#   control points.
# picture: a frame of a video of C. elegans, and a grid over it
# picture: after one edit: the middle turned by 30 degrees, softly
# seen: {anchors} control points in a box in the middle (the anchors) turn by 30 degrees, {slaves} points
#   around them (the slaves) by less the farther they are, and {derived} points in all are found by least
#   squares, under {conditions} conditions that keep the slopes continuous. Nothing else moves: the image's
#   border stays. The map is one-to-one: {one-to-one}; areas shrink to {det-lower} at the least.
image=$DATA/images/worm-254.png
mkgrid --image "$image" --cells 8 -o rest.grid
printf 'edits 1\nrotate box:22,38,42,58 about 32 48 by 30 within 18\n' >turn.edits
decles-edit --verbose turn.edits rest.grid -o turned.grid 2>&1 | awk -f "$HERE/lib/counts.awk"
check-grid turned.grid | grep -E '^(one-to-one|det-lower)'
warp-image --filter cubic --antialias 2 "$image" turned.grid -o turned.png
draw-grid --image "$image" --width 380 -o decles14-01-overview-1.png rest.grid
draw-grid --image turned.png --width 380 -o decles14-01-overview-2.png turned.grid
