# title: From one posture to another
# paper: Not known to us. Animation is named in the abstract.
# picture: at rest
# picture: the script with angles half as large
# picture: the omega turn
# picture: the mean of the control points of the first and the third
# seen: A deformation is its control points, and the conditions are linear: every mixture of two grids (mix-grid)
#   is C1, too; the relative residual of the mean is {c1-relative-residual}. But a mean of two maps that turn
#   against each other by 180 degrees shrinks: the last picture's map {mean}, with {det} at the least. A script
#   with smaller angles gives the posture between them, {half}.
worm=$DATA/models/virtual_worm_cuticle.obj
mkgrid --model "$worm" --plane zy --cells 40 --margin 0.02 -o 1.grid
awk '$1 == "rotate" { for (i = 1; i < NF; i++) if ($i == "by") $(i + 1) /= 2 } { print }' "$DATA/demo/omega.edits" >half.edits
decles-edit half.edits 1.grid -o 2.grid
decles-edit "$DATA/demo/omega.edits" 1.grid -o 3.grid
mix-grid 0.5 1.grid 0.5 3.grid >4.grid
check-grid 2.grid | sed -n 's/^local:/half/p'
check-grid 4.grid >report 2>/dev/null || true
sed -n 's/^local:/mean/p; s/^det-lower:/det/p; s/^c1-relative/&/p' report
for n in 1 2 3 4; do
    deform-mesh --normals drop "$worm" $n.grid -o worm.obj
    render-model --plane zy --view -25,50 --size 420x260 -o decles11-16-motion-$n.png worm.obj
done
