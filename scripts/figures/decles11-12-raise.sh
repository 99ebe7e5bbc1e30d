# title: The third dimension: raised bottoms and tops
# paper: Not known to us. sigma0 and sigma1 are edited like phi, by heights.
# picture: the prisms at rest
# picture: the top alone raised
# picture: bottom and top raised together
# picture: a red blood cell in them, from below
# picture: the top raised
# picture: both raised: a bowl
# seen: The middle of the cell: raised by 0.9 at the top alone, the upper side swells over the hollow; raised by
#   0.9 at both, the disc becomes a bowl, and its thickness stays: {thickness} of what it was at the least. The
#   plane does not move at all: det grad phi is {det}.
cell=$DATA/models/red_blood_cell.obj
mkgrid --model "$cell" --cells 6 -o rest.grid
decles-edit -e 'raise top box:-0.6,-0.6,0.6,0.6 by 0.9 within 1.8' rest.grid -o top.grid
decles-edit -e 'raise both box:-0.6,-0.6,0.6,0.6 by 0.9 within 1.8' rest.grid -o both.grid
check-grid both.grid | sed -n 's/^det-lower:/det/p; s/^thickness-lower:/thickness/p'
n=0
for name in rest top both; do
    n=$((n + 1))
    deform-mesh "$cell" $name.grid -o cell.obj
    render-model --grid $name.grid --no-model --view -25,15 --size 310x220 -o decles11-12-raise-$n.png
    render-model --view -25,-28 --size 310x220 -o decles11-12-raise-$((n + 3)).png cell.obj
done
