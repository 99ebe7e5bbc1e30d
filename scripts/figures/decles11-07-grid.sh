# title: A grid around the projection of a model
# paper: Not known to us. By section 4.1 a regular grid surrounds the model's projection.
# picture: 20 cells along the body: {triangles-20} triangles
# picture: 40 cells: {triangles-40} triangles
# picture: triangles in rows (--pattern hex): {triangles-hex}
# seen: The cells that meet the silhouette with its margin are kept. A fine grid lets edits be local and keeps
#   parts apart that lie near each other; a coarse one has fewer points to move. Prisms stand on the triangles.
worm=$DATA/models/virtual_worm_cuticle_red75.obj
n=0
for options in '--cells 20' '--cells 40' '--cells 24 --pattern hex'; do
    n=$((n + 1))
    # shellcheck disable=SC2086 # several words
    mkgrid --model "$worm" --plane zy $options --margin 0.05 -o worm.grid
    name=${options##* }
    awk -v name="$name" '/^triangles / { print "triangles-" name, $2 }' worm.grid
    draw-grid --model "$worm" --width 760 -o decles11-07-grid-$n.png worm.grid
done
