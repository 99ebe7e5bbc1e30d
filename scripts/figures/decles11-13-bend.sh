# title: A hinge
# paper: Not known to us. Movement of an organism is bending of its parts.
# picture: by 30 degrees
# picture: by 60 degrees
# picture: by 90 degrees
# seen: All that lies on the head's side of the hinge turns as one piece; the points within 1.9 of it make the
#   bend. On the inner side areas shrink, on the outer they grow; at 90 degrees the least growth is {det-90},
#   still without folds ({local-90}).
worm=$DATA/models/virtual_worm_cuticle_red75.obj
mkgrid --model "$worm" --plane zy --cells 40 --margin 0.02 -o rest.grid
n=0
for angle in 30 60 90; do
    n=$((n + 1))
    decles-edit -e "rotate box:1.2,-3,5,3 about 0 0 by $angle within 1.9" rest.grid -o bent.grid
    check-grid bent.grid >report || true
    sed -n "s/^local:/local-$angle/p; s/^det-lower:/det-$angle/p" report
    draw-grid --model "$worm" --layers jacobian,triangles,outline --width 310 -o decles11-13-bend-$n.png bent.grid
done
