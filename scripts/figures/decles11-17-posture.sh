# title: The model in the posture of a living worm
# paper: A 3-D model deformed until it fits a micrograph.
# picture: frame 254 of a video of a crawling C. elegans
# picture: the model bent to it, seen from above
# picture: in its prisms
# seen: The deformation of [14] figure 2, applied to the model in space. From above it fits the outline of the worm
#   (overlap {overlap}, intersection over union); bottoms and tops of the prisms are moved apart as the similarity
#   scales the plane, so that the worm stays round.
#   The paper's model and image are not public; here they are the Virtual Worm and a frame of WormPose.
worm=$DATA/models/virtual_worm_cuticle_red75.obj
mkgrid --model "$worm" --plane zy --cells 40 --margin 0.15 -o rest.grid
sh -e "$HERE/lib/posture.sh" 254 "$worm" rest.grid bent.grid
check-grid bent.grid | grep -E '^(local|one-to-one|psi-one-to-one)'
draw-grid --no-grid --image "$DATA/images/worm-254.png" --frame 0,0,64,-97 --width 300 -o decles11-17-posture-1.png
scale=$(awk '$1 == "scale" { print $NF - 1 }' posture.edits)
awk -v s="$scale" '/^depth/ { print "edits 1\nraise bottom all by " s * $2 "\nraise top all by " s * $3 }' rest.grid >depth.edits
decles-edit depth.edits bent.grid -o thick.grid
deform-mesh "$DATA/models/virtual_worm_cuticle.obj" thick.grid -o bent-full.obj
render-model --plane zy --view top --size 300x440 -o decles11-17-posture-2.png bent-full.obj
render-model --grid thick.grid --layers glass,triangles --view -25,50 --size 400x440 -o decles11-17-posture-3.png bent-full.obj
