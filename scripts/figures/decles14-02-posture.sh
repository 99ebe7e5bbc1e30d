# title: A worm bent to the posture in a micrograph
# also: decles14-15 decles11-17
# paper: A model of an organism deformed until it lies on a micrograph of a living one.
# seen: The Virtual Worm's cuticle on frame 254 of a video of a crawling worm (WormPose sample data, BSD-3).
#   posture.awk writes the script from the two midlines: the worm is made thicker, eight hinges bend it,
#   a similarity takes it to the image. The outline is the one measured in the video; the silhouette
#   and the outline overlap by more than 0.8 (intersection over union).
worm=$DATA/models/virtual_worm_cuticle_red75.obj
outline=$DATA/shapes2d/worm_outline_pairs/frame00254_outline102.dat
mkgrid --model "$worm" --flat --plane zy --cells 40 --margin 0.15 -o rest.grid
list-points rest.grid | awk '{ print "row", $5 }' | sort -u >rows
awk -v across=1.5 -v hinges=8 -v soft=1 -f "$HERE/lib/posture.awk" "$DATA/posture/midline-254.csv" rows "$worm" >posture.edits
decles-edit posture.edits rest.grid -o bent.grid
check-grid bent.grid | grep -E '^(local|det-lower)'
deform-mesh --normals drop "$worm" bent.grid >bent.obj
awk -f "$HERE/lib/overlap.awk" "$outline" bent.obj
tail -n 11 posture.edits
awk 'NF { line = sprintf("%s %.4f outline", $1, -$2); print line; if (!first) first = line } END { print first }' "$outline" >outline.lines
draw-grid --model "$worm" --layers outline,triangles --lines outline.lines --image "$DATA/images/worm-254.png" \
    --frame 0,0,64,-97 --width 600 -o decles14-02-posture.png bent.grid
