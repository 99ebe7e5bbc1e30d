# title: A model bent by hand
# paper: Not known to us. The paper's subject is the smooth deformation of 3-D models of microscopic organisms,
#   mostly in the plane.
# picture: the cuticle of C. elegans at rest
# picture: after the eight edits of the demo: an omega turn, and a lifted head
# seen: The Virtual Worm's cuticle ({vertices} vertices) instead of the paper's organisms, which are not public.
#   The body of 8 units is bent by 7 soft rotations of parts of its grid; the skin follows smoothly. The map
#   of the plane is {local} and one-to-one ({one-to-one}), as is that of space ({psi-one-to-one}).
worm=$DATA/models/virtual_worm_cuticle.obj
mkgrid --model "$worm" --plane zy --cells 40 --margin 0.02 -o rest.grid
decles-edit "$DATA/demo/omega.edits" rest.grid -o bent.grid
echo "vertices $(grep -c '^v ' "$worm")"
check-grid bent.grid | grep -E '^(local|det-lower|one-to-one|psi-one-to-one)'
deform-mesh "$worm" bent.grid -o bent.obj
render-model --plane zy --size 480x240 -o decles11-01-overview-1.png "$worm"
render-model --plane zy --size 480x330 -o decles11-01-overview-2.png bent.obj
