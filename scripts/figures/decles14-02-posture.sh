# title: A worm bent to the posture in a micrograph
# paper: A model of an organism deformed until it lies on a micrograph of a living one.
# picture: frame 254 of a video of a crawling C. elegans
# picture: the cuticle of the Virtual Worm, its grid, and the outline measured in the video
# seen: The Virtual Worm's cuticle on a frame of the WormPose sample data (the paper's organism and image are
#   not public). posture.awk writes the edit script from the two midlines: the worm is made thicker, eight
#   hinges bend it, a similarity takes it to the image. Silhouette and outline overlap by {overlap}
#   (intersection over union); the map is {local}, without folds.
worm=$DATA/models/virtual_worm_cuticle_red75.obj
mkgrid --model "$worm" --flat --plane zy --cells 40 --margin 0.15 -o rest.grid
sh -e "$HERE/lib/posture.sh" 254 "$worm" rest.grid bent.grid
check-grid bent.grid | grep -E '^(local|det-lower)'
tail -n 11 posture.edits
draw-grid --no-grid --image "$DATA/images/worm-254.png" --frame 0,0,64,-97 --width 340 -o decles14-02-posture-1.png
draw-grid --model "$worm" --layers outline,triangles --lines outline.lines --image "$DATA/images/worm-254.png" \
    --frame 0,0,64,-97 --width 380 -o decles14-02-posture-2.png bent.grid
