# title: The prisms
# paper: Not known to us. The control grid is made of prisms: the triangles, extended in depth from a to b.
# picture: the worm in its prisms, at rest
# picture: a red blood cell in {cell} prisms
# seen: Prisms with walls as glass, control points of the bottom (violet) and the top (orange). The worm's
#   {worm} prisms span its own depth, from {depth}. The red blood cell is a membrane of the Mirheo project.
worm=$DATA/models/virtual_worm_cuticle_red75.obj
cell=$DATA/models/red_blood_cell.obj
mkgrid --model "$worm" --plane zy --cells 20 -o worm.grid
mkgrid --model "$cell" --cells 4 --pattern hex -o cell.grid
awk '/^depth / { printf "depth %.3f to %.3f\n", $2, $3 } /^triangles / { print "worm", $2 }' worm.grid
awk '/^triangles / { print "cell", $2 }' cell.grid
render-model --grid worm.grid --size 640x300 -o decles11-08-prisms-1.png "$worm"
render-model --grid cell.grid --size 460x340 -o decles11-08-prisms-2.png "$cell"
