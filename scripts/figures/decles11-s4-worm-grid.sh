# title: The worm, its grid and its omega
# paper: A grid of triangles that surrounds the model's projection; prisms over it; bent, they bend the model.
# seen: The cuticle of C. elegans (Virtual Worm project) instead of the papers' organisms, which are not
#   public. 40 cells along the body; the eight edits of the demo; where areas grow (red) and shrink (blue).
worm=$DATA/models/virtual_worm_cuticle.obj
mkgrid --model "$worm" --plane zy --cells 40 --margin 0.02 -o rest.grid
draw-grid --model "$worm" -o decles11-s4-worm-grid-rest.png rest.grid
decles-edit "$DATA/demo/omega.edits" rest.grid -o bent.grid
draw-grid --model "$worm" --layers jacobian,triangles,outline -o decles11-s4-worm-grid-bent.png bent.grid
check-grid bent.grid | grep -E '^(local|det-lower|c1-relative|one-to-one)'
deform-mesh "$worm" bent.grid -o bent.obj
render-model --grid bent.grid bent.obj -o decles11-s4-worm-grid-prisms.png
